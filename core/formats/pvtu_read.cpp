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
  const auto sources = files_of_pieces(file);
  if (!sources) return sources.error();
  std::vector<NumberedMesh> pieces;
  for (const std::filesystem::path& source : *sources) {
    Result<NumberedMesh> piece = read_vtu_piece(source);
    // The list may name any file, so the message names the list, too.
    if (!piece) return Error{piece.error().kind, file.string() + ": " + piece.error().message};
    pieces.push_back(std::move(*piece));
  }
  return join_read_pieces(std::move(pieces), file);
}

}  // namespace pardel::files

namespace pardel {

Result<std::vector<std::filesystem::path>> files_of_pieces(const std::filesystem::path& pvtu) {
  const auto text = files::read_file(pvtu);
  if (!text) return text.error();
  std::vector<std::filesystem::path> files;
  for (const std::string& source : files::sources_of_pieces(*text)) files.push_back(pvtu.parent_path() / source);
  if (files.empty())
    return Error{ErrorKind::invalid_input, pvtu.string() + ": expected elements <Piece Source=\"...\">, found none"};
  return files;
}

}  // namespace pardel
