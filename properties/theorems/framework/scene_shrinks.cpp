// Makes simpler scenes, for shrinking.
#include <algorithm>
#include <cmath>

#include "scene_layouts.hpp"

namespace pardel::properties {
namespace {

bool all_on_a_line(const std::vector<Point>& points) {
  return std::ranges::all_of(points, [&](Point p) { return orientation(points[0], points[1], p) == 0; });
}

/// Does the scene satisfy the conditions that struct Scene states?
bool is_valid(const Scene& scene) {
  const auto are_distinct = [](std::vector<Point> points) {
    std::ranges::sort(points, [](Point a, Point b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
    return std::ranges::adjacent_find(points) == points.end();
  };
  std::vector<Point> all = scene.points;
  all.insert(all.end(), scene.insertions.begin(), scene.insertions.end());
  return scene.points.size() >= 3 && are_distinct(all) && !all_on_a_line(scene.points) &&
         std::ranges::all_of(scene.walls, [&](const ref::Edge& wall) { return can_be_wall(scene, wall); });
}

template <class T>
std::vector<T> without(std::vector<T> values, std::size_t k) {
  values.erase(values.begin() + static_cast<std::ptrdiff_t>(k));
  return values;
}

/// Removes the points v with is_removed(v), and the walls that end there.
template <class IsRemoved>
Scene without_points(const Scene& scene, const IsRemoved& is_removed) {
  Scene rest;
  rest.insertions = scene.insertions;
  rest.holes = scene.holes;
  std::vector<Index> number(scene.points.size(), no_index);
  for (Index v = 0; v < scene.points.size(); ++v) {
    if (is_removed(v)) continue;
    number[v] = static_cast<Index>(rest.points.size());
    rest.points.push_back(scene.points[v]);
  }
  for (const ref::Edge& wall : scene.walls)
    if (number[wall[0]] != no_index && number[wall[1]] != no_index)
      rest.walls.push_back({number[wall[0]], number[wall[1]]});
  return rest;
}

template <class Moved>
Scene with_points_moved(Scene scene, const Moved& moved) {
  for (Point& p : scene.points) p = moved(p);
  for (Point& p : scene.insertions) p = moved(p);
  for (Point& p : scene.holes) p = moved(p);
  return scene;
}

Point lower_left(const std::vector<Point>& points) {
  Point low = points.front();
  for (const Point& p : points) low = {std::min(low.x, p.x), std::min(low.y, p.y)};
  return low;
}

}  // namespace

std::vector<Scene> simpler(const Scene& scene) {
  std::vector<Scene> result;
  const auto offer = [&](Scene candidate) {
    if (candidate != scene && is_valid(candidate)) result.push_back(std::move(candidate));
  };
  for (std::size_t k = 0; scene.insertions.size() > 2 && k < scene.insertions.size(); ++k)
    offer({scene.points, scene.walls, without(scene.insertions, k), scene.holes});

  if (!scene.holes.empty()) offer({scene.points, scene.walls, scene.insertions});
  for (std::size_t k = 0; k < scene.holes.size(); ++k)
    offer({scene.points, scene.walls, scene.insertions, without(scene.holes, k)});
  offer({scene.points, {}, scene.insertions});
  for (std::size_t k = 0; k < scene.walls.size(); ++k)
    offer({scene.points, without(scene.walls, k), scene.insertions, scene.holes});

  for (std::size_t block = scene.points.size() / 2; block > 0; block /= 2)
    for (std::size_t first = 0; first < scene.points.size(); first += block)
      offer(without_points(scene, [&](Index v) { return v >= first && v < first + block; }));

  const Point low = lower_left(scene.points);
  offer(with_points_moved(scene, [&](Point p) { return Point{p.x - low.x, p.y - low.y}; }));
  if (low == Point{0, 0}) {
    // Halve all coordinates. Points are rounded down to integers, insertions to halves.
    Scene halved = with_points_moved(scene, [](Point p) { return Point{std::floor(p.x) / 2, std::floor(p.y) / 2}; });
    for (Point& p : halved.points) p = {std::floor(p.x), std::floor(p.y)};
    offer(std::move(halved));
  }
  return result;
}

}  // namespace pardel::properties
