// Bytes → Pslg and goal → mesh → exact check: every mesh must be right, but for triangles that the mesher
// itself reports as left alone because its budget of vertices ran out.
#include <algorithm>
#include <string>

#include "../parallel/mesher.hpp"
#include "../parallel/validate.hpp"
#include "../properties/check.hpp"
#include "fuzz_one.hpp"
#include "mesh_case.hpp"

namespace pardel::fuzz {
namespace {

bool concerns_quality(ViolationKind kind) {
  return kind == ViolationKind::small_angle || kind == ViolationKind::large_area ||
         kind == ViolationKind::region_area || kind == ViolationKind::long_edge;
}

bool reported_as_over_budget(const Violation& violation, const Report& report) {
  if (!concerns_quality(violation.kind)) return false;
  return std::any_of(report.exempt.begin(), report.exempt.end(), [&](const Exemption& exemption) {
    return exemption.reason == ExemptReason::budget &&
           std::find(violation.ids.begin(), violation.ids.end(), exemption.triangle) != violation.ids.end();
  });
}

}  // namespace

int fuzz_one(std::span<const std::uint8_t> bytes) {
  const MeshCase drawn = decode_mesh_case(bytes);
  const Prepared prepared = prepare(drawn);
  if (!prepared.usable) return -1;
  const ValidateOptions options{.convex_hull = drawn.goal.convex_hull};
  if (const auto problems = validate(prepared.pslg, options); !problems.empty())
    fail("repaired, and still: " + problems.front().message());

  const Result<Meshed> meshed = mesh(prepared.pslg, drawn.goal, drawn.options);
  if (!meshed) fail("a valid Pslg was refused: " + meshed.error().message);
  const Certificate certificate = check(prepared.pslg, meshed->mesh, drawn.goal, {.max_violations = 100'000});
  for (const Violation& violation : certificate.violations)
    if (!reported_as_over_budget(violation, meshed->report)) fail(violation.message());
  return 0;
}

}  // namespace pardel::fuzz
