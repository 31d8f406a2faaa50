// The segments of a domain, and the small angles between them.
#pragma once

#include <algorithm>
#include <optional>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

#include "../arithmetic/clearance.hpp"
#include "../segments/segment_pieces.hpp"
#include "../threads/threads.hpp"
#include "triangulation.hpp"

namespace pardel::engine {

/// A segment of the domain: a segment of the input or, if the domain is the convex hull of its points, an edge of the
/// hull. Refinement splits it into subsegments. They are not stored: every vertex inside the segment has the segment's
/// index as its origin, so the ends of a subsegment determine the segment. a < b holds, and vertices are numbered by
/// coordinates. So the direction of the segment in the input does not influence how points on it are rounded.
struct DomainSegment {
  VertexId a, b;
  double cosine_at_a = -1;  ///< of the smallest angle with another segment at a; -1 if there is no other segment
  double cosine_at_b = -1;  ///< the same at b
  /// The end at which other segments meet this one at less than one degree and at much less than at the other end.
  /// no_index if there is no such end, or if one of these other segments has another such end or none.
  VertexId narrow_apex = no_index;
  int marker = 0;  ///< of the input segment; 0: it has none

  /// The cosine of the smallest angle with another segment at v; -1 if v is a vertex inside the segment.
  [[nodiscard]] double cosine_at(VertexId v) const { return v == a ? cosine_at_a : v == b ? cosine_at_b : -1; }
};

/// Of one degree. Two segments that meet at a smaller angle form a narrow wedge.
inline constexpr double cosine_of_narrow_angle = 0.9998477;

/// The place on a segment beside the end of a shorter segment, where the two are the sides of a narrow wedge.
struct PlaceBesideEnd {
  VertexId apex;    ///< the common end of the two segments
  double distance;  ///< of the place from the apex: the length of the shorter segment
  double gap;       ///< between the two segments at this distance
};

class DomainSegments {
 public:
  DomainSegments() = default;
  /// `points` holds the coordinates of the vertices. `markers`: one per constraint; empty: no segment has one.
  /// O(k log k) for k constraints.
  DomainSegments(const Array<Point>& points, std::span<const Constraint> constraints, std::span<const int> markers = {},
                 const Threads& threads = {});

  // For a rank that has a part of the segments. What is added was computed where all segments around it are known.
  /// Adds a segment after the last one. Its direction and its angles stay as they are.
  void add(const DomainSegment& segment, std::span<const PlaceBesideEnd> places_beside_ends,
           std::span<const Clearance> clearances);
  /// Adds a vertex with all segments that end there, in the order of segments_at(). Fast for a vertex that comes after
  /// those that were added before. Precondition: the vertex was not added.
  void add_end(VertexId v, std::span<const Index> segments);

  /// For a mesh that is refined: the subsegments of which the segments consist. Their ends are rounded, so new vertices
  /// lie on the lines of the pieces, not on those of whole segments. `markers`: one per subsegment. They count, not
  /// those of whole segments.
  void set_pieces(SegmentPieces pieces, std::vector<int> markers) {
    pieces_ = std::move(pieces);
    markers_of_pieces_ = std::move(markers);
  }
  [[nodiscard]] const SegmentPieces& pieces() const { return pieces_; }
  /// The ends of the segment, or those of its piece at p.
  [[nodiscard]] Constraint line_at(const Array<Point>& points, Index segment, Point p) const {
    if (pieces_.empty()) return {segments_[segment].a, segments_[segment].b};
    const SegmentPieces::Piece piece = pieces_.at(points, segment, p);
    return {std::min(piece.a, piece.b), std::max(piece.a, piece.b)};
  }

  /// The marker of the input segment at p, a point of the segment; 0: it has none.
  [[nodiscard]] int marker_at(const Array<Point>& points, Index segment, Point p) const {
    return pieces_.empty() ? segments_[segment].marker : markers_of_pieces_[pieces_.at(points, segment, p).number];
  }
  /// The marker that an edge with this middle has in the mesh (ConstrainedEdge::marker), as a part of the segment.
  [[nodiscard]] int marker_of_edge(const Array<Point>& points, Index segment, Point middle, bool on_boundary) const {
    const int own = marker_at(points, segment, middle);
    return own == 0 && on_boundary ? 1 : own;
  }

  [[nodiscard]] const DomainSegment& operator[](Index segment) const { return segments_[segment]; }
  [[nodiscard]] std::size_t size() const { return segments_.size(); }

  /// The places on a segment beside the ends of shorter ones. At a hub of many segments, only the 16 nearest segments
  /// on each side count.
  [[nodiscard]] std::span<const PlaceBesideEnd> places_beside_ends(Index segment) const {
    return std::span(places_).subspan(first_place_[segment], first_place_[segment + 1] - first_place_[segment]);
  }
  /// What is so close to a segment that rounding could move its split points across it: segments that form a narrow
  /// wedge with it, and what add_clearance() has added.
  [[nodiscard]] std::span<const Clearance> clearances(Index segment) const {
    if (clearances_.empty()) return {};
    const auto found = clearances_.find(segment);
    return found == clearances_.end() ? std::span<const Clearance>() : found->second;
  }
  [[nodiscard]] bool has_clearances() const { return !clearances_.empty(); }
  void add_clearance(Index segment, const Clearance& clearance) { clearances_[segment].push_back(clearance); }
  /// True if the subsegment may be split at p (keeps_clear()).
  [[nodiscard]] bool may_split(const Array<Point>& points, Index segment, const EndPoints& edge, Point p) const {
    return !has_clearances() || stays_clear(points, segment, edge, p);
  }

  /// The segments that end at a vertex, in the order of their directions; none if it is no end of a segment.
  [[nodiscard]] std::span<const Index> segments_at(VertexId v) const;
  /// The segment that contains the constrained edge u-v as a subsegment. no_index if there is no such segment; this
  /// does not happen in a correct triangulation.
  [[nodiscard]] Index segment_of(const Triangulation& t, VertexId u, VertexId v) const;
  /// The segment with these two ends; no_index if there is none, or if one of them is no_index.
  [[nodiscard]] Index segment_between(VertexId a, VertexId b) const;
  /// The common end of two different segments, or no_index.
  [[nodiscard]] VertexId shared_end(Index first, Index second) const;
  /// The end of a segment that is not `end`.
  [[nodiscard]] VertexId other_end(Index segment, VertexId end) const {
    return segments_[segment].a == end ? segments_[segment].b : segments_[segment].a;
  }
  /// The cosine of the angle between two segments at their common end `apex`.
  [[nodiscard]] double cosine_at(const Array<Point>& points, VertexId apex, Index first, Index second) const;

 private:
  [[nodiscard]] bool stays_clear(const Array<Point>& points, Index segment, const EndPoints& edge, Point p) const;
  /// The segments that end at a vertex of ends_.
  [[nodiscard]] std::span<const Index> around(std::size_t end) const {
    return std::span(incident_).subspan(start_[end], start_[end + 1] - start_[end]);
  }
  /// Calls visit(v, s, t) for the vertex v of ends_, and all segments s and t that are adjacent in the angular order
  /// around it.
  template <class Visit>
  void for_each_angle_at(std::size_t end, const Visit& visit) const {
    const std::span<const Index> here = around(end);
    for (std::size_t i = 0; here.size() > 1 && i < here.size(); ++i)
      visit(ends_[end], here[i], here[(i + 1) % here.size()]);
  }
  /// True if two segments that are adjacent around v meet there at an angle with a larger cosine.
  [[nodiscard]] bool meet_narrowly(const Array<Point>& points, VertexId v, Index first, Index second,
                                   double cosine) const;
  void find_ends(SparseAsk& ask);
  void sort_around(const Array<Point>& points, std::size_t end);
  void find_smallest_angles(const Array<Point>& points, const Threads& threads);
  void find_narrow_apexes(const Array<Point>& points, SparseAsk& ask);
  void find_places_beside_ends(const Array<Point>& points, SparseAsk& ask);
  void find_narrow_wedges(const Array<Point>& points, SparseAsk& ask);
  [[nodiscard]] std::optional<PlaceBesideEnd> place_beside_end(const Array<Point>& points, VertexId apex, Index segment,
                                                               Index other) const;

  std::vector<DomainSegment> segments_;
  std::vector<VertexId> ends_;          ///< the vertices at which segments end, in ascending order
  SegmentPieces pieces_;                ///< empty if segments have no pieces
  std::vector<int> markers_of_pieces_;  ///< by the number of a piece
  std::vector<PlaceBesideEnd> places_;  ///< on segment s: from first_place_[s] to first_place_[s + 1] - 1
  std::vector<Index> first_place_{0};
  std::vector<Index> start_{0}, incident_;  ///< at ends_[i] end the segments incident_[start_[i]] to start_[i + 1] - 1
  std::unordered_map<Index, std::vector<Clearance>> clearances_;  ///< of the segments that have some
  std::unordered_map<VertexId, std::vector<Index>> late_ends_;    ///< vertices that were added out of order
};

}  // namespace pardel::engine
