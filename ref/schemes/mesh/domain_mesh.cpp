#include "domain_mesh.hpp"

namespace pardel::schemes {
namespace {

/// The marker of the segment if it is not 0; otherwise 1 on the border of the domain and 0 elsewhere.
int marker_of(const Pslg& pslg, Index segment, bool on_border) {
  const int own = segment < pslg.segments.size() ? pslg.segments[segment].marker : 0;
  return own != 0 ? own : static_cast<int>(on_border);
}

Index origin_of(std::size_t v, const LinkedMesh& linked, const Pslg& pslg) {
  if (v < pslg.points.size()) return input_vertex;
  const Index segment = linked.segment_of[v];
  if (segment == no_segment) return interior_vertex;
  return pslg.segments.empty() ? hull_vertex : origin_on_segment(segment);
}

void add_constrained_edges(Mesh& mesh, const LinkedMesh& linked, const Pslg& pslg) {
  for (Index t = 0; t < linked.faces.size(); ++t)
    for (int i = 0; i < 3; ++i) {
      const Face& face = linked.faces[t];
      const bool on_border = face.n[i] == no_index;
      // An edge inside the domain has two sides. It is added once.
      if (face.segment[i] == no_segment || (!on_border && face.n[i] < t)) continue;
      const Index segment = face.segment[i] < pslg.segments.size() ? face.segment[i] : no_index;
      const auto [a, b] = ends(linked, {t, i});
      const int marker = marker_of(pslg, segment, on_border);
      mesh.constrained_edges.push_back({a, b, segment, marker});
      for (const Index v : {a, b})
        if (mesh.point_markers[v] == 0) mesh.point_markers[v] = marker;
    }
}

}  // namespace

Mesh to_mesh(const LinkedMesh& linked, const Pslg& pslg) {
  Mesh mesh;
  mesh.points = Array<Point>(linked.points);
  for (std::size_t v = 0; v < linked.points.size(); ++v) mesh.origin.push_back(origin_of(v, linked, pslg));
  mesh.point_markers.resize(linked.points.size(), 0);
  for (std::size_t v = 0; v < pslg.point_markers.size(); ++v) mesh.point_markers[v] = pslg.point_markers[v];
  mesh.triangles.reserve(linked.faces.size());
  for (const Face& face : linked.faces) {
    mesh.triangles.push_back({face.v, face.n});
    if (!pslg.regions.empty()) mesh.region.push_back(face.region);
  }
  for (const Region& region : pslg.regions) mesh.region_attributes.push_back(region.attribute);
  add_constrained_edges(mesh, linked, pslg);
  return mesh;
}

}  // namespace pardel::schemes
