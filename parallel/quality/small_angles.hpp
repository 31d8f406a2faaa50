// Rules for small input angles. They make the refinement end on every input: concentric shells (Ruppert 1995) and the
// two exemptions of Miller, Pav and Walkington ("When and why Ruppert's algorithm works", 2003).
#pragma once

#include <cmath>
#include <optional>
#include <vector>

#include "../options.hpp"
#include "../report.hpp"
#include "../triangulation/domain_segments.hpp"
#include "criteria.hpp"

namespace pardel::engine {

/// The point that splits the constrained edge a-b, a part of segment `number`. It is the midpoint, with exceptions.
/// Where a shorter segment leaves the same end at less than one degree, the point lies beside the end of the shorter
/// segment, at the same distance from their common end, unless an end of the edge is as near to this place as the
/// shorter segment is, or an edge shorter than `floor` would result in a gap that doubles can resolve. Both sides of
/// the wedge then have vertices at the same distances, and a triangle across it is seditious (small_angle()).
/// Otherwise: an end of a segment is an apex if another segment leaves there at an angle below 60 degrees. If a or b is
/// an apex of the segment, the distance of the point from the apex is a power of two, between 1/3 and 2/3 of the edge.
/// The edges around one apex then end on common circles (shells), and the vertices of one segment do not encroach on
/// another. If both are apexes, the one with the much smaller angle is used; for similar angles, the point is the
/// midpoint. Measured: this gives the smallest meshes. For an edge shorter than 1/32 of its segment, angles of up to
/// 104 degrees make an apex: at bounds above 30 degrees, two segments at a right angle can split each other in turn
/// without end. If a segment has a narrow apex (DomainSegment), the edges that touch no apex are split at distances
/// from it with few binary digits, between 1/3 and 2/3 of the edge: the vertices of both sides of a narrow wedge then
/// stay side by side even if their far ends do not. If the other end is an apex, too, this holds around the apex whose
/// wedge is narrower at the edge. An edge longer than one and a half `pieces` that would be halved is split into two
/// whole numbers of about equal pieces of about this length. Halves of halves could be much shorter than the edges of a
/// patch beside the segment. The point lies on the segment up to the rounding of its coordinates, and the predicates
/// are exact for it (is_usable()). If the place has a coordinate for which they are not, the point is the nearest place
/// of the edge where this coordinate is zero or smallest_coordinate; it is a if there is no such place, so that no edge
/// is split there.
[[nodiscard]] Point edge_split_point(const Triangulation& t, const DomainSegments& segments, Index number, VertexId a,
                                     VertexId b, double floor = 0, double pieces = INFINITY);

/// Other points at which the edge can be split if edge_split_point() cannot be inserted: a vertex is too near to it, or
/// rounding moves it beyond one. The best comes first; none is nearer to an end than 5/16 of the edge.
[[nodiscard]] std::vector<Point> other_edge_split_points(const Triangulation& t, const DomainSegments& segments,
                                                         Index number, VertexId a, VertexId b);

/// The small input angle that exempts a triangle.
struct SmallAngle {
  ExemptReason reason;
  VertexId apex;
  double angle_deg;
};

/// The exemption of a triangle that breaks only the bound on angles, or nothing if it has to be split. A triangle is
/// exempt if splitting it would never end. Each of its angles below the bound needs a cause of its own. It is nestled
/// (it lies between two segments), or the edge opposite is seditious (it joins points inside two segments that meet at
/// an angle θ of less than 60 degrees, on one shell around their common end; at less than one degree, one of the points
/// can be the end of its segment) and the angle is at least arctan(sin θ / (2 - cos θ)). Returns the cause of the
/// smallest angle. Precondition: this angle is below the bound.
[[nodiscard]] std::optional<SmallAngle> small_angle(const Triangulation& t, const DomainSegments& segments,
                                                    const Criteria& criteria, const Slot& slot, const Measure& measure);

}  // namespace pardel::engine
