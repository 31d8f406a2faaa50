#include "import_mesh.hpp"

#include <algorithm>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "../../core/support/mesh_edges.hpp"
#include "../../core/support/name_of_triangle.hpp"
#include "../arithmetic/predicates.hpp"
#include "../triangulation/flips.hpp"
#include "../triangulation/limits.hpp"
#include "join_subsegments.hpp"

namespace pardel::engine {
namespace {

std::string number_of(const Mesh& mesh, Index vertex) { return std::to_string(number_in_file(mesh, vertex)); }

Error bad_mesh(const Mesh& mesh, TriangleId id, const std::string& what) {
  return {ErrorKind::invalid_input, name_of_triangle(mesh, id, " of the mesh") + " " + what};
}

/// The side of `triangle` that runs from `from` to `to`, or 3 if there is none.
unsigned side_between(const Triangle& triangle, VertexId from, VertexId to) {
  for (unsigned side = 0; side < 3; ++side)
    if (triangle.v[next_corner[side]] == from && triangle.v[previous_corner[side]] == to) return side;
  return 3;
}

/// An error if a triangle names no vertices, is flat, or is turned. A turned triangle seems to overlap its neighbours,
/// so this has to be known before.
Status check_triangles(const Mesh& mesh, SparseAsk& ask) {
  for (TriangleId id = 0; id < mesh.triangles.size(); ++id) {
    ask();
    const Triangle& triangle = mesh.triangles[id];
    for (const Index v : triangle.v)
      if (v >= mesh.points.size()) return bad_mesh(mesh, id, "names a vertex that does not exist");
    if (!(orient2d(mesh.points[triangle.v[0]], mesh.points[triangle.v[1]], mesh.points[triangle.v[2]]) > 0))
      return bad_mesh(mesh, id, "is not positively oriented");
  }
  return Done{};
}

/// The error of two triangles that both have the side from `from` to `to`.
Error overlap(const Mesh& mesh, TriangleId id, TriangleId other, VertexId from, VertexId to) {
  return bad_mesh(mesh, id,
                  "overlaps " + name_of_triangle(mesh, other) + ": both lie on the same side of the edge " +
                      number_of(mesh, from) + "-" + number_of(mesh, to));
}

/// Copies the triangles and links each side to the neighbour's side. Returns an error if the mesh is inconsistent.
/// Precondition: check_triangles() accepts the mesh.
Status link_neighbours(const Mesh& mesh, Triangulation& t, SparseAsk& ask) {
  for (TriangleId id = 0; id < mesh.triangles.size(); ++id) {
    ask();
    const Triangle& triangle = mesh.triangles[id];
    Slot slot{triangle.v, {}};
    for (unsigned side = 0; side < 3; ++side) {
      const Index other = triangle.n[side];
      if (other == no_index) continue;
      if (other >= mesh.triangles.size()) return bad_mesh(mesh, id, "names a neighbour that does not exist");
      const unsigned back = side_between(mesh.triangles[other], slot.to(side), slot.from(side));
      if (back == 3 || mesh.triangles[other].n[back] != id)
        return side_between(mesh.triangles[other], slot.from(side), slot.to(side)) == 3
                   ? bad_mesh(mesh, id, "has a neighbour that does not agree")
                   : overlap(mesh, id, other, slot.from(side), slot.to(side));
      slot.n[side] = EdgeRef(other, back);
    }
    t.slots.push_back(slot);
  }
  return Done{};
}

/// A side of a triangle without a neighbour there.
struct BorderSide {
  VertexId from, to;
  TriangleId triangle;
  [[nodiscard]] std::pair<VertexId, VertexId> ends() const { return std::minmax(from, to); }
};

/// An error if two triangles lie on the same side of an edge, at least one of them without a neighbour there. O(n + b
/// log b) for n triangles and b sides on the border, if few edges join two vertices of the border.
Status check_border(const Mesh& mesh, const Triangulation& t, SparseAsk& ask) {
  std::vector<BorderSide> border;
  std::vector<char> on_border(mesh.points.size(), 0);
  for (TriangleId id = 0; id < t.slots.size(); ++id) {
    ask();
    for (unsigned side = 0; side < 3; ++side) {
      if (!t.slots[id].n[side].none()) continue;
      border.push_back({t.slots[id].from(side), t.slots[id].to(side), id});
      on_border[border.back().from] = on_border[border.back().to] = 1;
    }
  }
  const auto directed = [](const BorderSide& side) { return std::tuple(side.ends(), side.from, side.triangle); };
  std::ranges::sort(border, {}, directed);
  for (std::size_t i = 0; i + 1 < border.size(); ++i)
    if (border[i].from == border[i + 1].from && border[i].to == border[i + 1].to)
      return overlap(mesh, border[i].triangle, border[i + 1].triangle, border[i].from, border[i].to);
  for (TriangleId id = 0; id < t.slots.size(); ++id) {
    ask();
    for (unsigned side = 0; side < 3; ++side) {
      const VertexId from = t.slots[id].from(side), to = t.slots[id].to(side);
      if (t.slots[id].n[side].none() || on_border[from] == 0 || on_border[to] == 0) continue;
      const auto ends = BorderSide{from, to, id}.ends();
      auto other = std::ranges::lower_bound(border, ends, {}, &BorderSide::ends);
      for (; other != border.end() && other->ends() == ends; ++other)
        if (other->from == from) return overlap(mesh, id, other->triangle, from, to);
    }
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
  if (Status fine = check_triangles(mesh, ask); !fine) return fine.error();
  if (Status linked = link_neighbours(mesh, t, ask); !linked) return linked.error();
  if (Status manifold = check_border(mesh, t, ask); !manifold) return manifold.error();
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

  make_delaunay(t, threads);
  return domain;
}

}  // namespace pardel::engine
