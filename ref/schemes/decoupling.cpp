#include "decoupling.hpp"

#include <algorithm>
#include <deque>

#include "decoupling/separators.hpp"
#include "mesh/forced_segments.hpp"
#include "mesh/predicates.hpp"
#include "mesh/triangle.hpp"
#include "workers/phase.hpp"
#include "workers/random.hpp"

namespace pardel::schemes {
namespace {

/// The parts of a mesh with separators, refined one after the other: they do not know of each other.
class Parts {
 public:
  Parts(Start& start, const Problem& problem, const decoupled::Plan& plan, const decoupled::Laid& laid,
        Encroaching encroaching)
      : mesh_(start.mesh), bounds_(start.bounds), problem_(problem), laid_(laid), encroaching_(encroaching) {
    for (Index t = 0; t < mesh_.faces.size(); ++t)
      part_.push_back(mesh_.in_use(t) ? plan.part_of(centroid(mesh_, t)) : -1);
  }

  [[nodiscard]] const std::vector<int>& part() const { return part_; }
  [[nodiscard]] int worker(int part) const { return part % problem_.workers; }

  /// Refines one part by Ruppert's rules, but gives up what would split a separator or read another part's triangles.
  /// Its work goes to the phase.
  void refine(int part, const std::vector<Index>& triangles, Phase& phase, Account& account) {
    std::deque<Index> waiting(triangles.begin(), triangles.end());
    while (!waiting.empty() && mesh_.points.size() <= problem_.most_points) {
      const Index t = waiting.front();
      waiting.pop_front();
      if (!mesh_.in_use(t) || part_[t] != part) continue;
      work_ = 0;
      is_given_up_ = false;
      const std::optional<Insertion> found = insertion_of(t, part);
      if (is_given_up_) {
        phase.waste(worker(part), work_);
        ++account.set_backs;
        given_up_.push_back(known(mesh_, t));
        continue;
      }
      phase.work(worker(part), work_);
      if (!found) continue;
      const std::vector<Index> made = carry_out(mesh_, *found);
      part_.resize(mesh_.faces.size(), part);
      for (const Index m : made) part_[m] = part;
      waiting.insert(waiting.end(), made.begin(), made.end());
      if (!found->cavity.contains(t)) waiting.push_back(t);
    }
  }

  [[nodiscard]] std::uint64_t separator_splits() const { return separator_splits_; }
  /// The triangles that parts gave up and that are still there.
  [[nodiscard]] std::deque<Index> given_up() const {
    std::deque<Index> left;
    for (const KnownTriangle& each : given_up_)
      if (is_current(mesh_, each)) left.push_back(each.triangle);
    return left;
  }

 private:
  [[nodiscard]] bool is_separator(Side side) const {
    const Index s = mesh_.faces[side.triangle].segment[side.i];
    return s != no_segment && s >= laid_.first;
  }
  /// Do the cavity, and the triangles across its sides that are not constrained, belong to the part? Otherwise another
  /// part might change what the insertion reads.
  [[nodiscard]] bool is_inside(const Cavity& cavity, int part) const {
    return std::ranges::all_of(cavity.triangles, [&](Index t) { return part_[t] == part; }) &&
           std::ranges::all_of(cavity.boundary, [&](Side side) {
             return is_constrained(mesh_, side) || part_[mesh_.faces[side.triangle].n[side.i]] == part;
           });
  }

  std::optional<Insertion> give_up() {
    is_given_up_ = true;
    return std::nullopt;
  }
  /// Gives up because the cavity leaves the part. Only triangles before the first one beyond the border were read.
  std::optional<Insertion> leave(const Cavity& cavity, int part) {
    const auto is_beyond = [&](Index t) {
      return part_[t] != part || std::ranges::any_of(std::array{0, 1, 2}, [&](int i) {
               const Index n = mesh_.faces[t].n[i];
               return n != no_index && !is_constrained(mesh_, {t, i}) && part_[n] != part;
             });
    };
    const auto first = std::ranges::find_if(cavity.triangles, is_beyond);
    work_ += static_cast<std::uint64_t>(first - cavity.triangles.begin());
    return give_up();
  }
  std::optional<Insertion> split(Side side, int part) {
    if (is_separator(side)) {
      ++separator_splits_;
      return give_up();
    }
    std::optional<Insertion> found = split_of(mesh_, side, bounds_.small_angles());
    if (!found) return std::nullopt;
    if (!is_inside(found->cavity, part)) return leave(found->cavity, part);
    work_ += found->work();
    // Midpoints encroach upon separators, too.
    if (encroaching_ == Encroaching::handed_back && splits_separator(*found)) {
      ++separator_splits_;
      return give_up();
    }
    return found;
  }
  [[nodiscard]] bool splits_separator(const Insertion& split) const {
    return std::ranges::any_of(split.cavity.boundary, [&](Side side) {
      const auto [a, b] = ends(mesh_, side);
      return is_separator(side) && encroaches(split.point, mesh_.points[a], mesh_.points[b]);
    });
  }
  [[nodiscard]] std::optional<Side> encroached(Index t) const {
    for (int i = 0; i < 3; ++i) {
      const Side side{t, i};
      if (!is_constrained(mesh_, side) || (is_separator(side) && encroaching_ == Encroaching::inserted)) continue;
      const auto [a, b] = ends(mesh_, side);
      if (encroaches(mesh_.corner(t, i), mesh_.points[a], mesh_.points[b])) return side;
    }
    return std::nullopt;
  }
  std::optional<Insertion> insertion_of(Index t, int part) {
    const std::optional<Side> own = encroached(t);
    if (!own && !bounds_.is_large(mesh_, t) && !bounds_.is_thin(mesh_, t)) return std::nullopt;
    ++work_;
    if (own) return split(*own, part);
    Insertion found{t, circumcentre(mesh_, t), {}, {}};
    if (!circumdisk_contains(mesh_, t, found.point)) return std::nullopt;
    found.cavity = cavity_of(mesh_, found.point, {t});
    if (!is_inside(found.cavity, part)) return leave(found.cavity, part);
    work_ += found.work();
    if (const auto side = blocking_side(mesh_, found.cavity, found.point)) {
      const bool may_be = encroaching_ == Encroaching::inserted && is_separator(*side) &&
                          can_be_connected(mesh_, found.cavity, found.point);
      if (!may_be) return split(*side, part);
    }
    if (!can_be_connected(mesh_, found.cavity, found.point)) return std::nullopt;
    return found;
  }

  LinkedMesh& mesh_;
  const Bounds& bounds_;
  const Problem& problem_;
  decoupled::Laid laid_;
  Encroaching encroaching_;
  std::vector<int> part_;
  std::vector<KnownTriangle> given_up_;
  std::uint64_t work_ = 0, separator_splits_ = 0;
  bool is_given_up_ = false;
};

/// Refines all parts at the same time, each after one message with its triangles.
void refine_parts(Parts& parts, const decoupled::Plan& plan, const Problem& problem, Account& account) {
  std::vector<std::vector<Index>> of(static_cast<std::size_t>(plan.parts));
  std::vector<std::uint64_t> held(static_cast<std::size_t>(problem.workers), 0);
  for (Index t = 0; t < parts.part().size(); ++t)
    if (parts.part()[t] >= 0) of[static_cast<std::size_t>(parts.part()[t])].push_back(t);
  Phase phase(problem.workers);
  std::vector<int> order;
  for (int part = 0; part < plan.parts; ++part) {
    const std::vector<Index>& triangles = of[static_cast<std::size_t>(part)];
    if (triangles.empty()) continue;
    phase.send(0, parts.worker(part), bytes_of_triangle * triangles.size());
    order.push_back(part);
  }
  std::ranges::sort(order, {}, [&](int part) {
    return random_number(problem.seed ^ random_number(static_cast<std::uint64_t>(part)));
  });
  for (const int part : order) parts.refine(part, of[static_cast<std::size_t>(part)], phase, account);
  for (const int part : parts.part())
    if (part >= 0) ++held[static_cast<std::size_t>(parts.worker(part))];
  account.most_held = *std::ranges::max_element(held);
  account.rounds = 1;
  phase.end(account);
}

/// Separators become edges like others. Returns the sides that were separators.
std::vector<Side> glue(LinkedMesh& mesh, const decoupled::Laid& laid) {
  std::vector<Side> sides;
  for (Index t = 0; t < mesh.faces.size(); ++t)
    for (int i = 0; mesh.in_use(t) && i < 3; ++i) {
      Index& s = mesh.faces[t].segment[i];
      if (s == no_segment || s < laid.first) continue;
      s = no_segment;
      sides.push_back({t, i});
    }
  mesh.segments.resize(laid.first);
  return sides;
}

}  // namespace

Result<Outcome> decoupling(const Problem& problem, const DecouplingOptions& options) {
  Result<Start> start = start_of(problem);
  if (!start) return start.error();
  LinkedMesh& mesh = start->mesh;
  Account& account = start->account;
  const Territory territory(mesh, start->bounds, problem.workers);
  const decoupled::Plan plan = options.separators == Separators::lattice
                                   ? decoupled::lattice_plan(mesh, problem.workers)
                                   : decoupled::bisection_plan(mesh, territory);
  const decoupled::Laid laid = decoupled::lay(mesh, start->bounds, plan, options.piece, problem.most_points);
  account.sequential += laid.work;
  account.critical += laid.work;
  Parts parts(*start, problem, plan, laid, options.encroaching);
  if (options.on_laid) options.on_laid({mesh, parts.part(), laid.first, laid.pieces, laid.gaps});
  refine_parts(parts, plan, problem, account);

  DecouplingEnd end{parts.separator_splits(), 0, 0};
  std::deque<Index> waiting = parts.given_up();
  const std::vector<Side> sides = glue(mesh, laid);
  for (const Side side : sides) waiting.push_back(side.triangle);
  const std::vector<Index> flipped = flip_to_delaunay(mesh, sides);
  waiting.insert(waiting.end(), flipped.begin(), flipped.end());
  end.flips = flipped.size() / 2;
  const std::size_t points = mesh.points.size();
  const std::uint64_t work = flipped.size() + refine_where(
                                                  mesh, start->bounds, std::move(waiting), [](Index) { return true; },
                                                  problem.most_points + 1);
  account.sequential += work;
  account.critical += work;
  end.late = mesh.points.size() - points;
  if (options.on_end) options.on_end(end);
  if (mesh.points.size() > problem.most_points) return too_many_points(problem);
  account.insertions = mesh.points.size() - problem.pslg.points.size();
  compact(mesh);
  return Outcome{std::move(mesh), account};
}

}  // namespace pardel::schemes
