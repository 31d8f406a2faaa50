// A bound on all circumradii of a refinement, computed from the input and the goal alone, before a mesh exists.
// Statement and proof: THEORY.md, T2-once and Lattice (f).
#pragma once

#include "../core/goal.hpp"
#include "../core/result.hpp"
#include "definitions.hpp"

namespace pardel::ref {

/// The theorem that gives the bound r0 on the circumradii at the start: T3 [CC] or T3-sharp (THEORY.md).
enum class RadiusTheorem : std::uint8_t { t3, t3_sharp };

/// An upper bound on the square of r0: no triangle that meets the bounds of the goal on angles and areas has a larger
/// circumradius (THEORY.md, T3: bounds on ratio and area bound it). Returns an Error of kind `usage` if the goal has no
/// bound on angles or none on areas. Precondition: the bound on angles is at most 60 degrees.
[[nodiscard]] Result<Number> squared_start_bound(const Goal& goal, RadiusTheorem theorem);

/// The square of the factor by which splits of segments may raise circumradii above r0, the largest of
/// - 1;
/// - 1 / sin θ for each corner θ of less than 90 degrees between two segments;
/// - (r0 / λ + λ / r0) / 2 if λ < r0, where λ is the least distance of two segments that have no point in common.
/// Precondition: the Pslg is valid.
[[nodiscard]] Number squared_growth_bound(const Pslg& pslg, const Number& squared_start);

/// The square of r̄ = r0 times the factor above. Under the hypotheses of Lattice (f), no circumradius ever exceeds r̄:
/// all border edges are segments, segments are split at midpoints, circumcentres that encroach are not inserted, and
/// all triangles meet the bounds of `start` when the refinement begins. Preconditions and errors: as for the two
/// functions above.
[[nodiscard]] Result<Number> squared_radius_bound(const Pslg& pslg, const Goal& start, RadiusTheorem theorem);

}  // namespace pardel::ref
