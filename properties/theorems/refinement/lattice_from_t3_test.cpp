// Lattice (f): the decomposition of [CC] as the paper runs it. The lattice is computed from a bound on ratios and a
// bound on areas, before a mesh exists.
#include <algorithm>
#include <cmath>

#include "../../../ref/insertion.hpp"
#include "../../checker/check.hpp"
#include "../circumradii/ratio_and_area.hpp"
#include "../framework/shares.hpp"
#include "refined_channels.hpp"

namespace pardel::properties {
namespace {
using generators::Random;
using ref::Number;
using ref::RadiusTheorem;

constexpr const char* sized_channels =
    "channels: bars, bends, rings and slants, with walls, cracks, area caps and moved corners; bounds by T3 or "
    "T3-sharp "
    "from half the width of the channel to a little more than the width";

/// A channel and the theorem that sizes its cells.
struct Sized {
  Channel channel;
  RadiusTheorem theorem = RadiusTheorem::t3;
};
std::ostream& operator<<(std::ostream& out, const Sized& sized) {
  return out << sized.channel << (sized.theorem == RadiusTheorem::t3 ? "; T3" : "; T3-sharp");
}

/// r⁴ / Δ̄² as the theorem bounds it, without the code of ref/, so that a slip there does not go unnoticed.
Number fourth_power_over_squared_area(const Goal& goal, RadiusTheorem theorem) {
  const double sine = std::sin(goal.min_angle_deg * std::acos(-1.0) / 180);
  const Number ratio = Number(1) / Number(4 * sine * sine);
  return theorem == RadiusTheorem::t3 ? paper_bound(ratio, 1) : sharp_bound(ratio, 1);
}

Sized some_sized_channel(Random& random, int size) {
  Sized sized{random_channel(random, size), random.chance(3) ? RadiusTheorem::t3 : RadiusTheorem::t3_sharp};
  Channel& c = sized.channel;
  const double radius = c.width * random.between(8, 17) / 16.0;  // the bound at the start
  const double fourth_power = CGAL::to_double(fourth_power_over_squared_area(goal_of(c), sized.theorem));
  c.coarse_area = radius * radius / std::sqrt(fourth_power);
  c.max_area = c.coarse_area * random.between(5, 7) / 8;
  c.length = c.shape == Shape::bar ? random.between(5, 12) : std::max(3, c.length / 2);
  c.has_crack = c.has_crack && c.length >= 6;
  if (random.chance(2) || ref::unsupported(to_pslg(c), goal_of(c))) c.nudges = {};
  return sized;
}

std::vector<Sized> simpler_sized(const Sized& sized) {
  std::vector<Sized> all;
  for (const Channel& c : simpler(sized.channel)) all.push_back({c, sized.theorem});
  return all;
}

PARDEL_PROPERTY(
    Lattice, sized_by_t3_before_a_mesh_exists_is_never_outgrown,
    {.statement = "Compute a bound r0 on circumradii by T3 or T3-sharp, from the bounds on ratio and area alone, and "
                  "the lattice with cells of side 4 r̄, before a mesh exists. r̄ is r0 if no two segments meet at less "
                  "than 90 degrees and segments without a common point are at least r0 apart; else r0 times the factor "
                  "of Lattice (f). Run Ruppert's algorithm until all triangles meet the two bounds, then refine on the "
                  "lattice for smaller areas. No insertion of any phase makes a circumradius larger than r̄, cells of "
                  "one colour touch no common vertex, and the mesh is certified.",
     .source = "[CC], Theorem 3 and the uniform lattice; properties/THEORY.md, Lattice (f)",
     .families = sized_channels}) {
  const Sized sized = *generators::generator(some_sized_channel, simpler_sized);
  RC_TAG(std::string(name(sized.channel.shape)));
  const Pslg pslg = to_pslg(sized.channel);
  const Goal goal = goal_of(sized.channel), coarse = coarse_goal_of(sized.channel);
  exhibit.show(pslg);
  const auto made = ref::refine_on_lattice_sized_by(sized.theorem, pslg, goal, coarse);
  if (!made) RC_FAIL(made.error().message);
  exhibit.show(pslg, made->mesh);
  const Number area = coarse.max_area;
  const Number start = fourth_power_over_squared_area(coarse, sized.theorem) * area * area;
  const Number growth = ref::squared_growth_bound(pslg, Number(std::sqrt(CGAL::to_double(start)) * (1 - 0x1p-30)));
  const Number bound = start * growth * growth * (1 + Number(0x1p-20));  // r̄⁴; the slack covers rounding upwards

  Number largest = 0;
  const auto require_bounded = [&](const Number& squared) {
    RC_ASSERT(squared * squared <= bound);
    largest = std::max(largest, squared);
  };
  const Number squared_at_start = squared_circumradius_bound(made->preprocessed);
  RC_ASSERT(squared_at_start * squared_at_start <= start);
  require_bounded(squared_at_start);
  std::size_t cells_at_once = 0;
  for_each_phase(*made, [&](const LatticeSweep& sweep, const ref::Phase& phase, const ref::PlainMesh& before) {
    const Number side = sweep.cells.side * sweep.cells.side;
    RC_ASSERT(side * side >= 256 * start * growth * growth);
    RC_ASSERT(side * side <= 256 * bound);
    RC_ASSERT(sweep.phases.size() == 4U);  // a phase that outgrows its cells ends the sweep
    ref::PlainMesh mesh = before;
    for (const auto& [cell, point] : phase.insertions) {
      const Index inserted = ref::insert(mesh, point);
      for (const ref::Corners& t : mesh.triangles)
        if (std::ranges::count(t, inserted) != 0) require_bounded(squared_circumradius(mesh, t));
    }
    RC_ASSERT(cells_touch_nothing_in_common(phase));
    cells_at_once = std::max(cells_at_once, phase.touched.size());
  });
  const Certificate certificate = check(pslg, made->mesh, goal);
  if (!certificate.valid) RC_FAIL(certificate.violations.at(0).message());
  RC_ASSERT(certificate.justified.empty());

  const double share = std::pow(CGAL::to_double(largest * largest / start), 0.25);  // of the bound at the start
  RC_TAG("largest circumradius: " + std::to_string(static_cast<int>(10 * share)) + "0 % or more of r0");
  RC_TAG(largest > squared_at_start ? "circumradii grew" : "circumradii never grew");
  classify(share >= 0.3, "a circumradius of 0.3 r0 or more", 40);
  classify(growth == 1, "the bound during the run is r0 itself", 15);
  classify(growth > 1, "the bound during the run is above r0", 30);
  classify(cells_at_once >= 2, "two or more cells work at once", 12);
}

/// A midpoint of one segment that encroaches upon another segment.
struct Encroachment {
  Pslg pslg;       ///< segment 0 is encroached by the midpoint of segment 1
  int start = 16;  ///< the bound at the start, in 16ths of half the length of segment 0
};
std::ostream& operator<<(std::ostream& out, const Encroachment& e) {
  for (const Point& p : e.pslg.points) out << '(' << p.x << ", " << p.y << ") ";
  return out << "r0 = " << e.start << "/16";
}

/// The segments have a common end, at an angle from 60 to 90 degrees.
Encroachment at_a_corner(Random& random) {
  const int u = random.between(1, 60), v = random.between((7 * u + 3) / 4, 20 * u);  // 7/4 > √3
  const int part = random.between(1, 7);  // the midpoint is on the diametral circle at part = 8
  Encroachment e;
  e.pslg.points = {{0, 0}, {8.0 * (u * u + v * v), 0}, {2.0 * part * u * u, 2.0 * part * u * v}};
  e.pslg.segments = {{0, 1}, {0, 2}};
  return e;
}

/// The segments have no common point.
Encroachment side_by_side(Random& random) {
  const int height = random.between(1, 255);
  const int reach = static_cast<int>(std::ceil(std::sqrt(256 * 256 - height * height))) - 1;
  const int x = random.chance(2) ? random.between(-reach / 8, reach / 8) : random.between(-reach, reach);
  const int along = random.between(1, 512), rise = random.chance(2) ? 0 : random.between(1 - height, height - 1);
  Encroachment e;
  e.pslg.points = {
      {-256, 0}, {256, 0}, {1.0 * (x - along), 1.0 * (height - rise)}, {1.0 * (x + along), 1.0 * (height + rise)}};
  e.pslg.segments = {{0, 1}, {2, 3}};
  return e;
}

Encroachment some_encroachment(Random& random, int /*size*/) {
  Encroachment e = random.chance(2) ? at_a_corner(random) : side_by_side(random);
  e.start = random.chance(2) ? 16 : random.between(17, 32);
  return e;
}

PARDEL_PROPERTY(Lattice, the_triangle_at_an_encroached_segment_keeps_the_bound_that_sizes_the_cells,
                {.statement = "The midpoint p of a segment lies strictly inside the diametral circle of a subsegment "
                              "mn of another segment, with |mn| ≤ 2 r0. The segments meet at 60 degrees or more, or "
                              "have no common point. The circumradius of (m, n, p) is at most r0 times the factor of "
                              "Lattice (f).",
                 .source = "properties/THEORY.md, Lattice (f)",
                 .families = "two segments with a common end at 60 to 90 degrees, or above each other at any distance "
                             "and slope"}) {
  const auto none = [](const Encroachment&) { return std::vector<Encroachment>{}; };
  const Encroachment drawn = *generators::generator(some_encroachment, none).as("segments");
  const std::vector<Point>& points = drawn.pslg.points;
  const ref::ExactPoint m = ref::exact(points[0]), n = ref::exact(points[1]);
  const Segment& other = drawn.pslg.segments[1];
  const ref::ExactPoint p = CGAL::midpoint(ref::exact(points[other.a]), ref::exact(points[other.b]));
  RC_ASSERT((m - p) * (n - p) < 0);
  const Number squared_start = CGAL::squared_distance(m, n) / 4 * drawn.start * drawn.start / 256;
  const Number squared_bound = squared_start * ref::squared_growth_bound(drawn.pslg, squared_start);
  const Number squared = CGAL::squared_radius(m, n, p);
  RC_ASSERT(squared <= squared_bound);
  const bool is_corner = points.size() == 3;
  const bool is_near = CGAL::to_double(squared / squared_bound) > 0.81;  // 0.9 of the bound
  classify(is_corner && is_near, "a corner, more than 0.9 of the bound", 10);
  classify(!is_corner && is_near, "no common point, more than 0.9 of the bound", 4);
  classify(squared > squared_start, "a circumradius above r0", 20);
}

}  // namespace
}  // namespace pardel::properties
