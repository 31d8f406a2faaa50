// KeptPart: what a rank keeps of a piece whose memory it frees. That are the triangles around all vertices that other
// pieces may have, too, or that have to do with the input.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "../model/attribute_ranges.hpp"
#include "../model/number_set.hpp"
#include "free_points.hpp"
#include "piece.hpp"

namespace pardel::checker {

struct KeptVertex {
  Point at;
  Index number;  ///< in the whole mesh
  Index origin;
  std::int32_t marker;
  bool is_special;    ///< has to do with the input, as far as the piece knows
  bool is_at_border;  ///< see is_at_border()
};

struct KeptTriangle {
  std::array<Index, 3> v;  ///< indices into KeptPart::vertices
  Index triangle;          ///< in the piece
};

/// A side without a neighbour in the piece. The triangle is on its left.
struct KeptSide {
  Index from, to, apex;  ///< indices into KeptPart::vertices
  Index triangle;        ///< in the piece
  std::uint8_t side;     ///< of the triangle
  bool is_open;          ///< the scan left tests of the triangle open
};

struct KeptEdge {
  Index a, b;  ///< the numbers of the ends in the whole mesh
  Index segment;
  std::int32_t marker;
};

/// Which data the vertices have.
struct KindsOfData {
  std::uint64_t markers = 0, origins = 0, attributes_per_point = 0;
  friend bool operator==(const KindsOfData&, const KindsOfData&) = default;
};

struct KeptPart {
  KindsOfData kinds;
  std::vector<KeptVertex> vertices;     ///< in the order of the piece
  std::vector<double> attributes;       ///< KindsOfData::attributes_per_point for each vertex
  std::vector<KeptTriangle> triangles;  ///< those with a vertex that is special or at the border, in ascending order
  std::vector<KeptSide> sides;          ///< in the order of Adjacency::boundary()
  std::vector<KeptEdge> edges;          ///< that the piece lists
};

/// The places of all points of the input.
class InputPlaces {
 public:
  explicit InputPlaces(std::span<const Point> inputs);
  [[nodiscard]] std::size_t count() const { return sorted_.size(); }
  [[nodiscard]] bool contains(Point p) const;

 private:
  std::vector<Point> sorted_;
};

/// Special are, in one piece: the points of the input, the ends of listed edges, vertices with a marker or an origin,
/// vertices without triangles, and vertices with an attribute outside of the range of the input. But input points are
/// settled, and not special, if FreePoints::is_settled() holds and no listed edge ends there; their numbers are added
/// to `settled`. `also`: the numbers of vertices that are kept as if they were at the border, sorted. These are not
/// settled. Precondition: the piece has an adjacency.
[[nodiscard]] KeptPart part_to_keep(const Piece& piece, const InputPlaces& inputs, const FreePoints& free,
                                    const AttributeRanges& ranges, NumberSet& settled,
                                    std::span<const std::uint64_t> also = {});

}  // namespace pardel::checker
