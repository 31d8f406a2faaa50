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
    "T3-sharp from half the width of the channel to a little more than the width";

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
                  "the lattice with cells of side 4 r0, before a mesh exists. Run Ruppert's algorithm until all "
                  "triangles meet the two bounds, then refine on the lattice for smaller areas. No insertion of any "
                  "phase makes a circumradius larger than r0 by T3-sharp, cells of one colour touch no common vertex, "
                  "and the mesh is certified.",
     .source = "[CC], Theorem 3 and the uniform lattice; properties/THEORY.md, Lattice (f)",
     .families = sized_channels}) {
  const Sized drawn = *generators::generator(some_sized_channel, simpler_sized);
  RC_TAG(std::string(name(drawn.channel.shape)));
  const Pslg pslg = to_pslg(drawn.channel);
  const Goal goal = goal_of(drawn.channel), coarse = coarse_goal_of(drawn.channel);
  exhibit.show(pslg);
  const auto made = ref::refine_on_lattice_sized_by(drawn.theorem, pslg, goal, coarse);
  if (!made) RC_FAIL(made.error().message);
  exhibit.show(pslg, made->mesh);
  const Number area = coarse.max_area;
  const Number sized = fourth_power_over_squared_area(coarse, drawn.theorem) * area * area;
  const Number bound = fourth_power_over_squared_area(coarse, RadiusTheorem::t3_sharp) * area * area *
                       (1 + Number(0x1p-20));  // r0⁴; the slack covers rounding upwards

  Number largest = 0;
  const auto require_bounded = [&](const Number& squared) {
    RC_ASSERT(squared * squared <= bound);
    largest = std::max(largest, squared);
  };
  const Number squared_at_start = squared_circumradius_bound(made->preprocessed);
  require_bounded(squared_at_start);
  std::size_t cells_at_once = 0;
  for_each_phase(*made, [&](const LatticeSweep& sweep, const ref::Phase& phase, const ref::PlainMesh& before) {
    const Number side = sweep.cells.side * sweep.cells.side;
    RC_ASSERT(side * side >= 256 * sized);
    RC_ASSERT(side * side <= 256 * sized * (1 + Number(0x1p-20)));
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

  const double share = std::pow(CGAL::to_double(largest * largest / bound), 0.25);
  RC_TAG("largest circumradius: " + std::to_string(static_cast<int>(10 * share)) + "0 % or more of r0");
  RC_TAG(largest > squared_at_start ? "circumradii grew" : "circumradii never grew");
  classify(share >= 0.4, "a circumradius of 0.4 r0 or more", 15);
  classify(cells_at_once >= 2, "two or more cells work at once", 12);
}

}  // namespace
}  // namespace pardel::properties
