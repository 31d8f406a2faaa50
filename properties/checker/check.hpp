// The independent checker: is this mesh a correct answer to this Pslg and Goal?
//
// The checker shares no code with the mesher. It sees plain values only (core/), and it trusts nothing that the mesh
// claims about itself.
//
//     const pardel::Certificate certificate = pardel::check(pslg, mesh, goal);
//     if (!certificate.valid) std::cerr << to_text(certificate);
#pragma once

#include "../../core/goal.hpp"
#include "../../core/mesh.hpp"
#include "../../core/pslg.hpp"
#include "certificate.hpp"
#include "check_options.hpp"
#include "tolerances.hpp"
#include "violation.hpp"

namespace pardel {

/// Checks every rule of ViolationKind and returns the certificate.
///
/// Any values are safe: indices out of range, coordinates that are not finite and arrays of the wrong length are
/// reported, and then rules that cannot be checked are skipped. A Pslg that is not valid (see validate()) gives some
/// certificate, but its meaning is undefined. goal.size must be pure, must not throw and is called from several
/// threads.
///
/// Predicates on coordinates and comparisons with bounds are exact: CGAL's filtered predicates, or intervals and then
/// rational numbers. The exceptions, in which a verdict depends on rounded values:
/// - goal.size is compared in doubles, with size_tolerance;
/// - shells around a small input angle are compared in doubles, with shell_tolerance and shell_ulps;
/// - goal.min_angle_deg stands for the double angle_cosine_bound(min_angle_deg), which is then compared exactly;
/// - a vertex on a segment may lie off the segment by chain_ulps, and a hole's seed that lies within that distance of
/// an
///   edge of the triangle around it is not reported.
///
/// O(n log n) time on typical input, on all OpenMP threads; the result does not depend on their number. Exact
/// arithmetic is used only where floating-point filters do not decide. Memory in addition to the mesh: 8 bytes per
/// triangle of a valid mesh without regions, 72 where the neighbours have to be found again.
[[nodiscard]] Certificate check(const Pslg& pslg, const Mesh& mesh, const Goal& goal, const CheckOptions& options = {});

}  // namespace pardel
