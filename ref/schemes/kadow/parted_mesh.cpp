#include "parted_mesh.hpp"

#include <algorithm>

#include "../../../core/support/without_repetitions.hpp"

namespace pardel::schemes {
namespace {

std::size_t at(int worker) { return static_cast<std::size_t>(worker); }

/// The triangles of one worker, and their points.
struct Share {
  int worker = 0;
  std::vector<Index> triangles;
  std::vector<Index> points, inner;
};

/// Points on the border of the domain and on interfaces are not inner points.
void find_points(const PartedMesh& parted, Share& share) {
  std::vector<Index> on_border;
  for (const Index t : share.triangles)
    for (int i = 0; i < 3; ++i) {
      const Face& face = parted.mesh.faces[t];
      share.points.push_back(face.v[i]);
      if (face.n[i] != no_index && parted.owner[face.n[i]] == share.worker) continue;
      const auto [a, b] = ends(parted.mesh, {t, i});
      on_border.push_back(a);
      on_border.push_back(b);
    }
  sort_without_repetitions(share.points);
  sort_without_repetitions(on_border);
  std::ranges::set_difference(share.points, on_border, std::back_inserter(share.inner));
}

std::vector<Share> shares_of(const PartedMesh& parted) {
  std::vector<Share> shares(parted.held.size());
  for (Index t = 0; t < parted.mesh.faces.size(); ++t)
    if (parted.mesh.in_use(t)) shares[at(parted.owner[t])].triangles.push_back(t);
  for (std::size_t w = 0; w < shares.size(); ++w) {
    shares[w].worker = static_cast<int>(w);
    find_points(parted, shares[w]);
  }
  return shares;
}

/// Gives the triangles above a path of the share to the other worker.
void divide(PartedMesh& parted, const Share& share, int other, const GivenPointsOptions& options, Phase& phase) {
  const std::vector<Point>& points = parted.mesh.points;
  const int worker = share.worker;
  const Cut cut = cut_of(points, share.points, parted.levels[at(worker)], options.cuts);
  const Point m = points[median(points, share.inner, cut, 1, 2)];
  const std::vector<Index> path = dividing_path(points, share.points, m, cut);
  const PathPlaces places(path);
  phase.work(worker, share.points.size());
  std::uint64_t moved = 0;
  for (const Index t : share.triangles) {
    const Corners& v = parted.mesh.faces[t].v;
    if (lies_low(points, path, places, {v[0], v[1], v[2]}, m, cut)) continue;
    parted.owner[t] = other;
    ++moved;
  }
  parted.held[at(worker)] -= moved;
  parted.held[at(other)] += moved;
  parted.levels[at(other)] = ++parted.levels[at(worker)];
  phase.send(worker, other, moved * bytes_of_triangle);
  std::deque<Index> all = std::move(parted.waiting[at(worker)]);
  parted.waiting[at(worker)] = {};
  for (const Index t : all) parted.waiting[at(parted.owner[t])].push_back(t);
}

/// Is this a split that replaces a circumcentre?
bool follows_rejection(const PartedMesh& parted, const Insertion& insertion) {
  return insertion.splits_segment() && !encroached_side(parted.mesh, insertion.triangle);
}

/// The first cavity that was searched for the insertion.
Cavity first_cavity(const PartedMesh& parted, const Insertion& insertion) {
  const Index t = insertion.triangle;
  return follows_rejection(parted, insertion) ? cavity_of(parted.mesh, circumcentre(parted.mesh, t), {t})
                                              : insertion.cavity;
}

}  // namespace

PartedMesh parted_mesh(PartedStart start) {
  const std::size_t workers = start.levels.size();
  PartedMesh parted{std::move(start.mesh), std::move(start.owner), {}, {}, std::move(start.levels)};
  parted.waiting.resize(workers);
  parted.held.resize(workers, 0);
  for (Index t = 0; t < parted.mesh.faces.size(); ++t) {
    parted.waiting[at(parted.owner[t])].push_back(t);
    ++parted.held[at(parted.owner[t])];
  }
  return parted;
}

bool belongs_to(const PartedMesh& parted, const Cavity& cavity, int worker) {
  const auto is_own = [&](Index t) { return parted.owner[t] == worker; };
  return std::ranges::all_of(cavity.triangles, is_own) && std::ranges::all_of(cavity.boundary, [&](Side side) {
           const Index beyond = parted.mesh.faces[side.triangle].n[side.i];
           return is_constrained(parted.mesh, side) || beyond == no_index || is_own(beyond);
         });
}

bool is_local(const PartedMesh& parted, const Insertion& insertion, int worker) {
  if (!belongs_to(parted, insertion.cavity, worker)) return false;
  return !follows_rejection(parted, insertion) || belongs_to(parted, first_cavity(parted, insertion), worker);
}

std::uint64_t read_before_interface(const PartedMesh& parted, const Insertion& insertion, int worker) {
  const Cavity cavity = first_cavity(parted, insertion);
  std::vector<Index> reached = {insertion.triangle};
  const auto contains = [](const std::vector<Index>& list, Index t) {
    return std::ranges::find(list, t) != list.end();
  };
  std::uint64_t rim = 0;
  for (std::size_t k = 0; k < reached.size(); ++k)
    for (int i = 0; i < 3; ++i) {
      const Index other = parted.mesh.faces[reached[k]].n[i];
      const bool is_open = other != no_index && !is_constrained(parted.mesh, {reached[k], i});
      if (!is_open || parted.owner[other] != worker || !cavity.contains(other))
        ++rim;
      else if (!contains(reached, other))
        reached.push_back(other);
    }
  return reached.size() + rim;
}

void carry_out(PartedMesh& parted, const Insertion& insertion) {
  const LinkedMesh& mesh = parted.mesh;
  const Side split = insertion.split;
  std::vector<int> owners;
  for (const Side side : insertion.cavity.boundary) {
    if (insertion.splits_segment()) {
      // replace() makes no triangle there.
      const auto [a, b] = ends(mesh, side);
      const std::array<Index, 2> halves = ends(mesh, split);
      if (halves == std::array{a, b} || halves == std::array{b, a}) continue;
    }
    owners.push_back(parted.owner[side.triangle]);
  }
  for (const Index t : insertion.cavity.triangles) --parted.held[at(parted.owner[t])];
  const std::vector<Index> made = carry_out(parted.mesh, insertion);
  parted.owner.resize(mesh.faces.size(), 0);
  for (std::size_t k = 0; k < made.size(); ++k) {
    parted.owner[made[k]] = owners[k];
    ++parted.held[at(owners[k])];
    parted.waiting[at(owners[k])].push_back(made[k]);
  }
  const Index t = insertion.triangle;
  if (!insertion.cavity.contains(t)) parted.waiting[at(parted.owner[t])].push_back(t);
}

std::vector<int> owners_of(const PartedMesh& parted, const Cavity& cavity) {
  std::vector<int> owners;
  for (const Index t : cavity.triangles)
    if (std::ranges::find(owners, parted.owner[t]) == owners.end()) owners.push_back(parted.owner[t]);
  return owners;
}

std::uint64_t interfaces_inside(const PartedMesh& parted, const Cavity& cavity) {
  std::uint64_t twice = 0;
  for (const Index t : cavity.triangles)
    for (int i = 0; i < 3; ++i) {
      const Index other = parted.mesh.faces[t].n[i];
      if (other == no_index || is_constrained(parted.mesh, {t, i}) || parted.owner[other] == parted.owner[t]) continue;
      if (cavity.contains(other)) ++twice;
    }
  return twice / 2;
}

std::uint64_t divide_large_parts(PartedMesh& parted, const GivenPointsOptions& options, std::size_t least_inner,
                                 Account& account) {
  std::vector<int> idle;
  for (std::size_t w = parted.held.size(); w-- > 0;)
    if (parted.held[w] == 0) idle.push_back(static_cast<int>(w));
  if (idle.empty()) return 0;
  std::vector<Share> shares = shares_of(parted);
  std::erase_if(shares, [&](const Share& s) { return s.inner.size() < least_inner; });
  if (shares.empty()) return 0;
  std::ranges::stable_sort(shares, std::ranges::greater{}, [](const Share& s) { return s.inner.size(); });
  Phase phase(static_cast<int>(parted.held.size()));
  std::uint64_t divided = 0;
  for (const Share& share : shares) {
    if (idle.empty()) break;
    divide(parted, share, idle.back(), options, phase);
    idle.pop_back();
    ++divided;
  }
  phase.end(account);
  return divided;
}

}  // namespace pardel::schemes
