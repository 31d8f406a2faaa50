// The mesher on every domain with every kind of goal; the independent checker examines the meshes.
#include "../../parallel/mesher.hpp"

#include <gtest/gtest.h>
#include <omp.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>
#include <set>
#include <thread>

#include "../../core/digest.hpp"
#include "../../parallel/sizes.hpp"
#include "../../properties/checker/check.hpp"
#include "../../properties/domains/domains.hpp"
#include "test_name.hpp"

namespace pardel::engine {
namespace {

Pslg domain(const std::string& name) {
  Result<Pslg> made = domains::generate(name, 0, 1);
  EXPECT_TRUE(made) << name;
  return std::move(made).value();
}

std::string verdict(const Pslg& pslg, const Mesh& mesh, const Goal& goal) {
  const Certificate certificate = check(pslg, mesh, goal);
  if (certificate.valid) return "valid";
  std::string text;
  for (std::size_t i = 0; i < certificate.violations.size() && i < 3; ++i)
    text += certificate.violations[i].message() + '\n';
  return text;
}

/// Expects that every triangle that the checker justifies is a justified exemption in the report, too.
void expect_same_exemptions(const Certificate& certificate, const Report& report) {
  std::set<Index> reported, found;
  for (const Exemption& e : report.exempt)
    if (justified(e.reason)) reported.insert(e.triangle);
  for (const Justified& j : certificate.justified) found.insert(j.triangle);
  // The mesher works with slightly stricter bounds, so it can exempt a triangle that satisfies the goal, but never
  // omits one.
  EXPECT_TRUE(std::includes(reported.begin(), reported.end(), found.begin(), found.end()));
}

Meshed expect_met(const Pslg& pslg, const Goal& goal, const Options& options = {}) {
  Result<Meshed> meshed = mesh(pslg, goal, options);
  EXPECT_TRUE(meshed) << meshed.error().message;
  if (!meshed) return {};
  const Certificate certificate = check(pslg, meshed->mesh, goal);
  EXPECT_TRUE(certificate.valid) << verdict(pslg, meshed->mesh, goal);
  EXPECT_TRUE(meshed->report.goal_met());
  expect_same_exemptions(certificate, meshed->report);
  EXPECT_EQ(meshed->mesh.points.size(), pslg.points.size() + meshed->report.inserted + meshed->report.segment_splits);
  return std::move(meshed).value();
}

// Every domain ------------------------------------------------------------------------------------------------

class Domain : public testing::TestWithParam<std::string> {};

TEST_P(Domain, is_meshed_at_every_angle) {
  for (const double angle : {0.0, 20.7, 25.0, 30.0, 33.0}) {
    SCOPED_TRACE(angle);
    expect_met(domain(GetParam()), {.min_angle_deg = angle});
  }
}

TEST_P(Domain, is_meshed_with_circumcentres) {
  Options options;
  options.placement = Placement::circumcentre;
  for (const double angle : {20.7, 30.0}) expect_met(domain(GetParam()), {.min_angle_deg = angle}, options);
}

TEST_P(Domain, is_meshed_with_points_chosen_among_several) {
  for (const double angle : {20.7, 30.0, 33.0}) {
    SCOPED_TRACE(angle);
    expect_met(domain(GetParam()), {.min_angle_deg = angle, .max_area = 0.003}, {.placement = Placement::search});
  }
}

TEST_P(Domain, is_meshed_conforming) {
  for (const double angle : {0.0, 20.7, 30.0}) {
    SCOPED_TRACE(angle);
    expect_met(domain(GetParam()), {.min_angle_deg = angle, .conforming = true});
  }
}

TEST_P(Domain, is_meshed_with_its_convex_hull) {
  Pslg pslg = domain(GetParam());
  pslg.holes.clear();
  pslg.regions.clear();
  expect_met(pslg, {.min_angle_deg = 25, .convex_hull = true});
}

TEST_P(Domain, is_meshed_with_caps_on_area_and_edges) {
  for (const Goal& goal : {Goal{.max_area = 0.003}, Goal{.min_angle_deg = 30, .max_edge = 0.08},
                           Goal{.min_angle_deg = 0, .max_area = 0.002, .conforming = true}}) {
    SCOPED_TRACE(goal.max_area);
    expect_met(domain(GetParam()), goal);
  }
}

TEST_P(Domain, is_meshed_to_a_size_that_varies) {
  Goal goal{.min_angle_deg = 25};
  goal.size = [](Point p) { return 0.05 + 0.2 * std::hypot(p.x - 0.5, p.y - 0.5); };
  expect_met(domain(GetParam()), goal);
}

TEST_P(Domain, is_meshed_far_from_the_origin) {
  for (const double angle : {20.7, 33.0}) {
    SCOPED_TRACE(angle);
    expect_met(domains::moved(domain(GetParam()), 654321, 4987654), {.min_angle_deg = angle});
  }
}

TEST_P(Domain, gives_the_same_mesh_twice) {
  const Pslg pslg = domain(GetParam());
  const Result<Meshed> first = mesh(pslg, {.min_angle_deg = 25}), second = mesh(pslg, {.min_angle_deg = 25});
  ASSERT_TRUE(first && second);
  EXPECT_EQ(first->mesh, second->mesh);
}

TEST_P(Domain, is_triangulated_without_new_points) {
  const Pslg pslg = domain(GetParam());
  const Result<Meshed> meshed = triangulate(pslg);
  ASSERT_TRUE(meshed) << meshed.error().message;
  EXPECT_EQ(meshed->mesh.points.size(), pslg.points.size());
  EXPECT_EQ(verdict(pslg, meshed->mesh, {.min_angle_deg = 0, .region_caps = false}), "valid");
}

INSTANTIATE_TEST_SUITE_P(Every, Domain, testing::ValuesIn(domains::even_names()), test_name);

// Goals of one kind -------------------------------------------------------------------------------------------

TEST(Mesher, applies_the_caps_of_regions_only_where_the_goal_says_so) {
  const Pslg pslg = domain("regions");
  const Meshed capped = expect_met(pslg, {.region_caps = true});
  const Meshed free = expect_met(pslg, {});
  EXPECT_GT(capped.mesh.triangles.size(), free.mesh.triangles.size());
  EXPECT_FALSE(check(pslg, free.mesh, {.region_caps = true}).valid);
}

TEST(Mesher, refuses_tiles_without_triangles) {
  const Result<Meshed> refused = mesh(domains::pipe(), {}, {.triangles_per_tile = 0});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().message, "the triangles of a tile must be positive, not 0");
}

TEST(Mesher, refuses_a_negative_number_of_threads) {
  const Pslg pslg = domains::square();
  const Result<ValidPslg, std::vector<Problem>> valid = validate(pslg);
  ASSERT_TRUE(valid);
  const Options options{.threads = -1};
  const Result<Meshed> coarse = mesh(pslg);
  ASSERT_TRUE(coarse);
  for (const Result<Meshed>& refused :
       {mesh(pslg, {}, options), mesh(*valid, {}, options), triangulate(pslg, false, options),
        triangulate(*valid, options), refine(coarse->mesh, {}, {}, options)}) {
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().kind, ErrorKind::usage);
    EXPECT_EQ(refused.error().message, "the number of threads must be zero or positive, not -1");
  }
}

TEST(Mesher, names_every_duplicate_point_of_a_set_of_points) {
  Pslg points = domains::random_points(1000, 7);
  for (const Index first : {5, 17, 5}) points.points.push_back(points.points[first]);
  const auto message = [](const Pslg& pslg, bool refines) {
    const Result<Meshed> made = refines ? mesh(pslg, {}) : triangulate(pslg, true);
    return made ? "no error" : made.error().message;
  };
  for (const bool refines : {false, true})
    EXPECT_EQ(message(points, refines), messages(find_problems(points), points.first_id.value)) << refines;
  EXPECT_NE(message(points, false).find("1001"), std::string::npos);
  points.points[3].x = NAN;  // then the search for duplicates is not left to the triangulation
  EXPECT_EQ(message(points, false), messages(find_problems(points), points.first_id.value));
  points.points = {{1, 2}, {1, 2}, {1, 2}};
  EXPECT_EQ(message(points, false), messages(find_problems(points), points.first_id.value));
}

TEST(Mesher, names_all_other_problems_of_a_set_of_points) {
  Pslg points = domains::random_points(20, 7);
  const auto refused = [&] {
    const std::string problems = messages(find_problems(points), points.first_id.value);
    EXPECT_NE(problems, "");
    for (const Result<Meshed>& made : {mesh(points, {}), triangulate(points)})
      EXPECT_EQ(made ? "no error" : made.error().message, problems);
  };
  points.point_markers.resize(19);
  refused();
  points.point_markers.clear();
  points.attributes_per_point = 2;
  points.point_attributes.resize(41);
  refused();
  points.attributes_per_point = 0;
  points.point_attributes.clear();
  for (const double unusable : std::initializer_list<double>{NAN, -INFINITY, 1e300, 1e-300}) {
    points.points[3].x = unusable;
    points.points[7].y = unusable;
    refused();
  }
  points.points = {{1, 2}, {2, 4}, {3, 6}};
  refused();
}

TEST(Mesher, uses_all_threads_by_default) {
  omp_set_num_threads(3);
  std::atomic<int> most{0};
  const Goal goal{.size = [&](Point) {
    if (omp_get_num_threads() > most) most = omp_get_num_threads();
    return 0.005;
  }};
  const Result<Meshed> all = mesh(domains::pipe(), goal);
  EXPECT_EQ(most, 3);
  most = 0;
  const Result<Meshed> one = mesh(domains::pipe(), goal, {.threads = 1});
  EXPECT_EQ(most, 1);
  ASSERT_TRUE(all && one);
  EXPECT_EQ(all->mesh, one->mesh);
}

TEST(Mesher, grades_from_sizes_at_the_input_points) {
  Pslg pslg = domains::square();
  const std::vector<double> sizes{0.01, 0.2, 0.2, 0.2};
  const auto size = interpolated_size(pslg, sizes);
  ASSERT_TRUE(size);
  EXPECT_EQ((*size)({0, 0}), 0.01);
  EXPECT_NEAR((*size)({0.5, 0}), 0.105, 1e-15);
  Goal goal{.min_angle_deg = 25};
  goal.size = *size;
  const Meshed meshed = expect_met(pslg, goal);
  EXPECT_GT(meshed.mesh.points.size(), 150U);
}

/// Two triangles over the unit square; the second is clockwise.
Mesh two_triangles() {
  Mesh mesh;
  for (const Point p : {Point{0, 0}, Point{1, 0}, Point{1, 1}, Point{0, 1}}) mesh.points.push_back(p);
  for (const std::array<Index, 3> v : {std::array<Index, 3>{0, 1, 2}, std::array<Index, 3>{0, 3, 2}}) {
    Triangle triangle;
    triangle.v = v;
    mesh.triangles.push_back(triangle);
  }
  return mesh;
}

TEST(SizeOnAMesh, is_linear_on_triangles_of_both_orientations) {
  const auto size = interpolated_size(two_triangles(), std::vector<double>{1, 2, 3, 4});
  ASSERT_TRUE(size);
  EXPECT_NEAR((*size)({0.75, 0.25}), 2, 1e-15);
  EXPECT_NEAR((*size)({0.25, 0.75}), 3, 1e-15);
  EXPECT_EQ((*size)({0, 1}), 4);
}

TEST(SizeOnAMesh, reaches_beyond_the_mesh_by_the_length_of_a_side) {
  const auto size = interpolated_size(two_triangles(), std::vector<double>{1, 2, 3, 4});
  ASSERT_TRUE(size);
  EXPECT_EQ((*size)({1.5, -0.25}), 2);
  EXPECT_THROW((*size)({3, 0}), Error);
  const Result<Meshed> meshed = mesh(domains::moved(domains::square(), 3, 0), {.size = *size});
  ASSERT_FALSE(meshed);
  EXPECT_EQ(meshed.error().kind, ErrorKind::invalid_input);
  EXPECT_NE(meshed.error().message.find("the mesh of the sizes does not cover ("), std::string::npos);
}

TEST(SizeOnAMesh, must_cover_all_vertices_of_the_domain) {
  const auto size = interpolated_size(two_triangles(), std::vector<double>{100, 100, 100, 100});
  ASSERT_TRUE(size);
  Pslg pslg = domains::square();
  const auto corner = std::ranges::find(pslg.points, Point{0, 1});
  ASSERT_NE(corner, pslg.points.end());
  *corner = {0, 3};
  const Result<Meshed> meshed = mesh(pslg, {.min_angle_deg = 0, .size = *size});
  ASSERT_FALSE(meshed) << "although no triangle has to be split";
  EXPECT_EQ(meshed.error().message, "the mesh of the sizes does not cover (0, 3)");
  *corner = {0, 2};
  EXPECT_TRUE(mesh(pslg, {.min_angle_deg = 0, .size = *size}));
}

TEST(SizeOnAMesh, gives_the_mesh_of_a_function_with_the_same_values) {
  const auto size = interpolated_size(two_triangles(), std::vector<double>{0.02, 0.05, 0.1, 0.3});
  ASSERT_TRUE(size);
  const Result<Meshed> on_mesh = mesh(domains::square(), {.size = *size});
  const Result<Meshed> function = mesh(domains::square(), {.size = [&](Point p) { return (*size)(p); }});
  ASSERT_TRUE(on_mesh && function);
  EXPECT_EQ(digest(on_mesh->mesh), digest(function->mesh));
}

TEST(SizeOnAMesh, names_what_is_wrong_with_its_mesh) {
  const auto message = [](const Mesh& mesh, std::vector<double> sizes = {1, 1, 1, 1}) {
    const auto size = interpolated_size(mesh, sizes);
    return size ? "no error" : size.error().message;
  };
  EXPECT_EQ(message(two_triangles(), {1, 1, 1}), "3 sizes for 4 points");
  EXPECT_EQ(message(two_triangles(), {1, 1, 0, 1}), "the size at point 2 must be positive, not 0");
  Mesh empty = two_triangles();
  empty.triangles.clear();
  EXPECT_EQ(message(empty), "the mesh of the sizes has no triangles");
  Mesh beyond = two_triangles();
  beyond.triangles[1].v[2] = 4;
  EXPECT_EQ(message(beyond), "triangle 1 of the mesh of the sizes (vertices 0, 3, 4) has a corner that does not exist");
  Mesh flat = two_triangles();
  flat.triangles[1].v[1] = 0;
  EXPECT_EQ(message(flat), "triangle 1 of the mesh of the sizes (vertices 0, 0, 2) is flat");
}

TEST(Mesher, keeps_the_attributes_of_points_and_interpolates_them_for_new_ones) {
  Pslg pslg = domains::pipe();
  pslg.attributes_per_point = 2;
  const auto linear = [](Point p) { return 3 * p.x - 2 * p.y + 7; };
  for (const Point p : pslg.points) pslg.point_attributes.insert(pslg.point_attributes.end(), {linear(p), p.x});
  const Meshed meshed = expect_met(pslg, {.max_area = 0.01});
  ASSERT_EQ(meshed.mesh.attributes_per_point, 2U);
  ASSERT_EQ(meshed.mesh.point_attributes.size(), 2 * meshed.mesh.points.size());
  for (std::size_t v = 0; v < meshed.mesh.points.size(); ++v) {
    const Point p = meshed.mesh.points[v];
    EXPECT_NEAR(meshed.mesh.point_attributes[2 * v], linear(p), 1e-12);
    EXPECT_NEAR(meshed.mesh.point_attributes[2 * v + 1], p.x, 1e-12);
  }
}

TEST(Mesher, records_the_origin_of_every_vertex_and_constrained_edge) {
  Pslg pslg = domains::square();
  pslg.segments.pop_back();
  pslg.has_segment_markers = true;
  for (Index s = 0; s < 3; ++s) pslg.segments[s].marker = static_cast<int>(10 + s);
  const Meshed meshed = expect_met(pslg, {.max_area = 0.01, .convex_hull = true});
  const Mesh& m = meshed.mesh;
  ASSERT_EQ(m.origin.size(), m.points.size());
  std::set<Index> origins(m.origin.begin(), m.origin.end());
  EXPECT_EQ(origins, (std::set<Index>{origin_on_segment(0), origin_on_segment(1), origin_on_segment(2), hull_vertex,
                                      interior_vertex, input_vertex}));
  for (std::size_t v = 0; v < m.points.size(); ++v) {
    EXPECT_EQ(m.origin[v] == input_vertex, v < pslg.points.size());
    if (m.origin[v] == input_vertex) continue;
    const int marker = m.origin[v] == hull_vertex       ? 1
                       : m.origin[v] == interior_vertex ? 0
                                                        : 10 + static_cast<int>(segment_of_origin(m.origin[v]));
    EXPECT_EQ(m.point_markers[v], marker);
  }
  for (const ConstrainedEdge& e : m.constrained_edges)
    EXPECT_EQ(e.marker, e.segment == no_index ? 1 : static_cast<int>(10 + e.segment));
}

TEST(Mesher,
     searches_for_points_by_default_above_30_degrees_without_bounds_on_lengths_and_from_30_degrees_on_in_meshes) {
  const auto digest_of = [](double angle, Placement placement) {
    return digest(
        expect_met(domains::pipe(), {.min_angle_deg = angle, .max_area = 0.003}, {.placement = placement}).mesh);
  };
  EXPECT_EQ(digest_of(30, Placement::automatic), digest_of(30, Placement::off_centre));
  EXPECT_NE(digest_of(30, Placement::automatic), digest_of(30, Placement::search));
  EXPECT_EQ(digest_of(30.1, Placement::automatic), digest_of(30.1, Placement::search));
  const auto with_edges = [](Placement placement) {
    return digest(expect_met(domains::pipe(), {.min_angle_deg = 31, .max_edge = 0.1}, {.placement = placement}).mesh);
  };
  EXPECT_EQ(with_edges(Placement::automatic), with_edges(Placement::off_centre));
  const Mesh coarse = expect_met(domains::pipe(), {.min_angle_deg = 15, .max_area = 0.01}).mesh;
  const auto refined = [&](double angle, Placement placement) {
    const Result<Meshed> result = refine(coarse, {}, {.min_angle_deg = angle}, {.placement = placement});
    EXPECT_TRUE(result);
    return digest(result->mesh);
  };
  EXPECT_EQ(refined(30, Placement::automatic), refined(30, Placement::search));
  EXPECT_EQ(refined(29.9, Placement::automatic), refined(29.9, Placement::off_centre));
  EXPECT_NE(refined(29.9, Placement::automatic), refined(29.9, Placement::search));
}

TEST(Mesher, marks_a_vertex_as_the_first_marked_segment_on_which_it_lies) {
  Pslg pslg = domains::square();
  pslg.has_segment_markers = true;
  const std::vector<int> of_segment = {0, 1, 9, 5};
  for (Index s = 0; s < 4; ++s) pslg.segments[s].marker = of_segment[s];
  pslg.segments.push_back({0, 2, 7});
  const Mesh m = expect_met(pslg, {.max_area = 0.1}).mesh;
  const std::vector<int> inside_segment = {1, 1, 9, 5, 7};
  const std::vector<int> corners(m.point_markers.begin(), m.point_markers.begin() + 4);
  EXPECT_EQ(corners, (std::vector<int>{5, 1, 1, 9}));
  for (std::size_t v = 4; v < m.points.size(); ++v) {
    const bool interior = m.origin[v] == interior_vertex;
    EXPECT_EQ(m.point_markers[v], interior ? 0 : inside_segment[segment_of_origin(m.origin[v])]) << v;
  }
}

TEST(Mesher, marks_a_vertex_of_the_boundary_as_the_segment_that_ends_there) {
  Pslg pslg = domains::square();
  pslg.points.push_back({0.5, 0.5});
  pslg.has_segment_markers = true;
  for (Index corner = 0; corner < 4; ++corner) pslg.segments.push_back({corner, 4, 7});
  const Mesh m = expect_met(pslg, {.max_area = 0.01}).mesh;
  for (std::size_t v = 0; v < m.points.size(); ++v) {
    const bool diagonal = m.origin[v] == input_vertex || m.origin[v] >= origin_on_segment(4);
    EXPECT_EQ(m.point_markers[v], diagonal ? 7 : m.origin[v] == interior_vertex ? 0 : 1) << v;
  }
}

TEST(Mesher, keeps_isolated_points_and_both_sides_of_a_crack) {
  const Pslg pslg = domain("cracks");
  const Meshed meshed = expect_met(pslg, {.min_angle_deg = 30});
  for (std::size_t v = 0; v < pslg.points.size(); ++v) EXPECT_EQ(meshed.mesh.points[v], pslg.points[v]);
}

/// The number of threads that ask for a size while a square becomes about this number of triangles.
std::size_t threads_that_ask(double triangles, int threads) {
  std::mutex writing;
  std::set<std::thread::id> seen;
  Goal goal;
  goal.size = [&](Point) {
    const std::scoped_lock lock(writing);
    seen.insert(std::this_thread::get_id());
    return std::sqrt(2.3 / triangles);
  };
  EXPECT_TRUE(mesh(domains::square(), goal, {.threads = threads, .triangles_per_tile = 1000}));
  return seen.size();
}

TEST(Mesh, uses_several_threads_for_a_large_mesh_of_few_points_and_one_for_a_small_mesh) {
  omp_set_num_threads(2);
  for (int i = 0; i < 20; ++i) EXPECT_EQ(threads_that_ask(3000, 0), 1U);
  // On a busy machine, one thread may do everything before the other one starts.
  const auto uses_both = [](double triangles, int threads) {
    for (int i = 0; i < 20; ++i)
      if (threads_that_ask(triangles, threads) == 2) return true;
    return false;
  };
  EXPECT_TRUE(uses_both(60'000, 0));
  EXPECT_TRUE(uses_both(20'000, 2)) << "a number of threads that the caller gives is used";
}

TEST(Mesh, reports_the_times_of_its_stages) {
  const Result<Meshed> meshed = mesh(domains::square(), {.max_area = 0.01});
  ASSERT_TRUE(meshed);
  EXPECT_GT(meshed->report.validate_seconds, 0);
  EXPECT_GT(meshed->report.triangulate_seconds, 0);
  EXPECT_GT(meshed->report.refine_seconds, 0);
  const Result<Meshed> again = refine(meshed->mesh, {}, {.max_area = 0.005});
  ASSERT_TRUE(again);
  EXPECT_EQ(again->report.validate_seconds, 0);
  EXPECT_GT(again->report.triangulate_seconds, 0);
  EXPECT_GT(again->report.refine_seconds, 0);
}

}  // namespace
}  // namespace pardel::engine
