// The independent checker: decides whether a mesh is a correct mesh of a Pslg and meets a Goal.
//
// The checker shares no code with the mesher. They have only the plain data types of core/ in common. The checker does
// not rely on anything that the mesh states about itself. If several paths of edges lie on a segment up to rounding, it
// prefers the path that the mesh lists as constrained. Files contain this list, too. So a mesh and its file get the
// same verdict.
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
/// A mesh may have any content: indices out of range, coordinates that are not finite and arrays of the wrong length
/// are reported, and rules that can then not be checked are skipped. For a Pslg that is not valid (see validate()) the
/// function is safe, but the certificate has no meaning. goal.size must be pure; it is called from several threads. A
/// triangle at whose centroid it throws, or returns a number that is not positive, is reported as size_exceeded.
/// goal.user_test is asked by one thread at a time, unless it is declared to be free of state. A triangle for which it
/// throws is reported as user_test.
///
/// Predicates on coordinates and comparisons with bounds are exact: CGAL's filtered predicates, or intervals and then
/// rational numbers. Two bounds are rounded values, with which triangles are then compared exactly:
/// - goal.min_angle_deg stands for the double angle_cosine_bound(min_angle_deg);
/// - goal.size is evaluated at the rounded centroid ((a.x + b.x + c.x) / 3, (a.y + b.y + c.y) / 3) of the corners in
///   the order of the triangle.
/// The lengths that goal.grading and goal.feature_edges allow are computed from the Pslg with a tolerance
/// (tolerances.hpp), at the same centroids. Some rules allow for the rounding of vertices by a tolerance
/// (tolerances.hpp), which is compared exactly, too:
/// - a vertex on a segment may lie off the segment by chain_units;
/// - a hole's seed that lies within that distance of a segment on which the triangle around it has a corner is not
///   reported;
/// - two vertices lie on one shell around a small input angle within shell_tolerance and shell_units, and an angle
///   across a shell has its least value within across_tolerance and across_units.
///
/// Most of the work is one scan of all triangles, in which floating-point filters with proven bounds on their errors
/// decide nearly every test (arithmetic/filter.hpp). Exact arithmetic decides the others;
/// Certificate::decided_exactly counts the triangles that have such tests. The memory of the mesh's neighbours is read,
/// but not trusted: the scan proves that they are right, or they are computed anew.
///
/// O(n log n) time on typical input, on all OpenMP threads; the result does not depend on the number of threads. Memory
/// in addition to the mesh: 6 bytes per triangle of a valid mesh without regions, 78 bytes if the neighbours have to be
/// recomputed.
[[nodiscard]] Certificate check(const Pslg& pslg, const Mesh& mesh, const Goal& goal, const CheckOptions& options = {});

}  // namespace pardel
