#include "import_mesh.hpp"

#include <algorithm>
#include <string>

#include "../../core/support/mesh_edges.hpp"
#include "../arithmetic/predicates.hpp"
#include "../scheduling/limits.hpp"
#include "../triangulation/flips.hpp"
#include "join_subsegments.hpp"

namespace pardel::engine {
namespace {

/// Names the triangle, and its corners as in the file of the mesh: not every file numbers triangles.
Error bad_mesh(const Mesh& mesh, TriangleId id, const char* what) {
  const auto corner = [&](int i) { return std::to_string(number_in_file(mesh, mesh.triangles[id].v[i])); };
  return {ErrorKind::invalid_input,
          "triangle " + std::to_string(std::uint64_t{id} + static_cast<unsigned>(mesh.first_id.value)) +
              " of the mesh (vertices " + corner(0) + ", " + corner(1) + ", " + corner(2) + ") " + what};
}

/// The side of `triangle` that runs from `from` to `to`, or 3 if there is none.
unsigned side_between(const Triangle& triangle, VertexId from, VertexId to) {
  for (unsigned side = 0; side < 3; ++side)
    if (triangle.v[next_corner[side]] == from && triangle.v[previous_corner[side]] == to) return side;
  return 3;
}

/// Copies the triangles and links each side to the neighbour's side. Returns an error if the mesh is inconsistent.
Status link_neighbours(const Mesh& mesh, Triangulation& t, SparseAsk& ask) {
  for (TriangleId id = 0; id < mesh.triangles.size(); ++id) {
    ask();
    const Triangle& triangle = mesh.triangles[id];
    for (const Index v : triangle.v)
      if (v >= mesh.points.size()) return bad_mesh(mesh, id, "names a vertex that does not exist");
    if (!(orient2d(mesh.points[triangle.v[0]], mesh.points[triangle.v[1]], mesh.points[triangle.v[2]]) > 0))
      return bad_mesh(mesh, id, "is not positively oriented");
    Slot slot{triangle.v, {}};
    for (unsigned side = 0; side < 3; ++side) {
      const Index other = triangle.n[side];
      if (other == no_index) continue;
      if (other >= mesh.triangles.size()) return bad_mesh(mesh, id, "names a neighbour that does not exist");
      const unsigned back = side_between(mesh.triangles[other], slot.to(side), slot.from(side));
      if (back == 3 || mesh.triangles[other].n[back] != id)
        return bad_mesh(mesh, id, "has a neighbour that does not agree");
      slot.n[side] = EdgeRef(other, back);
    }
    t.slots.push_back(slot);
  }
  return Done{};
}

/// Marks the mesh's constrained edges and all boundary edges in the triangulation, and returns them.
std::vector<ConstrainedEdge> constrain_edges(const Mesh& mesh, Triangulation& t, SparseAsk& ask) {
  std::vector<ConstrainedEdge> subsegments;
  const ConstrainedEdgeIndex constrained(mesh);
  for (TriangleId id = 0; id < t.slots.size(); ++id) {
    ask();
    for (unsigned side = 0; side < 3; ++side) {
      const EdgeRef across = t.slots[id].n[side];
      if (!across.none() && across.triangle() < id) continue;  // handled from the other side
      const VertexId a = t.slots[id].from(side), b = t.slots[id].to(side);
      const ConstrainedEdge* listed = constrained.find(a, b);
      if (listed == nullptr && !across.none()) continue;
      t.constrain(EdgeRef(id, side));
      subsegments.push_back(listed == nullptr ? ConstrainedEdge{a, b, no_index, 0} : *listed);
    }
  }
  return subsegments;
}

}  // namespace

Result<DomainTriangulation> import_mesh(const Mesh& mesh, const Threads& threads) {
  if (mesh.triangles.size() > max_engine_triangles) return too_many_triangles();
  if (mesh.triangles.empty()) return Error{ErrorKind::invalid_input, "the mesh has no triangles"};
  for (const ConstrainedEdge& e : mesh.constrained_edges)
    if (e.a >= mesh.points.size() || e.b >= mesh.points.size())
      return Error{ErrorKind::invalid_input, "a constrained edge of the mesh names a vertex that does not exist"};
  SparseAsk ask(threads.stop);
  DomainTriangulation domain;
  Triangulation& t = domain.triangulation;
  t.points = mesh.points;
  if (Status linked = link_neighbours(mesh, t, ask); !linked) return linked.error();
  if (mesh.region.size() == mesh.triangles.size()) t.region = mesh.region;
  domain.subsegments = constrain_edges(mesh, t, ask);
  JoinedSegments joined = join_subsegments(mesh, domain.subsegments, threads);
  t.origin = std::move(joined.origin);
  domain.given_origin.assign(mesh.points.size(), input_vertex);
  if (mesh.origin.size() == mesh.points.size()) std::ranges::copy(mesh.origin, domain.given_origin.begin());
  std::vector<int> markers;
  for (const ConstrainedEdge& e : domain.subsegments) markers.push_back(e.marker);
  domain.segments = DomainSegments(t.points, joined.segments, {}, threads);
  domain.segments.set_pieces(std::move(joined.pieces), std::move(markers));
  for (const Index first : joined.subsegment) domain.input_segment.push_back(domain.subsegments[first].segment);
  domain.input_of_vertex.resize(t.points.size());
  for (Index v = 0; v < t.points.size(); ++v) domain.input_of_vertex[v] = v;

  std::vector<EdgeRef> suspects;
  for (TriangleId id = 0; id < t.slots.size(); ++id) {
    ask();
    for (unsigned side = 0; side < 3; ++side)
      if (!locally_delaunay(t, EdgeRef(id, side))) suspects.push_back(EdgeRef(id, side));
  }
  std::vector<TriangleId> changed;
  restore_delaunay(t, std::move(suspects), changed, threads);
  return domain;
}

}  // namespace pardel::engine
