#include "lines_in_holes.hpp"

#include <cstddef>

#include "../core/support/mesh_edges.hpp"
#include "../parallel/mesher.hpp"
#include "around_mesh.hpp"

namespace pardel::cli {
namespace {

/// The edges with no part of the domain beside them.
EdgeSet outside_domain(const Mesh& mesh, const std::vector<ConstrainedEdge>& drawn, const std::vector<Point>& holes) {
  EdgeSet all = to_edge_set(drawn);
  all.finish();
  Pslg pslg = part_of(mesh, all.edges);
  pslg.holes = holes;
  const Result<Meshed> domain = triangulate(pslg);
  if (!domain) return {};
  std::vector<char> is_beside(all.edges.size(), 0);
  for (const ConstrainedEdge& edge : domain->mesh.constrained_edges)
    if (edge.segment < is_beside.size()) is_beside[edge.segment] = 1;
  EdgeSet outside;  // in the order of `all`
  for (std::size_t i = 0; i < all.edges.size(); ++i)
    if (is_beside[i] == 0) outside.edges.push_back(all.edges[i]);
  return outside;
}

/// Those of the edges that enter no triangle; none if one crosses the boundary of the mesh.
EdgeSet outside_triangles(const Mesh& mesh, const EdgeSet& lines) {
  std::vector<Segment> edges = boundary(mesh);
  const std::size_t walls = edges.size();
  EdgeSet outline{edges};
  outline.finish();
  for (const Segment& line : lines.edges)
    if (!outline.contains(line.a, line.b)) edges.push_back(line);
  const Result<AroundMesh> around = around_mesh(part_of(mesh, edges), walls);
  if (!around) return {};
  const ConstrainedEdgeIndex index(around->hull);
  std::vector<char> is_inside(edges.size(), 0);
  for (Index t = 0; t < around->face.size(); ++t) {
    const Index face = around->face[t];
    if (around->is_bare[face] != 0 || around->is_out[face] != 0) continue;
    for (int i = 0; i < 3; ++i) {
      const auto [from, to] = side(around->hull.triangles[t], i);
      const ConstrainedEdge* edge = index.find(from, to);
      if (edge != nullptr && edge->segment < is_inside.size()) is_inside[edge->segment] = 1;
    }
  }
  EdgeSet outside;
  for (std::size_t i = walls; i < edges.size(); ++i)
    if (is_inside[i] == 0) outside.edges.push_back(edges[i]);
  return outside;  // in the order of `lines`
}

}  // namespace

EdgeSet lines_in_holes(const Mesh& mesh, const std::vector<ConstrainedEdge>& drawn, const std::vector<Point>& holes) {
  const EdgeSet lines = outside_domain(mesh, drawn, holes);
  return lines.edges.empty() ? EdgeSet{} : outside_triangles(mesh, lines);
}

}  // namespace pardel::cli
