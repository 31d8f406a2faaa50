// The input points at which no segment and no edge of the convex outline ends.
#pragma once

#include <span>
#include <vector>

#include "../model/domain.hpp"
#include "piece.hpp"

namespace pardel::checker {

/// Such a point concerns no chain and no boundary: it has to be a vertex, with its data, and nothing else. One piece
/// can decide this.
class FreePoints {
 public:
  FreePoints(const Pslg& pslg, const Domain& domain) : pslg_(pslg), domain_(domain) {}

  /// True if vertex v is the input point with its number, if this point is free, and if nothing is wrong with it: it
  /// has the place and the data of the point. All its triangles are in this piece; or it has none, and the point is not
  /// in the domain. Listed edges are not examined. Precondition: the piece has an adjacency.
  [[nodiscard]] bool is_settled(const Piece& piece, Index v) const;

 private:
  [[nodiscard]] bool has_data_of(const Mesh& mesh, Index v, Index point) const;

  const Pslg& pslg_;
  const Domain& domain_;
};

}  // namespace pardel::checker
