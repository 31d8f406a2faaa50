#include "../../../parallel/locator.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <numeric>

#include "../../../parallel/location/located_triangles.hpp"
#include "../../../parallel/mesher.hpp"
#include "triangle_sets.hpp"

namespace pardel::engine {
namespace {

Mesh two_triangles() {
  Mesh mesh;
  for (const Point p : {Point{0, 0}, {1, 0}, {1, 1}, {0, 1}}) mesh.points.push_back(p);
  mesh.triangles.push_back({{0, 1, 2}, {}});
  mesh.triangles.push_back({{0, 2, 3}, {}});
  return mesh;
}

/// Meshes of the mesher, graded ones too.
Mesh mesh_of_square(double max_edge, double at_origin) {
  Pslg square;
  square.points = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  square.segments = {{0, 1}, {1, 2}, {2, 3}, {3, 0}};
  Goal goal;
  goal.size = [=](Point p) { return at_origin + (max_edge - at_origin) * std::hypot(p.x, p.y); };
  return mesh(*validate(square), goal)->mesh;
}

TEST(Locator, knows_inside_edges_vertices_and_outside) {
  const Mesh mesh = two_triangles();
  const Locator locator = *Locator::over(mesh);
  EXPECT_EQ(locator.triangle_at({0.75, 0.25}), 0U);
  EXPECT_EQ(locator.triangle_at({0.25, 0.75}), 1U);
  EXPECT_EQ(locator.triangle_at({0.5, 0.5}), 0U) << "the first of both";
  EXPECT_EQ(locator.triangle_at({0, 0}), 0U);
  EXPECT_EQ(locator.triangle_at({0, 1}), 1U);
  EXPECT_EQ(locator.triangle_at({std::nextafter(1, 2), 0.5}), no_index);
  EXPECT_EQ(locator.triangle_at({0.5, std::nextafter(0.5, 1)}), 1U);
}

TEST(Locator, finds_no_triangle_at_places_that_are_not_finite) {
  const Mesh mesh = two_triangles();
  const Locator locator = *Locator::over(mesh);
  for (const double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL, 1e300}) {
    EXPECT_EQ(locator.triangle_at({bad, 0.5}), no_index);
    EXPECT_EQ(locator.triangle_at({0.5, bad}), no_index);
  }
  EXPECT_EQ(locator.triangle_at({-1e-200, 0.5}), 1U) << "counts as 0";
}

TEST(Locator, finds_nothing_in_an_empty_mesh) {
  const Mesh none;
  EXPECT_EQ(Locator::over(none)->triangle_at({0, 0}), no_index);
}

TEST(Locator, leaves_flat_triangles_out) {
  Mesh mesh = two_triangles();
  mesh.triangles[0].v = {0, 0, 1};
  const Locator locator = *Locator::over(mesh);
  EXPECT_EQ(locator.triangle_at({0.5, 0}), no_index);
  EXPECT_EQ(locator.triangle_at({0, 0}), 1U);
}

TEST(Locator, refuses_a_mesh_that_it_cannot_use_and_names_the_triangle) {
  const auto message = [](const Mesh& mesh) {
    const Result<Locator> locator = Locator::over(mesh);
    return locator ? "" : locator.error().message;
  };
  Mesh clockwise = two_triangles(), beyond = clockwise, infinite = clockwise;
  clockwise.triangles[1].v = {0, 3, 2};
  EXPECT_EQ(message(clockwise),
            "triangle 1 of the mesh (vertices 0, 3, 2) is clockwise; points are located in "
            "counter-clockwise triangles");
  beyond.triangles[1].v[2] = 7;
  EXPECT_EQ(message(beyond), "triangle 1 of the mesh (vertices 0, 2, 7) has a corner that is not a point of the mesh");
  infinite.points[1] = {INFINITY, 0};
  EXPECT_NE(message(infinite).find("triangle 0 of the mesh (vertices 0, 1, 2) has a corner at (inf, 0)"),
            std::string::npos);
}

TEST(Locator, ends_when_the_caller_asks_it_to) {
  const Mesh mesh = mesh_of_square(0.01, 0.01);
  const LocatorOptions stop{.go_on = [] { return false; }};
  EXPECT_EQ(Locator::over(mesh, stop).error().kind, ErrorKind::cancelled);
  const std::vector<Point> points(10, Point{0.5, 0.5});
  std::vector<Index> found(10);
  EXPECT_EQ(Locator::over(mesh)->triangles_at(points, found, stop).error().kind, ErrorKind::cancelled);
}

TEST(Locator, locates_many_points_as_single_ones_on_any_number_of_threads) {
  const Mesh mesh = mesh_of_square(0.05, 0.0001);
  generators::Random random(3);
  std::vector<Point> points = telling_points(mesh, random, 20'000);
  std::vector<Index> expected(points.size()), found(points.size());
  const Locator locator = *Locator::over(mesh);
  for (std::size_t i = 0; i < points.size(); ++i) expected[i] = locator.triangle_at(points[i]);
  for (const int threads : {1, 2, 7}) {
    ASSERT_TRUE(Locator::over(mesh, {.threads = threads})->triangles_at(points, found, {.threads = threads}).ok());
    EXPECT_EQ(found, expected);
  }
}

/// Seconds per point, the least of three runs. find(p): a triangle.
template <class Find>
double seconds_per_point(std::span<const Point> points, const Find& find) {
  double least = INFINITY;
  std::size_t found = 0;
  for (int run = 0; run < 3; ++run) {
    const auto start = std::chrono::steady_clock::now();
    for (const Point p : points) found += find(p) != no_index ? 1 : 0;
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
    least = std::min(least, took.count());
  }
  EXPECT_GT(found, 0U);
  return least / static_cast<double>(points.size());
}

TEST(Locator, is_fast_in_meshes_that_defeat_grids) {
  generators::Random random(5);
  const std::size_t many = 100'000;
  const Mesh round = fan(many, {0.1, 0.2}, 1), slivers = stack_of_slivers(many / 2, 50'000, 50'000.5),
             graded = torn_lattice(random, 220, 0.5, 1.1);
  for (const Mesh* mesh : {&round, &slivers, &graded}) {
    const Locator locator = *Locator::over(*mesh);
    const LocatedTriangles all{mesh->points.span(), mesh->triangles.span()};
    const auto try_all = [&](Point p) {
      for (Index t = 0; t < all.triangles.size(); ++t)
        if (all.contains(t, p)) return t;
      return no_index;
    };
    const std::vector<Point> points = telling_points(*mesh, random, 5000);
    const double quick = seconds_per_point(points, [&](Point p) { return locator.triangle_at(p); });
    EXPECT_LT(quick, seconds_per_point(std::span(points).first(100), try_all) / 50);
  }
}

TEST(Interpolation, has_the_value_of_a_vertex_exactly) {
  const Mesh mesh = mesh_of_square(0.1, 0.001);
  generators::Random random(6);
  std::vector<double> values(mesh.points.size()), found(mesh.points.size());
  for (double& value : values) value = std::ldexp(random.uniform(-1, 1), random.between(-40, 40));
  ASSERT_TRUE(Locator::over(mesh)->interpolate(values, 1, mesh.points.span(), found).ok());
  EXPECT_EQ(found, values);
}

TEST(Interpolation, reproduces_linear_functions_to_rounding_and_constants_exactly) {
  const Mesh mesh = mesh_of_square(0.1, 0.001);
  generators::Random random(7);
  std::vector<double> values;
  for (const Point p : mesh.points) values.insert(values.end(), {3 * p.x - 5 * p.y + 1, 0.1});
  std::vector<Point> points(20'000);
  for (Point& p : points) p = {random.uniform(0, 1), random.uniform(0, 1)};
  std::vector<double> found(2 * points.size());
  ASSERT_TRUE(Locator::over(mesh)->interpolate(values, 2, points, found).ok());
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_NEAR(found[2 * i], 3 * points[i].x - 5 * points[i].y + 1, 1e-14);
    EXPECT_EQ(found[2 * i + 1], 0.1);
  }
}

TEST(Interpolation, is_accurate_in_slivers) {
  Mesh mesh;
  for (const Point p : {Point{0, 0}, {3, 1 + 0x1p-50}, {1.5, 0.5 + 0x1p-50}}) mesh.points.push_back(p);
  add_triangle(mesh, 0, 1, 2);
  const std::vector<double> values{0, 3, 1.5};  // x
  const std::vector<Point> points{{1.5, 0.5 + 0x1p-51}, {0.75, 0.25 + 0x1p-52}, {1.5, 0.5 + 0x1p-50}};
  std::vector<double> found(3);
  const Locator locator = *Locator::over(mesh);
  ASSERT_TRUE(locator.interpolate(values, 1, points, found).ok());
  for (std::size_t i = 0; i < 3; ++i)
    if (locator.triangle_at(points[i]) != no_index) {
      EXPECT_NEAR(found[i], points[i].x, 1e-14);
    }
  EXPECT_EQ(found[2], 1.5);
}

TEST(Interpolation, on_an_edge_depends_on_its_ends_alone) {
  const Mesh mesh = two_triangles();
  const double none = std::nan("");
  std::vector<double> found(2);
  const std::vector<Point> points{{0.25, 0.25}, {2, 2}};
  ASSERT_TRUE(Locator::over(mesh)->interpolate(std::vector<double>{1, none, 5, INFINITY}, 1, points, found, -7).ok());
  EXPECT_EQ(found[0], 2);
  EXPECT_EQ(found[1], -7) << "outside";
}

TEST(Interpolation, lies_between_the_values_at_the_corners_also_if_these_are_huge) {
  const Mesh mesh = two_triangles();
  std::vector<double> found(1);
  ASSERT_TRUE(
      Locator::over(mesh)
          ->interpolate(std::vector<double>{-1.7e308, 1.7e308, 1.7e308, 0}, 1, std::vector<Point>{{0.75, 0.25}}, found)
          .ok());
  EXPECT_NEAR(found[0] / 1.7e308, 0.5, 1e-12);
}

TEST(Interpolation, has_weights_that_are_not_negative_and_sum_to_one) {
  generators::Random random(8);
  const Mesh mesh = torn_lattice(random, 12, 0.3, 1.5);
  const Locator locator = *Locator::over(mesh);
  for (const Point p : telling_points(mesh, random, 1000)) {
    const Index t = locator.triangle_at(p);
    if (t == no_index) continue;
    const auto weights = locator.weights_at(t, p);
    for (const double weight : weights) EXPECT_GE(weight, 0);
    EXPECT_NEAR(std::accumulate(weights.begin(), weights.end(), 0.0), 1, 1e-14);
  }
}

}  // namespace
}  // namespace pardel::engine
