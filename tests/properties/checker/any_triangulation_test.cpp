// The checker returns a verdict for every input.
#include <algorithm>
#include <bit>
#include <cmath>

#include "../../../properties/checker/check.hpp"
#include "../../../properties/domains/generators/random.hpp"
#include "../../../properties/theorems/framework/property.hpp"
#include "meshes.hpp"

namespace pardel::checker {
namespace {

using testing::Case;

PARDEL_PROPERTY(
    Check, neither_crashes_nor_accepts_when_ids_are_scrambled,
    {.statement = "a correct mesh with vertices or neighbours changed at random is refused, with an explanation",
     .source = "properties/checker/check.hpp",
     .families = "a square in eight triangles, spoiled"}) {
  Case c = testing::square_in_eight();
  generators::Random random(*rc::gen::arbitrary<std::uint32_t>());
  const int changes = random.between(1, 8);
  for (int i = 0; i < changes; ++i) {
    Triangle& t = c.mesh.triangles[random.below(c.mesh.triangles.size())];
    const auto id = static_cast<Index>(random.chance(10) ? random.next() : random.below(9));
    (random.chance(2) ? t.v : t.n)[random.below(3)] = id;
  }
  const Case original = testing::square_in_eight();
  RC_PRE(!(c.mesh.triangles == original.mesh.triangles));
  const bool foreign = random.chance(2);
  CheckOptions options;
  options.foreign = foreign;
  const Certificate certificate = check(c.pslg, c.mesh, Goal{}, options);
  RC_ASSERT(!certificate.valid);
  RC_ASSERT(!to_text(certificate).empty());
}

PARDEL_PROPERTY(Check, does_not_crash_on_arbitrary_numbers,
                {.statement = "any bits as coordinates, caps and goals give a certificate, and none is valid if a "
                              "coordinate is not finite",
                 .source = "properties/checker/check.hpp",
                 .families = "a square in eight triangles, spoiled"}) {
  generators::Random random(*rc::gen::arbitrary<std::uint32_t>());
  const auto number = [&] { return random.chance(2) ? std::bit_cast<double>(random.next()) : double(random.below(4)); };
  Case c = testing::square_in_eight();
  for (int i = 0; i < 3; ++i) {
    c.mesh.points[random.below(9)] = {number(), number()};
    c.pslg.points[random.below(6)] = {number(), number()};
  }
  c.pslg.holes.push_back({number(), number()});
  c.pslg.regions[0].max_area = number();
  Goal goal;
  goal.min_angle_deg = number();
  goal.max_area = number();
  goal.max_edge = number();
  CheckOptions options;
  options.max_circumradius = number();
  const Certificate certificate = check(c.pslg, c.mesh, goal, options);
  RC_ASSERT(!to_json(certificate).empty());
  const auto is_finite = [](Point p) { return std::isfinite(p.x) && std::isfinite(p.y); };
  RC_ASSERT(!certificate.valid ||
            (std::ranges::all_of(c.mesh.points, is_finite) && std::ranges::all_of(c.pslg.points, is_finite) &&
             std::ranges::all_of(c.pslg.holes, is_finite)));
}

}  // namespace
}  // namespace pardel::checker
