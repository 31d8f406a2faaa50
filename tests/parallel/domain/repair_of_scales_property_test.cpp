// repair() without a given snapping distance, of random segments that cross, overlap, touch and nearly touch, at mixed
// scales.
#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include "../../../parallel/repair.hpp"
#include "../../../properties/domains/generators/mixed_scales.hpp"
#include "../../../properties/theorems/framework/property.hpp"
#include "../../../properties/theorems/framework/rapidcheck_generators.hpp"
#include "../../../properties/theorems/framework/shares.hpp"
#include "../shapes.hpp"
#include "drawing.hpp"

namespace pardel::engine {
namespace {

using generators::Mixed;
using generators::Mixture;
using generators::Random;
using testing::Drawing;

/// A mess: segments between a few points of a lattice that cross, overlap and touch, inside a square outline.
/// `is_torn`: each end is a point of its own, a few roundings beside the common point. In one of 16 cases it is farther
/// away; such a gap is tiny only beside long segments.
Pslg random_mess(Random& random, bool is_torn) {
  const int side = random.between(3, 40);
  std::vector<Point> places;
  for (int left = random.between(2, 8); left > 0; --left)
    places.push_back({1.0 * random.between(1, side), 1.0 * random.between(1, side)});
  Pslg pslg;
  const auto add_point = [&](Point p) {
    const double step = !is_torn ? 0 : random.chance(16) ? 0x1p-36 : 0x1p-44;
    pslg.points.push_back({p.x + step * random.between(-4, 4), p.y + step * random.between(-4, 4)});
    return static_cast<Index>(pslg.points.size() - 1);
  };
  // Bundles of many copies of a segment cross so often that a snapping distance may fail.
  std::multiset<std::pair<std::size_t, std::size_t>> joined;
  for (int left = random.between(1, 12), marker = 1; left > 0; --left, ++marker) {
    const std::size_t i = random.below(places.size()), j = random.below(places.size());
    const Point a = places[i], b = places[j];
    if (a == b || joined.count(std::minmax(i, j)) == 2) continue;
    joined.insert(std::minmax(i, j));
    const Index from = add_point(a), to = add_point(b);
    pslg.segments.push_back({from, to, marker});
  }
  for (int left = random.between(0, 3); left > 0; --left) add_point(random.one_of(places));
  testing::add_square(pslg, side + 1, {0, 0});
  return pslg;
}

/// Two messes, one of them much smaller, or one mess and far points.
Mixed mixed_mess(Random& random, int) {
  while (true) {
    const bool is_torn = !random.chance(3);
    const Pslg domain = random_mess(random, is_torn), other = random_mess(random, is_torn);
    Mixed mixed = generators::mixed_scales(domain, other, random);
    const Mixture what = mixed.what.empty() ? Mixture::tiny_feature : mixed.what.front();
    if (what == Mixture::component_beside || what == Mixture::component_far_off || what == Mixture::far_points_outside)
      return mixed;
  }
}

PARDEL_PROPERTY(
    Repair, of_a_domain_of_mixed_scales_is_that_of_its_parts_alone,
    {.statement = "by default the repair of two parts of different scales gives the points and segments that "
                  "it gives for each part alone, and far points change nothing",
     .source = "parallel/repair.hpp",
     .families =
         "two sets of segments that cross, overlap and touch, with ends torn apart, one far smaller, or far from "
         "the origin; far points"}) {
  const Mixed mixed = *generators::generator(mixed_mess, [](const Mixed&) { return std::vector<Mixed>(); });
  exhibit.show(mixed.pslg);
  Drawing expected;
  std::size_t points = 0;
  for (const Pslg& part : mixed.parts) {
    const Result<Repaired> alone = repair(part);
    // If a distance fails for one part, a smaller one is tried for all.
    const bool has_failed = !alone || alone->snap < default_snap(part);
    RC_PRE(!has_failed);
    expected.add(alone->domain.pslg());
    points += part.points.size();
  }
  for (std::size_t far = points; far < mixed.pslg.points.size(); ++far)
    expected.points.insert({mixed.pslg.points[far].x, mixed.pslg.points[far].y});
  properties::classify(mixed.parts.size() > 1, "two parts", 30);
  properties::classify(expected.points.size() < mixed.pslg.points.size(), "something is merged", 30);
  const Result<Repaired> both = repair(mixed.pslg);
  RC_ASSERT(both.ok());
  const Drawing found(both->domain.pslg());
  RC_ASSERT(found.segments == expected.segments);
  // Far points may be merged with each other.
  RC_ASSERT(std::ranges::includes(expected.points, found.points));
  RC_ASSERT(found.points.size() + 3 >= expected.points.size());
}

}  // namespace
}  // namespace pardel::engine
