// What refinement does near small input angles, so that it ends on every input: concentric shells (Ruppert
// 1995) and the two exemptions of Miller, Pav and Walkington ("When and why Ruppert's algorithm works", 2003).
#pragma once

#include <optional>

#include "../options.hpp"
#include "../triangulation/domain_segments.hpp"
#include "criteria.hpp"

namespace pardel::engine {

/// Where to split the constrained edge a-b of a segment. The midpoint; but where exactly one end is an end of
/// the line at which another line leaves at an acute angle, the power-of-two distance from that end which
/// cuts the edge between 1/3 and 2/3: pieces about one apex then end on shared circles, and the vertices of
/// one do not encroach on another. The point is kept on the line to within rounding of its coordinates.
[[nodiscard]] Point edge_split_point(const Triangulation& t, const DomainSegment& segment, VertexId a, VertexId b);

struct SmallAngle {
  ExemptReason reason;
  VertexId apex;
  double angle_deg;
};

/// Whether a triangle that is bad by shape alone is to be left alone, since splitting it would not end:
/// nestled (its smallest angle lies between two segments) or seditious (its shortest edge joins points of one
/// shell on two segments that meet at less than 60 degrees).
[[nodiscard]] std::optional<SmallAngle> small_angle(const Triangulation& t, const DomainSegments& segments,
                                                    const Slot& slot, const Measure& measure);

}  // namespace pardel::engine
