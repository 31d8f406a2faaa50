#include "task.hpp"

#include "flips.hpp"

namespace pardel {

bool Judge::forbidden(EdgeRef e) const {
  return options_.no_segment_splits || (options_.no_boundary_splits && t_.slot(e).n[e.side()].none());
}

bool Judge::below_floor(EdgeRef e) const {
  const Point a = t_.points[t_.slot(e).from(e.side())], b = t_.points[t_.slot(e).to(e.side())];
  return (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y) < 4 * squared_floor_;
}

bool Judge::encroached(const Slot& slot, const Shape& shape, TriangleId id, unsigned side) const {
  if (criteria_.encroaches(shape.dot_at(side), shape.squared[next_corner[side]], shape.squared[previous_corner[side]]))
    return true;
  return criteria_.conforming() && !slot.n[side].none() && !delaunay_across(t_, EdgeRef(id, side));
}

Assessment Judge::assess(TriangleId id) const {
  const Slot& slot = t_.slots[id];
  const Shape shape(t_, slot);
  Assessment result;
  result.longest_squared = shape.longest_squared();
  for (unsigned side = 0; side < 3; ++side) {
    if (!slot.n[side].constrained() || !encroached(slot, shape, id, side)) continue;
    const EdgeRef e(id, side);
    if (forbidden(e) || below_floor(e)) continue;
    result.need = Assessment::Need::split_edge;
    result.side = side;
    result.key = BucketQueue::urgent;
    return result;
  }
  const double shortest = shape.squared[shape.shortest];
  if (shortest < squared_floor_) return result;
  const bool bad = criteria_.too_large(shape, region_of(id)) ||
                   (criteria_.bad_shape(shape) && !small_angle(t_, lines_, slot, shape));
  if (bad) {
    result.need = Assessment::Need::split_triangle;
    result.key = BucketQueue::key(shortest);
  }
  return result;
}

bool Judge::breaks_goal(TriangleId id) const {
  const Shape shape(t_, t_.slots[id]);
  return criteria_.bad_shape(shape) || criteria_.too_large(shape, region_of(id));
}

Index Judge::line_of(EdgeRef e) const {
  const Slot& slot = t_.slot(e);
  return lines_.line_of(t_, slot.from(e.side()), slot.to(e.side()));
}

Point Judge::point_on(EdgeRef e) const {
  const Slot& slot = t_.slot(e);
  return edge_split_point(t_, lines_[line_of(e)], slot.from(e.side()), slot.to(e.side()));
}

Point Judge::point_for(TriangleId id, const Assessment& a) const {
  return a.need == Assessment::Need::split_edge ? point_on(EdgeRef(id, a.side))
                                                : criteria_.split_point(Shape(t_, t_.slots[id]));
}

bool Task::run(const Lattice& lattice, Index cell, std::span<const TriangleId> seeds, const Deferral& later) {
  lattice_ = &lattice;
  cell_ = cell;
  box_ = lattice.box_of(cell);
  later_ = later;
  handed_on.clear();
  for (const TriangleId id : seeds) consider(id);
  while (!queue_.empty()) {
    if (!may_go_on()) return false;
    process(queue_.pop());
  }
  return true;
}

void Task::consider(TriangleId id) {
  const Assessment a = judge_.assess(id);
  if (a.need == Assessment::Need::nothing) return;
  if (later_.applies_to(a))
    deferred.push_back(id);
  else
    queue_.push(id, a.key);
}

/// The queue's entry may be stale, its triangle long replaced by another in the same slot: what the slot
/// holds now is assessed again, and that is all that counts.
void Task::process(TriangleId id) {
  const Assessment a = judge_.assess(id);
  if (a.need == Assessment::Need::nothing || later_.applies_to(a)) return;
  if (a.need == Assessment::Need::split_edge) {
    const EdgeRef e(id, a.side);
    const Outcome outcome = split_edge(e);
    if (outcome == Outcome::leaves_box) hand_on(id, judge_.point_on(e));
    return;
  }
  const Point p = judge_.point_for(id, a);
  switch (insertion_.insert_in_face(p, id, box_)) {
    case Outcome::inserted:
      ++inserted;
      for (const TriangleId changed : insertion_.changed()) consider(changed);
      return;
    case Outcome::encroaches: {
      const EdgeRef blocker = insertion_.blocker();
      if (judge_.forbidden(blocker) || judge_.below_floor(blocker)) return;
      const Outcome outcome = split_edge(blocker);
      if (outcome == Outcome::inserted) consider(id);
      if (outcome == Outcome::leaves_box) hand_on(id, judge_.point_on(blocker));
      return;
    }
    case Outcome::leaves_box:
      hand_on(id, p);
      return;
    case Outcome::refused:
      ++refused;
      return;
  }
}

Outcome Task::split_edge(EdgeRef e) {
  const Index line = judge_.line_of(e);
  const Outcome outcome = insertion_.split_edge(judge_.point_on(e), e, line, box_);
  if (outcome == Outcome::inserted) {
    ++segment_splits;
    for (const TriangleId changed : insertion_.changed()) consider(changed);
  }
  if (outcome == Outcome::refused) ++refused;
  return outcome;
}

void Task::hand_on(TriangleId id, Point p) {
  const Index cell = lattice_->cell_of(p);
  if (cell == cell_)
    stuck.push_back(id);
  else
    handed_on.push_back({id, cell});
}

bool Task::may_go_on() {
  if (options_.max_vertices > 0 && t_.points.size() >= options_.max_vertices) budget_reached = true;
  constexpr std::uint64_t steps_between_reports = 4096;
  if (options_.progress && ++steps_ % steps_between_reports == 0 && !options_.progress({t_.slots.size(), 0}))
    cancelled = true;
  return !budget_reached && !cancelled;
}

}  // namespace pardel
