// Reads PVTU, the list of the pieces of a mesh, and the pieces.
#include <string>
#include <utility>
#include <vector>

#include "../formats.hpp"
#include "mesh_readers.hpp"
#include "text_reader.hpp"

namespace pardel::files {
namespace {

/// The attributes Source of all elements Piece, in their order.
std::vector<std::string> sources_of_pieces(std::string_view text) {
  std::vector<std::string> sources;
  constexpr std::string_view element = "<Piece", attribute = "Source=\"";
  for (std::size_t at = text.find(element); at != std::string_view::npos; at = text.find(element, at + 1)) {
    const std::string_view tag = text.substr(at, text.find('>', at) - at);
    const std::size_t begin = tag.find(attribute);
    if (begin == std::string_view::npos) continue;
    const std::string_view value = tag.substr(begin + attribute.size());
    sources.emplace_back(value.substr(0, value.find('"')));
  }
  return sources;
}

}  // namespace

Result<Mesh> read_pvtu(const std::filesystem::path& file) {
  const auto text = read_file(file);
  if (!text) return text.error();
  const std::vector<std::string> sources = sources_of_pieces(*text);
  if (sources.empty())
    return Error{ErrorKind::invalid_input, file.string() + ": expected elements <Piece Source=\"...\">, found none"};
  std::vector<NumberedMesh> pieces;
  for (const std::string& source : sources) {
    Result<NumberedMesh> piece = read_vtu_piece(file.parent_path() / source);
    if (!piece) return piece.error();
    pieces.push_back(std::move(*piece));
  }
  return join_read_pieces(std::move(pieces), file);
}

}  // namespace pardel::files
