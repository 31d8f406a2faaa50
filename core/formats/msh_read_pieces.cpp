// Reads the pieces of a partitioned mesh, one MSH file per partition.
#include <string>
#include <utility>
#include <vector>

#include "../formats.hpp"
#include "mesh_readers.hpp"
#include "text_reader.hpp"

namespace pardel::files {

Result<Mesh> read_msh_pieces(const std::filesystem::path& file, StopSignal* stop) {
  std::vector<NumberedMesh> pieces;
  std::size_t partitions = 1;
  for (std::size_t i = 1; i <= partitions; ++i) {
    const std::filesystem::path of_piece = msh_of_piece(file, static_cast<int>(i));
    const auto text = read_file(of_piece, stop);
    if (!text) return text.error();
    Result<MshPiece> piece = parse_msh_piece(*text, of_piece.string(), static_cast<int>(i), stop);
    if (!piece) return piece.error();
    if (i == 1) partitions = piece->partitions;
    if (piece->partitions != partitions)
      return Error{ErrorKind::invalid_input, of_piece.string() + ": belongs to a mesh with " +
                                                 std::to_string(piece->partitions) + " partitions, not " +
                                                 std::to_string(partitions) + " as " + msh_of_piece(file, 1).string()};
    pieces.push_back(std::move(*piece));
  }
  Result<Mesh> whole = join_read_pieces(std::move(pieces), file, {1});
  if (whole) whole->first_id = {1};
  return whole;
}

}  // namespace pardel::files
