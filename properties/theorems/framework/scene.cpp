#include "scene.hpp"

#include <algorithm>
#include <ostream>

#include "../../../core/support/picture.hpp"
#include "../../../ref/constrained.hpp"
#include "../../../ref/faces.hpp"
#include "../../../ref/independent.hpp"

namespace pardel::properties {
using drawing::Circle;
using drawing::Ink;
using drawing::Picture;
using drawing::tint;

namespace {

std::vector<Point> corners_of(const ref::PlainMesh& mesh, const ref::Corners& t) {
  return {ref::rounded(mesh.points[t[0]]), ref::rounded(mesh.points[t[1]]), ref::rounded(mesh.points[t[2]])};
}

Circle circumcircle(const ref::PlainMesh& mesh, const ref::Corners& t) {
  return {ref::rounded(ref::circumcentre(mesh, t)), std::sqrt(CGAL::to_double(ref::squared_circumradius(mesh, t)))};
}

bool is_flat(const ref::PlainMesh& mesh, const ref::Corners& t) {
  return CGAL::collinear(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]);
}

bool breaks_the_empty_circle(const ref::PlainMesh& mesh, const ref::Corners& t) {
  for (std::size_t v = 0; v < mesh.points.size(); ++v)
    if (ref::circumdisk_contains(mesh, t, mesh.points[v]) && ref::sees(mesh, mesh.points[v], t)) return true;
  return false;
}

}  // namespace

std::ostream& operator<<(std::ostream& out, const Scene& scene) {
  const auto list = [&](const char* what, const std::vector<Point>& points) {
    out << what;
    for (const Point& p : points) out << " (" << p.x << ", " << p.y << ")";
  };
  list("points", scene.points);
  out << "; walls";
  for (const ref::Edge& e : scene.walls) out << ' ' << e[0] << '-' << e[1];
  list("; insertions", scene.insertions);
  if (!scene.holes.empty()) list("; holes", scene.holes);
  return out;
}

ref::PlainMesh mesh_of(const Scene& scene) {
  ref::PlainMesh mesh = ref::constrained_delaunay(scene.points, scene.walls);
  if (scene.holes.empty()) return mesh;
  ref::carve(mesh, ref::exact(scene.holes.front()), {scene.holes.begin() + 1, scene.holes.end()});
  std::set<ref::Edge> edges;
  for (const ref::Corners& t : mesh.triangles)
    for (int i = 0; i < 3; ++i) edges.insert(ref::edge_of(t, i));
  std::erase_if(mesh.constraints, [&](const ref::Edge& e) { return !edges.contains(e); });
  return mesh;
}

Pslg to_pslg(const Scene& scene) {
  Pslg pslg;
  pslg.points = scene.points;
  pslg.points.insert(pslg.points.end(), scene.insertions.begin(), scene.insertions.end());
  pslg.point_markers.assign(scene.points.size(), 0);
  for (std::size_t k = 1; k <= scene.insertions.size(); ++k) pslg.point_markers.push_back(static_cast<int>(k));
  for (const ref::Edge& e : scene.walls) pslg.segments.push_back({e[0], e[1]});
  pslg.holes = scene.holes;
  return pslg;
}

Scene to_scene(const Pslg& pslg) {
  Scene scene;
  for (std::size_t i = 0; i < pslg.points.size(); ++i)
    (pslg.point_markers.empty() || pslg.point_markers[i] == 0 ? scene.points : scene.insertions)
        .push_back(pslg.points[i]);
  for (const Segment& s : pslg.segments) scene.walls.push_back(ref::edge(s.a, s.b));
  scene.holes = pslg.holes;
  return scene;
}

Status draw(const Scene& scene, const std::filesystem::path& file) {
  const ref::PlainMesh mesh = mesh_of(scene);
  Picture picture;
  for (const ref::Corners& t : mesh.triangles) picture.polygon(corners_of(mesh, t), "none", Ink::thin);

  std::vector<ref::ExactPoint> insertions;
  std::vector<std::set<Index>> closures;
  for (const Point& p : scene.insertions) {
    insertions.push_back(ref::exact(p));
    const std::vector<Index> cavity = ref::cavity(mesh, insertions.back());
    closures.push_back(ref::closure(mesh, cavity));
    for (const Index t : cavity) picture.polygon(corners_of(mesh, mesh.triangles[t]), tint(closures.size()), Ink::thin);
  }
  for (std::size_t i = 0; i < closures.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      for (const Index v : closures[i])
        if (closures[j].contains(v)) picture.dot(ref::rounded(mesh.points[v]), "red");

  // The independent insertion of all points. It is correct under the hypotheses of the theorems only.
  const ref::PlainMesh result = ref::insert_independently(mesh, insertions);
  for (const ref::Corners& t : result.triangles)
    if (*std::max_element(t.begin(), t.end()) >= scene.points.size()) {
      picture.polygon(corners_of(result, t), "none", Ink::dashed);
      if (!is_flat(result, t) && breaks_the_empty_circle(result, t)) picture.circle(circumcircle(result, t), "red");
    }
  for (const ref::Edge& wall : scene.walls) picture.line(scene.points[wall[0]], scene.points[wall[1]], Ink::thick);
  for (const Point& p : scene.insertions) picture.dot(p, "black");
  return picture.write(file);
}

}  // namespace pardel::properties
