// Piece: a piece of a mesh while it is in memory.
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>

#include "../../../core/ranks.hpp"
#include "../../../core/result.hpp"
#include "../pieces_of_rank.hpp"
#include "../stages/stages.hpp"

namespace pardel::checker {

/// What is checked, and the ranks that check it.
struct Task {
  const Pslg& pslg;
  const Goal& goal;
  const CheckOptions& options;
  Ranks& ranks;
};

struct Piece {
  std::shared_ptr<const NumberedMesh> source;
  Subject subject;  ///< the piece, with the names of its vertices and triangles in the whole mesh
  Scan scanned;
  Sanity sanity;
  std::optional<Adjacency> adjacency;  ///< neighbours within the piece; nothing if sanity.geometry is false
  std::uint64_t found = 0;             ///< the number of violations that these stages have found
  bool is_counter_clockwise = true;    ///< all its triangles are

  [[nodiscard]] const Mesh& mesh() const { return source->mesh; }
  /// Per vertex: its number in the whole mesh.
  [[nodiscard]] std::span<const std::uint64_t> number() const { return source->number.span(); }
};

/// Opens the pieces of a rank, one at a time.
class PieceReader {
 public:
  PieceReader(const PiecesOfRank& pieces, const Task& task) : pieces_(pieces), task_(task) {}

  [[nodiscard]] std::size_t count() const { return pieces_.count; }
  /// Closes the piece that is open, reads piece i, and runs the stages that look at a piece alone: whether its parts
  /// are usable, and if they are, orientation and neighbours. Their findings go to `found`. `names`: of triangles and
  /// listed edges; those of vertices are the numbers of the piece. The result is valid until the next call.
  ///
  /// If this piece is open already, and these stages have found nothing in it, it remains open.
  ///
  /// Errors: those of PiecesOfRank::read(); invalid_input if the piece has not one number for each vertex.
  [[nodiscard]] Result<Piece*> open(std::size_t i, const Numbering& names, Findings& found);
  /// From now on, a piece without regions has no region for each triangle, because other pieces have regions.
  void expect_regions() { expects_regions_ = true; }
  /// Frees the memory of the piece that is open. The only piece of a rank remains open.
  void close();

 private:
  const PiecesOfRank& pieces_;
  const Task& task_;
  bool expects_regions_ = false;
  std::size_t number_ = 0;  ///< of the open piece
  std::optional<Piece> open_;
};

/// The rank that compares what the pieces say about the vertex with this number.
struct Referees {
  Referees(std::uint64_t points, int ranks) : share_(points / static_cast<std::uint64_t>(ranks) + 1) {}
  [[nodiscard]] int of(std::uint64_t number) const { return static_cast<int>(number / share_); }
  [[nodiscard]] std::uint64_t first(int rank) const { return static_cast<std::uint64_t>(rank) * share_; }
  [[nodiscard]] std::uint64_t share() const { return share_; }

 private:
  std::uint64_t share_;
};

/// True for the vertices of a piece that other pieces may have, too: the ends of sides without a neighbour in the
/// piece, and vertices without a triangle.
[[nodiscard]] inline bool is_at_border(Index v, const Adjacency& adjacency) {
  return adjacency.on_boundary(v) || !adjacency.has_triangle(v);
}

}  // namespace pardel::checker
