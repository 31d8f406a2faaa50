// Pieces of a mesh with patches, made one after another, so that no more than one has to be in memory.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "../../parallel/filling/division.hpp"
#include "../../parallel/filling/filled_round.hpp"
#include "../../parallel/patches/lay_patches.hpp"
#include "../../parallel/sizing/background.hpp"
#include "../distributed.hpp"

namespace pardel::engine {

/// What is around the patches is a whole mesh, usually a small one. The triangles of patches follow from the numbers of
/// their strips, so any piece can be made without the others, and the pieces are the same wherever they are made.
///
/// The points and triangles have the numbers that they have in the mesh of refine_filled().
class FilledPieces {
 public:
  /// Divides the mesh of a round whose report has been written. `input` belongs to the round. `report`: of the round.
  /// Errors: resources if the mesh has more points or triangles than an Index can number, or a piece more than
  /// the engine.
  [[nodiscard]] static Result<FilledPieces> make(FilledRound round, InputData input, Report report, std::size_t pieces,
                                                 const Threads& threads);

  /// The triangles around the patches, with all that a mesh has. Their sides at patches have neighbours beyond.
  [[nodiscard]] const Mesh& around() const { return around_; }
  /// Makes a piece. MeshPiece::shared names pieces by their numbers, not ranks. O(n) for n triangles of the piece, and
  /// for those around the patches. The number of threads does not change the result.
  [[nodiscard]] MeshPiece piece(std::size_t number, const Threads& threads) const;

 private:
  FilledPieces(Filling filling, Mesh around, std::vector<PlacesOfPatch> places, std::vector<Seam> seams,
               InputData input, Report report, std::size_t pieces, const Threads& threads);

  friend class FilledPieceMaker;
  Filling filling_;
  Mesh around_;
  std::vector<PlacesOfPatch> places_;
  std::vector<Seam> seams_;
  InputData input_;
  Report report_;
  std::optional<Background> background_;  ///< of the attributes, if there are any
  Division division_;
  std::vector<PointOfPiece> shared_;
  std::vector<Index> first_triangle_;  ///< per constrained edge: the first triangle beside it; ascending
  std::vector<char> is_corner_;        ///< per point around the patches: of a triangle there
};

}  // namespace pardel::engine
