// Reads PVTU, the list of the pieces of a mesh, and the pieces.
#include <algorithm>
#include <string>
#include <vector>

#include "../formats.hpp"
#include "../join_pieces.hpp"
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

/// A mesh has one list of regions; each piece has its own.
void unite_regions(std::vector<NumberedMesh>& pieces) {
  std::vector<double> all;
  for (const NumberedMesh& piece : pieces)
    all.insert(all.end(), piece.mesh.region_attributes.begin(), piece.mesh.region_attributes.end());
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  for (NumberedMesh& piece : pieces) {
    for (Index& region : piece.mesh.region)
      if (region != no_index) {
        const auto found = std::lower_bound(all.begin(), all.end(), piece.mesh.region_attributes[region]);
        region = static_cast<Index>(found - all.begin());
      }
    piece.mesh.region_attributes = all;
  }
}

}  // namespace

Result<Mesh> read_pvtu(const std::filesystem::path& file) {
  const auto sources = files_of_pieces(file);
  if (!sources) return sources.error();
  std::vector<NumberedMesh> pieces;
  for (const std::filesystem::path& source : *sources) {
    Result<NumberedMesh> piece = read_vtu_piece(source);
    if (!piece) return piece.error();
    pieces.push_back(std::move(*piece));
  }
  unite_regions(pieces);
  Result<Mesh> whole = join_pieces(pieces);
  if (!whole) return Error{whole.error().kind, file.string() + ": " + whole.error().message};
  return whole;
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
