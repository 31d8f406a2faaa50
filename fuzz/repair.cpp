// Validation and repair. On a lattice, validate() must agree with the definition in exact integers. A repaired domain
// must be valid and must have everything that the old one had (repaired_domain.hpp), and repairing it again must change
// nothing. A domain may be refused only for the reasons of refused_repair.hpp.
#include "../parallel/repair.hpp"

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "../properties/domains/generators/lattice_domain.hpp"
#include "fuzz_one.hpp"
#include "mesh_case.hpp"
#include "refused_repair.hpp"
#include "repaired_domain.hpp"
#include "supply.hpp"

namespace pardel::fuzz {
namespace {

/// The Pslg on the lattice of a quarter of its unit, on which seeds of strokes are not. Empty if a coordinate is not on
/// the lattice.
std::optional<generators::LatticeDomain> on_lattice(const Pslg& pslg) {
  generators::LatticeDomain domain;
  const auto exact = [](Point p, double unit) -> std::optional<generators::LatticePoint> {
    const double x = p.x / unit, y = p.y / unit;
    if (x != std::floor(x) || y != std::floor(y) || std::abs(x) > 1e7 || std::abs(y) > 1e7) return {};
    return generators::LatticePoint{static_cast<std::int64_t>(x), static_cast<std::int64_t>(y)};
  };
  constexpr double unit = 1.0 / 64;
  domain.exponent = 6;
  for (const Point p : pslg.points) {
    const auto q = exact(p, unit);
    if (!q) return {};
    domain.points.push_back(*q);
  }
  domain.segments = pslg.segments;
  for (const Point hole : pslg.holes) {
    const auto q = exact(hole, unit / 4);
    if (!q) return {};
    domain.holes.push_back(*q);
  }
  for (const Region& region : pslg.regions) {
    const auto q = exact(region.seed, unit / 4);
    if (!q) return {};
    domain.regions.push_back({*q, region.attribute, region.max_area});
  }
  return domain;
}

void compare_with_the_definition(const Pslg& pslg) {
  const auto domain = on_lattice(pslg);
  if (!domain) return;
  const std::vector<Problem> problems = find_problems(pslg);
  if (is_valid(*domain) == problems.empty()) return;
  fail(problems.empty() ? "validation finds no problem, but the domain is not valid by definition"
                        : "the domain is valid by definition, but validation says: " + problems.front().message());
}

/// The Pslg with attributes and markers of points. The attributes are linear functions of the place, so interpolation
/// does not change them.
Pslg with_values_of_points(Pslg pslg) {
  pslg.attributes_per_point = linear_attributes.size();
  pslg.point_attributes.clear();
  pslg.point_markers.clear();
  for (Index p = 0; p < pslg.points.size(); ++p) {
    for (const Linear& linear : linear_attributes) pslg.point_attributes.push_back(linear(pslg.points[p]));
    pslg.point_markers.push_back(static_cast<int>(p) + 1000);
  }
  return pslg;
}

}  // namespace

int fuzz_one(std::span<const std::uint8_t> bytes) {
  const MeshCase drawn = decode_mesh_case(bytes);
  if (!drawn.goal.convex_hull) compare_with_the_definition(drawn.pslg);

  RepairOptions options{.convex_hull = drawn.goal.convex_hull};
  if (drawn.seed % 3 == 1) options.snap = 0;
  if (drawn.seed % 3 == 2) options.snap = std::ldexp(default_snap(drawn.pslg), static_cast<int>(drawn.seed / 3 % 32));
  const Pslg before = with_values_of_points(drawn.pslg);
  const Result<Repaired> once = repair(before, options);
  const bool is_valid_before = find_problems(before, {.convex_hull = options.convex_hull}).empty();
  if (is_valid_before && options.snap == 0.0 && !(once && once->log.empty() && once->domain.pslg() == before))
    fail("the repair of a valid domain without snapping changes it");
  if (!once) {
    check_refusal(before, options, once.error());
    return 0;
  }
  const Pslg& repaired = once->domain.pslg();
  if (const auto problems = find_problems(repaired, {.convex_hull = options.convex_hull}); !problems.empty())
    fail("the repaired domain is not valid: " + problems.front().message());
  compare_with_repaired(before, *once, options);

  if (options.snap) options.snap = once->snap;
  const Result<Repaired> twice = repair(repaired, options);
  if (!twice) fail("a repaired domain cannot be repaired: " + twice.error().message);
  if (!twice->log.empty()) fail("repairing again changes the domain: " + twice->log.front());
  if (twice->domain.pslg() != repaired) fail("repairing again changes the domain and does not say so");
  return 0;
}

}  // namespace pardel::fuzz
