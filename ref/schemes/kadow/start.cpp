#include "start.hpp"

#include <algorithm>

#include "../mesh/predicates.hpp"
#include "../mesh/triangulation.hpp"
#include "../workers/phase.hpp"

namespace pardel::schemes {
namespace {

constexpr std::uint64_t bytes_of_flag = 8;

std::vector<std::array<Index, 2>> segments_of(const Pslg& pslg) {
  if (pslg.segments.empty()) return hull_of(pslg.points);
  std::vector<std::array<Index, 2>> segments;
  for (const Segment& s : pslg.segments) segments.push_back({s.a, s.b});
  return segments;
}

/// Splits the missing pieces. False if one is too short.
bool split(LinkedMesh& mesh, std::vector<Piece>& pieces, const std::vector<std::size_t>& missing,
           const SmallAngles& angles) {
  for (const std::size_t k : missing) {
    const auto [a, b, segment] = pieces[k];
    const Point p = angles.split_point(mesh, segment, a, b);
    if (p == mesh.points[a] || p == mesh.points[b]) return false;
    const auto v = static_cast<Index>(mesh.points.size());
    mesh.points.push_back(p);
    mesh.segment_of.push_back(segment);
    pieces[k].b = v;
    pieces.push_back({v, b, segment});
  }
  return true;
}

/// Each piece is looked up by the first worker that has its first end. A new point has to be told to all, because the
/// points are divided anew.
void count_splits(const std::vector<Piece>& pieces, const std::vector<std::size_t>& missing, const Division& division,
                  std::size_t points, Account& account) {
  const auto workers = static_cast<int>(division.parts.size());
  std::vector<int> holder(points, 0);
  for (int worker = workers - 1; worker >= 0; --worker)
    for (const Index v : division.parts[static_cast<std::size_t>(worker)].points) holder[v] = worker;
  Phase phase(workers);
  for (const Piece& piece : pieces) phase.work(holder[piece.a], 1);
  for (const std::size_t k : missing) phase.send(holder[pieces[k].a], 0, bytes_of_triangle);
  phase.end(account);
}

/// Values of triangles that spread up to segments. A worker spreads them in its part, and tells its neighbours.
class Spreading {
 public:
  Spreading(const LinkedMesh& mesh, const std::vector<int>& owner, int workers)
      : values(mesh.faces.size(), no_index), mesh_(mesh), owner_(owner), workers_(workers) {}

  void spread(std::vector<Index> starts, Index value, Account& account) {
    while (!starts.empty()) {
      Phase phase(workers_);
      std::vector<Index> beyond;
      while (!starts.empty()) {
        const Index t = starts.back();
        starts.pop_back();
        if (values[t] == value) continue;
        values[t] = value;
        phase.work(owner_[t], 1);
        for (int i = 0; i < 3; ++i) {
          const Index other = mesh_.faces[t].n[i];
          if (other == no_index || is_constrained(mesh_, {t, i}) || values[other] == value) continue;
          (owner_[other] == owner_[t] ? starts : beyond).push_back(other);
          phase.send(owner_[t], owner_[other], bytes_of_flag);
        }
      }
      phase.end(account);
      starts = std::move(beyond);
    }
  }

  std::vector<Index> values;

 private:
  const LinkedMesh& mesh_;
  const std::vector<int>& owner_;
  int workers_;
};

/// Removes the outside and the holes, and gives triangles their regions.
void carve_in_parts(LinkedMesh& mesh, std::vector<int>& owner, const Pslg& pslg, int workers, Account& account) {
  Spreading spreading(mesh, owner, workers);
  const auto around = [&](Point p) {
    const Index t = triangle_around(mesh, p);
    return t == no_index ? std::vector<Index>() : std::vector<Index>{t};
  };
  std::vector<Index> outside;
  for (Index t = 0; t < mesh.faces.size(); ++t)
    for (int i = 0; i < 3; ++i)
      if (mesh.faces[t].n[i] == no_index && !is_constrained(mesh, {t, i})) outside.push_back(t);
  spreading.spread(outside, removed_face, account);
  for (const Point hole : pslg.holes) spreading.spread(around(hole), removed_face, account);
  for (Index r = 0; r < pslg.regions.size(); ++r) {
    const std::vector<Index> start = around(pslg.regions[r].seed);
    if (!start.empty() && spreading.values[start.front()] != removed_face) spreading.spread(start, r + 1, account);
  }
  std::vector<int> kept;
  for (Index t = 0; t < mesh.faces.size(); ++t)
    if (spreading.values[t] != removed_face) kept.push_back(owner[t]);
  keep_faces(mesh, spreading.values);
  owner = std::move(kept);
}

/// Removes the new points of segments outside the domain. `inputs`: number of points of the input, which all stay.
void remove_unused_points(LinkedMesh& mesh, Index inputs) {
  std::vector<bool> used(mesh.points.size(), false);
  for (const Face& face : mesh.faces)
    for (const Index v : face.v) used[v] = true;
  std::vector<Index> number(mesh.points.size(), no_index);
  Index kept = 0;
  for (Index v = 0; v < mesh.points.size(); ++v) {
    if (v >= inputs && !used[v]) continue;
    mesh.points[kept] = mesh.points[v];
    mesh.segment_of[kept] = mesh.segment_of[v];
    number[v] = kept++;
  }
  mesh.points.resize(kept);
  mesh.segment_of.resize(kept);
  for (Face& face : mesh.faces)
    for (Index& v : face.v) v = number[v];
}

}  // namespace

Result<PartedStart> parted_start(const Problem& problem, const GivenPointsOptions& options) {
  const Pslg& pslg = problem.pslg;
  if (auto error = unsupported(pslg, problem.goal)) return *error;
  const Error empty{ErrorKind::invalid_input, "The domain has no triangle."};
  if (pslg.points.size() < 3) return empty;
  LinkedMesh outline{pslg.points, std::vector<Index>(pslg.points.size(), no_segment), {}, segments_of(pslg)};
  const Bounds bounds(pslg, problem.goal, outline);
  std::vector<Piece> pieces;
  for (const auto& [a, b] : outline.segments) pieces.push_back({a, b, static_cast<Index>(pieces.size())});
  Account account;
  for (;;) {
    const Division division = division_of(outline.points, problem.workers, options, account);
    Triangles triangles = triangles_of(outline.points, division, account);
    if (triangles.corners.empty()) return empty;  // all points are on one line
    std::vector<std::size_t> missing;
    LinkedMesh mesh = linked(outline.points, triangles.corners, pieces, missing);
    count_splits(pieces, missing, division, mesh.points.size(), account);
    if (missing.empty()) {
      mesh.segment_of = outline.segment_of;
      mesh.segments = outline.segments;
      carve_in_parts(mesh, triangles.owner, pslg, problem.workers, account);
      if (mesh.faces.empty()) return empty;
      remove_unused_points(mesh, static_cast<Index>(pslg.points.size()));
      account.insertions = mesh.points.size() - pslg.points.size();
      account.rounds = 0;
      return PartedStart{std::move(mesh), std::move(triangles.owner), division.levels, bounds, account};
    }
    if (!split(outline, pieces, missing, bounds.small_angles()))
      return Error{ErrorKind::resources, "A segment is too short to be split."};
    if (outline.points.size() > problem.most_points) return too_many_points(problem);
  }
}

}  // namespace pardel::schemes
