#include "export_mesh.hpp"

#include <bit>

#include "../concurrency/parallel_arrays.hpp"
#include "background.hpp"

namespace pardel::engine {
namespace {

/// Moves the input points back to the positions that they have in the input.
void restore_order(std::span<const Index> input_of_vertex, Array<Point>& points, int threads) {
  const Array<Point> moved = make_array(threads, input_of_vertex.size(), [&](std::size_t v) { return points[v]; });
  parallel_blocks(threads, moved.size(), [&](std::size_t first, std::size_t last, std::size_t) {
    for (std::size_t v = first; v < last; ++v) points[input_of_vertex[v]] = moved[v];
  });
}

/// The marker of a vertex is the one that the input gives it. If that is 0 or missing, it is the marker of a segment on
/// which the vertex lies; else 1 on the boundary and 0 elsewhere.
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

Mesh export_mesh(DomainTriangulation&& domain, std::vector<double> region_attributes, const PointData& data,
                 std::vector<std::array<Index, 3>> background, int threads) {
  Triangulation& t = domain.triangulation;
  Mesh mesh;
  const std::size_t inputs = domain.input_of_vertex.size();
  const auto number = [&](VertexId v) { return v < inputs ? domain.input_of_vertex[v] : v; };
  const auto triangle_of = [&](EdgeRef out) { return out.none() ? no_index : out.triangle(); };
  const auto constrained_edge = [&](const Slot& slot, unsigned side) {
    const Index segment = domain.segments.segment_of(t, slot.from(side), slot.to(side));
    int marker = domain.segment_marker[segment];
    if (marker == 0 && slot.n[side].none()) marker = 1;
    return ConstrainedEdge{number(slot.from(side)), number(slot.to(side)), domain.input_segment[segment], marker};
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
      if (t.origin[v] < domain.segments.size()) {
        const Index segment = domain.input_segment[t.origin[v]];
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
