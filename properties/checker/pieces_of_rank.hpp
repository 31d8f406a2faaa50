// The pieces of a mesh that one rank checks, and how it gets them.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>

#include "../../core/join_pieces.hpp"
#include "../../core/result.hpp"

namespace pardel {

/// The pieces of one rank. A rank may have none. In the order of the whole mesh, the pieces of the first rank come
/// first, then those of the second one, and so on.
struct PiecesOfRank {
  std::size_t count = 0;
  /// Returns piece i, i < count: reads it from a file, or points to one that is in memory. The check calls it again if
  /// it needs a piece again; the mesh must then be the same.
  std::function<Result<std::shared_ptr<const NumberedMesh>>(std::size_t i)> read{};
};

/// One piece that the caller holds. It must outlive the result.
[[nodiscard]] inline PiecesOfRank only_piece(const NumberedMesh& piece) {
  return {1, [&piece](std::size_t) { return std::shared_ptr<const NumberedMesh>(std::shared_ptr<void>(), &piece); }};
}

}  // namespace pardel
