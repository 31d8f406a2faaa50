#include "expected_size.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "../arithmetic/floor.hpp"
#include "../quality/estimates.hpp"
#include "../quality/parts.hpp"
#include "../threads/parallel_for.hpp"

namespace pardel::engine {
namespace {

/// Where the size depends on the place, small sizes between the samples are missed: this much on average.
constexpr double missed = 1.25;

/// Twice the area of an equilateral triangle with edges as short as the floor.
double twice_area_at_floor(const Floor& floor, Point p) { return 0.5 * std::numbers::sqrt3 * floor.squared_at(p); }

/// The number of such triangles that fill this one.
double most_above_floor(const Shape& s, const Floor& floor) {
  return s.twice_area / twice_area_at_floor(floor, s.centroid());
}

/// How often a triangle is divided for its samples, if its centroid lets expect so many triangles.
int divisions_of(double triangles) {
  constexpr int most = 2;
  int divisions = 0;
  for (double samples = 1; divisions < most && samples < triangles; samples *= 4) ++divisions;
  return divisions;
}

/// The number of triangles in one whose size depends on the place, counted from its constrained sides: sizes can grow
/// so fast from a side that all samples inside the triangle miss the small ones. So samples lie in layers along the
/// side, each of them twice as wide as the one before; the first is as wide as the small triangles there.
class TrianglesFromSides {
 public:
  TrianglesFromSides(const Criteria& criteria, const Floor& floor) : criteria_(criteria), floor_(floor) {}

  /// The largest of the numbers from each side, with 2^divisions samples in each layer.
  [[nodiscard]] double count(const Shape& shape, const Slot& slot, Index region, int divisions,
                             LocalHints& hints) const {
    double most = 0;
    for (unsigned side = 0; side < 3; ++side) {
      if (!slot.n[side].constrained()) continue;
      const int parts = 1 << divisions;
      double sum = 0;
      for (int i = 0; i < parts; ++i) sum += behind(shape, side, (i + 0.5) / parts, region, hints);
      most = std::max(most, sum / parts);
    }
    return most;
  }

 private:
  /// The number, if all lines from the side to the corner opposite were as the one that begins at this part of the
  /// side.
  [[nodiscard]] double behind(const Shape& shape, unsigned side, double part, Index region, LocalHints& hints) const {
    const Point apex = shape.p[side];
    const Point p = between(shape.p[next_corner[side]], shape.p[previous_corner[side]], part);
    const double height = shape.twice_area / std::sqrt(shape.squared[side]);
    double sum = 0, from = 0;  // as parts of the height
    for (double width = std::sqrt(twice_area_wanted(p, region, hints)) / height; from < 1; width *= 2) {
      const double to = std::min(1.0, from + width), middle = 0.5 * (from + to);
      sum += 2 * (to - from) * (1 - middle) / twice_area_wanted(between(p, apex, middle), region, hints);
      from = to;
    }
    return shape.twice_area * sum;
  }
  [[nodiscard]] static Point between(Point a, Point b, double part) {
    return {std::lerp(a.x, b.x, part), std::lerp(a.y, b.y, part)};
  }
  [[nodiscard]] double twice_area_wanted(Point p, Index region, LocalHints& hints) const {
    return std::max(criteria_.twice_area_wanted(p, region, hints), twice_area_at_floor(floor_, p));
  }

  const Criteria& criteria_;
  const Floor& floor_;
};

}  // namespace

double expected_triangles(const Triangulation& t, const Criteria& criteria, double min_edge, const Threads& threads) {
  const Floor floor(min_edge);
  const TrianglesFromSides from_sides(criteria, floor);
  const std::size_t count = t.slots.size();
  const int everywhere = divisions_for(criteria, count);
  std::vector<double> of_block(block_count(count), 0);
  parallel_blocks(threads, count, [&](std::size_t first, std::size_t last, std::size_t block) {
    LocalHints hints;
    for (std::size_t id = first; id < last; ++id) {
      const Shape shape(t, t.slots[id]);
      const Index region = t.region.empty() ? no_index : t.region[id];
      const auto wanted = [&](int divisions) {
        double sum = 0;
        visit_parts(shape, divisions, [&](const Shape& part) {
          sum += std::min(criteria.triangles_wanted(part, region, hints), most_above_floor(part, floor));
        });
        return sum;
      };
      double triangles = wanted(everywhere);
      if (criteria.depends_on_place()) {
        const int divisions = std::max(everywhere, divisions_of(triangles));
        if (divisions > everywhere) triangles = wanted(divisions);
        triangles = std::max(missed * triangles, from_sides.count(shape, t.slots[id], region, divisions, hints));
      }
      of_block[block] += estimate(std::max(criteria.triangles_by_shape(), triangles));
    }
  });
  double all = 0;
  for (const double triangles : of_block) all += triangles;
  return all;
}

}  // namespace pardel::engine
