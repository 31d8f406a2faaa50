#include "task.hpp"

#include <utility>

#include "../quality/split_candidates.hpp"
#include "../triangulation/held.hpp"

namespace pardel::engine {

template <class Work>
void Task::with_triangles_around(TriangleId id, const Work& work) {
  try {
    work();
  } catch (const NotHeld&) {
    if (!is_in_submesh_) throw;
    note_missing_triangles(id);
  }
}

void Task::start(const Tiles& tiles, Index cell, std::span<const QueuedTriangle> seeds, const Deferral& later,
                 FreeIndices& free, const Report& report, bool list_changes) {
  tiles_ = &tiles;
  cell_ = cell;
  box_ = tiles.box_of(cell);
  later_ = later;
  lists_changes_ = list_changes;
  free_ = &free;
  insertion_.start(free);
  result_ = {};
  changed_.clear();
  hints_ = {};
  for (std::size_t i = 0; i < seeds.size(); ++i) {
    if (report && i % steps_between_reports == 0) report(0);
    with_triangles_around(seeds[i].id(), [&] { consider(seeds[i].id()); });
  }
}

bool Task::step() {
  while (!queue_.empty()) {
    const QueuedTriangle next = queue_.pop();
    if (!next.is_current(t_)) continue;  // stale; the new triangle was queued, too, if it is bad
    if (!free_->suffice()) {
      hand_on_to_own_cell(next);
      return true;
    }
    with_triangles_around(next.id(), [&] { process(next); });
    return true;
  }
  return false;
}

void Task::note_missing_triangles(TriangleId around) {
  const std::vector<VertexId> at = insertion_.ends_of_missed_edges();
  std::vector<VertexId>& all = result_.needs_more_at;
  all.insert(all.end(), at.begin(), at.end());
  if (at.empty()) all.insert(all.end(), t_.slots[around].v.begin(), t_.slots[around].v.end());
}

TaskResult Task::run(const Tiles& tiles, Index cell, std::span<const QueuedTriangle> seeds, const Deferral& later,
                     FreeIndices& free, const Report& report, bool list_changes) {
  start(tiles, cell, seeds, later, free, report, list_changes);
  std::uint64_t reported = 0;
  for (std::uint64_t steps = 1; step(); ++steps) {
    if (steps % steps_between_reports != 0) continue;
    const std::uint64_t made = result_.inserted + result_.segment_splits;
    report(made - std::exchange(reported, made));
  }
  return finish();
}

TaskResult Task::finish() {
  std::erase_if(changed_, [&](const QueuedTriangle& made) { return !made.is_current(t_); });
  result_.changed.reserve(changed_.size());
  for (const QueuedTriangle& made : changed_) result_.changed.push_back(made.id());
  return std::move(result_);
}

void Task::hand_on_to_own_cell(QueuedTriangle triangle) {
  result_.handed_on.push_back({triangle, cell_});
  ++result_.out_of_numbers;
}

void Task::consider_changed() {
  const auto changed = insertion_.changed();
  const auto measures = insertion_.measures();
  if (lists_changes_) [[unlikely]] {
    for (const TriangleId id : changed) changed_.push_back(QueuedTriangle::now(t_, EdgeRef(id, 0)));
  }
  if (measures.empty()) {
    for (const TriangleId id : changed) consider(id);
    return;
  }
  if (insertion_.may_touch_constraint() || assessor_.has_local_size()) {
    if (assessor_.announces_places()) [[unlikely]]
      assessor_.announce(changed, measures);
    assessor_.look_around(t_.slots[changed.front()].v[0], hints_);
    for (std::size_t i = 0; i < changed.size(); ++i)
      queue_if_bad(changed[i], assessor_.assess(changed[i], measures[i], hints_), measures[i]);
  } else {
    for (const std::size_t i : insertion_.breaking())
      queue_if_bad(changed[i], assessor_.assess_inside(changed[i], measures[i], hints_), measures[i]);
  }
}

// Ruppert's order, which the proofs that refinement ends assume (THEORY.md, Refinement): an encroached side is split
// before the triangle is.
void Task::process(QueuedTriangle triangle) {
  const TriangleId id = triangle.id();
  EdgeRef shortest = triangle.side;
  if (t_.slots[id].any_constrained() || insertion_.has_flipped()) {
    shortest = split_encroached_side(triangle);
    if (shortest.none()) return;
  }
  const Point p = assessor_.point_in(shortest, hints_);
  if (is_foreign(p)) return hand_on(triangle, p);
  switch (assessor_.searches() ? insert_best(p, id) : insertion_.insert_in_face(p, id, box_)) {
    case Outcome::inserted:
      ++result_.inserted;
      consider_changed();
      return;
    case Outcome::encroaches:
      return split_blocker(triangle);
    case Outcome::leaves_box:
      if (own_cell_only_ && violates_t1(p)) ++result_.against_promise;
      hand_on(triangle, p);
      return;
    case Outcome::too_close:
    case Outcome::refused:
      return count_refused();
  }
}

Outcome Task::insert_best(Point first, TriangleId id) {
  const Outcome outcome = insertion_.try_in_face(first, id, box_);
  if (outcome != Outcome::inserted) return outcome;
  if (insertion_.breaking().empty()) {
    insertion_.insert_tried_in_face(first);
    return outcome;
  }
  struct {
    Point point;
    std::size_t breaking;
    double squared_closest;
  } best{first, insertion_.breaking().size(), insertion_.squared_closest()};
  const Shape shape(t_, t_.slots[id]);
  const double least = least_squared_distance(shape);
  for (const CandidateCircle& circle : split_candidates(shape)) {
    for (const Point p : circle) {
      if (is_foreign(p) || insertion_.try_in_face(p, id, box_) != Outcome::inserted) continue;
      const std::size_t breaking = insertion_.breaking().size();
      const double closest = insertion_.squared_closest();
      if (closest < least || breaking > best.breaking) continue;
      if (breaking < best.breaking || closest > best.squared_closest) best = {p, breaking, closest};
    }
    if (best.breaking == 0) break;
  }
  return insertion_.insert_in_face(best.point, id, box_);
}

EdgeRef Task::split_encroached_side(QueuedTriangle triangle) {
  const TriangleId id = triangle.id();
  Assessment a = assessor_.assess(id, hints_);
  if (a.need == Assessment::Need::split_edge) {
    const EdgeRef e(id, a.side);
    const Outcome outcome = split_edge(e, id);
    if (outcome == Outcome::leaves_box) hand_on(triangle, assessor_.point_on(e));
    if (outcome == Outcome::inserted || outcome == Outcome::leaves_box) return {};
    a = assessor_.assess_inside(id, hints_);
  }
  return a.need == Assessment::Need::nothing ? EdgeRef() : EdgeRef(id, a.side);
}

// The proofs that refinement ends assume (THEORY.md, Refinement) that a point which encroaches on an edge is rejected,
// and that the edge is split instead.
void Task::split_blocker(QueuedTriangle triangle) {
  const EdgeRef blocker = insertion_.blocker();
  const bool may_be_split = !assessor_.forbidden(blocker) && !assessor_.below_floor(blocker);
  const Outcome outcome = may_be_split ? split_edge(blocker, triangle.id()) : Outcome::refused;
  if (outcome == Outcome::inserted) return consider(triangle.id());
  if (outcome == Outcome::leaves_box) return hand_on(triangle, assessor_.point_on(blocker));
  result_.blocked.push_back(triangle);
  result_.left_alone = true;
}

Outcome Task::split_edge(EdgeRef e, TriangleId on_behalf_of) {
  const Index segment = assessor_.segment_of(e);
  Outcome outcome = split_edge_at(assessor_.point_on(e), e, segment);
  if (outcome == Outcome::too_close || outcome == Outcome::refused) {
    for (const Point p : assessor_.other_points_on(e, on_behalf_of, hints_)) {
      const Outcome here = split_edge_at(p, e, segment);
      if (here == Outcome::inserted || here == Outcome::leaves_box) outcome = here;
      if (here == Outcome::inserted) break;
    }
  }
  if (outcome == Outcome::inserted) {
    ++result_.segment_splits;
    consider_changed();
  }
  if (outcome == Outcome::refused || outcome == Outcome::too_close) count_refused();
  return outcome;
}

Outcome Task::split_edge_at(Point p, EdgeRef e, Index segment) {
  if (is_foreign(p)) return Outcome::leaves_box;
  return assessor_.may_split(e, segment, p) ? insertion_.split_edge(p, e, segment, box_) : Outcome::refused;
}

void Task::count_refused() {
  ++result_.refused;
  result_.left_alone = true;
}

void Task::hand_on(QueuedTriangle triangle, Point p) {
  const Index cell = tiles_->cell_of(p);
  if (cell == cell_)
    result_.needs_larger_box.push_back(triangle);
  else
    result_.handed_on.push_back({triangle, cell});
}

// Theorem 1 (THEORY.md, T1): every corner of a cavity is closer to its point than twice the largest circumradius of the
// cavity. So if no circumradius exceeds radius_that_fits, no corner lies farther away than the margin of the box.
bool Task::violates_t1(Point p) const {
  const double fits = tiles_->radius_that_fits(cell_);
  return box_.contains_half_open(p) && insertion_.left_box_for(p, box_, fits * fits);
}

}  // namespace pardel::engine
