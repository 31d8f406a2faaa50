#include "expected_size.hpp"

#include <algorithm>
#include <numbers>
#include <vector>

#include "../arithmetic/floor.hpp"
#include "../concurrency/parallel_for.hpp"
#include "../criteria/estimates.hpp"
#include "../criteria/parts.hpp"

namespace pardel::engine {
namespace {

/// Where the size depends on the place, small sizes between the samples are missed: this much on average.
constexpr double missed = 1.25;

/// The number of equilateral triangles with edges as short as the floor that fill this one.
double most_above_floor(const Shape& s, const Floor& floor) {
  return s.twice_area / (0.5 * std::numbers::sqrt3 * floor.squared_at(s.centroid()));
}

/// How often a triangle is divided for its samples, if its centroid lets expect so many triangles.
int divisions_of(double triangles) {
  constexpr int most = 2;
  int divisions = 0;
  for (double samples = 1; divisions < most && samples < triangles; samples *= 4) ++divisions;
  return divisions;
}

}  // namespace

double expected_triangles(const Triangulation& t, const Criteria& criteria, double min_edge, const Threads& threads) {
  const Floor floor(min_edge);
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
        if (const int more = divisions_of(triangles); more > everywhere) triangles = wanted(more);
        triangles *= missed;
      }
      of_block[block] += estimate(std::max(criteria.triangles_by_shape(), triangles));
    }
  });
  double all = 0;
  for (const double triangles : of_block) all += triangles;
  return all;
}

}  // namespace pardel::engine
