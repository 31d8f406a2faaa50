// What each rank writes of a mesh in pieces into a file of the whole mesh, in an order that does not depend on the
// pieces.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "../array.hpp"
#include "../piece_of_mesh.hpp"
#include "../ranks.hpp"
#include "../result.hpp"

namespace pardel::files {

/// The file has the points in the order of their numbers. It has each triangle with the least of its three numbers
/// first, the corners counter-clockwise, and the triangles in the lexicographic order of their numbers; constrained
/// edges in the order of their lesser and then of their greater number.
///
/// A rank writes the records whose first number lies in one of two ranges: an equal part of the input points, and the
/// numbers that the rank has given. So nearly all that it writes is in its piece; what is not, it gets from the other
/// ranks. The file consists of two sections: the first ranges of all ranks, then the second ranges of all ranks.
class ShareOfFile {
 public:
  static constexpr std::size_t sections = 2;

  /// Collective. The piece must outlive the object.
  ShareOfFile(const PieceOfMesh& piece, Ranks& ranks);
  /// An internal error if the pieces do not have a point with each number, once.
  [[nodiscard]] Status complete() const;

  /// Of a section: record 0 of its points, triangles or edges, and how many there are.
  struct Records {
    std::size_t first = 0, count = 0;
  };
  [[nodiscard]] Records points(std::size_t section) const { return points_[section]; }
  [[nodiscard]] Records triangles(std::size_t section) const { return triangles_[section]; }
  [[nodiscard]] Records edges(std::size_t section) const { return edges_[section]; }

  /// Records of both sections are numbered together.
  [[nodiscard]] std::uint64_t number(std::size_t i) const;
  [[nodiscard]] const Point& point(std::size_t i) const;
  [[nodiscard]] const int& marker(std::size_t i) const;
  [[nodiscard]] std::span<const double> attributes(std::size_t i) const;

  using Corners = std::array<std::uint64_t, 3>;  ///< numbers of points
  [[nodiscard]] Corners corners(std::size_t i) const { return corners_of(order_[i]); }
  [[nodiscard]] Index region(std::size_t i) const;  ///< an index into Mesh::region_attributes, or no_index

  struct Edge {
    std::uint64_t a, b;
    int marker;
  };
  [[nodiscard]] const Edge& edge(std::size_t i) const { return edge_[i]; }

 private:
  struct TravellingPoint {
    std::uint64_t number;
    Point point;
    int marker;
  };
  struct TravellingTriangle {
    Corners corners;
    Index region;
  };

  void take_points(Ranks& ranks);
  void take_triangles(Ranks& ranks);
  void take_edges(Ranks& ranks);
  void sort_triangles(std::size_t all);
  [[nodiscard]] int writer_of(std::uint64_t number) const;
  [[nodiscard]] bool is_mine(std::uint64_t number) const { return writer_of(number) == rank_; }
  /// Of a number in a range of this rank: its place in the two ranges.
  [[nodiscard]] std::size_t place_of(std::uint64_t number) const;
  [[nodiscard]] Corners corners_of(Index triangle) const;

  const PieceOfMesh& piece_;
  int rank_, count_;
  /// Range k begins at bounds_[k] and is of rank k % count_: the input points in `count_` ranges, then the others.
  std::vector<std::uint64_t> bounds_;
  std::array<Records, sections> points_, triangles_, edges_;
  /// Per place: a point of the piece or, beyond these, one that has arrived; no_index if it is missing.
  Array<Index> point_;
  std::vector<TravellingPoint> arrived_points_;
  std::vector<double> arrived_attributes_;
  Array<Index> order_;  ///< triangles of the piece or, beyond these, that have arrived
  std::vector<TravellingTriangle> arrived_triangles_;
  std::vector<Edge> edge_;
};

}  // namespace pardel::files
