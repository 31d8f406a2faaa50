#include "assemble.hpp"

#include <bit>
#include <string>

#include "../arithmetic/predicates.hpp"
#include "../concurrency/in_order.hpp"
#include "../triangulation/delaunay.hpp"
#include "../triangulation/flips.hpp"
#include "background.hpp"
#include "join_subsegments.hpp"

namespace pardel::engine {
namespace {

std::vector<Index> inverse(std::span<const Index> permutation) {
  std::vector<Index> result(permutation.size());
  for (std::size_t i = 0; i < permutation.size(); ++i) result[permutation[i]] = static_cast<Index>(i);
  return result;
}

Error bad_mesh(TriangleId id, const char* what) {
  return {ErrorKind::invalid_input, "triangle " + std::to_string(id) + " of the mesh " + what};
}

Error too_many_triangles() {
  return {ErrorKind::resources, "more triangles than the triangulation can number (2^29 - 1)"};
}

/// The side of `triangle` that neighbours `other`, or 3.
unsigned side_towards(const Triangle& triangle, VertexId from, VertexId to) {
  for (unsigned side = 0; side < 3; ++side)
    if (triangle.v[next_corner[side]] == from && triangle.v[previous_corner[side]] == to) return side;
  return 3;
}

Status link_neighbours(const Mesh& mesh, Triangulation& t) {
  for (TriangleId id = 0; id < mesh.triangles.size(); ++id) {
    const Triangle& triangle = mesh.triangles[id];
    for (const Index v : triangle.v)
      if (v >= mesh.points.size()) return bad_mesh(id, "names a vertex that does not exist");
    if (!(orient2d(mesh.points[triangle.v[0]], mesh.points[triangle.v[1]], mesh.points[triangle.v[2]]) > 0))
      return bad_mesh(id, "is not positively oriented");
    Slot slot{triangle.v, {}};
    for (unsigned side = 0; side < 3; ++side) {
      const Index other = triangle.n[side];
      if (other == no_index) continue;
      if (other >= mesh.triangles.size()) return bad_mesh(id, "names a neighbour that does not exist");
      const unsigned back = side_towards(mesh.triangles[other], slot.to(side), slot.from(side));
      if (back == 3 || mesh.triangles[other].n[back] != id) return bad_mesh(id, "has a neighbour that does not agree");
      slot.n[side] = EdgeRef(other, back);
    }
    t.slots.push_back(slot);
  }
  return Done{};
}

/// Marks the mesh's constrained edges in the triangulation and lists them and every boundary edge.
std::vector<ConstrainedEdge> constrain_edges(const Mesh& mesh, Triangulation& t) {
  std::vector<ConstrainedEdge> pieces;
  std::vector<Index> start(mesh.points.size() + 1, 0), list(mesh.constrained_edges.size());
  for (const ConstrainedEdge& e : mesh.constrained_edges) ++start[std::min(e.a, e.b) + 1U];
  for (std::size_t v = 1; v < start.size(); ++v) start[v] += start[v - 1];
  std::vector<Index> next = start;
  for (Index i = 0; i < mesh.constrained_edges.size(); ++i)
    list[next[std::min(mesh.constrained_edges[i].a, mesh.constrained_edges[i].b)]++] = i;

  for (TriangleId id = 0; id < t.slots.size(); ++id)
    for (unsigned side = 0; side < 3; ++side) {
      const EdgeRef across = t.slots[id].n[side];
      if (!across.none() && across.triangle() < id) continue;  // seen from the other side already
      const VertexId a = t.slots[id].from(side), b = t.slots[id].to(side);
      const ConstrainedEdge* listed = nullptr;
      for (Index k = start[std::min(a, b)]; k < start[std::min(a, b) + 1U]; ++k) {
        const ConstrainedEdge& e = mesh.constrained_edges[list[k]];
        if (std::max(e.a, e.b) == std::max(a, b)) listed = &e;
      }
      if (listed == nullptr && !across.none()) continue;
      t.constrain(EdgeRef(id, side));
      pieces.push_back(listed == nullptr ? ConstrainedEdge{a, b, no_index, 0} : *listed);
    }
  return pieces;
}

/// Puts the input's points back into the input's order.
void restore_order(std::span<const Index> input_of_vertex, Array<Point>& points, int threads) {
  const Array<Point> moved = make_array(threads, input_of_vertex.size(), [&](std::size_t v) { return points[v]; });
  parallel_blocks(threads, moved.size(), [&](std::size_t first, std::size_t last, std::size_t) {
    for (std::size_t v = first; v < last; ++v) points[input_of_vertex[v]] = moved[v];
  });
}

/// Vertex marker: its own, else that of a line it lies on, else 1 on the boundary, else 0.
void mark_vertices(Mesh& mesh, const PointData& data, int threads) {
  mesh.point_markers = make_array(threads, mesh.points.size(), [](std::size_t) { return 0; });
  for (const ConstrainedEdge& e : mesh.constrained_edges)
    for (const Index v : {e.a, e.b})
      if (e.marker != 0 && (mesh.point_markers[v] == 0 || (e.segment != no_index && mesh.point_markers[v] == 1)))
        mesh.point_markers[v] = e.marker;
  for (std::size_t v = 0; v < data.markers.size(); ++v)
    if (data.markers[v] != 0) mesh.point_markers[v] = data.markers[v];
}

void interpolate_attributes(Mesh& mesh, const PointData& data, std::vector<std::array<Index, 3>> background) {
  const std::size_t k = data.attributes_per_point;
  if (k == 0) return;
  const std::size_t inputs = data.attributes.size() / k;
  mesh.attributes_per_point = k;
  mesh.point_attributes.reserve(mesh.points.size() * k);
  mesh.point_attributes.append(data.attributes);
  const Background on(mesh.points.span().first(inputs), std::move(background));
  for (std::size_t v = inputs; v < mesh.points.size(); ++v) {
    const Located at = on.locate(mesh.points[v]);
    for (std::size_t a = 0; a < k; ++a) {
      double value = 0;
      for (unsigned i = 0; i < 3; ++i) value += at.weight[i] * data.attributes[at.v[i] * k + a];
      mesh.point_attributes.push_back(value);
    }
  }
}

}  // namespace

Result<Assembled> assemble(const Pslg& pslg, bool convex_hull, int threads) {
  Result<Delaunay> triangulated = delaunay(pslg.points, threads);
  if (!triangulated) return triangulated.error();
  Assembled domain;
  Triangulation& t = domain.triangulation;
  t = std::move(triangulated->triangulation);
  domain.input_of_vertex = std::move(triangulated->input_of_vertex);

  std::vector<Constraint> constraints;
  if (!pslg.segments.empty()) {
    const std::vector<Index> vertex_of_input = inverse(domain.input_of_vertex.span());
    for (Index s = 0; s < pslg.segments.size(); ++s) {
      const Segment& segment = pslg.segments[s];
      if (segment.a >= pslg.points.size() || segment.b >= pslg.points.size())
        return Error{ErrorKind::invalid_input, "segment " + std::to_string(s) + " names a point that does not exist"};
      constraints.push_back({vertex_of_input[segment.a], vertex_of_input[segment.b]});
      domain.segment_of_line.push_back(s);
      domain.marker_of_line.push_back(segment.marker);
    }
  }
  if (Status inserted = insert_constraints(t, constraints); !inserted) return inserted.error();

  DomainRules rules{convex_hull || pslg.segments.empty(), pslg.holes, {}};
  for (const Region& region : pslg.regions) rules.region_seeds.push_back(region.seed);
  for (const Constraint hull_edge : carve(t, rules, threads)) {
    constraints.push_back(hull_edge);
    domain.segment_of_line.push_back(no_index);
    domain.marker_of_line.push_back(0);
  }
  if (t.slots.empty())
    return Error{ErrorKind::invalid_input, "no domain is left: the segments enclose nothing, or holes take all of it"};
  t.origin = make_array(threads, t.points.size(), [](std::size_t) { return input_vertex; });
  domain.lines = Lines(t.points, constraints);
  return domain;
}

Result<Assembled> assemble(const Mesh& mesh) {
  if (mesh.triangles.size() > max_triangles) return too_many_triangles();
  if (mesh.triangles.empty()) return Error{ErrorKind::invalid_input, "the mesh has no triangles"};
  for (const ConstrainedEdge& e : mesh.constrained_edges)
    if (e.a >= mesh.points.size() || e.b >= mesh.points.size())
      return Error{ErrorKind::invalid_input, "a constrained edge of the mesh names a vertex that does not exist"};
  Assembled domain;
  Triangulation& t = domain.triangulation;
  t.points = mesh.points;
  if (Status linked = link_neighbours(mesh, t); !linked) return linked.error();
  if (mesh.region.size() == mesh.triangles.size()) t.region = mesh.region;
  Joined joined = join_pieces(mesh, constrain_edges(mesh, t));
  t.origin = std::move(joined.origin);
  domain.lines = Lines(t.points, joined.lines);
  domain.segment_of_line = std::move(joined.segment_of_line);
  domain.marker_of_line = std::move(joined.marker_of_line);
  domain.input_of_vertex.resize(t.points.size());
  for (Index v = 0; v < t.points.size(); ++v) domain.input_of_vertex[v] = v;

  std::vector<EdgeRef> all;
  for (TriangleId id = 0; id < t.slots.size(); ++id)
    for (unsigned side = 0; side < 3; ++side)
      if (!locally_delaunay(t, EdgeRef(id, side))) all.push_back(EdgeRef(id, side));
  std::vector<TriangleId> changed;
  restore_delaunay(t, std::move(all), changed);
  return domain;
}

std::vector<std::array<Index, 3>> corners(const Assembled& domain) {
  std::vector<std::array<Index, 3>> result;
  result.reserve(domain.triangulation.slots.size());
  for (const Slot& slot : domain.triangulation.slots) {
    std::array<Index, 3> v = slot.v;
    for (Index& corner : v)
      if (corner < domain.input_of_vertex.size()) corner = domain.input_of_vertex[corner];
    result.push_back(v);
  }
  return result;
}

Mesh disassemble(Assembled&& domain, std::vector<double> region_attributes, const PointData& data,
                 std::vector<std::array<Index, 3>> background, int threads) {
  Triangulation& t = domain.triangulation;
  Mesh mesh;
  const std::size_t inputs = domain.input_of_vertex.size();
  const auto number = [&](VertexId v) { return v < inputs ? domain.input_of_vertex[v] : v; };
  const auto triangle_of = [&](EdgeRef out) { return out.none() ? no_index : out.triangle(); };
  const auto constrained_edge = [&](const Slot& slot, unsigned side) {
    const Index line = domain.lines.line_of(t, slot.from(side), slot.to(side));
    int marker = domain.marker_of_line[line];
    if (marker == 0 && slot.n[side].none()) marker = 1;
    return ConstrainedEdge{number(slot.from(side)), number(slot.to(side)), domain.segment_of_line[line], marker};
  };
  Array<Triangle> triangles = Array<Triangle>::recast(std::move(t.slots));
  std::vector<std::vector<ConstrainedEdge>> edges(block_count(triangles.size()));
  parallel_blocks(threads, triangles.size(), [&](std::size_t first, std::size_t last, std::size_t block) {
    for (std::size_t id = first; id < last; ++id) {
      const auto slot = std::bit_cast<Slot>(triangles[id]);
      if (slot.any_constrained())
        for (unsigned side = 0; side < 3; ++side) {
          const EdgeRef across = slot.n[side];
          if (across.constrained() && (across.none() || across.triangle() > id))
            edges[block].push_back(constrained_edge(slot, side));
        }
      triangles[id] = {{number(slot.v[0]), number(slot.v[1]), number(slot.v[2])},
                       {triangle_of(slot.n[0]), triangle_of(slot.n[1]), triangle_of(slot.n[2])}};
    }
  });
  for (const auto& block : edges)
    mesh.constrained_edges.insert(mesh.constrained_edges.end(), block.begin(), block.end());
  mesh.triangles = std::move(triangles);
  restore_order(domain.input_of_vertex.span(), t.points, threads);
  parallel_blocks(threads, t.origin.size(), [&](std::size_t first, std::size_t last, std::size_t) {
    for (std::size_t v = first; v < last; ++v)
      if (t.origin[v] < domain.lines.size()) {
        const Index segment = domain.segment_of_line[t.origin[v]];
        t.origin[v] = segment == no_index ? hull_vertex : segment;
      }
  });

  mesh.points = std::move(t.points);
  mesh.origin = std::move(t.origin);
  mesh.region = std::move(t.region);
  mesh.region_attributes = std::move(region_attributes);
  mark_vertices(mesh, data, threads);
  interpolate_attributes(mesh, data, std::move(background));
  return mesh;
}

}  // namespace pardel::engine
