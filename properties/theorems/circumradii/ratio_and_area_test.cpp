// T3 and T3-sharp: bounds ρ̄ on the ratio of circumradius to shortest edge and Δ̄ on the area give a bound on the
// circumradius r. Proofs: properties/THEORY.md, T3 and T3-sharp.
#include "ratio_and_area.hpp"

#include <algorithm>
#include <cmath>
#include <ostream>

#include "../../../core/goal.hpp"
#include "../../../ref/definitions.hpp"
#include "../../../ref/ruppert.hpp"
#include "../../domains/domains.hpp"
#include "../framework/property.hpp"
#include "../framework/rapidcheck_generators.hpp"
#include "../framework/shares.hpp"

namespace pardel::properties {
namespace {
using generators::Random;
using ref::Number;

/// Computed from the squared sides by Heron's formula; a is the shortest side.
Squares squares_of_sides(const Number& aa, const Number& bb, const Number& cc) {
  const Number area = (2 * (aa * bb + bb * cc + cc * aa) - aa * aa - bb * bb - cc * cc) / 16;
  return {aa * bb * cc / (16 * area), aa, area};
}

/// The triangle with two angles arcsin(1 / 2ρ) and shortest edge 1; `ratio` is ρ² > 1/4.
Squares isosceles(const Number& ratio) { return squares_of_sides(1, 1, (4 * ratio - 1) / ratio); }

/// The fourth power of √2 ρ̄^(3/2) √Δ̄; `ratio` is ρ̄², `area` is Δ̄².
Number root_two_bound(const Number& ratio, const Number& area) { return 4 * ratio * ratio * ratio * area; }

/// Values of ρ² from 1/3, the least possible value, to about 1000; denser where the bounds change faster.
std::vector<Number> ratios() {
  std::vector<Number> grid;
  for (int k = 0; k <= 400; ++k) grid.push_back(Number(1) / 3 + Number(k * k * k) / 64'000);
  grid.push_back(2);  // ρ̄ = sqrt 2: a smallest angle of 20.7 degrees
  return grid;
}

/// A triangle with integer corners, counter-clockwise.
struct LatticeTriangle {
  ref::PlainMesh mesh;
  const char* family = "";
};

std::ostream& operator<<(std::ostream& out, const LatticeTriangle& triangle) {
  out << triangle.family;
  for (const ref::ExactPoint& p : triangle.mesh.points) out << " (" << p << ')';
  return out;
}

struct Vector {
  int x, y;
};

bool is_flat(const std::array<Vector, 3>& v) {
  const auto cross = [](Vector a, Vector b) { return std::int64_t{a.x} * b.y - std::int64_t{a.y} * b.x; };
  return cross({v[1].x - v[0].x, v[1].y - v[0].y}, {v[2].x - v[0].x, v[2].y - v[0].y}) == 0;
}

LatticeTriangle triangle_of(const std::array<Vector, 3>& v, double offset, const char* family) {
  LatticeTriangle triangle{{{}, {{0, 1, 2}}, {}}, family};
  for (const Vector& p : v) triangle.mesh.points.push_back(ref::exact({offset + p.x, offset + p.y}));
  if (CGAL::right_turn(triangle.mesh.points[0], triangle.mesh.points[1], triangle.mesh.points[2]))
    std::swap(triangle.mesh.points[1], triangle.mesh.points[2]);
  return triangle;
}

LatticeTriangle some_triangle(Random& random, int /*size*/) {
  const int extent = 1 << random.between(2, 20);
  const auto any = [&](int most) { return Vector{random.between(-most, most), random.between(-most, most)}; };
  const double offset = random.chance(4) ? 0x1p40 : 0;
  for (;;) {
    const Vector o{0, 0}, u = any(extent), small = any(3);
    const int i = random.between(1, 8), k = random.between(1, 20);
    std::array<Vector, 3> corners{};
    const char* family = "";
    switch (random.below(6)) {
      case 0:
        family = "general", corners = {o, u, any(extent)};
        break;
      case 1:
        family = "needle", corners = {o, small, u};
        break;
      case 2:
        family = "cap", corners = {o, Vector{2 * u.x, 2 * u.y}, Vector{u.x + small.x, u.y + small.y}};
        break;
      case 3:  // base 2k|u|, height i|u|
        family = "isosceles",
        corners = {o, Vector{2 * k * u.x, 2 * k * u.y}, Vector{k * u.x - i * u.y, k * u.y + i * u.x}};
        break;
      case 4:
        family = "right", corners = {o, Vector{k * u.x, k * u.y}, Vector{-i * u.y, i * u.x}};
        break;
      default: {
        const int half = random.between(1, extent);
        const auto height = static_cast<int>(std::lround(std::sqrt(3.0) * half));
        family = "nearly equilateral", corners = {o, Vector{2 * half, 0}, Vector{half, height}};
      }
    }
    if (!is_flat(corners)) return triangle_of(corners, offset, family);
  }
}

/// Up to two simpler triangles, for shrinking: the triangle at half the size, and the triangle moved to the origin.
std::vector<LatticeTriangle> simpler(const LatticeTriangle& triangle) {
  std::vector<LatticeTriangle> simpler;
  const ref::ExactPoint o = triangle.mesh.points[0];
  std::array<Vector, 3> whole{}, halved{};
  for (std::size_t i = 0; i < 3; ++i) {
    const Point p = ref::rounded(CGAL::ORIGIN + (triangle.mesh.points[i] - o));
    whole[i] = {static_cast<int>(p.x), static_cast<int>(p.y)};
    halved[i] = {whole[i].x / 2, whole[i].y / 2};
  }
  if (!is_flat(halved)) simpler.push_back(triangle_of(halved, 0, triangle.family));
  if (o != CGAL::ORIGIN) simpler.push_back(triangle_of(whole, 0, triangle.family));
  return simpler;
}

/// A triangle and bounds on its ρ² and A²; the triangle may attain one bound, both or none.
struct Bounded {
  Squares triangle;
  bool has_two_shortest_sides;
  Number ratio, area;
};

bool has_two_shortest_sides(const ref::PlainMesh& mesh) {
  std::array<Number, 3> sides;
  for (std::size_t i = 0; i < 3; ++i) sides[i] = CGAL::squared_distance(mesh.points[i], mesh.points[(i + 1) % 3]);
  std::sort(sides.begin(), sides.end());
  return sides[0] == sides[1];
}

Bounded some_bounded_triangle(Exhibit& exhibit) {
  const LatticeTriangle triangle = *generators::generator(some_triangle, simpler).as("triangle");
  const int ratio_slack = *rc::gen::inRange(0, 4).as("excess of the bound on ρ² over ρ², in sixteenths of ρ²");
  const int area_slack = *rc::gen::inRange(0, 4).as("excess of the bound on A² over A², in sixteenths of A²");
  Scene scene;
  for (const ref::ExactPoint& p : triangle.mesh.points) scene.points.push_back(ref::rounded(p));
  exhibit.show(scene);
  RC_TAG(std::string(triangle.family));
  const Squares squares = squares_of(triangle.mesh, triangle.mesh.triangles[0]);
  return {squares, has_two_shortest_sides(triangle.mesh), squares.ratio() * (16 + ratio_slack) / 16,
          squares.area * (16 + area_slack) / 16};
}

constexpr const char* triangle_families =
    "integer triangles: general, needles, caps, isosceles, right, nearly equilateral; at the origin and far from it; "
    "bounds that are attained and bounds that are not attained";

PARDEL_PROPERTY(T3, bounds_on_ratio_and_area_bound_the_circumradius,
                {.statement = "If ρ̄ bounds the ratio of circumradius to shortest edge of a triangle and Δ̄ bounds its "
                              "area, then r ≤ 2 ρ̄^(3/2) sqrt(Δ̄).",
                 .source = "[CC]; THEORY.md, T3",
                 .families = triangle_families}) {
  const Bounded given = some_bounded_triangle(exhibit);
  RC_ASSERT(fourth_power(given.triangle.radius) <= paper_bound(given.ratio, given.area));
}

PARDEL_PROPERTY(T3Sharp, the_isosceles_triangle_has_the_largest_circumradius,
                {.statement = "If ρ̄ bounds the ratio of circumradius to shortest edge of a triangle and Δ̄ bounds its "
                              "area, then r ≤ 2 ρ̄² sqrt(Δ̄) / (4ρ̄² - 1)^(1/4). Equality holds if and only if both "
                              "bounds are attained and the two shorter sides are equal.",
                 .source = "THEORY.md, T3-sharp",
                 .families = triangle_families}) {
  const Bounded given = some_bounded_triangle(exhibit);
  const Squares& t = given.triangle;
  const Number power = fourth_power(t.radius), bound = sharp_bound(given.ratio, given.area);
  RC_ASSERT(power <= bound);

  const bool attained = given.ratio == t.ratio() && given.area == t.area;
  classify(given.has_two_shortest_sides && attained, "equality", 3);
  RC_ASSERT((power == bound) == (given.has_two_shortest_sides && attained));
}

PARDEL_FACT(T3Sharp, the_isosceles_triangle_attains_the_bound_at_every_ratio,
            {.statement = "For every ρ̄ ≥ 1/sqrt(3), the isosceles triangle with two angles arcsin(1/2ρ̄) has the "
                          "ratio ρ̄, and its circumradius equals the bound of T3-sharp for its area. So no smaller "
                          "bound holds.",
             .source = "THEORY.md, T3-sharp",
             .families = "402 exact values of ρ̄² from 1/3 to 1000"}) {
  for (const Number& ratio : ratios()) {
    const Squares t = isosceles(ratio);
    ASSERT_EQ(t.ratio(), ratio);
    ASSERT_EQ(fourth_power(t.radius), sharp_bound(ratio, t.area)) << "ρ̄² = " << ratio;
    ++facts.cases;
  }
  const auto factor = [](const Number& power) { return std::to_string(std::pow(CGAL::to_double(power), 0.25)); };
  facts.notes.push_back("at ρ̄ = sqrt 2: r ≤ " + factor(sharp_bound(2, 1)) + " sqrt(Δ̄) by T3-sharp, r ≤ " +
                        factor(paper_bound(2, 1)) + " sqrt(Δ̄) by T3");
  facts.notes.push_back("the same bound on r allows " +
                        std::to_string(std::sqrt(CGAL::to_double(paper_bound(2, 1) / sharp_bound(2, 1)))) +
                        " times the area at ρ̄ = sqrt 2");
}

PARDEL_FACT(T3, only_the_equilateral_triangle_attains_the_bound,
            {.statement = "The equilateral triangle, with ρ̄ = 1/sqrt(3), attains the bound of T3. For every larger "
                          "ρ̄ the bound of T3-sharp is below the bound of T3. So no other triangle attains the bound "
                          "of T3.",
             .source = "THEORY.md, T3",
             .families = "402 exact values of ρ̄² from 1/3 to 1000"}) {
  for (const Number& ratio : ratios()) {
    const Squares t = isosceles(ratio);
    const Number bound = paper_bound(ratio, t.area);
    if (3 * ratio == 1) {
      ASSERT_EQ(fourth_power(t.radius), bound);
    } else {
      ASSERT_LT(fourth_power(t.radius), bound);
      ASSERT_LT(sharp_bound(ratio, t.area), bound);
    }
    ++facts.cases;
  }
}

PARDEL_FACT(T3, the_bound_with_factor_root_two_is_false_at_every_ratio,
            {.statement = "r ≤ sqrt(2) ρ̄^(3/2) sqrt(Δ̄) is false for every ρ̄ ≥ 1/sqrt(3): the isosceles triangle "
                          "with two angles arcsin(1/2ρ̄) has a larger circumradius.",
             .source = "THEORY.md, T3",
             .families = "402 exact values of ρ̄² from 1/3 to 1000"}) {
  for (const Number& ratio : ratios()) {
    const Squares t = isosceles(ratio);
    ASSERT_GT(fourth_power(t.radius), root_two_bound(ratio, t.area)) << "ρ̄² = " << ratio;
    ++facts.cases;
  }
}

PARDEL_FACT(T3Sharp, fails_if_a_bound_is_too_small,
            {.statement = "T3-sharp fails if ρ̄ is less than the ratio or Δ̄ is less than the area, even slightly: "
                          "the circumradius of the isosceles triangle then exceeds the bound.",
             .source = "THEORY.md, T3-sharp",
             .families = "402 exact values of ρ̄² from 1/3 to 1000, bounds too small by 2^-60 of their value"}) {
  const Number a_little_less = 1 - Number(0x1p-60);
  for (const Number& ratio : ratios()) {
    const Squares t = isosceles(ratio);
    ASSERT_GT(fourth_power(t.radius), sharp_bound(ratio, t.area * a_little_less));
    if (3 * ratio * a_little_less >= 1) {
      ASSERT_GT(fourth_power(t.radius), sharp_bound(ratio * a_little_less, t.area));
    }
    ++facts.cases;
  }
}

PARDEL_FACT(T3Sharp, the_bound_grows_with_the_ratio,
            {.statement = "The bound of T3-sharp increases with ρ̄ for ρ̄ ≥ 1/sqrt(3). The ratio of every triangle "
                          "is at least 1/sqrt(3). So T3-sharp holds for every upper bound ρ̄ of the ratio. Between "
                          "1/2 and 1/sqrt(3) the bound decreases.",
             .source = "THEORY.md, T3-sharp",
             .families = "402 exact values of ρ̄² from 1/3 to 1000, and 80 from 1/4 to 1/3"}) {
  const std::vector<Number> grid = ratios();
  for (std::size_t k = 1; k + 1 < grid.size(); ++k) {
    ASSERT_LT(sharp_bound(grid[k - 1], 1), sharp_bound(grid[k], 1));
    ++facts.cases;
  }
  for (int k = 1; k < 80; ++k) {
    const Number below = Number(1) / 4 + Number(k) / 960;
    ASSERT_GT(sharp_bound(below, 1), sharp_bound(below + Number(1) / 960, 1));
    ++facts.cases;
  }
}

PARDEL_FACT(T3Sharp, holds_for_whole_meshes,
            {.statement = "In a mesh whose angles are at least 20.7 degrees (ρ̄ = sqrt 2), every circumradius is at "
                          "most 2.459 sqrt(Δ̄), where Δ̄ is the largest area of a triangle.",
             .source = "THEORY.md, T3-sharp",
             .families = "meshes of two domains by ref::ruppert, each with three bounds on the area"}) {
  const double proven = 180 / std::acos(-1.0) * std::asin(1 / (2 * std::sqrt(2.0)));
  const std::vector<std::pair<const char*, Pslg>> inputs = {{"square", domains::square()},
                                                            {"comb", domains::comb(2, 0.25)}};
  for (const auto& [name, pslg] : inputs)
    for (const double area : {0.05, 0.01, 0.004}) {
      Goal goal;
      goal.min_angle_deg = proven;
      goal.max_area = area;
      const Result<Mesh> mesh = ref::ruppert(pslg, goal);
      ASSERT_TRUE(mesh) << mesh.error().message;
      const Squares most = largest(ref::to_plain_mesh(*mesh));
      ASSERT_LE(fourth_power(most.radius), sharp_bound(most.ratio(), most.area));
      ASSERT_LE(fourth_power(most.radius), sharp_bound(2, most.area));
      ++facts.cases;
      facts.notes.push_back(std::string(name) + ", area ≤ " + std::to_string(area) + ": largest circumradius " +
                            std::to_string(std::pow(CGAL::to_double(fourth_power(most.radius) / most.area), 0.25)) +
                            " sqrt(Δ̄), at most 2.459 sqrt(Δ̄) as proved, " + std::to_string(mesh->triangles.size()) +
                            " triangles");
    }
}

}  // namespace
}  // namespace pardel::properties
