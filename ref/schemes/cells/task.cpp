#include "task.hpp"

#include <algorithm>
#include <tuple>

namespace pardel::schemes::cells {
namespace {

/// The place of the triangle, and the side that is to be split, counted from its first corner.
using Key = std::tuple<std::array<double, 6>, int>;
Key key_of(const LinkedMesh& mesh, const Waiting& w) {
  return {place_of(mesh, w.v), w.side < 0 ? -1 : (w.side - first_corner(mesh, w.v) + 3) % 3};
}

}  // namespace

std::optional<Point> first_point(const LinkedMesh& mesh, Index t, const Bounds& bounds) {
  if (const auto side = encroached_side(mesh, t)) return bounds.small_angles().split_point(mesh, *side);
  if (!bounds.is_large(mesh, t) && !bounds.is_thin(mesh, t)) return std::nullopt;
  return circumcentre(mesh, t);
}

std::optional<Point> first_point(const LinkedMesh& mesh, const Waiting& w, const Bounds& bounds) {
  if (w.side < 0) return first_point(mesh, w.triangle, bounds);
  return bounds.small_angles().split_point(mesh, {w.triangle, w.side});
}

Task::Task(LinkedMesh& mesh, const Bounds& bounds, const Division& division, Index cell, std::vector<Waiting> list,
           bool records)
    : mesh_(mesh), bounds_(bounds), division_(division), cell_(cell), records_(records), queue_(std::move(list)) {
  std::erase_if(queue_, [&](const Waiting& w) { return !is_current(mesh_, w); });
  std::vector<std::pair<Key, Waiting>> sorted;
  sorted.reserve(queue_.size());
  for (const Waiting& w : queue_) sorted.emplace_back(key_of(mesh_, w), w);
  std::ranges::sort(sorted, [](const auto& a, const auto& b) { return a.first < b.first; });
  std::ranges::transform(sorted, queue_.begin(), [](const auto& entry) { return entry.second; });
}

bool Task::step() {
  while (next_ < queue_.size()) {
    const Waiting w = queue_[next_++];
    if (!is_current(mesh_, w)) continue;
    if (const auto insertion = insertion_of(w)) {
      carry_out_for(w, *insertion);
      return true;
    }
  }
  return false;
}

std::optional<Insertion> Task::insertion_of(const Waiting& w) {
  ++work_;
  if (w.side >= 0) return split(w, {w.triangle, w.side});
  if (const auto side = encroached_side(mesh_, w.triangle)) return split(w, *side);
  Insertion found{w.triangle, circumcentre(mesh_, w.triangle), {}, {}};
  // A point is inserted by the cell that contains it, wherever the bad triangle lies.
  if (!owns(found.point)) {
    if (division_.owns_box)
      left_box_.push_back(w);
    else
      handed_on_.push_back({w, division_.cell_of(found.point)});
    return std::nullopt;
  }
  if (!circumdisk_contains(mesh_, w.triangle, found.point)) return std::nullopt;
  found.cavity = cavity_of(mesh_, found.point, {w.triangle});
  work_ += found.work();
  if (!stays_in_box(found)) {
    left_box_.push_back(w);
    return std::nullopt;
  }
  if (records_) record(found.cavity);
  if (const auto side = blocking_side(mesh_, found.cavity, found.point)) {
    // The triangle waits until the other cell has split the side.
    if (!division_.owns_box && !owns(bounds_.small_angles().split_point(mesh_, *side))) again_.push_back(w);
    return split(w, *side);
  }
  if (!can_be_connected(mesh_, found.cavity, found.point)) return std::nullopt;
  return found;
}

std::optional<Insertion> Task::split(const Waiting& w, Side side) {
  const Point p = bounds_.small_angles().split_point(mesh_, side);
  if (!division_.owns_box && !owns(p)) {
    handed_on_.push_back({{known(mesh_, side.triangle), side.i}, division_.cell_of(p)});
    return std::nullopt;
  }
  std::optional<Insertion> found = split_of(mesh_, side, bounds_.small_angles());
  if (!found) return std::nullopt;
  work_ += found->work();
  if (!stays_in_box(*found)) {
    left_box_.push_back(w);
    return std::nullopt;
  }
  return found;
}

bool Task::owns(Point p) const {
  return division_.owns_box ? division_.in_box(cell_, p) : division_.cell_of(p) == cell_;
}

bool Task::stays_in_box(const Insertion& insertion) const {
  if (!division_.owns_box) return true;
  return owns(insertion.point) && std::ranges::all_of(insertion.cavity.triangles, [&](Index t) {
           return std::ranges::all_of(mesh_.faces[t].v, [&](Index v) { return owns(mesh_.points[v]); });
         });
}

void Task::record(const Cavity& cavity) {
  for (const Index t : cavity.triangles) {
    touched_.triangles.push_back(t);
    touched_.vertices.insert(touched_.vertices.end(), mesh_.faces[t].v.begin(), mesh_.faces[t].v.end());
  }
  for (const Side side : cavity.boundary)
    if (const Index other = mesh_.faces[side.triangle].n[side.i]; other != no_index)
      touched_.triangles.push_back(other);
}

void Task::carry_out_for(const Waiting& w, const Insertion& insertion) {
  if (records_) record(insertion.cavity);
  const std::vector<Index> made = carry_out(mesh_, insertion);
  made_.insert(made_.end(), made.begin(), made.end());
  for (const Index t : made) consider(t);
  // A triangle whose circumcentre was rejected is still there.
  if (is_current(mesh_, w)) queue_.push_back(w);
}

void Task::consider(Index t) {
  const std::optional<Point> p = first_point(mesh_, t, bounds_);
  if (!p) return;
  const Waiting w{known(mesh_, t)};
  if (!division_.is_due(mesh_, t)) {
    later_.push_back(w);
  } else if (const Index to = division_.cell_of(*p); to == cell_) {
    queue_.push_back(w);
  } else {
    handed_on_.push_back({w, to});
  }
}

}  // namespace pardel::schemes::cells
