// Two segments run close to each other where a triangle with a side on one of them is flat. From a few places of that
// side, a walk straight across the triangulation finds the other segment.
#include "find_least_size.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "../arithmetic/distance.hpp"
#include "../arithmetic/floor.hpp"
#include "../threads/parallel_arrays.hpp"
#include "../triangulation/triangle_shape.hpp"
#include "straight_walk.hpp"

namespace pardel::engine {
namespace {

constexpr double flat = 1000;  ///< wider parts require too few triangles to matter

/// True if a constrained side of the triangle is so much longer than the triangle is high.
bool stands_on_flat_side(const Triangulation& t, const Slot& slot) {
  if (!slot.any_constrained()) return false;
  const Shape shape(t, slot);
  for (unsigned side = 0; side < 3; ++side)
    if (slot.n[side].constrained() && flat * shape.twice_area < shape.squared[side]) return true;
  return false;
}

class LeastSizeSearch {
 public:
  LeastSizeSearch(const DomainTriangulation& domain, double min_angle_deg, double min_edge)
      : domain_(domain),
        t_(domain.triangulation),
        edges_(std::tan(min_angle_deg * std::numbers::pi / 180) / 2),
        floor_(min_edge) {}

  void examine(TriangleId id) {
    for (unsigned side = 0; side < 3; ++side)
      if (t_.slots[id].n[side].constrained()) examine(EdgeRef(id, side));
  }

  [[nodiscard]] const LeastSize& found() const { return found_; }

 private:
  /// Examines the parts of a constrained side one by one: other segments may face each of them.
  void examine(EdgeRef base) {
    const Slot& slot = t_.slot(base);
    const Point a = t_.points[slot.from(base.side())], b = t_.points[slot.to(base.side())];
    constexpr int parts = 4;
    for (int i = 0; i < parts; ++i) {
      const double middle = (i + 0.5) / parts;
      const StraightWalk walk(t_, {a.x + middle * (b.x - a.x), a.y + middle * (b.y - a.y)}, a, b);
      const EdgeRef opposite = walk.to_constraint(walk.exit(base));
      if (!opposite.none() && are_apart(base, opposite))
        add(a, b, opposite, static_cast<double>(i) / parts, static_cast<double>(i + 1) / parts);
    }
  }

  [[nodiscard]] Index segment_of(EdgeRef e) const {
    const Slot& slot = t_.slot(e);
    return domain_.segments.segment_of(t_, slot.from(e.side()), slot.to(e.side()));
  }
  [[nodiscard]] bool are_apart(EdgeRef e, EdgeRef f) const {
    const Index s = segment_of(e), u = segment_of(f);
    return s != u && domain_.segments.shared_end(s, u) == no_index;
  }

  /// Adds the edges on the part of a-b between `first` and `last`, as fractions of its length, as far as `opposite`
  /// faces it.
  void add(Point a, Point b, EdgeRef opposite, double first, double last) {
    const Slot& slot = t_.slot(opposite);
    const Point u = t_.points[slot.from(opposite.side())], v = t_.points[slot.to(opposite.side())];
    const double length = distance(a, b);
    const auto place = [&](Point p) {
      return ((b.x - a.x) * (p.x - a.x) + (b.y - a.y) * (p.y - a.y)) / (length * length);
    };
    const auto height = [&](Point p) {
      return std::abs((b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x)) / length;
    };
    const double at_u = place(u), at_v = place(v);
    first = std::max(first, std::min(at_u, at_v));
    last = std::min(last, std::max(at_u, at_v));
    if (!(first < last)) return;
    const auto height_at = [&](double at) {
      return height(u) + (height(v) - height(u)) * ((at - at_u) / (at_v - at_u));
    };
    const double width = std::max(height_at(first), height_at(last));
    const double triangles = (last - first) * length * edges_ / width, middle = (first + last) / 2;
    const Point where{a.x + middle * (b.x - a.x), a.y + middle * (b.y - a.y)};
    if (!(width >= floor_.at(where))) return;
    found_.triangles += triangles;
    if (triangles <= most_) return;
    most_ = triangles;
    found_.width = width;
    found_.where = where;
  }

  const DomainTriangulation& domain_;
  const Triangulation& t_;
  double edges_;  ///< the least number of edges on a segment, for a length equal to the width
  Floor floor_;
  double most_ = 0;
  LeastSize found_;
};

}  // namespace

LeastSize find_least_size(const DomainTriangulation& domain, double min_angle_deg, double min_edge,
                          const Threads& threads) {
  const Triangulation& t = domain.triangulation;
  if (!(min_angle_deg > 0)) return {};
  const Array<Index> thin =
      indices_where(threads, t.slots.size(), [&](std::size_t id) { return stands_on_flat_side(t, t.slots[id]); });
  LeastSizeSearch search(domain, min_angle_deg, min_edge);
  SparseAsk ask(threads.stop);
  for (const TriangleId id : thin) {
    ask();
    search.examine(id);
  }
  LeastSize found = search.found();
  found.expected = LeastSize::most_likely * found.triangles;
  return found;
}

}  // namespace pardel::engine
