#include "faces.hpp"

#include <algorithm>
#include <map>
#include <set>

namespace pardel::ref {
namespace {

/// The triangles at each edge.
std::map<Edge, std::vector<Index>> incidence(const PlainMesh& mesh) {
  std::map<Edge, std::vector<Index>> at;
  for (Index t = 0; t < mesh.triangles.size(); ++t)
    for (int i = 0; i < 3; ++i) at[edge_of(mesh.triangles[t], i)].push_back(t);
  return at;
}

bool contains(const PlainMesh& mesh, const Corners& t, const ExactPoint& p) {
  const Kernel::Triangle_2 triangle(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]);
  return !triangle.has_on_unbounded_side(p);
}

/// The rule of the program Triangle: the marker of the segment if it is not 0; otherwise 1 on the boundary and 0
/// elsewhere.
int edge_marker(const Segment& segment, bool on_boundary) {
  return segment.marker != 0 ? segment.marker : static_cast<int>(on_boundary);
}

}  // namespace

std::vector<Index> face_of(const PlainMesh& mesh, const ExactPoint& p) {
  const auto at = incidence(mesh);
  std::set<Index> reached;
  std::vector<Index> frontier;
  for (Index t = 0; t < mesh.triangles.size(); ++t)
    if (contains(mesh, mesh.triangles[t], p)) frontier.push_back(t);
  while (!frontier.empty()) {
    const Index t = frontier.back();
    frontier.pop_back();
    if (!reached.insert(t).second) continue;
    for (int i = 0; i < 3; ++i) {
      const Edge e = edge_of(mesh.triangles[t], i);
      if (!mesh.constraints.contains(e)) frontier.insert(frontier.end(), at.at(e).begin(), at.at(e).end());
    }
  }
  return {reached.begin(), reached.end()};
}

void carve(PlainMesh& mesh, const ExactPoint& outside, const std::vector<Point>& holes) {
  std::set<Index> removed;
  std::vector<ExactPoint> starts = {outside};
  for (const Point& hole : holes) starts.push_back(exact(hole));
  for (const ExactPoint& start : starts) {
    const std::vector<Index> face = face_of(mesh, start);
    removed.insert(face.begin(), face.end());
  }
  std::vector<Corners> kept;
  for (Index t = 0; t < mesh.triangles.size(); ++t)
    if (!removed.contains(t)) kept.push_back(mesh.triangles[t]);
  mesh.triangles = kept;
}

PlainMesh to_plain_mesh(const Mesh& mesh) {
  PlainMesh plain;
  for (const Point& p : mesh.points) plain.points.push_back(exact(p));
  for (const Triangle& t : mesh.triangles) plain.triangles.push_back(t.v);
  for (const ConstrainedEdge& e : mesh.constrained_edges) plain.constraints.insert(edge(e.a, e.b));
  return plain;
}

Mesh to_mesh(const PlainMesh& plain, const Provenance& provenance, const Pslg& pslg) {
  Mesh mesh;
  for (const ExactPoint& p : plain.points) mesh.points.push_back(rounded(p));
  for (Index origin : provenance.origin) mesh.origin.push_back(origin);

  const auto at = incidence(plain);
  for (Index t = 0; t < plain.triangles.size(); ++t) {
    Triangle triangle;
    triangle.v = plain.triangles[t];
    for (int i = 0; i < 3; ++i)
      for (Index other : at.at(edge_of(plain.triangles[t], i)))
        if (other != t) triangle.n[i] = other;
    mesh.triangles.push_back(triangle);
  }

  if (!pslg.regions.empty()) {
    mesh.region.resize(plain.triangles.size(), no_index);
    for (Index r = 0; r < pslg.regions.size(); ++r) {
      mesh.region_attributes.push_back(pslg.regions[r].attribute);
      for (Index t : face_of(plain, exact(pslg.regions[r].seed))) mesh.region[t] = r;
    }
  }

  mesh.point_markers.resize(plain.points.size(), 0);
  for (std::size_t v = 0; v < pslg.point_markers.size(); ++v) mesh.point_markers[v] = pslg.point_markers[v];
  for (const auto& [e, segment] : provenance.segment_of_edge) {
    const auto triangles = at.find(e);
    if (triangles == at.end()) continue;  // in a hole
    const int marker = edge_marker(pslg.segments[segment], triangles->second.size() == 1);
    mesh.constrained_edges.push_back({e[0], e[1], segment, marker});
    for (Index v : e)
      if (mesh.point_markers[v] == 0) mesh.point_markers[v] = marker;
  }
  return mesh;
}

}  // namespace pardel::ref
