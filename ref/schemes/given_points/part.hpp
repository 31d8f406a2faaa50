// A part of the plane between Delaunay edges: its division by a path, and its triangles.
//
// Source: Blelloch, Hardwick, Miller and Talmor 1999, Figure 4 (the algorithm), Section 2 (points are compared with the
// line; borders are merged with the path) and Section 4 (the triangulation of a part by a sequential algorithm).
#pragma once

#include <optional>

#include "path.hpp"

namespace pardel::schemes {

/// The region on the left of all edges of its border. It need not be simple: paths touch borders, so it may consist of
/// several polygons that share corners.
struct Part {
  std::vector<Index> points;                 ///< in the region and on its border
  std::vector<std::array<Index, 2>> border;  ///< edges of the Delaunay triangulation of all points
};

/// The points inside the region, in the order of `part.points`.
[[nodiscard]] std::vector<Index> inner_points(const Part& part);

/// The point of the list before which a share lower/count of the list lies, in the direction across the cut.
/// Precondition: the list has a point, 0 < lower < count. Linear time.
[[nodiscard]] Index median(const std::vector<Point>& points, std::vector<Index> list, Cut cut, int lower, int count);

/// The places on a path.
class PathPlaces {
 public:
  explicit PathPlaces(const std::vector<Index>& path);
  /// The place of v, or no_index. O(log n) time.
  [[nodiscard]] Index operator[](Index v) const;

 private:
  std::vector<std::pair<Index, Index>> places_;
};

/// Do the vertices, which are the ends of an edge or the corners of a triangle, lie below the median, that is, on the
/// left of the path in turned coordinates? Precondition: the path is the one of the line through m, and no edge between
/// the vertices crosses it or belongs to it.
[[nodiscard]] bool lies_low(const std::vector<Point>& points, const std::vector<Index>& path, const PathPlaces& places,
                            const std::vector<Index>& vertices, Point m, Cut cut);

/// The part below and the part above the path through the point `m`. Points on the path and on the border between the
/// two parts belong to both of them. O(n log n) time.
struct Halves {
  Part low, high;
};
[[nodiscard]] Halves halves_of(const std::vector<Point>& points, const Part& part, const std::vector<Index>& path,
                               Point m, Cut cut);

/// The triangles of the region, by a sequential algorithm, with ties as settle_ties() says.
struct PartTriangles {
  std::vector<Corners> triangles;
  std::uint64_t work = 0;
  std::uint64_t held = 0;  ///< triangles before those outside the region were removed
};
[[nodiscard]] PartTriangles triangles_of(const std::vector<Point>& points, const Part& part);

/// A constrained edge and its segment.
struct Piece {
  Index a = 0, b = 0, segment = no_segment;
};
/// The mesh of all triangles. Pieces that are sides become constrained; the numbers of the others are added to
/// `missing`. O(n log n) time.
[[nodiscard]] LinkedMesh linked(std::vector<Point> points, const std::vector<Corners>& triangles,
                                const std::vector<Piece>& pieces, std::vector<std::size_t>& missing);

}  // namespace pardel::schemes
