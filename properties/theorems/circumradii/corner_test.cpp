// T2-corner: if a split point encroaches upon another segment, circumradii grow. These properties test the factor.
// Proof: properties/THEORY.md, T2-corner. Notation: segments ab and ax meet at a at the angle θ < 90°, c = cos θ, and m
// is the midpoint of ab.
#include <cmath>

#include "../../../ref/insertion.hpp"
#include "../framework/property.hpp"
#include "../framework/rapidcheck_generators.hpp"
#include "../framework/shares.hpp"
#include "left_triangle.hpp"

namespace pardel::properties {
namespace {
using generators::Random;
using ref::ExactPoint;
using ref::Number;

/// The square of the largest factor at an angle θ, from cos² θ in (0, 1).
Number squared_factor(const Number& squared_cosine) { return (4 / squared_cosine - 3) / (4 / squared_cosine - 4); }

/// The same for a point that divides ab at `share` of its length: 1 + (1 - λ)² cot² θ.
Number squared_factor(const Number& squared_cosine, const Number& share) {
  return 1 + (1 - share) * (1 - share) * squared_cosine / (1 - squared_cosine);
}

/// cos² of the angle at a between ab and ax.
Number squared_cosine(const ExactPoint& a, const ExactPoint& b, const ExactPoint& x) {
  const auto u = b - a, v = x - a;
  return (u * v) * (u * v) / (u.squared_length() * v.squared_length());
}

/// The factor by which splitting the edge ab at its midpoint multiplies r̄².
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

/// The position of x on a ray for which the circumradius grows most. Lengths are in units of |ab|.
struct Best {
  double length = 0;  ///< |ax|
  double growth = 0;  ///< the factor by which the circumradius grows
};

/// Searches the ray at this angle for the point x for which splitting ab raises the circumradius most. Only positions
/// of x are tested for which neither segment is encroached.
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
            {.statement = "Segments ab and ax meet at an angle θ < 90°, c = cos θ. The triangle abx is in the mesh, "
                          "and neither segment is encroached. Splitting ab at its midpoint raises the largest "
                          "circumradius by a factor below sqrt((4/c² - 3) / (4/c² - 4)), and every smaller factor "
                          "occurs. The limit is 1.04 at 60°, 1.12 at 45°, 1.32 at 30°, 1.70 at 20°.",
             .source = "THEORY.md, T2-corner",
             .families = "the triangle abx alone, with x on a ray at each angle, in exact arithmetic"}) {
  const std::vector<std::pair<double, double>> table = {{60, 1.04}, {45, 1.12}, {30, 1.32}, {20, 1.70}};
  for (const auto& [degrees, factor] : table) {
    const Best found = worst_corner(degrees, facts);
    EXPECT_NEAR(found.growth, factor, 0.005) << degrees << " degrees";
    const double cosine = std::cos(degrees * std::acos(-1.0) / 180);
    const double formula = std::sqrt(CGAL::to_double(squared_factor(Number(cosine * cosine))));
    EXPECT_NEAR(found.growth, formula, 5e-5) << degrees << " degrees";
    EXPECT_NEAR(found.length, 1 / cosine, 1e-4) << "there b is on the diametral circle of ax";
    facts.notes.push_back("θ = " + std::to_string(static_cast<int>(degrees)) + "°: " + std::to_string(found.growth) +
                          " found at |ax| = " + std::to_string(found.length) + " |ab|, the formula gives " +
                          std::to_string(formula));
  }
}

/// Two segments from point 0 to points 1 and 2, and other points; no point encroaches upon a segment. The insertion is
/// `part` eighths of the way from point 0 to point 1.
Scene some_corner_split_at(Random& random, int size, int part) {
  const auto any = [&](int most) {
    return Point{static_cast<double>(random.between(-most, most)), static_cast<double>(random.between(-most, most))};
  };
  const auto dot = [](Point u, Point v) { return u.x * v.x + u.y * v.y; };
  const auto encroaches = [&](Point p, Point b) { return dot({p.x - b.x, p.y - b.y}, p) <= 0; };
  const bool halves = part == 4;
  Scene scene;
  for (;;) {
    const Point u = any(halves ? 12 : 3), b = halves ? Point{2 * u.x, 2 * u.y} : Point{8 * u.x, 8 * u.y};
    const Point x = random.chance(2) ? any(24) : Point{b.x + random.between(-6, 6), b.y + random.between(-6, 6)};
    if (b.x * x.y == b.y * x.x || dot(b, x) <= 0 || encroaches(b, x) || encroaches(x, b)) continue;
    scene = {{{0, 0}, b, x}, {{0, 1}, {0, 2}}, {halves ? u : Point{part * u.x, part * u.y}}};
    break;
  }
  // Points of a frame around the segments. Its edges are so short that the insertion does not encroach upon them.
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

Scene some_corner(Random& random, int size) { return some_corner_split_at(random, size, 4); }

/// The two segments with x close to the perpendicular of ab in b, where the circumradius grows most, and nothing else.
Scene worst_corner_split_at(Random& random, int part) {
  const int u = random.between(20, 60), x = random.between(2, 12);  // the angle is about arctan(x / 8)
  const double b = 8.0 * u, nudge = random.between(1, 8);
  Scene scene{{{0, 0}, {b, 0}, {b - nudge, std::round(b * x / 8)}}, {{0, 1}, {0, 2}}, {{1.0 * part * u, 0}}};
  if (random.chance(2))
    for (Point& p : scene.points) std::swap(p.x, p.y);
  if (scene.points[1].x == 0) std::swap(scene.insertions[0].x, scene.insertions[0].y);
  return scene;
}

std::vector<Scene> without_one_point(const Scene& scene) {
  std::vector<Scene> simpler;
  for (std::size_t k = 19; k < scene.points.size(); ++k) {
    simpler.push_back(scene);
    simpler.back().points.erase(simpler.back().points.begin() + static_cast<std::ptrdiff_t>(k));
  }
  return simpler;
}

/// The insertion of the scene lies `part` eighths of the way from point 0 to point 1.
template <class Make>
void growth_is_bounded(Exhibit& exhibit, const Make& make, int part) {
  const Scene scene = *generators::generator(make, without_one_point).as("scene");
  exhibit.show(scene);
  const ref::PlainMesh before = mesh_of(scene);
  ref::PlainMesh after = before;
  ref::insert(after, ref::exact(scene.insertions[0]));

  const auto& p = before.points;
  const bool is_left = CGAL::left_turn(p[0], p[1], p[2]);  // is x left of ab?
  const Index from = is_left ? 2 : 0, to = is_left ? 0 : 2;
  const Number old = squared_circumradius_left_of(before, from, to).value();
  const Number now = squared_circumradius_left_of(after, from, to).value();
  const bool encroaches = ref::encroaches(ref::exact(scene.insertions[0]), p[0], p[2]);
  const Number factor = squared_factor(squared_cosine(p[0], p[1], p[2]), Number(part) / 8);
  classify(encroaches, "the point encroaches upon ax", 25);
  classify(now > old, "the circumradius grows", 15);
  classify(now > old && now > Number(0.9604) * factor * old, "it grows by more than 0.98 of the factor", 5);
  if (encroaches)
    RC_ASSERT(now <= old * factor);
  else
    RC_ASSERT(now <= old);
}

PARDEL_PROPERTY(
    T2Corner, a_midpoint_raises_the_circumradius_at_the_other_segment_at_most_by_the_factor,
    {.statement = "Segments ab and ax meet at an angle θ < 90°, c = cos θ, and no vertex encroaches upon them. The "
                  "midpoint m of ab encroaches upon no constrained edge other than ax. In any mesh, inserting m "
                  "multiplies the circumradius of the triangle on ax by at most sqrt((4/c² - 3) / (4/c² - 4)). If m "
                  "does not encroach upon ax, this circumradius does not grow.",
     .source = "THEORY.md, T2-corner",
     .families = "two segments at a random angle among up to 32 lattice points; points in general and in "
                 "cocircular position"}) {
  growth_is_bounded(exhibit, some_corner, 4);
}

PARDEL_PROPERTY(
    T2Corner, a_split_point_anywhere_raises_the_circumradius_at_most_by_the_factor_of_its_place,
    {.statement = "As above, for a point p with |ap| = λ |ab|, such as a point on a shell. The factor is sqrt(1 + (1 - "
                  "λ)² cot² θ): for shells, 1/3 ≤ λ ≤ 2/3, at most sqrt(1 + (4/9) cot² θ).",
     .source = "THEORY.md, T2-corner",
     .families = "λ = 1/8, ..., 7/8; two segments at a random angle among up to 32 lattice points; two segments alone "
                 "whose ends are nearly in the worst position, at 14 to 56 degrees"}) {
  const int part = *rc::gen::inRange(1, 8).as("eighths of ab");
  const bool is_worst = *rc::gen::arbitrary<bool>().as("nearly the worst position");
  growth_is_bounded(
      exhibit,
      [=](Random& random, int size) {
        return is_worst ? worst_corner_split_at(random, part) : some_corner_split_at(random, size, part);
      },
      part);
}

PARDEL_FACT(T2Corner, t2_fails_for_a_split_point_that_encroaches_upon_another_segment,
            {.statement = "T2 fails if a split point encroaches upon another constrained edge: a random search finds "
                          "a scene with no encroached edge in which splitting an edge at its midpoint raises the "
                          "largest circumradius.",
             .source = "THEORY.md, T2-corner",
             .families = "triangles at random corners, alone"}) {
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
            {.statement = "If a split point encroaches upon a constrained edge that shares no end with the split "
                          "edge, no factor bounds the growth. Example: a rectangle of width 1 and length 2h with no "
                          "encroached side. Splitting a long side multiplies the largest circumradius by "
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
