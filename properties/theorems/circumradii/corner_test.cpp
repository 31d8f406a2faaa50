// T2-corner: where a split point encroaches upon another segment, circumradii grow, and how far.
//
// Segments ab and ax meet at a at the angle θ < 90°, c = cos θ; neither is encroached; m is the midpoint of ab and
// encroaches upon ax. What inserting m puts on ax is the triangle (a, x, m). Let D be the open circumdisk of the
// triangle that was there. It holds m and not b (m sees b along ab, so that what sees m in D sees b), so its circle
// meets ab at a point y, |ay| = t |ab|, 1/2 < t ≤ 1. Both triangles (a, x, m) and (a, x, y) have the angle θ at a, so
// their circumradii are as |mx| to |yx|, and |yx| is at least the distance of x from ab. In units of |ab|, |ax| = s:
//
//   factor² ≤ (s² - sc + 1/4) / (s² sin² θ) = (1/c² - 1/u + 1/(4u²)) / tan² θ,   u = sc.
//
// That grows in u > 1/2, and u < 1, since b does not encroach upon ax. At u = 1 it is (4/c² - 3) / (4/c² - 4), which
// the triangle abx alone comes as close to as one likes, as b nears the diametral circle of ax.
//
// All other new triangles obey T2. Segments that share no end with ab know no such bound: see the channel below.
#include <cmath>

#include "../../../ref/insertion.hpp"
#include "../framework/property.hpp"
#include "../framework/rapidcheck_generators.hpp"

namespace pardel::properties {
namespace {
using generators::Random;
using ref::ExactPoint;
using ref::Number;

/// The square of the largest factor at an angle θ, from cos² θ in (0, 1).
Number squared_factor(const Number& squared_cosine) { return (4 / squared_cosine - 3) / (4 / squared_cosine - 4); }

/// Of the angle at a between ab and ax.
Number squared_cosine(const ExactPoint& a, const ExactPoint& b, const ExactPoint& x) {
  const auto u = b - a, v = x - a;
  return (u * v) * (u * v) / (u.squared_length() * v.squared_length());
}

/// r̄² after over r̄² before splitting the edge ab at its midpoint.
Number squared_growth(ref::PlainMesh mesh, Index a, Index b) {
  const Number before = squared_circumradius_bound(mesh);
  ref::insert(mesh, CGAL::midpoint(mesh.points[a], mesh.points[b]));
  return squared_circumradius_bound(mesh) / before;
}

bool has_no_encroached_constraint(const ref::PlainMesh& mesh) {
  return std::none_of(mesh.constraints.begin(), mesh.constraints.end(),
                      [&](const ref::Edge& e) { return is_encroached(mesh, e); });
}

/// The triangle (a, b, x) alone, numbered in that order, with the segments ab and ax.
ref::PlainMesh triangle_at_corner(const ExactPoint& x, double ab) {
  return {{{0, 0}, {ab, 0}, x}, {{0, 1, 2}}, {{0, 1}, {0, 2}}};
}

/// Searches along one ray for the apex x whose triangle grows most when ab is split, neither segment being
/// encroached; lengths in units of |ab|.
struct Best {
  double length = 0;
  double growth = 0;
};

Best worst_corner(double degrees, Facts& facts) {
  constexpr double ab = 0x1p30;
  const double angle = degrees * std::acos(-1.0) / 180;
  Best best;
  double from = 0.1, to = 8;
  for (int round = 0; round < 6; ++round) {
    const double step = (to - from) / 100;
    for (int k = 0; k <= 100; ++k) {
      const double length = from + k * step;
      const ExactPoint x(std::round(ab * length * std::cos(angle)), std::round(ab * length * std::sin(angle)));
      const ref::PlainMesh mesh = triangle_at_corner(x, ab);
      ++facts.cases;
      if (!has_no_encroached_constraint(mesh)) continue;
      const Number growth = squared_growth(mesh, 0, 1);
      EXPECT_LT(growth, squared_factor(squared_cosine(mesh.points[0], mesh.points[1], x)));
      if (const double root = std::sqrt(CGAL::to_double(growth)); root > best.growth) best = {length, root};
    }
    from = best.length - step, to = best.length + step;
  }
  return best;
}

PARDEL_FACT(T2Corner, a_search_for_the_worst_corner_finds_the_factors_of_the_formula,
            {.statement = "Segments ab and ax meet at an angle θ < 90°, triangle abx is in the mesh, neither segment "
                          "is encroached. Splitting ab at its midpoint raises the largest circumradius by a factor "
                          "below sqrt((4/c² - 3) / (4/c² - 4)), c = cos θ, and by any factor below that: 1.04 at 60°, "
                          "1.12 at 45°, 1.32 at 30°, 1.70 at 20°.",
             .source = "THEORY.md, T2-corner",
             .families = "the triangle abx alone, x on a ray of each angle, in exact arithmetic"}) {
  const std::vector<std::pair<double, double>> table = {{60, 1.04}, {45, 1.12}, {30, 1.32}, {20, 1.70}};
  for (const auto& [degrees, factor] : table) {
    const Best found = worst_corner(degrees, facts);
    EXPECT_NEAR(found.growth, factor, 0.005) << degrees << " degrees";
    const double cosine = std::cos(degrees * std::acos(-1.0) / 180);
    const double formula = std::sqrt(CGAL::to_double(squared_factor(Number(cosine * cosine))));
    EXPECT_NEAR(found.growth, formula, 5e-5) << degrees << " degrees";
    EXPECT_NEAR(found.length, 1 / cosine, 1e-4) << "where b reaches the diametral circle of ax";
    facts.notes.push_back("θ = " + std::to_string(static_cast<int>(degrees)) + "°: " + std::to_string(found.growth) +
                          " found at |ax| = " + std::to_string(found.length) + " |ab|, the formula says " +
                          std::to_string(formula));
  }
}

/// Two segments from point 0, to points 1 and 2, among other points; none encroaches upon either. The insertion is
/// the midpoint of the first.
Scene some_corner(Random& random, int size) {
  const auto any = [&](int most) {
    return Point{static_cast<double>(random.between(-most, most)), static_cast<double>(random.between(-most, most))};
  };
  const auto dot = [](Point u, Point v) { return u.x * v.x + u.y * v.y; };
  const auto encroaches = [&](Point p, Point b) { return dot({p.x - b.x, p.y - b.y}, p) <= 0; };
  Scene scene;
  for (;;) {
    const Point u = any(12), b{2 * u.x, 2 * u.y};
    const Point x = random.chance(2) ? any(24) : Point{b.x + random.between(-6, 6), b.y + random.between(-6, 6)};
    if (b.x * x.y == b.y * x.x || dot(b, x) <= 0 || encroaches(b, x) || encroaches(x, b)) continue;
    scene = {{{0, 0}, b, x}, {{0, 1}, {0, 2}}, {u}};
    break;
  }
  // A frame whose edges are too short for the insertion to encroach upon.
  for (int k = -2; k < 2; ++k)
    for (const Point& p : {Point{16.0 * k, -32}, Point{32, 16.0 * k}, Point{-16.0 * k, 32}, Point{-32, -16.0 * k}})
      scene.points.push_back(p);
  for (int k = random.between(0, size / 6); k > 0; --k) {
    const Point p = any(30);
    const bool taken = std::find(scene.points.begin(), scene.points.end(), p) != scene.points.end();
    if (!taken && !encroaches(p, scene.points[1]) && !encroaches(p, scene.points[2])) scene.points.push_back(p);
  }
  return scene;
}

std::vector<Scene> with_a_point_less(const Scene& scene) {
  std::vector<Scene> simpler;
  for (std::size_t k = 19; k < scene.points.size(); ++k) {
    simpler.push_back(scene);
    simpler.back().points.erase(simpler.back().points.begin() + static_cast<std::ptrdiff_t>(k));
  }
  return simpler;
}

/// r² of the triangle on the left of the directed edge.
Number squared_circumradius_left_of(const ref::PlainMesh& mesh, Index a, Index b) {
  for (const ref::Corners& t : mesh.triangles)
    for (int i = 0; i < 3; ++i)
      if (t[i] == a && t[(i + 1) % 3] == b) return squared_circumradius(mesh, t);
  throw std::logic_error("no triangle on the left of the edge");
}

PARDEL_PROPERTY(
    T2Corner, a_midpoint_raises_the_circumradius_at_the_other_segment_at_most_by_the_factor,
    {.statement = "Segments ab and ax meet at an angle θ < 90° and no vertex encroaches upon them; the "
                  "midpoint m of ab encroaches upon no other constrained edge. Whatever the mesh around "
                  "them, the triangle that inserting m puts on ax has at most sqrt((4/c² - 3) / (4/c² - 4)) "
                  "times the circumradius of the one that it replaces there, c = cos θ; and not even as "
                  "much where m does not encroach upon ax.",
     .source = "THEORY.md, T2-corner",
     .families = "two segments at a random angle among up to 32 lattice points; points in general and in "
                 "cocircular position"}) {
  const Scene scene = *generators::generator(some_corner, with_a_point_less).as("scene");
  exhibit.show(scene);
  const ref::PlainMesh before = mesh_of(scene);
  ref::PlainMesh after = before;
  ref::insert(after, ref::exact(scene.insertions[0]));

  const auto& p = before.points;
  const bool is_left = CGAL::left_turn(p[0], p[1], p[2]);  // the side of ax on which b lies
  const Index from = is_left ? 2 : 0, to = is_left ? 0 : 2;
  const Number old = squared_circumradius_left_of(before, from, to);
  const Number now = squared_circumradius_left_of(after, from, to);
  const bool encroaches = ref::encroaches(ref::exact(scene.insertions[0]), p[0], p[2]);
  RC_CLASSIFY(encroaches, "m encroaches upon ax");
  RC_CLASSIFY(now > old, "the circumradius grows");
  if (encroaches)
    RC_ASSERT(now <= old * squared_factor(squared_cosine(p[0], p[1], p[2])));
  else
    RC_ASSERT(now <= old);
}

PARDEL_FACT(T2Corner, without_its_hypothesis_the_circumradius_bound_is_refuted,
            {.statement = "Fails when a split point encroaches upon another constrained edge: a random search finds a "
                          "scene with no encroached edge in which splitting one at its midpoint raises the largest "
                          "circumradius.",
             .source = "THEORY.md, T2-corner",
             .families = "the triangle of a random corner alone"}) {
  Random random(1);
  Number most = 1;
  while (most == 1 && ++facts.cases < 1000) {
    const Scene corner = some_corner(random, 0);
    const Scene alone{{corner.points.begin(), corner.points.begin() + 3}, corner.walls, corner.insertions};
    most = std::max(most, squared_growth(mesh_of(alone), 0, 1));
  }
  EXPECT_GT(most, 1);
  facts.notes.push_back("found after " + std::to_string(facts.cases) + " random corners: a factor of " +
                        std::to_string(std::sqrt(CGAL::to_double(most))));
}

PARDEL_FACT(T2Corner, across_a_thin_channel_no_factor_bounds_the_growth,
            {.statement = "Where a split point encroaches upon a constrained edge that shares no end with the one "
                          "split, no factor bounds the growth: splitting one long side of a rectangle of width 1 and "
                          "length 2h, none of whose sides is encroached, multiplies the largest circumradius by "
                          "(h² + 1) / sqrt(4h² + 1) > h/2.",
             .source = "THEORY.md, T2-corner",
             .families = "h = 2, 4, ..., 2^20"}) {
  for (double h = 2; h <= 0x1p20; h *= 2) {
    const Scene channel{{{0, 0}, {2 * h, 0}, {2 * h, 1}, {0, 1}}, {{0, 1}, {1, 2}, {2, 3}, {0, 3}}, {{h, 0}}};
    const ref::PlainMesh mesh = mesh_of(channel);
    ASSERT_TRUE(has_no_encroached_constraint(mesh));
    const Number hh = Number(h) * h;
    ASSERT_EQ(squared_growth(mesh, 0, 1), (hh + 1) * (hh + 1) / (4 * hh + 1));
    ++facts.cases;
  }
}

}  // namespace
}  // namespace pardel::properties
