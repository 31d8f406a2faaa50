// What a command has made, and what it prints about it.
#pragma once

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string_view>

#include "../cli/points_outside.hpp"
#include "../core/digest.hpp"
#include "../distributed/distributed.hpp"
#include "job.hpp"

namespace pardel::mpi {

struct Seconds {
  double read = 0, refine = 0, pieces = 0, check = 0, write = 0, all = 0;
};

/// A mesh, and what this rank has of it.
struct Made {
  std::uint64_t points = 0, triangles = 0, constrained_edges = 0;  ///< of the whole mesh
  std::uint64_t least = UINT64_MAX, most = 0;                      ///< triangles of a piece
  cli::PointsOutside outside;                                      ///< of the pieces of this rank
  std::uint64_t margin = 0;                                        ///< MeshPiece::margin of this rank
  Digest digest;                                                   ///< of the pieces of this rank
  Seconds seconds;
  bool divided = false;       ///< each rank has read a part of the input
  std::optional<bool> valid;  ///< what the check has found; without a value: there was none

  void add(const MeshPiece& piece) {
    points = piece.points;
    triangles = piece.triangles;
    constrained_edges = piece.constrained_edges;
    least = std::min<std::uint64_t>(least, piece.mesh.triangles.size());
    most = std::max<std::uint64_t>(most, piece.mesh.triangles.size());
    outside.add(cli::points_outside(piece.mesh, piece.number.span()));
    margin += piece.margin;
    digest = digest + pardel::digest(piece.mesh);
    seconds.refine = piece.report.refine_seconds;
    seconds.pieces += piece.seconds;
  }
};

/// Prints on the first rank, unless `quiet`. Collective. `lines`: on the mesh; `threads`: of each rank; `making`: the
/// name of the longest step.
void print(const Made& made, std::string_view lines, const char* making, int threads,
           std::span<const std::filesystem::path> outputs, bool quiet, Job& job);

}  // namespace pardel::mpi
