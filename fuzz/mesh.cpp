// Decodes the bytes to a case, meshes it and checks the result exactly. Every mesh must be valid. A bound may be missed
// only in triangles that the report lists, and only for a reason that the case allows.
#include <algorithm>
#include <string>

#include "../cli/domain_of_mesh.hpp"
#include "../parallel/mesher.hpp"
#include "../parallel/validate.hpp"
#include "../properties/checker/check.hpp"
#include "fuzz_one.hpp"
#include "mesh_case.hpp"

namespace pardel::fuzz {
namespace {

bool is_bound(ViolationKind kind) {
  return kind == ViolationKind::small_angle || kind == ViolationKind::large_area ||
         kind == ViolationKind::region_area || kind == ViolationKind::long_edge || kind == ViolationKind::size_exceeded;
}

bool ran_out(const Report& report) { return report.count(ExemptReason::budget) > 0; }

/// True if the options or the domain are a reason why a bound may be missed: a least edge, segments that may not be
/// split, points a few units in the last place from their neighbours, an angle for which there is no proof.
bool may_miss(const MeshCase& drawn) {
  return drawn.options.min_edge > 0 || drawn.options.no_boundary_splits || drawn.options.no_segment_splits ||
         drawn.nudged || drawn.goal.min_angle_deg > 30;
}

/// Does the violation concern this triangle? An edge that is too long concerns both triangles at it.
bool concerns(const Violation& violation, Index t, const Mesh& mesh) {
  if (violation.kind != ViolationKind::long_edge) return violation.ids.front() == t;
  const auto has = [&](Index v) { return std::ranges::count(mesh.triangles[t].v, v) > 0; };
  return has(violation.ids[0]) && has(violation.ids[1]);
}

bool is_allowed(const Violation& violation, const MeshCase& drawn, const Meshed& meshed) {
  if (!is_bound(violation.kind)) return false;
  if (ran_out(meshed.report)) return true;
  return may_miss(drawn) && std::ranges::any_of(meshed.report.exempt, [&](const Exemption& e) {
           return !justified(e.reason) && concerns(violation, e.triangle, meshed.mesh);
         });
}

void check_mesh(const Pslg& pslg, const Meshed& meshed, Goal goal, const MeshCase& drawn, bool foreign = false) {
  // In this case some constrained edges may be left that a conforming goal would have split.
  if (ran_out(meshed.report) || (may_miss(drawn) && !meshed.report.goal_met())) goal.conforming = false;
  const Certificate certificate = check(pslg, meshed.mesh, goal, {.max_violations = 100'000, .foreign = foreign});
  for (const Violation& violation : certificate.violations)
    if (!is_allowed(violation, drawn, meshed)) fail(violation.message());
  if (certificate.valid != certificate.violations.empty()) fail("the verdict contradicts the list of violations");
  if (meshed.report.goal_met() && !certificate.valid) fail("the report says that every bound holds");
}

/// What a file does not say about a mesh: from which part of the input its vertices and edges come.
void forget_origins(Mesh& mesh) {
  mesh.origin.clear();
  for (ConstrainedEdge& edge : mesh.constrained_edges) edge.segment = no_index;
}

/// Refines a mesh, with a bound on the area of every second triangle, and checks the result against the domain of the
/// mesh, as `pardel mesh --refine` does with a file.
void refine_and_check(Mesh coarse, const MeshCase& drawn) {
  forget_origins(coarse);
  const Result<Pslg> domain = cli::domain_of(coarse);
  if (!domain) fail("a mesh without a domain: " + domain.error().message);
  Goal goal = drawn.goal;
  goal.region_caps = goal.convex_hull = false;
  goal.grading = Goal{}.grading;
  goal.feature_edges = 0;
  std::vector<double> caps(coarse.triangles.size(), std::numeric_limits<double>::infinity());
  for (std::size_t t = 0; t < caps.size(); t += 2) {
    const auto& [a, b, c] = coarse.triangles[t].v;
    const Point p = coarse.points[a], q = coarse.points[b], r = coarse.points[c];
    caps[t] = std::abs((q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x)) / 3;
    if (!(caps[t] > 0)) caps[t] = std::numeric_limits<double>::infinity();
  }
  Options options = drawn.options;
  options.max_vertices = coarse.points.size() + 300;
  Result<Meshed> refined = refine(coarse, caps, goal, options);
  if (!refined) fail("a valid mesh was rejected: " + refined.error().message);
  forget_origins(refined->mesh);
  MeshCase again = drawn;
  again.goal = goal;
  check_mesh(*domain, *refined, goal, again, /*foreign=*/true);
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
    const Result<Meshed> meshed = mesh(prepared.pslg, drawn.goal, options);
    if (!meshed) fail("a valid Pslg was rejected: " + meshed.error().message);
    check_mesh(prepared.pslg, *meshed, drawn.goal, drawn);
    if (drawn.refine_again && interior == Interior::refine) refine_and_check(meshed->mesh, drawn);
  }
  return 0;
}

}  // namespace pardel::fuzz
