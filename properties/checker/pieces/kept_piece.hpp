// KeptPiece: what a rank knows about a piece after it has read it for the first time.
#pragma once

#include "../model/measures.hpp"
#include "../model/wanted_size.hpp"
#include "kept_part.hpp"

namespace pardel::checker {

struct KeptPiece {
  std::size_t points = 0, triangles = 0, listed_edges = 0;
  bool has_geometry = false, has_labels = false, has_regions = false, has_attributes = false, has_markers = false;
  bool is_counter_clockwise = false;  ///< all its triangles are
  /// Nothing can be found in the piece alone, whatever is outside, unless a triangle contains the seed of a hole or the
  /// input has regions. Then the piece is not read again.
  bool is_clear = false;
  bool is_described = false;  ///< the stages that look at a piece alone have found something
  std::uint64_t open = 0;     ///< the number of triangles with tests that the scan left open
  Measures measures;
  Digest digest;  ///< if it has labels
  KeptPart part;  ///< if it has geometry
};

/// What a piece is judged by before the other pieces are known.
struct InputOfPieces {
  InputOfPieces(const Pslg& pslg, const Goal& goal)
      : domain(pslg, goal.convex_hull), wanted(pslg, goal), places(pslg.points), free(pslg, domain), ranges(pslg) {}

  Domain domain;
  WantedSize wanted;
  InputPlaces places;
  FreePoints free;
  AttributeRanges ranges;
};

/// `input`: nothing if it is not usable.
///
/// Without chains, check_delaunay() and check_goal() find at least what they find with chains, because chains only
/// excuse: an edge that need not be Delaunay, or a small angle. So if they find nothing here, they would find nothing
/// later.
///
/// Adds the numbers of settled points (part_to_keep()) to `settled`.
[[nodiscard]] KeptPiece kept_piece(const Piece& piece, const InputOfPieces* input, NumberSet& settled);

}  // namespace pardel::checker
