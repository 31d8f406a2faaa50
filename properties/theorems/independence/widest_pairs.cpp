#include "widest_pairs.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "../../../ref/independent.hpp"
#include "../framework/scene_layouts.hpp"
#include "pairs.hpp"

namespace pardel::properties {
namespace {

using Pair = std::pair<Point, Point>;

double squared_distance(const Pair& pair) {
  const double dx = pair.first.x - pair.second.x, dy = pair.first.y - pair.second.y;
  return dx * dx + dy * dy;
}

/// All pairs of a lattice position within two units of p and a lattice position within two units of q. The most distant
/// pairs come first.
std::vector<Pair> pairs_around(Point p, Point q) {
  constexpr int reach = 2;
  const auto around = [](Point at) {
    std::vector<Point> positions;
    for (int dx = -reach; dx <= reach; ++dx)
      for (int dy = -reach; dy <= reach; ++dy) positions.push_back({at.x + dx, at.y + dy});
    return positions;
  };
  std::vector<Pair> pairs;
  for (const Point& first : around(p))
    for (const Point& second : around(q)) pairs.emplace_back(first, second);
  std::ranges::stable_sort(pairs, std::ranges::greater(), squared_distance);
  return pairs;
}

/// Does p lie strictly inside the convex hull of the mesh?
bool lies_inside(const std::vector<ref::Edge>& hull, const Scene& scene, Point p) {
  return std::ranges::all_of(
      hull, [&](const ref::Edge& e) { return orientation(scene.points[e[0]], scene.points[e[1]], p) > 0; });
}

/// The first pair inside the mesh for which `meets(mesh, p, q)` is true.
template <class Meets>
MeshedScene first_that_meets(Scene layout, const std::vector<Pair>& pairs, const Meets& meets) {
  MeshedScene scene = meshed(std::move(layout));
  const std::vector<ref::Edge> hull = border_of(scene.mesh);
  for (const auto& [p, q] : pairs) {
    scene.scene.insertions = {p, q};
    if (lies_inside(hull, scene.scene, p) && lies_inside(hull, scene.scene, q) &&
        meets(scene.mesh, ref::exact(p), ref::exact(q)))
      return scene;
  }
  throw std::logic_error("no pair of the family meets in the required way");
}

/// Three squares in a row with side 10 scale; all circumradii are √50 scale. Relative to its centre, the circumcircle
/// of the middle square has the antipodes (7, 1) and (−7, −1) times scale, which lie in the other two squares.
struct Squares {
  Scene scene;
  std::vector<Pair> pairs;
};

Squares squares(int scale) {
  Squares result;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 2; ++j) result.scene.points.push_back({10.0 * scale * i, 10.0 * scale * j});
  result.pairs = pairs_around({22.0 * scale, 6.0 * scale}, {8.0 * scale, 4.0 * scale});
  return result;
}

void add_mirrored(Scene& scene, double x, double y) {
  for (const Point& p : {Point{x, y}, Point{-x, y}, Point{x, -y}, Point{-x, -y}})
    if (std::ranges::count(scene.points, p) == 0) scene.points.push_back(p);
}

/// Two octagons that share a side of length 2. Their corners lie on circles of radius √(scale² + 1).
Scene octagons(int scale) {
  const double c = scale;
  Scene scene;
  add_mirrored(scene, 0, 1);
  add_mirrored(scene, c - 1, c);
  add_mirrored(scene, c + 1, c);
  add_mirrored(scene, 2 * c, 1);
  return scene;
}

/// Two dodecagons that share a corner, and two points in the notches between them. The corners lie on circles of radius
/// 5 scale.
Scene dodecagons(int scale) {
  const double k = scale;
  Scene scene;
  add_mirrored(scene, 0, 0);
  add_mirrored(scene, 10 * k, 0);
  for (const auto& [x, y] : {std::pair{-4, 3}, {-3, 4}, {0, 5}, {3, 4}, {4, 3}})
    add_mirrored(scene, (5 + x) * k, y * k);
  add_mirrored(scene, 0, 5 * k);
  return scene;
}

}  // namespace

MeshedScene widest_non_conformal(int scale) {
  Squares family = squares(scale);
  return first_that_meets(std::move(family.scene), family.pairs, [](const auto& mesh, const auto& p, const auto& q) {
    return !ref::is_conformal(ref::insert_independently(mesh, {p, q}));
  });
}

MeshedScene widest_not_delaunay(int scale) {
  Squares family = squares(scale);
  return first_that_meets(std::move(family.scene), family.pairs, [](const auto& mesh, const auto& p, const auto& q) {
    const ref::PlainMesh made = ref::insert_independently(mesh, {p, q});
    return ref::is_conformal(made) && !ref::is_delaunay(made);
  });
}

MeshedScene widest_shared_edge(int scale) {
  const double far = 2.0 * scale;
  return first_that_meets(
      octagons(scale), pairs_around({far, 0}, {-far, 0}),
      [](const auto& mesh, const auto& p, const auto& q) { return contact(mesh, p, q) == Contact::edge; });
}

MeshedScene widest_shared_vertex(int scale) {
  const double far = 10.0 * scale;
  return first_that_meets(
      dodecagons(scale), pairs_around({far, 0}, {-far, 0}),
      [](const auto& mesh, const auto& p, const auto& q) { return contact(mesh, p, q) == Contact::vertex; });
}

}  // namespace pardel::properties
