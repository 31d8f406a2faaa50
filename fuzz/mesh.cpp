// Decodes the bytes to a case, meshes it and checks the result exactly. Every mesh must be valid. A bound may be missed
// only if the limit on vertices was reached and the report lists this.
#include <algorithm>
#include <string>

#include "../parallel/mesher.hpp"
#include "../parallel/validate.hpp"
#include "../properties/checker/check.hpp"
#include "fuzz_one.hpp"
#include "mesh_case.hpp"

namespace pardel::fuzz {
namespace {

bool is_bound(ViolationKind kind) {
  return kind == ViolationKind::small_angle || kind == ViolationKind::large_area ||
         kind == ViolationKind::region_area || kind == ViolationKind::long_edge;
}

bool ran_out(const Report& report) { return report.count(ExemptReason::budget) > 0; }

/// True if the violation is allowed. If the limit on vertices was reached, any triangle may miss a bound. For angles
/// above 30 degrees, for which there is no proof, refinement may also stop at the lower bound on edge lengths, but only
/// in triangles that the report lists.
bool is_allowed(const Violation& violation, const Goal& goal, const Report& report) {
  if (!is_bound(violation.kind)) return false;
  if (ran_out(report)) return true;
  return goal.min_angle_deg > 30 && std::any_of(report.exempt.begin(), report.exempt.end(), [&](const Exemption& e) {
           return !justified(e.reason) && e.triangle == violation.ids.front();
         });
}

/// Meshes the domain and checks the mesh.
void mesh_and_check(const Pslg& pslg, Goal goal, const Options& options) {
  const Result<Meshed> meshed = mesh(pslg, goal, options);
  if (!meshed) fail("a valid Pslg was rejected: " + meshed.error().message);
  // In this case some constrained edges may be left that a conforming goal would have split.
  if (ran_out(meshed->report)) goal.conforming = false;
  const Certificate certificate = check(pslg, meshed->mesh, goal, {.max_violations = 100'000});
  for (const Violation& violation : certificate.violations)
    if (!is_allowed(violation, goal, meshed->report)) fail(violation.message());
  if (certificate.valid != certificate.violations.empty()) fail("the verdict contradicts the list of violations");
}

}  // namespace

int fuzz_one(std::span<const std::uint8_t> bytes) {
  const MeshCase drawn = decode_mesh_case(bytes);
  const Prepared prepared = prepare(drawn);
  if (!prepared.usable) return -1;
  const ValidateOptions validation{.convex_hull = drawn.goal.convex_hull};
  if (const auto problems = find_problems(prepared.pslg, validation); !problems.empty())
    fail("the repaired Pslg is not valid: " + problems.front().message());
  Options options = drawn.options;
  for (const Interior interior : {Interior::refine, Interior::fill}) {
    options.interior = interior;
    mesh_and_check(prepared.pslg, drawn.goal, options);
  }
  return 0;
}

}  // namespace pardel::fuzz
