#include "task.hpp"

#include <utility>

namespace pardel::engine {

void Task::start(const Lattice& lattice, Index cell, std::span<const Queued> seeds, const Deferral& later,
                 Supply& supply) {
  lattice_ = &lattice;
  cell_ = cell;
  box_ = lattice.box_of(cell);
  later_ = later;
  supply_ = &supply;
  insertion_.start(supply);
  result_ = {};
  for (const Queued seed : seeds) consider(seed.id());
}

bool Task::step() {
  while (!queue_.empty()) {
    const Queued next = queue_.pop();
    if (!judge_.is_current(next)) continue;  // replaced; if what replaced it is bad, it was queued too
    if (supply_->suffices())
      process(next);
    else
      give_up(next);
    return true;
  }
  return false;
}

TaskResult Task::run(const Lattice& lattice, Index cell, std::span<const Queued> seeds, const Deferral& later,
                     Supply& supply, const std::function<bool(std::uint64_t)>& go_on) {
  start(lattice, cell, seeds, later, supply);
  constexpr std::uint64_t steps_between_questions = 1024;
  std::uint64_t told = 0;
  for (std::uint64_t steps = 1; step(); ++steps) {
    if (steps % steps_between_questions != 0) continue;
    const std::uint64_t made = result_.inserted + result_.segment_splits;
    if (!go_on(made - std::exchange(told, made))) break;
  }
  while (!queue_.empty()) give_up(queue_.pop());
  return finish();
}

/// Left to another run of its own cell.
void Task::give_up(Queued triangle) {
  result_.handed_on.push_back({triangle, cell_});
  ++result_.out_of_numbers;
}

void Task::consider_changed() {
  const auto changed = insertion_.changed();
  const auto measures = insertion_.measures();
  if (measures.empty()) {
    for (const TriangleId id : changed) consider(id);
    return;
  }
  if (insertion_.may_touch_constraint() || judge_.has_local_size())
    for (std::size_t i = 0; i < changed.size(); ++i)
      queue_if_bad(changed[i], judge_.assess(changed[i], measures[i]), measures[i]);
  else
    for (const std::size_t i : insertion_.breaking())
      queue_if_bad(changed[i], judge_.assess_inside(changed[i], measures[i]), measures[i]);
}

void Task::process(Queued triangle) {
  const TriangleId id = triangle.id();
  EdgeRef shortest = triangle.side;
  const Slot& slot = t_.slots[id];
  if (slot.any_constrained() || insertion_.has_flipped()) {
    Assessment a = judge_.assess(id);
    if (a.need == Assessment::Need::split_edge) {
      const EdgeRef e(id, a.side);
      const Outcome outcome = split_edge(e);
      if (outcome == Outcome::leaves_box) hand_on(triangle, judge_.point_on(e));
      if (outcome == Outcome::inserted || outcome == Outcome::leaves_box) return;
      a = judge_.assess_inside(id);
    }
    if (a.need == Assessment::Need::nothing) return;
    shortest = EdgeRef(id, a.side);
  }
  const Point p = judge_.point_in(shortest);
  if (is_foreign(p)) return hand_on(triangle, p);
  switch (insertion_.insert_in_face(p, id, box_)) {
    case Outcome::inserted:
      ++result_.inserted;
      consider_changed();
      return;
    case Outcome::encroaches: {
      const EdgeRef blocker = insertion_.blocker();
      if (judge_.forbidden(blocker) || judge_.below_floor(blocker)) {
        result_.left_alone = true;
        return;
      }
      const Outcome outcome = split_edge(blocker);
      if (outcome == Outcome::inserted) consider(id);
      if (outcome == Outcome::leaves_box) hand_on(triangle, judge_.point_on(blocker));
      return;
    }
    case Outcome::leaves_box:
      if (own_cell_only_ && breaks_promise(p)) ++result_.against_promise;
      hand_on(triangle, p);
      return;
    case Outcome::too_close:
    case Outcome::refused:
      ++result_.refused;
      result_.left_alone = true;
      return;
  }
}

Outcome Task::split_edge(EdgeRef e) {
  const Index segment = judge_.segment_of(e);
  const Point p = judge_.point_on(e);
  if (is_foreign(p)) return Outcome::leaves_box;
  const Outcome outcome = insertion_.split_edge(p, e, segment, box_);
  if (outcome == Outcome::inserted) {
    ++result_.segment_splits;
    consider_changed();
  }
  if (outcome == Outcome::refused || outcome == Outcome::too_close) {
    ++result_.refused;
    result_.left_alone = true;
  }
  return outcome;
}

void Task::hand_on(Queued triangle, Point p) {
  const Index cell = lattice_->cell_of(p);
  if (cell == cell_)
    result_.stuck.push_back(triangle);
  else
    result_.handed_on.push_back({triangle, cell});
}

bool Task::breaks_promise(Point p) const {
  const double fits = lattice_->radius_that_fits();
  return box_.contains_half_open(p) && insertion_.left_box_for(p, box_, fits * fits);
}

}  // namespace pardel::engine
