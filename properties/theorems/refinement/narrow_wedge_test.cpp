// Narrow wedges between segments of different lengths need few triangles.
#include <cmath>

#include "meshing.hpp"

namespace pardel::properties {
namespace {

/// A square with a segment and a point near it that is joined to both ends of the segment.
Pslg some_wedges_with_a_common_side() {
  const auto coordinate = [](int from, int to) { return 0.001 * *rc::gen::inRange(1000 * from, 1000 * to); };
  const Point a{coordinate(-2, 0), coordinate(-2, 2)}, b{coordinate(1, 2), coordinate(-2, 2)};
  const double part = 0.01 * *rc::gen::inRange(5, 96);
  const double gap = std::exp2(-0.125 * *rc::gen::inRange(8 * 7, 8 * 34));
  const Point near{a.x + part * (b.x - a.x) - gap * (b.y - a.y), a.y + part * (b.y - a.y) + gap * (b.x - a.x)};
  Pslg pslg;
  pslg.points = {{-3, -3}, {3, -3}, {3, 3}, {-3, 3}, a, b, near};
  pslg.segments = {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {4, 6}, {6, 5}};
  return pslg;
}

PARDEL_PROPERTY(
    NarrowWedge, needs_few_triangles_at_any_angle,
    {.statement = "A segment, and a point near it that is joined to both ends of the segment: the mesh has "
                  "at most 160 triangles, however small the gap is, and is certified. (The most in 10,000 cases: 80.)",
     .source = "properties/THEORY.md, refinement of every input",
     .families = "a segment in a square; gaps from 2^-7 to 2^-34 of its length"}) {
  const Pslg pslg = some_wedges_with_a_common_side();
  exhibit.show(pslg);
  const Goal goal{.min_angle_deg = *rc::gen::element(20.0, 25.0, 28.0), .region_caps = false};
  const Meshed result = value_of(mesh(pslg, goal, {.max_vertices = 2'000}));
  exhibit.show(pslg, result.mesh);
  RC_ASSERT(result.mesh.triangles.size() <= 160U);
  RC_ASSERT(result.report.goal_met());
  require_valid(check(pslg, result.mesh, goal));
}

}  // namespace
}  // namespace pardel::properties
