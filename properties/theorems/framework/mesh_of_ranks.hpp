// Compares what several ranks make with the mesh of one process.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "../../../core/digest.hpp"
#include "../../../core/join_pieces.hpp"
#include "../../../distributed/distributed.hpp"
#include "../../comparison/all_arrays.hpp"
#include "local_ranks.hpp"

namespace pardel::properties {

/// Each of `count` ranks calls make(ranks) for its piece: a Result<MeshPiece>. Returns how the pieces together differ
/// from the mesh of one process: by their digest, their counts, or by any array. Empty if they do not differ.
/// delays: as for on_ranks().
template <class Make>
[[nodiscard]] std::string difference_on_ranks(const Mesh& whole, int count, const Make& make,
                                              std::uint64_t delays = 0) {
  std::vector<NumberedMesh> pieces(static_cast<std::size_t>(count));
  std::vector<std::string> faults(pieces.size());
  on_ranks(
      count,
      [&](Ranks& ranks) {
        const auto here = static_cast<std::size_t>(ranks.rank());
        Result<MeshPiece> piece = make(ranks);
        if (!piece) {
          faults[here] = piece.error().message;
          return;
        }
        if (digest(*piece, ranks) != digest(whole)) faults[here] = "another digest";
        if (piece->triangles != whole.triangles.size() || piece->points != whole.points.size())
          faults[here] = "other counts";
        pieces[here] = {std::move(piece->mesh), std::move(piece->number)};
      },
      delays);
  for (const std::string& fault : faults)
    if (!fault.empty()) return "on " + std::to_string(count) + " ranks: " + fault;
  const Result<Mesh> joined = join_pieces(pieces);
  const std::string text = joined ? difference(whole, *joined) : joined.error().message;
  return text.empty() ? text : "on " + std::to_string(count) + " ranks: " + text;
}

}  // namespace pardel::properties
