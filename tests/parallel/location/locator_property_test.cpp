// Points are located in sets of triangles of many kinds, and compared with the definition in rational arithmetic.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include "../../../parallel/locator.hpp"
#include "../../../properties/theorems/framework/property.hpp"
#include "triangle_sets.hpp"

namespace pardel::engine {
namespace {

using K = CGAL::Exact_predicates_inexact_constructions_kernel;

Index first_around_by_definition(const Mesh& mesh, Point p) {
  const K::Point_2 q(snapped(p.x), snapped(p.y));
  for (Index t = 0; t < mesh.triangles.size(); ++t) {
    bool is_inside = true;
    for (unsigned i = 0; i < 3 && is_inside; ++i) {
      const Point a = mesh.points[mesh.triangles[t].v[i]], b = mesh.points[mesh.triangles[t].v[(i + 1) % 3]];
      is_inside = CGAL::orientation(K::Point_2(a.x, a.y), K::Point_2(b.x, b.y), q) != CGAL::RIGHT_TURN;
    }
    if (is_inside) return t;
  }
  return no_index;
}

constexpr const char* kinds =
    "up to 900 triangles: heaps that overlap, fans, stacks of slivers, lattices with holes, "
    "cracks, random diagonals and steps that grow; near 0 and far away, of all sizes";

Mesh some_triangles(generators::Random& random) {
  const auto count = static_cast<std::size_t>(random.between(1, 30) * random.between(1, 30));
  switch (random.below(std::size_t{4})) {
    case 0:
      return heap_of_triangles(random, count, random.between(2, 40));
    case 1:
      return fan(count + 2, {random.uniform(-1, 1), 0}, random.uniform(0.5, 2));
    case 2:
      return stack_of_slivers(count / 2 + 2, random.between(-100, 100), random.between(1, 1000));
    default:
      return torn_lattice(random, random.between(1, 20), random.between(-3, 3), random.between(0, 1) == 0 ? 1 : 1.5);
  }
}

/// The same triangles elsewhere, in another unit of length. Rounding can make some flat or clockwise; they are left
/// out.
Mesh moved(const Mesh& mesh, double scale, Point by) {
  Mesh result;
  for (const Point p : mesh.points) result.points.push_back({snapped(scale * p.x + by.x), snapped(scale * p.y + by.y)});
  for (const Triangle& t : mesh.triangles)
    if (orient2d(result.points[t.v[0]], result.points[t.v[1]], result.points[t.v[2]]) > 0)
      result.triangles.push_back(t);
  return result;
}

PARDEL_PROPERTY(Locator, finds_the_first_triangle_that_contains_the_point,
                {.statement = "the triangle of a point is the first one whose closure contains it, and none if no "
                              "triangle's closure does; coordinates below 2^-140 count as 0; on one thread and on four",
                 .source = "parallel/locator.hpp",
                 .families = kinds}) {
  generators::Random random(*rc::gen::arbitrary<std::uint32_t>());
  const double scale = std::ldexp(1.0, random.between(0, 2) == 0 ? random.between(-100, 100) : 0);
  const Point by = random.between(0, 2) == 0 ? Point{scale * 1e6 / 3, -scale * 1e7 / 3} : Point{};
  const Mesh mesh = moved(some_triangles(random), scale, by);
  const Result<Locator> one = Locator::over(mesh, {.threads = 1}), four = Locator::over(mesh, {.threads = 4});
  RC_ASSERT(one.ok() && four.ok());
  for (const Point p : telling_points(mesh, random, 12)) {
    RC_ASSERT(one->triangle_at(p) == first_around_by_definition(mesh, p));
    RC_ASSERT(four->triangle_at(p) == one->triangle_at(p));
  }
}

}  // namespace
}  // namespace pardel::engine
