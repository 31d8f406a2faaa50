// Lattice (f): which insertions raise no circumradius above the bound that T3-sharp gives for the mesh at the start.
// The meshes at the start are made by hand, because Ruppert's algorithm never makes the triangles that attain the
// bound.
#include <algorithm>
#include <cmath>
#include <vector>

#include "../../../ref/insertion.hpp"
#include "../circumradii/ratio_and_area.hpp"
#include "../framework/property.hpp"
#include "../framework/rapidcheck_generators.hpp"
#include "../framework/shares.hpp"

namespace pardel::properties {
namespace {
using generators::Random;
using ref::ExactPoint;
using ref::Number;
using ref::PlainMesh;

/// A triangle on the wall mn with nearly equal angles at m and n, and fans of isosceles triangles around m and n: each
/// stands on a leg of the one before it. The walls are mn and the outline of the fans, which is so near to the apex
/// that its midpoints encroach upon mn.
struct Fans {
  std::vector<int> left, right;  ///< the tangents of the equal angles in 64ths, from the inside to the outside
  int at_m = 24, at_n = 24;      ///< of the triangle on mn
  Point direction{64, 0};        ///< from m to n
  std::uint64_t seed = 0;        ///< of the insertions
};
std::ostream& operator<<(std::ostream& out, const Fans& fans) {
  out << "base " << fans.at_m << ' ' << fans.at_n << "; left";
  for (const int t : fans.left) out << ' ' << t;
  out << "; right";
  for (const int t : fans.right) out << ' ' << t;
  return out << "; direction (" << fans.direction.x << ", " << fans.direction.y << "); seed " << fans.seed;
}

/// The apex of a triangle over ab, on its left side (`sign` 1) or its right side (-1), from the tangents of the angles
/// at a and b in 64ths.
ExactPoint apex_over(const ExactPoint& a, const ExactPoint& b, int at_a, int at_b, int sign) {
  const ref::Kernel::Vector_2 d = b - a;
  const Number along = Number(at_b) / (at_a + at_b), height = along * at_a / 64 * sign;
  return a + ref::Kernel::Vector_2(along * d.x() - height * d.y(), along * d.y() + height * d.x());
}

PlainMesh mesh_of_fans(const Fans& fans) {
  const ExactPoint m(0, 0), n(fans.direction.x, fans.direction.y);
  PlainMesh mesh;
  mesh.points = {m, n, apex_over(m, n, fans.at_m, fans.at_n, 1)};
  mesh.triangles = {{0, 1, 2}};
  mesh.constraints = {{0, 1}};
  for (const Index centre : {0U, 1U}) {
    Index last = 2;
    for (const int tangent : centre == 0 ? fans.left : fans.right) {
      mesh.points.push_back(apex_over(mesh.points[centre], mesh.points[last], tangent, tangent, centre == 0 ? 1 : -1));
      const auto next = static_cast<Index>(mesh.points.size() - 1);
      mesh.triangles.push_back(centre == 0 ? ref::Corners{centre, last, next} : ref::Corners{centre, next, last});
      mesh.constraints.insert(ref::edge(last, next));
      last = next;
    }
    mesh.constraints.insert(ref::edge(centre, last));
  }
  return mesh;
}

/// tan 20.56° = 24/64, and tan 29.4° = 36/64. So three angles exceed 60 degrees together.
Fans some_fans(Random& random, int /*size*/) {
  Fans fans;
  const bool is_extremal = !random.chance(4);
  fans.at_m = is_extremal ? random.between(24, 28) : random.between(24, 36);
  fans.at_n = is_extremal ? fans.at_m + random.between(0, 3) : random.between(24, 36);
  const auto tangent = [&](bool is_first) {
    return is_extremal && is_first ? fans.at_m : random.between(is_extremal ? fans.at_m : 24, 36);
  };
  for (std::vector<int>* side : {&fans.left, &fans.right})
    for (int k = random.between(2, 4); k > 0; --k) side->push_back(tangent(side->empty()));
  if (random.chance(2)) fans.direction = {64.0 * random.between(1, 7), 64.0 * random.between(-7, 7)};
  fans.seed = random.next();
  return fans;
}

std::vector<Fans> with_fewer_triangles(const Fans& fans) {
  std::vector<Fans> simpler;
  const auto offer = [&](auto change) {
    simpler.push_back(fans);
    change(simpler.back());
  };
  if (fans.left.size() > 2) offer([](Fans& f) { f.left.pop_back(); });
  if (fans.right.size() > 2) offer([](Fans& f) { f.right.pop_back(); });
  if (fans.direction != Point{64, 0}) offer([](Fans& f) { f.direction = {64, 0}; });
  return simpler;
}

/// The next point: the midpoint of a wall, often of one that ends in the apex of the first triangle, or a circumcentre
/// that encroaches upon no wall. Nothing if the drawn triangle has no such circumcentre.
std::optional<ExactPoint> some_insertion(const PlainMesh& mesh, Random& random) {
  if (!random.chance(6)) {
    std::vector<ref::Edge> walls(mesh.constraints.begin(), mesh.constraints.end());
    if (!random.chance(8)) std::erase_if(walls, [](const ref::Edge& e) { return e[0] != 2 && e[1] != 2; });
    const ref::Edge e = random.one_of(walls);
    return CGAL::midpoint(mesh.points[e[0]], mesh.points[e[1]]);
  }
  const ref::Corners t = random.one_of(mesh.triangles);
  const ExactPoint centre = circumcentre(mesh, t);
  if (!ref::encroached_by(mesh, centre).empty() || !sees(mesh, centre, t)) return std::nullopt;
  return centre;
}

/// The largest r² of the triangles at a vertex, and of those of them that lie at a wall upon which the vertex
/// encroaches.
struct AtVertex {
  Number all = 0, encroaching = 0;
};
AtVertex radii_at(const PlainMesh& mesh, Index v) {
  AtVertex most;
  for (const ref::Corners& t : mesh.triangles)
    for (int i = 0; i < 3; ++i) {
      if (t[i] != v) continue;
      const Number squared = squared_circumradius(mesh, t);
      most.all = std::max(most.all, squared);
      const Index a = t[(i + 1) % 3], b = t[(i + 2) % 3];
      if (mesh.constraints.contains(ref::edge(a, b)) && ref::encroaches(mesh.points[v], mesh.points[a], mesh.points[b]))
        most.encroaching = std::max(most.encroaching, squared);
    }
  return most;
}

PARDEL_PROPERTY(
    Lattice, no_order_of_splits_outgrows_the_bound_of_t3,
    {.statement = "Let all triangles of a mesh keep a bound of at least 1 on their ratios and a bound on their areas, "
                  "let walls meet at 60 degrees or more, and let all border edges be walls. Insert midpoints of walls "
                  "and circumcentres that encroach upon no wall, in any order, whether a split is necessary or not, "
                  "and although walls are encroached. No circumradius ever exceeds the bound of T3-sharp.",
     .source = "properties/THEORY.md, Lattice (f)",
     .families = "isosceles triangles of 20.6 to 29.4 degrees, in most cases attaining the bound, between fans of such "
                 "triangles; the walls at the apex are split again and again"}) {
  const Fans fans = *generators::generator(some_fans, with_fewer_triangles);
  Random random(fans.seed);
  PlainMesh mesh = mesh_of_fans(fans);
  RC_ASSERT(ref::is_conformal(mesh) && ref::is_constrained_delaunay(mesh));
  const Squares start = largest(mesh);
  RC_ASSERT(start.ratio() >= 1);
  const Number bound = sharp_bound(start.ratio(), start.area);  // r0⁴
  RC_ASSERT(fourth_power(start.radius) <= bound);
  Number most = 0, encroaching = 0;
  for (int k = 0; k < 12; ++k) {
    const std::optional<ExactPoint> p = some_insertion(mesh, random);
    if (!p) continue;
    const AtVertex made = radii_at(mesh, ref::insert(mesh, *p));
    RC_ASSERT(fourth_power(made.all) <= bound);
    most = std::max(most, made.all);
    encroaching = std::max(encroaching, made.encroaching);
  }
  const auto share = [&](const Number& squared) { return std::pow(CGAL::to_double(squared * squared / bound), 0.25); };
  classify(fourth_power(start.radius) == bound, "a triangle at the start attains the bound", 12);
  classify(share(encroaching) > 0.9, "a split makes a triangle of 0.9 r0 at a wall that it encroaches upon", 25);
  classify(share(encroaching) > 0.95, "a split makes a triangle of 0.95 r0 at a wall that it encroaches upon", 12);
}

}  // namespace
}  // namespace pardel::properties
