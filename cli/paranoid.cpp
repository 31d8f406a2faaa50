#include "paranoid.hpp"

#include <fmt/core.h>

#include "../properties/checker/check.hpp"
#include "verdict.hpp"

namespace pardel::cli {

Status check_sweep(const Pslg& pslg, const Mesh& mesh, std::uint64_t number, const Sweep& sweep,
                   const SweepCheck& how) {
  const Goal so_far{.min_angle_deg = 0, .region_caps = false, .convex_hull = how.convex_hull};
  const Certificate certificate =
      check(pslg, mesh, so_far, {.max_violations = most_listed, .max_circumradius = 0, .foreign = how.foreign});
  if (certificate.valid) return Done{};
  // The mesh has no file yet. Its first vertices are the input points.
  const int first = pslg.first_id.value;
  const NumbersInWitnesses numbers{.first_of_domain = first, .first_triangle = first, .first_vertex = first};
  return Error{ErrorKind::internal,
               fmt::format("the check failed after sweep {}, on a lattice of {} x {} cells, {}", number, sweep.columns,
                           sweep.rows, violations_text(certificate, most_listed, numbers))};
}

}  // namespace pardel::cli
