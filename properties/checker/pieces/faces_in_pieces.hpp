// The faces of the domain in which the triangles of pieces lie.
#pragma once

#include <vector>

#include "border.hpp"

namespace pardel::checker {

/// Sets of triangles of one piece that are joined without crossing a chain.
struct JoinedTriangles {
  std::vector<Index> set_of_triangle;
  std::vector<Index> face;  ///< per set: the face of the domain at its chain edges, or no_index
};
[[nodiscard]] JoinedTriangles joined_triangles(const Piece& piece, const Domain& domain, const Chains& chains);

/// The sets of all pieces of a rank. Sets of different pieces that are joined across a border tell each other their
/// faces.
class FacesOfPieces {
 public:
  /// Call it once for each piece of the rank, in their order.
  void add(const JoinedTriangles& sets, const KeptPart& part, const Chains& chains);
  /// Collective. Call it when all pieces have been added.
  void unite(const Border& border, Ranks& ranks);
  /// After unite(): the face of the domain around each triangle of a piece, as paint_faces() finds it. `sets` are those
  /// of add().
  [[nodiscard]] std::vector<Index> faces_of(std::size_t piece, JoinedTriangles sets) const;

 private:
  struct SetAtSide {
    Index set;
    bool on_chain;
  };
  std::vector<Index> first_;        ///< per piece: its first set
  std::vector<Index> face_;         ///< per set of the rank
  std::vector<SetAtSide> at_side_;  ///< per side of the rank, see Border
};

}  // namespace pardel::checker
