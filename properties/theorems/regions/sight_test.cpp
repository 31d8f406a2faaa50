// What points see in a mesh with walls: Lemmas 7 and 8 of properties/THEORY.md.
#include <algorithm>

#include "../../../ref/insertion.hpp"
#include "../framework/property.hpp"
#include "../framework/scene_carving.hpp"
#include "../framework/shares.hpp"

namespace pardel::properties {
namespace {
using ref::Number;

MeshedScene some_scene(Exhibit& exhibit) {
  MeshedScene meshed = *scenes(in_any_walled_domain({.insertions = 3})).as("scene");
  exhibit.show(meshed.scene);
  tag_families(meshed);
  classify_outline(meshed, meshed.scene.insertions, 1);
  return meshed;
}

constexpr const char* walled_scenes = "all layouts, walls, carved domains and positions of random scenes";

PARDEL_PROPERTY(Sight, of_a_point_of_a_circumdisk_is_hidden_only_if_a_wall_is_encroached,
                {.statement = "Let a point lie in the open circumdisk of a triangle that it does not see. Then the "
                              "point, or a corner of the triangle, encroaches upon a wall.",
                 .source = "THEORY.md, Lemma 7",
                 .families = walled_scenes}) {
  const MeshedScene meshed = some_scene(exhibit);
  const ref::PlainMesh& mesh = meshed.mesh;
  bool hidden = false;
  for (const ref::Corners& t : mesh.triangles) {
    std::vector<ref::ExactPoint> points{ref::circumcentre(mesh, t)};
    for (const Point& p : meshed.scene.insertions) points.push_back(ref::exact(p));
    for (const ref::ExactPoint& p : points) {
      if (!circumdisk_contains(mesh, t, p) || sees(mesh, p, t)) continue;
      hidden = true;
      RC_ASSERT(!encroached_by(mesh, p).empty() ||
                std::ranges::any_of(t, [&](Index v) { return !encroached_by(mesh, mesh.points[v]).empty(); }));
    }
  }
  classify(hidden, "a wall hides a point of a disk from its triangle", 5);
}

/// Does p see the vertex w? That is, does no wall meet the open segment between them, except walls that contain p?
bool sees_vertex(const ref::PlainMesh& mesh, const ref::ExactPoint& p, const ref::ExactPoint& w) {
  const ref::Kernel::Segment_2 between(p, w);
  return std::ranges::none_of(mesh.constraints, [&](const ref::Edge& e) {
    const ref::Kernel::Segment_2 wall(mesh.points[e[0]], mesh.points[e[1]]);
    if (wall.has_on(p)) return false;
    const auto common = CGAL::intersection(wall, between);
    if (!common) return false;
    const auto* at = boost::get<ref::ExactPoint>(&*common);
    return at == nullptr || *at != w;
  });
}

PARDEL_PROPERTY(Sight, of_a_new_point_finds_no_vertex_nearer_than_its_nearest_neighbour,
                {.statement = "After a point is inserted, no vertex that it sees is nearer to it than the nearest of "
                              "its neighbours in the mesh.",
                 .source = "THEORY.md, Lemma 8",
                 .families = walled_scenes}) {
  const MeshedScene meshed = some_scene(exhibit);
  ref::PlainMesh mesh = meshed.mesh;
  const ref::ExactPoint p = ref::exact(meshed.scene.insertions.front());
  const Index inserted = ref::insert(mesh, p);
  std::set<Index> neighbours;
  for (const ref::Corners& t : mesh.triangles)
    if (std::ranges::count(t, inserted) != 0) neighbours.insert(t.begin(), t.end());
  neighbours.erase(inserted);
  const auto squared_distance = [&](Index v) { return Number(CGAL::squared_distance(p, mesh.points[v])); };
  const Number nearest = squared_distance(*std::ranges::min_element(neighbours, {}, squared_distance));
  bool nearer_but_hidden = false;
  for (Index v = 0; v < inserted; ++v) {
    if (squared_distance(v) >= nearest) continue;
    nearer_but_hidden = true;
    RC_ASSERT(!sees_vertex(mesh, p, mesh.points[v]));
  }
  classify(nearer_but_hidden, "a wall hides the nearest vertex", 1);
}

}  // namespace
}  // namespace pardel::properties
