#include "mesh_in_pieces.hpp"

#include <algorithm>
#include <string>

#include "../core/neighbours.hpp"
#include "../properties/theorems/framework/local_ranks.hpp"

namespace pardel::fuzz {
namespace {

bool has_equal_corners(const Triangle& t) { return t.v[0] == t.v[1] || t.v[1] == t.v[2] || t.v[2] == t.v[0]; }

/// For each point of the whole mesh: its index in a piece, or no_index.
using LocalIndices = std::vector<Index>;

/// Fills the piece of the triangles [begin, end), without constrained edges.
LocalIndices take(const Mesh& whole, std::size_t begin, std::size_t end, Mesh& piece,
                  std::vector<std::uint64_t>& number) {
  LocalIndices local(whole.points.size(), no_index);
  for (std::size_t t = begin; t < end; ++t)
    for (const Index v : whole.triangles[t].v) local[v] = 0;
  const std::size_t attributes = whole.attributes_per_point;
  piece.attributes_per_point = attributes;
  for (std::size_t v = 0; v < local.size(); ++v) {
    if (local[v] == no_index) continue;
    local[v] = static_cast<Index>(number.size());
    number.push_back(v);
    piece.points.push_back(whole.points[v]);
    piece.point_markers.push_back(whole.point_markers.empty() ? 0 : whole.point_markers[v]);
    for (std::size_t k = 0; k < attributes; ++k)
      piece.point_attributes.push_back(whole.point_attributes[v * attributes + k]);
  }
  piece.region_attributes = whole.region_attributes;
  for (std::size_t t = begin; t < end; ++t) {
    Triangle triangle = whole.triangles[t];
    for (Index& v : triangle.v) v = local[v];
    piece.triangles.push_back(triangle);
    if (!whole.region.empty()) piece.region.push_back(whole.region[t]);
  }
  rebuild_neighbours(piece.triangles, piece.points.size());
  return local;
}

/// The points of the first piece that are also in the second one.
std::vector<Index> common_points(const LocalIndices& first, const LocalIndices& second) {
  std::vector<Index> common;
  for (std::size_t v = 0; v < first.size(); ++v)
    if (first[v] != no_index && second[v] != no_index) common.push_back(first[v]);
  return common;
}

}  // namespace

std::optional<MeshInPieces> in_pieces(const Mesh& mesh, std::size_t count) {
  const std::size_t n = mesh.triangles.size();
  if (n < count || std::any_of(mesh.triangles.begin(), mesh.triangles.end(), has_equal_corners)) return {};
  MeshInPieces made{std::vector<Mesh>(count), std::vector<std::vector<std::uint64_t>>(count),
                    std::vector<std::vector<SharedVertices>>(count), mesh.points.size()};
  std::vector<LocalIndices> locals;
  for (std::size_t k = 0; k < count; ++k)
    locals.push_back(take(mesh, n * k / count, n * (k + 1) / count, made.mesh[k], made.number[k]));

  for (std::size_t v = 0; v < mesh.points.size(); ++v)
    if (std::ranges::all_of(locals, [&](const LocalIndices& local) { return local[v] == no_index; })) return {};
  for (std::size_t k = 0; k < count; ++k)
    for (std::size_t other = 0; other < count; ++other)
      if (std::vector<Index> common = common_points(locals[k], locals[other]); other != k && !common.empty())
        made.shared[k].push_back({static_cast<int>(other), std::move(common)});
  for (ConstrainedEdge edge : mesh.constrained_edges) {
    const auto has_ends = [&](const LocalIndices& local) {
      return local[edge.a] != no_index && local[edge.b] != no_index;
    };
    const auto local = std::ranges::find_if(locals, has_ends);
    if (local == locals.end()) return {};
    edge.a = (*local)[edge.a];
    edge.b = (*local)[edge.b];
    made.mesh[static_cast<std::size_t>(local - locals.begin())].constrained_edges.push_back(edge);
  }
  return made;
}

Status write_pvtu(const MeshInPieces& pieces, const std::filesystem::path& file) {
  const Mesh& first = pieces.mesh.front();
  PiecesOfMesh index{{}, !first.region.empty(), first.attributes_per_point};
  VtuPieces files;
  for (std::size_t k = 0; k < pieces.mesh.size(); ++k) {
    index.files.push_back("piece_" + std::to_string(k) + ".vtu");
    if (Status added = files.add(pieces.mesh[k], pieces.number[k], file.parent_path() / index.files.back()); !added)
      return added;
  }
  if (Status placed = files.commit(); !placed) return placed;
  return pardel::write_pvtu(index, file);
}

Status write_msh(const MeshInPieces& pieces, const std::filesystem::path& file, MshEncoding encoding) {
  Status written = Done{};  // all ranks return the same
  properties::on_ranks(static_cast<int>(pieces.mesh.size()), [&](Ranks& ranks) {
    Status of_rank = write_msh_piece(pieces.piece(static_cast<std::size_t>(ranks.rank())), file, encoding, ranks);
    if (ranks.rank() == 0) written = std::move(of_rank);
  });
  return written;
}

}  // namespace pardel::fuzz
