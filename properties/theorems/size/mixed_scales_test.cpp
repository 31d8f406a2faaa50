// The figures that tell how small the triangles of a part of a domain have to be do not depend on parts of other
// scales, nor on far points: the least number of triangles, gaps, and edge lengths.
#include "../refinement/mixed_scales.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include "../../../parallel/gaps.hpp"
#include "../../../parallel/least_size.hpp"
#include "../../../parallel/sizes.hpp"
#include "../framework/shares.hpp"

namespace pardel::properties {
namespace {

using generators::Mixture;

constexpr double relative_rounding = 1e-9;
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr const char* flat_families =
    "lattice domains of every family, up to 2^26 times as wide as high; far points outside, or a component up to 2^60 "
    "times smaller beside the domain or in a hole, or one far off";

ValidPslg valid(const Pslg& pslg) {
  auto domain = validate(pslg);
  if (!domain) RC_FAIL(domain.error().front().message());
  return std::move(*domain);
}

/// Far points outside, or two components.
std::vector<Mixture> separate_parts() {
  std::vector<Mixture> mixtures = mixtures_of_components;
  mixtures.push_back(Mixture::far_points_outside);
  return mixtures;
}

/// All heights are divided by a power of two, so that there are narrow places. Vertical segments become short.
void flatten(Pslg& pslg, int power) {
  for (Point& p : pslg.points) p.y = std::ldexp(p.y, -power);
  for (Point& p : pslg.holes) p.y = std::ldexp(p.y, -power);
  for (Region& region : pslg.regions) region.seed.y = std::ldexp(region.seed.y, -power);
}

/// Separate parts, flattened.
generators::Mixed some_flat_parts(Exhibit& exhibit, int least_power) {
  generators::Mixed mixed = some_mixed_problem(exhibit, separate_parts()).mixed;
  const int power = *rc::gen::inRange(least_power, 27);
  flatten(mixed.pslg, power);
  for (Pslg& part : mixed.parts) flatten(part, power);
  RC_PRE(find_problems(mixed.pslg).empty());  // coordinates can become too small
  exhibit.show(mixed.pslg);
  return mixed;
}

double least_size_of(const Pslg& pslg, double min_angle_deg) {
  const Result<LeastSize> found = least_size(valid(pslg), min_angle_deg);
  if (!found) RC_FAIL(found.error().message);
  return found->triangles;
}

PARDEL_PROPERTY(LeastSize, is_the_sum_of_those_of_the_components,
                {.statement = "The least number of triangles that narrow parts of a domain require is the sum of those "
                              "of its components. Far points outside change nothing.",
                 .source = "parallel/least_size.hpp",
                 .families = flat_families}) {
  const generators::Mixed mixed = some_flat_parts(exhibit, 8);
  const double angle = *rc::gen::element(20.7, 30.0);
  double sum = 0;
  for (const Pslg& part : mixed.parts) sum += least_size_of(part, angle);
  classify(sum > 0, "there are narrow parts", 30);
  RC_ASSERT(std::abs(least_size_of(mixed.pslg, angle) - sum) <= 1e-6 * sum);
}

std::vector<Gap> gaps_of(const Pslg& pslg) {
  const Result<std::vector<Gap>> found = find_gaps(valid(pslg));
  if (!found) RC_FAIL(found.error().message);
  return *found;
}

bool is_the_same(const Gap& gap, const Gap& alone, Index first_point, Index first_segment) {
  std::vector<Index> points = alone.points;
  for (Index& p : points) p += first_point;
  const Index segment = alone.segment == no_index ? no_index : alone.segment + first_segment;
  return gap.kind == alone.kind && gap.points == points && gap.segment == segment && gap.distance == alone.distance &&
         gap.surroundings == alone.surroundings && gap.where == alone.where;
}

PARDEL_PROPERTY(Gaps, of_a_component_are_found_beside_others,
                {.statement = "Every gap of a component is found, with the same distance and the same surroundings, "
                              "where there are components of other scales, or far points outside.",
                 .source = "parallel/gaps.hpp",
                 .families = flat_families}) {
  const generators::Mixed mixed = some_flat_parts(exhibit, 20);
  const std::vector<Gap> whole = gaps_of(mixed.pslg);
  Index first_point = 0, first_segment = 0;
  bool any = false;
  for (const Pslg& part : mixed.parts) {
    for (const Gap& alone : gaps_of(part)) {
      any = true;
      RC_ASSERT(std::ranges::any_of(
          whole, [&](const Gap& gap) { return is_the_same(gap, alone, first_point, first_segment); }));
    }
    first_point += static_cast<Index>(part.points.size());
    first_segment += static_cast<Index>(part.segments.size());
  }
  classify(any, "there are gaps", 20);
}

std::function<double(Point)> size_of(const Pslg& pslg, const Goal& goal) {
  Result<std::function<double(Point)>> size = allowed_size(valid(pslg), goal);
  if (!size) RC_FAIL(size.error().message);
  return std::move(*size);
}

/// A place in the bounding box of the points, or one of them.
Point some_place(const std::vector<Point>& points) {
  const auto some = [&] { return points[*rc::gen::inRange<std::size_t>(0, points.size())]; };
  const Point p = some(), q = some(), r = some();
  const double share = *rc::gen::inRange(0, 9) / 8.0;
  return {p.x + share * (q.x - p.x), p.y + share * (r.y - p.y)};
}

PARDEL_PROPERTY(WantedLength, of_a_domain_does_not_depend_on_far_points,
                {.statement = "Far points outside do not change the lengths that the features of a domain ask for.",
                 .source = "docs/sizes.md",
                 .families = "lattice domains of every family; one to three points outside, 2^10 to 2^198 times as "
                             "far away as the domain reaches"}) {
  const MixedProblem drawn = some_mixed_problem(exhibit, {Mixture::far_points_outside});
  const Pslg& alone = drawn.mixed.parts.front();
  Goal goal;
  const int kind = *rc::gen::inRange(0, 3);
  if (kind != 0) goal.feature_edges = *rc::gen::element(0.5, 1.0, 3.0);
  if (kind != 1) goal.grading = *rc::gen::element(0.15, 0.3, 1.0);
  const auto expected = size_of(alone, goal), found = size_of(drawn.problem.pslg, goal);
  classify(expected(alone.points.front()) < infinity, "a length is asked for", 90);
  for (int i = 0; i < 10; ++i) {
    const Point p = some_place(alone.points);
    RC_ASSERT(std::abs(found(p) - expected(p)) <= relative_rounding * expected(p));
  }
}

}  // namespace
}  // namespace pardel::properties
