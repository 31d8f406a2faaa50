// Bounds on all circumradii of a refinement: from one measurement (THEORY.md, T2-once), and from the goal alone, before
// a mesh exists (Lattice (f)).
#pragma once

#include "../core/goal.hpp"
#include "../core/result.hpp"
#include "definitions.hpp"

namespace pardel::ref {

/// The square of the factor by which splits of segments may raise circumradii above the bound r̄ at some time
/// (THEORY.md, T2-once), the largest of
/// - 1;
/// - 1 / sin θ for each corner θ of less than 90 degrees between two segments;
/// - (r̄ / λ + λ / r̄) / 2 if λ < r̄, where λ is the least distance of two segments that have no point in common.
/// Precondition: the Pslg is valid.
[[nodiscard]] Number squared_growth_bound(const Pslg& pslg, const Number& squared_bound);

/// The theorem that gives the bound: T3 [CC] or T3-sharp (THEORY.md).
enum class RadiusTheorem : std::uint8_t { t3, t3_sharp };

/// The square of r0, rounded upwards: no triangle that meets the bounds of the goal on angles and areas has a larger
/// circumradius (THEORY.md, T3 and T3-sharp). Under the hypotheses of Lattice (f), no circumradius ever exceeds r0 if
/// all triangles meet the bounds when the refinement begins: segments meet at 60 degrees or more, all border edges are
/// segments, segments are split at midpoints, and circumcentres that encroach are not inserted. Returns an Error of
/// kind `usage` if the goal has no bound on angles or none on areas. Precondition: the bound on angles is at most 60
/// degrees, for Lattice (f) at most 30.
[[nodiscard]] Result<Number> squared_radius_bound(const Goal& start, RadiusTheorem theorem);

}  // namespace pardel::ref
