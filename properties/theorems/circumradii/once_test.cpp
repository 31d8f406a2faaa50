// T2-once: circumradii are measured once, before points are inserted in any order, and the bound holds ever after.
// Proof: properties/THEORY.md, T2-once.
#include <algorithm>
#include <optional>

#include "../../../ref/constrained.hpp"
#include "../../../ref/insertion.hpp"
#include "../../../ref/radius_bound.hpp"
#include "../framework/property.hpp"
#include "../framework/rapidcheck_generators.hpp"
#include "../framework/scene_carving.hpp"
#include "../framework/scenes.hpp"
#include "../framework/shares.hpp"
#include "lens.hpp"

namespace pardel::properties {
namespace {
using generators::Random;
using ref::ExactPoint;
using ref::Number;

/// A split point p of one segment, and a subsegment mn of another one whose diametral circle contains p.
struct Split {
  Pslg pslg;  ///< segments 0 and 1
  ExactPoint m, n, p;
  bool is_apart = false;    ///< the segments have no common point
  bool is_at_apex = false;  ///< m is the common end
  int start = 16;           ///< the bound at the start, in 16ths of |mn| / 2
};
std::ostream& operator<<(std::ostream& out, const Split& s) {
  return out << "m (" << s.m << "), n (" << s.n << "), p (" << s.p << "), r = " << s.start << "/16";
}

/// The point of the segment from a to b at this share of its length.
ExactPoint along(const ExactPoint& a, const ExactPoint& b, const Number& share) { return a + share * (b - a); }

/// The segments have a common end, at an angle from 2 to 90 degrees. The subsegment begins there, or it ends at most
/// three times as far away as it begins.
Split at_a_corner(Random& random) {
  Split s;
  s.is_at_apex = random.chance(2);
  const bool is_near_thirty_degrees = !s.is_at_apex && random.chance(2);
  const int u = random.between(is_near_thirty_degrees ? 15 : 1, 30);
  const int v = is_near_thirty_degrees ? static_cast<int>(u * 0.5773) : random.between(1, 30);
  s.pslg.points = {{0, 0}, {4096, 0}, {128.0 * u, 128.0 * v}};
  s.pslg.segments = {{0, 1}, {0, 2}};
  const ExactPoint apex(0, 0);
  // |an| is 60 / (20 + near) times as long as |am|.
  const int near = is_near_thirty_degrees || s.is_at_apex ? 0 : random.between(0, 20);
  s.n = {Number(60), 0};
  s.m = {s.is_at_apex ? Number(0) : Number(20 + near), 0};
  // On the ray, the diametral circle lies between these distances; p is anywhere between them.
  const Number k = s.m.x(), l = s.n.x(), length = std::sqrt(1.0 * u * u + 1.0 * v * v);
  const double cosine = u / CGAL::to_double(length), sum = CGAL::to_double(k + l) * cosine;
  const double squared = sum * sum - 4 * CGAL::to_double(k * l), root = std::sqrt(std::max(0.0, squared));
  const double distance = (sum - root) / 2 + root * random.between(1, 255) / 256;
  s.p = along(apex, ExactPoint(u, v), Number(distance) / length);
  return s;
}

/// The segments have no common point.
Split side_by_side(Random& random) {
  const int height = random.between(1, 255);
  const int reach = static_cast<int>(std::sqrt(256.0 * 256 - height * height)) - 1;
  const int x = random.chance(2) ? random.between(-reach / 8, reach / 8) : random.between(-reach, reach);
  const int along_x = random.between(1, 512), rise = random.chance(2) ? 0 : random.between(1 - height, height - 1);
  Split s;
  s.is_apart = true;
  // p divides the segment 1 as 1 : 2 to 2 : 1.
  const int part = random.between(8, 16), other = 24 - part;
  const double left = part / 8.0, right = other / 8.0;
  s.pslg.points = {{-256, 0},
                   {256, 0},
                   {x - along_x * left, height - rise * left / 2},
                   {x + along_x * right, height + rise * right / 2}};
  s.pslg.segments = {{0, 1}, {2, 3}};
  s.m = ref::exact(s.pslg.points[0]);
  s.n = ref::exact(s.pslg.points[1]);
  s.p = along(ref::exact(s.pslg.points[2]), ref::exact(s.pslg.points[3]), Number(part) / 24);
  return s;
}

Split some_split(Random& random, int /*size*/) {
  Split s = random.chance(2) ? at_a_corner(random) : side_by_side(random);
  s.start = random.chance(2) ? 16 : random.between(17, 32);
  return s;
}

PARDEL_PROPERTY(T2Once, a_split_point_in_the_circle_of_another_segment_keeps_the_bound,
                {.statement = "The split point p of a segment lies strictly inside the diametral circle of a "
                              "subsegment mn of another segment, with |mn| ≤ 2 r. The circumradius of (m, n, p) is at "
                              "most r / sin φ if the segments meet in m at the angle φ; less than half of that if they "
                              "meet farther along mn and n is at most three times as far away from their common end "
                              "as m; and at most (r/λ + λ/r) r / 2 if they are λ ≤ r apart.",
                 .source = "properties/THEORY.md, T2-once",
                 .families = "two segments with a common end at 2 to 88 degrees, or above each other at any distance "
                             "and slope; split points between a third and two thirds"}) {
  const auto none = [](const Split&) { return std::vector<Split>{}; };
  const Split s = *generators::generator(some_split, none).as("segments");
  RC_PRE((s.m - s.p) * (s.n - s.p) < 0);
  const Number squared_start = CGAL::squared_distance(s.m, s.n) / 4 * s.start * s.start / 256;
  const bool is_farther = !s.is_apart && !s.is_at_apex;
  const Number squared_bound = squared_start * ref::squared_growth_bound(s.pslg, squared_start) / (is_farther ? 4 : 1);
  const Number squared = CGAL::squared_radius(s.m, s.n, s.p);
  RC_ASSERT(squared <= squared_bound);
  const bool is_near = CGAL::to_double(squared / squared_bound) > 0.81;  // 0.9 of the bound
  classify(s.is_at_apex && is_near, "m is the common end, more than 0.9 of the bound", 4);
  classify(is_farther, "m is not the common end", 12);
  classify(is_farther && CGAL::to_double(squared / squared_bound) > 0.64, "m is not the common end, more than 0.8", 6);
  classify(s.is_apart && is_near, "no common point, more than 0.9 of the bound", 4);
}

/// The walls of a mesh on which p may not lie strictly inside a lens: those on the boundary of its cavity.
bool lies_in_a_lens(const ref::PlainMesh& mesh, const ExactPoint& p, const Lens& lens) {
  return std::ranges::any_of(ref::boundary(mesh, ref::cavity(mesh, p)), [&](const ref::Edge& e) {
    return mesh.constraints.contains(ref::edge(e[0], e[1])) && lens.contains(p, mesh.points[e[0]], mesh.points[e[1]]);
  });
}

/// A split point of a subsegment, between a third and two thirds of it. One half of the splits are those of the
/// shortest subsegment at some input vertex, so that others stay encroached.
ExactPoint some_split_point(Random& random, const ref::PlainMesh& mesh, std::size_t inputs) {
  std::vector<ref::Edge> walls(mesh.constraints.begin(), mesh.constraints.end());
  const auto length = [&](const ref::Edge& e) { return CGAL::squared_distance(mesh.points[e[0]], mesh.points[e[1]]); };
  if (random.chance(2)) {
    const Index apex = static_cast<Index>(random.below(inputs));
    std::vector<ref::Edge> at_apex = walls;
    std::erase_if(at_apex, [&](const ref::Edge& e) { return e[0] != apex && e[1] != apex; });
    if (!at_apex.empty()) walls = {*std::ranges::min_element(at_apex, {}, length)};
  }
  const ref::Edge e = random.one_of(walls);
  return along(mesh.points[e[0]], mesh.points[e[1]], Number(random.between(8, 16)) / 24);
}

PARDEL_PROPERTY(T2Once, one_measurement_bounds_all_circumradii_of_a_run_in_any_order,
                {.statement = "In a carved domain, measure the largest circumradius r once. Then split subsegments "
                              "between a third and two thirds and insert points outside all lenses, in a random order, "
                              "however many subsegments are encroached. No circumradius ever exceeds r max(1, "
                              "1 / sin 2α, 1 / sin θ, (r/λ + λ/r) / 2).",
                 .source = "properties/THEORY.md, T2-once",
                 .families = "all layouts, walls and positions of carved random scenes; up to 12 splits and points; "
                             "lenses of angle bounds from 20.6 to 32 degrees"}) {
  const MeshedScene meshed = *scenes({.carved = true, .insertions = 3, .on_walls = true}).as("scene");
  exhibit.show(meshed.scene);
  tag_families(meshed);
  RC_PRE(!meshed.mesh.constraints.empty());
  Random random(*rc::gen::arbitrary<std::uint64_t>().as("seed"));
  const Lens lens(Number(*rc::gen::inRange(24, 41).as("64 times the tangent of the bound")) / 64);
  Pslg pslg;
  pslg.points = meshed.scene.points;
  for (const ref::Edge& wall : meshed.mesh.constraints) pslg.segments.push_back({wall[0], wall[1]});
  const Number growth = ref::squared_growth_bound(pslg, meshed.squared_bound);
  const Number bound = meshed.squared_bound * std::max(growth, Number(1 / lens.squared_sine));

  ref::PlainMesh mesh = meshed.mesh;
  std::vector<Point> inside = meshed.scene.insertions;
  Number largest = meshed.squared_bound;
  int splits = 0;
  for (int step = 0; step < 12; ++step) {
    ExactPoint p;
    if (random.chance(4) && !inside.empty()) {
      p = ref::exact(inside.back());
      inside.pop_back();
      if (std::ranges::count(mesh.points, p) != 0 || ref::constraint_through(mesh, p)) continue;
      if (lies_in_a_lens(mesh, p, lens)) continue;
    } else {
      p = some_split_point(random, mesh, pslg.points.size());
      ++splits;
    }
    const Index inserted = ref::insert(mesh, p);
    for (const ref::Corners& t : mesh.triangles)
      if (std::ranges::count(t, inserted) != 0) largest = std::max(largest, squared_circumradius(mesh, t));
    RC_ASSERT(largest <= bound);
  }
  classify(splits >= 6, "six or more splits", 80);
  classify(largest > meshed.squared_bound, "circumradii grew", 14);
  classify(largest > meshed.squared_bound && 4 * largest > bound, "grew to more than half of the bound", 7);
}

/// Inserts p into the mesh of a convex polygon whose sides are walls. Returns the largest r² of all triangles.
Number largest_after(ref::PlainMesh& mesh, const ExactPoint& p) {
  ref::insert(mesh, p);
  return squared_circumradius_bound(mesh);
}

PARDEL_FACT(
    T2Once, each_term_is_needed,
    {.statement = "The bound of T2-once is attained in the limit: by a point on the border of a lens, by splits "
                  "of one side of a corner while the other side stays encroached, and by a split in a channel.",
     .source = "properties/THEORY.md, T2-once",
     .families = "a right triangle, a right triangle with a corner of sine 3/5, a rectangle of 64 by 1"}) {
  {  // 1 / sin 2α, with tan α = 1/2: the lens of the side from (-1, 0) to (1, 0) ends at (0, 1/2).
    ref::PlainMesh mesh = ref::constrained_delaunay({{-1, 0}, {1, 0}, {0, 1}}, {{0, 1}, {1, 2}, {0, 2}});
    EXPECT_EQ(squared_circumradius_bound(mesh), 1);
    const Number bound = 1 / Lens(Number(1) / 2).squared_sine;
    const Number largest = largest_after(mesh, {0, Number(1) / 2 + Number(0x1p-20)});
    EXPECT_LE(largest, bound);
    EXPECT_GT(largest * Number(1.001), bound);
    ++facts.cases;
  }
  {  // 1 / sin θ: the subsegment at the corner is split again and again.
    ref::PlainMesh mesh = ref::constrained_delaunay({{0, 0}, {25, 0}, {16, 12}}, {{0, 1}, {1, 2}, {0, 2}});
    const Number start = squared_circumradius_bound(mesh), bound = start * 25 / 9;
    EXPECT_EQ(start, Number(625) / 4);
    Number largest = start;
    for (ExactPoint end(16, 12); ++facts.cases <= 8;) {
      end = along({0, 0}, end, Number(1) / 3);
      largest = std::max(largest, largest_after(mesh, end));
      EXPECT_LE(largest, bound);
    }
    EXPECT_GT(largest * Number(1.01), bound);
  }
  {  // (r/λ + λ/r) / 2: a long side of a thin rectangle is halved.
    ref::PlainMesh mesh =
        ref::constrained_delaunay({{0, 0}, {64, 0}, {64, 1}, {0, 1}}, {{0, 1}, {1, 2}, {2, 3}, {0, 3}});
    const Number start = squared_circumradius_bound(mesh), bound = start * (start + 2 + 1 / start) / 4;
    const Number largest = largest_after(mesh, {32, 1});
    EXPECT_LE(largest, bound);
    EXPECT_GT(largest * Number(1.001), bound);
    ++facts.cases;
  }
}

}  // namespace
}  // namespace pardel::properties
