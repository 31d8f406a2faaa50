// The rules near small input angles, which make refinement end on every input: concentric shells (Ruppert 1995) and the
// two exemptions of Miller, Pav and Walkington ("When and why Ruppert's algorithm works", 2003).
#pragma once

#include <optional>

#include "../options.hpp"
#include "../triangulation/domain_segments.hpp"
#include "criteria.hpp"

namespace pardel::engine {

/// The point that splits the constrained edge a-b, a piece of `segment`. The midpoint, with one exception: where
/// exactly one of a and b is an end of the segment at which another segment leaves at an acute angle (the apex), the
/// point lies at a distance from that end that is a power of two and cuts the edge between 1/3 and 2/3. The pieces
/// around one apex then end on shared circles (shells), and the vertices of one segment do not encroach on another. The
/// point lies on the segment to within the rounding of its coordinates.
[[nodiscard]] Point edge_split_point(const Triangulation& t, const DomainSegment& segment, VertexId a, VertexId b);

/// The small input angle that exempts a triangle.
struct SmallAngle {
  ExemptReason reason;
  VertexId apex;
  double angle_deg;
};

/// Tells whether a triangle that is bad by its shape alone is left alone, because splitting it would not end. Such a
/// triangle is nestled (its smallest angle lies between two segments) or seditious (its shortest edge joins points of
/// one shell on two segments that meet at less than 60 degrees).
[[nodiscard]] std::optional<SmallAngle> small_angle(const Triangulation& t, const DomainSegments& segments,
                                                    const Slot& slot, const Measure& measure);

}  // namespace pardel::engine
