// Reads PVTU, the list of the pieces of a mesh, and the pieces.
#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "../formats.hpp"
#include "mesh_readers.hpp"
#include "text_reader.hpp"
#include "xml_tag.hpp"

namespace pardel::files {
namespace {

/// The attributes Source of all elements Piece, in their order. `name`: the file, for messages.
Result<std::vector<std::string>> sources_of_pieces(std::string_view text, const std::string& name) {
  std::vector<std::string> sources;
  for (std::size_t at = next_xml_tag(text, 0); at != std::string_view::npos;) {
    const XmlTag tag = xml_tag_at(text, at);
    if (tag.name == "Piece") {
      const std::string_view source = tag["Source"];
      if (source.empty()) {
        const auto line = 1 + std::ranges::count(text.substr(0, at), '\n');
        return Error{ErrorKind::invalid_input,
                     name + ":" + std::to_string(line) + ": expected <Piece Source=\"...\">, found no Source"};
      }
      sources.push_back(xml_text(source));
    }
    at = next_xml_tag(text, tag.end);
  }
  return sources;
}

}  // namespace

Result<Mesh> read_pvtu(const std::filesystem::path& file, StopSignal* stop) {
  const auto sources = files_of_pieces(file);
  if (!sources) return sources.error();
  std::vector<NumberedMesh> pieces;
  for (const std::filesystem::path& source : *sources) {
    Result<NumberedMesh> piece = read_piece(source, stop);
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
  const auto sources = files::sources_of_pieces(*text, pvtu.string());
  if (!sources) return sources.error();
  std::vector<std::filesystem::path> files;
  for (const std::string& source : *sources) files.push_back(pvtu.parent_path() / source);
  if (files.empty())
    return Error{ErrorKind::invalid_input, pvtu.string() + ": expected elements <Piece Source=\"...\">, found none"};
  return files;
}

}  // namespace pardel
