#include "export_mesh.hpp"

#include <algorithm>
#include <bit>
#include <optional>
#include <utility>
#include <vector>

#include "../arithmetic/between_ends.hpp"
#include "../decomposition/hilbert_order.hpp"
#include "../sizing/background.hpp"
#include "../threads/parallel_arrays.hpp"

namespace pardel::engine {
namespace {

/// The index of a vertex in the mesh.
Index mesh_vertex(const DomainTriangulation& domain, VertexId v) {
  return v < domain.input_of_vertex.size() ? domain.input_of_vertex[v] : v;
}

/// Converts the triangles in place, and lists the constrained edges in the order of the triangles.
void export_triangles(DomainTriangulation& domain, Mesh& mesh, const Threads& threads) {
  const auto vertex = [&](VertexId v) { return mesh_vertex(domain, v); };
  const auto neighbour = [](EdgeRef out) { return out.none() ? no_index : out.triangle(); };
  Array<Triangle> triangles = Array<Triangle>::recast(std::move(domain.triangulation.slots));
  std::vector<std::vector<ConstrainedEdge>> edges(block_count(triangles.size()));
  parallel_blocks(threads, triangles.size(), [&](std::size_t first, std::size_t last, std::size_t block) {
    for (std::size_t id = first; id < last; ++id) {
      const auto slot = std::bit_cast<Slot>(triangles[id]);
      if (slot.any_constrained())
        for (unsigned side = 0; side < 3; ++side) {
          const EdgeRef across = slot.n[side];
          if (across.constrained() && (across.none() || across.triangle() > id))
            if (const auto e = constrained_edge(domain, slot, side))
              edges[block].push_back({vertex(e->a), vertex(e->b), e->segment, e->marker});
        }
      triangles[id] = {{vertex(slot.v[0]), vertex(slot.v[1]), vertex(slot.v[2])},
                       {neighbour(slot.n[0]), neighbour(slot.n[1]), neighbour(slot.n[2])}};
    }
  });
  for (const auto& block : edges)
    mesh.constrained_edges.insert(mesh.constrained_edges.end(), block.begin(), block.end());
  mesh.triangles = std::move(triangles);
}

/// Puts the input points in the order of the input. The vertices of the triangulation have another order.
void restore_order(std::span<const Point> input, Array<Point>& points, const Threads& threads) {
  parallel_blocks(threads, input.size(), [&](std::size_t first, std::size_t last, std::size_t) {
    std::copy(input.begin() + static_cast<std::ptrdiff_t>(first), input.begin() + static_cast<std::ptrdiff_t>(last),
              points.begin() + first);
  });
}

/// Among the first vertices, which get the order of the input, moves the origins that are not input_vertex.
void restore_order_of_origins(std::span<const Index> input_of_vertex, Array<Index>& origin, SparseAsk& ask) {
  std::vector<std::pair<Index, Index>> moved;
  for (std::size_t v = 0; v < input_of_vertex.size(); ++v) {
    ask();
    if (origin[v] != input_vertex) moved.emplace_back(input_of_vertex[v], std::exchange(origin[v], input_vertex));
  }
  for (const auto& [v, its_origin] : moved) origin[v] = its_origin;
}

void export_origins(DomainTriangulation& domain, Mesh& mesh, const Threads& threads) {
  Array<Index>& origin = domain.triangulation.origin;
  name_input_segments(domain, threads);
  SparseAsk ask(threads.stop);
  restore_order_of_origins(domain.input_of_vertex.span(), origin, ask);
  std::ranges::copy(domain.given_origin, origin.begin());
  mesh.origin = std::move(origin);
}

/// The edges of segments that have a marker in the input, in the order of the segments.
std::vector<const ConstrainedEdge*> edges_with_own_marker(const DomainTriangulation& domain, const Mesh& mesh) {
  std::vector<bool> has_marker;
  const auto note = [&](Index input, int marker) {
    if (marker == 0 || input == no_index) return;
    if (has_marker.size() <= input) has_marker.resize(std::size_t{input} + 1, false);
    has_marker[input] = true;
  };
  for (const ConstrainedEdge& e : domain.subsegments) note(e.segment, e.marker);
  for (Index s = 0; s < domain.segments.size() && domain.subsegments.empty(); ++s)
    note(domain.input_segment[s], domain.segments[s].marker);
  std::vector<const ConstrainedEdge*> edges;
  for (const ConstrainedEdge& e : mesh.constrained_edges)
    if (e.segment < has_marker.size() && has_marker[e.segment]) edges.push_back(&e);
  std::ranges::stable_sort(edges, {}, &ConstrainedEdge::segment);
  return edges;
}

/// The marker of a vertex is its marker in the input. If this is 0 or missing, it is the marker of the first segment
/// with a marker on which the vertex lies. If there is none, it is 1 on the boundary and 0 elsewhere.
void mark_vertices(Mesh& mesh, const DomainTriangulation& domain, const PointData& data, const Threads& threads) {
  mesh.point_markers = Array<int>::zeroes(mesh.points.size());
  const auto mark = [&](const ConstrainedEdge& e) {
    for (const Index v : {e.a, e.b})
      if (mesh.point_markers[v] == 0) mesh.point_markers[v] = e.marker;
  };
  SparseAsk ask(threads.stop);
  for (const ConstrainedEdge* e : edges_with_own_marker(domain, mesh)) {
    ask();
    mark(*e);
  }
  for (const ConstrainedEdge& e : mesh.constrained_edges) {
    ask();
    mark(e);
  }
  for (std::size_t v = 0; v < data.markers.size(); ++v)
    if (data.markers[v] != 0) mesh.point_markers[v] = data.markers[v];
}

/// The interpolation of attribute `a`.
double attribute_at(const Located& at, const PointData& data, std::size_t a) {
  double value = 0;
  for (unsigned corner = 0; corner < 3; ++corner)
    value += at.weight[corner] * data.attributes[at.v[corner] * data.attributes_per_point + a];
  return value;
}

/// The attributes of vertices that were inserted on segments of a mesh. Rounding has moved them off the sides of its
/// triangles.
void interpolate_on_sides(Mesh& mesh, const Background& on, const PointData& data, const Threads& threads) {
  const std::size_t k = data.attributes_per_point;
  const std::size_t given = data.points.size();
  parallel_blocks(threads, mesh.points.size() - given, [&](std::size_t first, std::size_t last, std::size_t) {
    LocationHint hint;
    for (std::size_t v = given + first; v < given + last; ++v) {
      if (mesh.origin[v] == interior_vertex) continue;
      const Located at = on_nearest_side(on.locate(mesh.points[v], hint));
      for (std::size_t a = 0; a < k; ++a) mesh.point_attributes[v * k + a] = attribute_at(at, data, a);
    }
  });
}

void interpolate_attributes(Mesh& mesh, const PointData& data, std::vector<std::array<Index, 3>> background,
                            const Threads& threads) {
  const std::size_t k = data.attributes_per_point;
  if (k == 0) return;
  const std::size_t inputs = data.attributes.size() / k;
  mesh.attributes_per_point = k;
  mesh.point_attributes.reserve(mesh.points.size() * k);
  mesh.point_attributes.append(data.attributes);
  const Background on(mesh.points.span().first(inputs), std::move(background), threads);
  mesh.point_attributes.append(interpolated_attributes(on, mesh.points.span().subspan(inputs), data, threads));
  if (data.segments)
    interpolate_along_segments(mesh.points.span(), mesh.origin.span(), data, mesh.point_attributes.span(), threads);
  else
    interpolate_on_sides(mesh, on, data, threads);
}

}  // namespace

std::optional<ConstrainedEdge> constrained_edge(const DomainTriangulation& domain, const Slot& slot, unsigned side) {
  const VertexId a = slot.from(side), b = slot.to(side);
  const Index segment = domain.segments.segment_of(domain.triangulation, a, b);
  if (segment == no_index) return std::nullopt;
  const Array<Point>& points = domain.triangulation.points;
  const Point middle = middle_of(points[a], points[b]);
  const int marker = domain.segments.marker_of_edge(points, segment, middle, slot.n[side].none());
  return ConstrainedEdge{a, b, domain.input_segment_at(segment, middle), marker};
}

void name_input_segments(DomainTriangulation& domain, const Threads& threads) {
  Array<Index>& origin = domain.triangulation.origin;
  parallel_blocks(threads, origin.size(), [&](std::size_t first, std::size_t last, std::size_t) {
    for (std::size_t v = first; v < last; ++v)
      if (const Index segment = segment_of_origin(origin[v]); segment < domain.segments.size()) {
        const Index input = domain.input_segment_at(segment, domain.triangulation.points[v]);
        origin[v] = input == no_index ? hull_vertex : origin_on_segment(input);
      }
  });
}

std::vector<double> interpolated_attributes(const Background& on, std::span<const Point> places, const PointData& data,
                                            const Threads& threads) {
  const std::size_t k = data.attributes_per_point;
  std::vector<double> values(k * places.size());
  // Along a curve, each search begins beside the place where the last one ended.
  const Array<Index> order = hilbert_order(places, threads);
  parallel_blocks(threads, order.size(), [&](std::size_t first, std::size_t last, std::size_t) {
    LocationHint hint;
    for (std::size_t i = first; i < last; ++i) {
      const Located at = on.locate(places[order[i]], hint);
      for (std::size_t a = 0; a < k; ++a) values[order[i] * k + a] = attribute_at(at, data, a);
    }
  });
  return values;
}

void interpolate_along_segments(std::span<const Point> vertices, std::span<const Index> origin, const PointData& data,
                                std::span<double> attributes, const Threads& threads) {
  const std::size_t k = data.attributes_per_point;
  const std::span<const Segment> segments = *data.segments;
  const auto end = [&](Index point) { return SegmentEnd{data.points[point], data.attributes.subspan(point * k, k)}; };
  parallel_blocks(threads, vertices.size(), [&](std::size_t first, std::size_t last, std::size_t) {
    for (std::size_t v = first; v < last; ++v)
      if (const Index number = segment_of_origin(origin[v]); number < segments.size())
        interpolate_between(end(segments[number].a), end(segments[number].b), vertices[v],
                            attributes.subspan(v * k, k));
  });
}

Mesh export_triangulation(DomainTriangulation& domain, std::vector<double> region_attributes,
                          std::span<const Point> input_points, const Threads& threads) {
  Mesh mesh;
  export_triangles(domain, mesh, threads);  // first, because it reads the origins of the vertices
  export_origins(domain, mesh, threads);
  restore_order(input_points, domain.triangulation.points, threads);
  mesh.points = std::move(domain.triangulation.points);
  mesh.region = std::move(domain.triangulation.region);
  mesh.region_attributes = std::move(region_attributes);
  return mesh;
}

void add_point_data(Mesh& mesh, const DomainTriangulation& domain, const PointData& data,
                    std::vector<std::array<Index, 3>> background, const Threads& threads) {
  mark_vertices(mesh, domain, data, threads);
  interpolate_attributes(mesh, data, std::move(background), threads);
}

Mesh export_mesh(DomainTriangulation&& domain, std::vector<double> region_attributes, const PointData& data,
                 std::vector<std::array<Index, 3>> background, const Threads& threads) {
  Mesh mesh = export_triangulation(domain, std::move(region_attributes), data.points, threads);
  add_point_data(mesh, domain, data, std::move(background), threads);
  return mesh;
}

}  // namespace pardel::engine
