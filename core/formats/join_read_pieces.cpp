// Joins the pieces of a mesh that have been read from files.
#include <algorithm>
#include <vector>

#include "mesh_readers.hpp"

namespace pardel::files {
namespace {

/// The pieces get one list of regions. If one piece has regions, all have, possibly none for all triangles.
void unite_regions(std::vector<NumberedMesh>& pieces) {
  std::vector<double> all;
  for (const NumberedMesh& piece : pieces)
    all.insert(all.end(), piece.mesh.region_attributes.begin(), piece.mesh.region_attributes.end());
  if (all.empty()) return;
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  for (NumberedMesh& piece : pieces) {
    Mesh& mesh = piece.mesh;
    mesh.region.resize(mesh.triangles.size(), no_index);
    for (Index& region : mesh.region)
      if (region != no_index) {
        const auto found = std::lower_bound(all.begin(), all.end(), mesh.region_attributes[region]);
        region = static_cast<Index>(found - all.begin());
      }
    mesh.region_attributes = all;
  }
}

}  // namespace

Result<Mesh> join_read_pieces(std::vector<NumberedMesh> pieces, const std::filesystem::path& file, FirstId first_id) {
  unite_regions(pieces);
  Result<Mesh> whole = join_pieces(pieces, first_id);
  if (!whole) return Error{whole.error().kind, file.string() + ": " + whole.error().message};
  return whole;
}

}  // namespace pardel::files
