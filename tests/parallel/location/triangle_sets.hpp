// Sets of triangles in which points are hard to locate.
#pragma once

#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "../../../core/mesh.hpp"
#include "../../../core/neighbours.hpp"
#include "../../../parallel/arithmetic/predicates.hpp"
#include "../../../properties/domains/generators/random.hpp"

namespace pardel::engine {

/// Adds the triangle with its corners counter-clockwise; nothing if it is flat.
inline void add_triangle(Mesh& mesh, Index a, Index b, Index c) {
  const double turn = orient2d(mesh.points[a], mesh.points[b], mesh.points[c]);
  if (turn > 0) mesh.triangles.push_back({{a, b, c}, {}});
  if (turn < 0) mesh.triangles.push_back({{a, c, b}, {}});
}

/// Triangles between random points of a lattice, which overlap.
inline Mesh heap_of_triangles(generators::Random& random, std::size_t count, int side) {
  Mesh mesh;
  const auto points = static_cast<std::size_t>(count / 2 + 3);
  for (std::size_t i = 0; i < points; ++i)
    mesh.points.push_back({static_cast<double>(random.between(0, side)), static_cast<double>(random.between(0, side))});
  const auto near = [&](Index a) { return static_cast<Index>((a + random.below(std::size_t{9})) % points); };
  for (std::size_t i = 0; i < count; ++i) {
    const auto a = static_cast<Index>(random.below(points));
    add_triangle(mesh, a, near(a), near(a));
  }
  return mesh;
}

/// Triangles around one vertex, every seventh of which is missing.
inline Mesh fan(std::size_t count, Point centre, double radius) {
  Mesh mesh;
  mesh.points.push_back(centre);
  for (std::size_t i = 0; i < count; ++i) {
    const double angle = 6.283185307179586 * static_cast<double>(i) / static_cast<double>(count);
    mesh.points.push_back({centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle)});
  }
  for (std::size_t i = 0; i < count; ++i)
    if (i % 7 != 3) add_triangle(mesh, 0, static_cast<Index>(1 + i), static_cast<Index>(1 + (i + 1) % count));
  return mesh;
}

/// Long thin triangles between two parallel lines, whose direction is (along, up).
inline Mesh stack_of_slivers(std::size_t count, double along, double up) {
  Mesh mesh;
  for (std::size_t i = 0; i < count; ++i) {
    const double x = static_cast<double>(i);
    mesh.points.push_back({x, -x});
    mesh.points.push_back({x + along, up - x});
  }
  for (Index i = 0; i + 2 < mesh.points.size(); ++i) add_triangle(mesh, i, i + 1, i + 2);
  return mesh;
}

/// The cells of a lattice, each cut into two triangles along a random diagonal: not Delaunay where the lattice is
/// sheared. Cells are missing, and others are in pieces with vertices of their own: cracks, though nothing gaps.
inline Mesh torn_lattice(generators::Random& random, int side, double shear, double growth) {
  Mesh mesh;
  const auto place = [&](int i, int j) {
    const auto far = [&](int k) { return growth == 1 ? static_cast<double>(k) : std::pow(growth, k); };
    return Point{far(i) + shear * far(j), far(j)};
  };
  for (int j = 0; j <= side; ++j)
    for (int i = 0; i <= side; ++i) mesh.points.push_back(place(i, j));
  for (int j = 0; j < side; ++j)
    for (int i = 0; i < side; ++i) {
      if (random.below(std::size_t{8}) == 0) continue;
      auto low = static_cast<Index>(j * (side + 1) + i);
      const auto high = low + static_cast<Index>(side) + 1;
      Index right = low + 1;
      if (random.below(std::size_t{6}) == 0) {
        mesh.points.push_back(mesh.points[low]);
        low = static_cast<Index>(mesh.points.size() - 1);
      }
      const Index opposite = high + 1;
      if (random.below(std::size_t{2}) == 0) {
        add_triangle(mesh, low, right, opposite);
        add_triangle(mesh, low, opposite, high);
      } else {
        add_triangle(mesh, low, right, high);
        add_triangle(mesh, right, opposite, high);
      }
    }
  return mesh;
}

/// Points at which a mistake shows: vertices, middles of edges, points in triangles, near their edges, and beyond.
inline std::vector<Point> telling_points(const Mesh& mesh, generators::Random& random, std::size_t count) {
  std::vector<Point> points;
  const auto middle = [](Point a, Point b) { return Point{a.x / 2 + b.x / 2, a.y / 2 + b.y / 2}; };
  for (std::size_t k = 0; k < count && !mesh.triangles.empty(); ++k) {
    const auto& v = mesh.triangles[random.below(mesh.triangles.size())].v;
    const auto i = static_cast<unsigned>(random.below(std::size_t{3}));
    const Point a = mesh.points[v[i]], b = mesh.points[v[(i + 1) % 3]], c = mesh.points[v[(i + 2) % 3]];
    const Point on = middle(a, b), inside = middle(on, c);
    points.insert(points.end(), {a,
                                 on,
                                 inside,
                                 {std::nextafter(on.x, c.x), on.y},
                                 {on.x, std::nextafter(on.y, c.y)},
                                 {2 * on.x - c.x, 2 * on.y - c.y},
                                 middle(inside, on)});
  }
  return points;
}

}  // namespace pardel::engine
