// Each file of this folder is meshed at several angle bounds. The independent checker certifies each mesh; exempt
// triangles occur only at small input angles. Without bounds, no point is inserted. Each file of repair/ is repaired;
// new points lie on their segments up to rounding. Each file of written/ is meshed, and the mesh is written and read;
// the checker's verdict stays the same. Each file of refined/ is meshed, written, read, and refined. Each file of
// wrong_meshes/ has a mesh that the checker refuses, at all scales. Each file of bounds/ and of meshes/ has a test of
// its own.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>
#include <string>

#include "../../core/digest.hpp"
#include "../../core/formats.hpp"
#include "../../distributed/distributed.hpp"
#include "../../parallel/mesher.hpp"
#include "../../parallel/repair.hpp"
#include "../../parallel/validate.hpp"
#include "../../properties/checker/check.hpp"
#include "../../properties/domains/domains.hpp"
#include "../../properties/theorems/framework/local_ranks.hpp"
#include "../parallel/on_segment.hpp"
#include "../properties/checker/written_mesh.hpp"

namespace pardel {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> inputs(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.path().extension() == ".poly") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

std::string test_name(const ::testing::TestParamInfo<fs::path>& info) {
  std::string name = info.param.stem().string();
  std::replace_if(
      name.begin(), name.end(), [](char c) { return c == '-' || c == '.'; }, '_');
  return name;
}

class Regression : public ::testing::TestWithParam<fs::path> {
 protected:
  void mesh_and_certify(const Goal& goal) {
    SCOPED_TRACE(GetParam().filename().string() + " at " + std::to_string(goal.min_angle_deg) + " degrees");
    const Result<Pslg> pslg = read_pslg(GetParam());
    ASSERT_TRUE(pslg) << pslg.error().message;
    const Result<Meshed> meshed = mesh(*pslg, goal);
    ASSERT_TRUE(meshed) << meshed.error().message;
    EXPECT_TRUE(meshed->report.goal_met());
    const Certificate certificate = check(*pslg, meshed->mesh, goal);
    EXPECT_TRUE(certificate.valid) << to_text(certificate);
  }
};

TEST_P(Regression, is_meshed_and_certified_at_every_angle) {
  for (const double angle : {0.0, 20.7, 25.0, 30.0, 33.0}) mesh_and_certify({.min_angle_deg = angle});
}

TEST_P(Regression, is_meshed_and_certified_as_a_conforming_mesh) {
  mesh_and_certify({.min_angle_deg = 25, .conforming = true});
}

TEST_P(Regression, gets_no_point_from_a_goal_without_bounds) {
  const Result<Pslg> pslg = read_pslg(GetParam());
  ASSERT_TRUE(pslg) << pslg.error().message;
  const Result<Meshed> meshed = mesh(*pslg, {.min_angle_deg = 0});
  const Result<Meshed> triangulated = triangulate(*pslg);
  ASSERT_TRUE(meshed && triangulated);
  EXPECT_EQ(meshed->mesh, triangulated->mesh);
}

INSTANTIATE_TEST_SUITE_P(Files, Regression, ::testing::ValuesIn(inputs(PARDEL_REGRESSIONS)), test_name);

TEST(FeatureSizeRegression, point_almost_on_a_side_needs_few_triangles) {
  const Result<Pslg> pslg = read_pslg(fs::path(PARDEL_REGRESSIONS) / "point_almost_on_a_side.poly");
  ASSERT_TRUE(pslg) << pslg.error().message;
  const Goal goal{.min_angle_deg = 20.7, .feature_edges = 2};
  const Result<Meshed> meshed = mesh(*pslg, goal, {.max_vertices = 10'000});
  ASSERT_TRUE(meshed) << meshed.error().message;
  EXPECT_TRUE(meshed->report.goal_met());
  EXPECT_TRUE(check(*pslg, meshed->mesh, goal).valid);
}

Pslg domain_for_bounds(const std::string& name) {
  return std::move(read_pslg(fs::path(PARDEL_REGRESSIONS "/bounds") / (name + ".poly"))).value();
}

/// Computed coordinates below 2^-140 become 0, so a domain of this size has places for a few vertices only. The
/// refinement of the first file did not end, and the second one got vertices too far from their segment.
TEST(BoundsRegression, domains_near_the_smallest_coordinates_are_refined_as_far_as_possible) {
  for (const char* name : {"square_near_the_smallest_coordinates", "slanted_side_near_the_smallest_coordinates"}) {
    const Pslg pslg = domain_for_bounds(name);
    const Result<Meshed> meshed = mesh(pslg, {.max_edge = 1e-42}, {.max_vertices = 10'000});
    ASSERT_TRUE(meshed) << meshed.error().message;
    EXPECT_FALSE(meshed->report.goal_met());
    EXPECT_EQ(meshed->report.count(ExemptReason::min_edge), meshed->report.exempt.size()) << name;
    EXPECT_TRUE(check(pslg, meshed->mesh, {.min_angle_deg = 0}).valid) << name;
  }
}

TEST(BoundsRegression, vertex_almost_on_the_middle_of_a_side_leaves_no_triangle_too_large) {
  for (const char* name : {"vertex_almost_on_the_middle_of_a_side", "vertex_almost_on_the_middle_of_a_hull_side"}) {
    const Pslg pslg = domain_for_bounds(name);
    Goal goal{.min_angle_deg = 0};
    for (const double size : {0.5, 0.1, 0.01, 0.003}) {
      for (const bool by_area : {false, true}) {
        goal.max_area = by_area ? size * size : Goal{}.max_area;
        goal.max_edge = by_area ? Goal{}.max_edge : size;
        SCOPED_TRACE(std::string(name) + (by_area ? " by area " : " by length ") + std::to_string(size));
        const Result<Meshed> meshed = mesh(pslg, goal);
        ASSERT_TRUE(meshed) << meshed.error().message;
        EXPECT_TRUE(meshed->report.exempt.empty());
        EXPECT_TRUE(check(pslg, meshed->mesh, goal).valid);
      }
    }
  }
}

/// The sides of triangles were compared with the floor after their lengths had been rounded by the far corner: to 0.
TEST(BoundsRegression, near_points_in_a_huge_outline_are_refined_wherever_points_are_placed) {
  const Pslg pslg = domain_for_bounds("near_points_in_a_huge_outline");
  for (const Placement placement : {Placement::circumcentre, Placement::off_centre, Placement::search}) {
    const Goal goal{.min_angle_deg = 20};
    const Result<Meshed> meshed = mesh(pslg, goal, {.placement = placement});
    ASSERT_TRUE(meshed) << meshed.error().message;
    EXPECT_TRUE(meshed->report.exempt.empty());
    EXPECT_TRUE(check(pslg, meshed->mesh, goal).valid);
  }
}

/// The vertices of a side form slivers, because everything else is far away. They left no room for splits of the side.
TEST(BoundsRegression, slivers_along_a_side_in_a_huge_outline_do_not_keep_it_from_being_split) {
  for (const char* name : {"capped_triangle_in_a_huge_outline", "zigzag_along_a_side_in_a_huge_outline"}) {
    const Pslg pslg = domain_for_bounds(name);
    for (const bool conforming : {false, true}) {
      const Goal goal{.min_angle_deg = 0, .region_caps = true, .conforming = conforming};
      const Result<Meshed> meshed = mesh(pslg, goal);
      ASSERT_TRUE(meshed) << meshed.error().message;
      EXPECT_TRUE(meshed->report.exempt.empty()) << name;
      EXPECT_TRUE(check(pslg, meshed->mesh, goal).valid) << name;
    }
  }
}

/// Vertices of a mesh already lie off the sides of the notch. Those of its refinement lie off the pieces between them,
/// so that the sides crossed.
TEST(BoundsRegression, sides_of_a_notch_do_not_cross_when_a_mesh_with_vertices_on_them_is_refined) {
  const Pslg pslg = domain_for_bounds("notch_as_narrow_as_rounding");
  for (const double first : {0.4, 0.5})
    for (const double second : {0.25, 0.2, 0.1}) {
      const Result<Meshed> coarse = mesh(pslg, {.min_angle_deg = 0, .max_edge = first});
      ASSERT_TRUE(coarse) << coarse.error().message;
      const Result<Meshed> refined = refine(coarse->mesh, {}, {.min_angle_deg = 0, .max_edge = second});
      ASSERT_TRUE(refined) << refined.error().message;
      EXPECT_TRUE(check(pslg, refined->mesh, {.min_angle_deg = 0}).valid) << first << ", then " << second;
    }
}

/// Of a thin triangle, an angle beside the shortest side was taken for an obtuse one, and needed no cause.
TEST(BoundsRegression, the_report_and_the_checker_justify_the_same_angles_beside_a_side_of_the_hull) {
  const Pslg pslg = domain_for_bounds("hull_side_beside_a_nearly_straight_chain");
  const Goal goal{.min_angle_deg = 10, .convex_hull = true};
  const Result<Meshed> meshed = mesh(pslg, goal);
  ASSERT_TRUE(meshed) << meshed.error().message;
  std::set<Index> reported, found;
  for (const Exemption& e : meshed->report.exempt)
    if (justified(e.reason)) reported.insert(e.triangle);
  const Certificate certificate = check(pslg, meshed->mesh, goal);
  for (const Justified& j : certificate.justified) found.insert(j.triangle);
  EXPECT_EQ(reported, found);
}

/// The circumcentre of a thin triangle was computed from an area that rounding had made 0, and was not finite.
TEST(BoundsRegression, circumcentres_of_thin_triangles_are_placed_in_the_cells_of_the_paper) {
  const Pslg pslg = domain_for_bounds("thin_triangles_in_cells_of_the_paper");
  const Goal goal{.min_angle_deg = 20.7, .conforming = true};
  const Result<Meshed> meshed =
      mesh(pslg, goal, {.placement = Placement::circumcentre, .decomposition = Decomposition::paper});
  ASSERT_TRUE(meshed) << meshed.error().message;
  EXPECT_TRUE(meshed->report.goal_met());
  EXPECT_TRUE(check(pslg, meshed->mesh, goal).valid);
}

/// On most of the slanted side, x is too small for the predicates. Vertices there were moved to x = 0, which is far
/// beside the side for coordinates of this size.
TEST(BoundsRegression, a_side_with_a_tiny_slope_has_its_vertices_on_it) {
  Pslg pslg = domain_for_bounds("slanted_side_near_the_smallest_coordinates");
  for (Point& p : pslg.points) p = {p.x == 1e-42 ? p.x : p.x * 1e11, p.y * 1e11};
  const Result<Meshed> meshed = mesh(pslg, {.max_edge = 1e-31});
  ASSERT_TRUE(meshed) << meshed.error().message;
  const Mesh& m = meshed->mesh;
  for (std::size_t v = 0; v < m.points.size(); ++v)
    if (m.origin[v] == origin_on_segment(0)) {
      EXPECT_GE(m.points[v].x, 0x1p-140);
      EXPECT_TRUE(engine::samples::is_on_line(m.points[v], pslg.points[0], pslg.points[1]));
    }
  EXPECT_GT(std::ranges::count(m.origin, origin_on_segment(0)), 0);
  EXPECT_GT(meshed->report.exempt.size(), 0U);
  EXPECT_EQ(meshed->report.count(ExemptReason::min_edge), meshed->report.exempt.size());
  EXPECT_TRUE(check(pslg, m, {.min_angle_deg = 0}).valid);
}

TEST(FeatureSizeRegression, widths_below_the_rounding_of_coordinates_take_no_time) {
  const Pslg pslg = domain_for_bounds("widths_below_the_rounding_of_coordinates");
  const Goal goal{.min_angle_deg = 25, .grading = 0.2, .feature_edges = 1};
  const Result<Meshed> meshed = mesh(pslg, goal, {.max_vertices = 1'000});
  ASSERT_TRUE(meshed) << meshed.error().message;
  EXPECT_TRUE(check(pslg, meshed->mesh, {.min_angle_deg = 0}).valid);
}

TEST(FloorRegression, edges_from_a_patch_to_an_isolated_point_keep_the_floor) {
  const Pslg pslg = domain_for_bounds("isolated_point_beside_a_patch");
  const Goal goal{.min_angle_deg = 10, .max_area = 2.8131868131868134};
  const Options options{.interior = Interior::fill, .min_edge = 2};
  const Result<Meshed> meshed = mesh(pslg, goal, options);
  ASSERT_TRUE(meshed) << meshed.error().message;
  for (const Triangle& triangle : meshed->mesh.triangles)
    for (int k = 0; k < 3; ++k) {
      const Index a = triangle.v[k], b = triangle.v[(k + 1) % 3];
      if (std::max(a, b) < pslg.points.size()) continue;
      const Point p = meshed->mesh.points[a], q = meshed->mesh.points[b];
      EXPECT_GE(std::hypot(q.x - p.x, q.y - p.y), options.min_edge) << a << " to " << b;
    }
}

TEST(LimitRegression, a_limit_on_vertices_limits_the_cells_of_the_lattice) {
  const Options options{.decomposition = Decomposition::lattice, .triangles_per_tile = 4, .max_vertices = 60};
  const Result<Meshed> meshed = mesh(domains::square(), {.max_area = 1e-9}, options);
  ASSERT_TRUE(meshed) << meshed.error().message;
  EXPECT_EQ(meshed->mesh.points.size(), 60U);
  EXPECT_LE(meshed->report.tiling.columns * meshed->report.tiling.rows, 150U);
}

TEST(ReasonRegression, the_smallest_angle_of_a_flat_triangle_is_found_exactly) {
  const Pslg pslg = domain_for_bounds("flat_triangle_with_two_sides_of_nearly_one_length");
  const Goal goal{.min_angle_deg = 33, .conforming = true};
  const Result<Meshed> meshed = mesh(pslg, goal, {.max_vertices = 313, .min_edge = 0.125});
  ASSERT_TRUE(meshed) << meshed.error().message;
  ASSERT_FALSE(meshed->report.exempt.empty());
  const Certificate certificate = check(pslg, meshed->mesh, goal);
  for (const Exemption& e : meshed->report.exempt)
    EXPECT_TRUE(!justified(e.reason) || std::ranges::count(certificate.justified, e.triangle, &Justified::triangle) > 0)
        << name(e.reason) << " triangle " << e.triangle;
}

TEST(ReasonRegression, a_blocked_triangle_is_tried_again_after_a_vertex_has_come_between) {
  const Pslg pslg = domain_for_bounds("vertex_between_a_blocked_triangle_and_a_side");
  const Goal goal{.min_angle_deg = 0, .max_area = 28, .feature_edges = 1, .conforming = true};
  const Result<Meshed> meshed = mesh(pslg, goal, {.no_boundary_splits = true});
  ASSERT_TRUE(meshed) << meshed.error().message;
  ASSERT_FALSE(meshed->report.exempt.empty());
  EXPECT_EQ(meshed->report.count(ExemptReason::kept_segment), meshed->report.exempt.size());
}

TEST(RanksRegression, a_triangle_beside_a_segment_between_ranks_counts_as_in_one_process) {
  const Pslg pslg = domain_for_bounds("triangle_beside_a_segment_between_ranks");
  const Goal goal{.min_angle_deg = 0, .region_caps = true, .conforming = true};
  const Options options{.threads = 1, .cells = {20, 3}, .min_edge = 0.004};
  const Result<Meshed> whole = mesh(pslg, goal, options);
  ASSERT_TRUE(whole) << whole.error().message;
  const ValidPslg domain = std::move(validate(pslg)).value();
  for (const int count : {2, 3, 6})
    properties::on_ranks(count, [&](Ranks& ranks) {
      const Result<MeshPiece> piece = mesh(domain, goal, options, ranks);
      ASSERT_TRUE(piece) << piece.error().message;
      EXPECT_EQ(piece->missed, whole->report.exempt.size()) << count << " ranks";
    });
}

Mesh mesh_of(const std::string& name) {
  return std::move(read_mesh(fs::path(PARDEL_REGRESSIONS "/meshes") / (name + ".off"))).value();
}

/// The triangles are neighbours in the order of the file, so they are one fan, which begins and ends at the edge.
TEST(CheckerRegression, an_edge_with_two_triangles_on_one_side_is_not_manifold_if_a_fan_turns_round_it) {
  Mesh mesh = mesh_of("fan_that_turns_by_more_than_360_degrees");
  for (Index t = 0; t < 4; ++t) mesh.triangles[t].n = {no_index, t == 3 ? no_index : t + 1, t == 0 ? no_index : t - 1};
  Pslg pslg;
  for (const Point p : mesh.points) pslg.points.push_back(p);
  pslg.segments = {{1, 2, 0}, {2, 3, 0}, {3, 1, 0}};
  const Certificate certificate = check(pslg, mesh, {.min_angle_deg = 0});
  EXPECT_GT(std::ranges::count(certificate.violations, ViolationKind::non_manifold_edge, &Violation::kind), 0)
      << to_text(certificate);
}

/// A mesh that `pardel check` called valid, the smallest angle that was asked for, and what is wrong with it.
struct WrongFile {
  const char* name;
  double min_angle_deg;
  ViolationKind kind;
};

class WrongMeshRegression : public ::testing::TestWithParam<WrongFile> {};

/// The product of the coordinates with a power of two is exact. `swapped`: mirrors the domain at the diagonal.
Point placed(Point p, int exponent, bool swapped) {
  const Point q{std::ldexp(p.x, exponent), std::ldexp(p.y, exponent)};
  return swapped ? Point{q.y, -q.x} : q;
}

TEST_P(WrongMeshRegression, is_refused_at_every_scale) {
  const auto [name, angle, kind] = GetParam();
  const fs::path file = fs::path(PARDEL_REGRESSIONS "/wrong_meshes") / name;
  const Result<Pslg> read = read_pslg(fs::path(file).concat(".poly"));
  const Result<Mesh> as_read = read_mesh(fs::path(file).concat(".ele"));
  ASSERT_TRUE(read) << read.error().message;
  ASSERT_TRUE(as_read) << as_read.error().message;
  for (const int exponent : {0, -110, -60, 17, 50, 120})
    for (const bool swapped : {false, true}) {
      SCOPED_TRACE(exponent);
      Pslg pslg = *read;
      Mesh mesh = *as_read;
      const auto place = [&](Point& p) { p = placed(p, exponent, swapped); };
      for (Point& p : pslg.points) place(p);
      for (Point& p : pslg.holes) place(p);
      for (Region& region : pslg.regions) place(region.seed);
      for (Point& p : mesh.points) place(p);
      const Certificate certificate = check(pslg, mesh, {.min_angle_deg = angle}, {.foreign = true});
      const auto found = std::ranges::find(certificate.violations, kind, &Violation::kind);
      ASSERT_NE(found, certificate.violations.end()) << to_text(certificate);
      EXPECT_FALSE(found->ids.empty());
      EXPECT_FALSE(found->where.empty());
    }
}

std::string name_of_file(const ::testing::TestParamInfo<WrongFile>& info) {
  return std::string(info.param.name) + (info.param.min_angle_deg == 33 ? "_at_33_degrees" : "");
}

INSTANTIATE_TEST_SUITE_P(
    Files, WrongMeshRegression,
    ::testing::Values(WrongFile{"saw_instead_of_a_square", 20.7, ViolationKind::chain_off_segment},
                      WrongFile{"three_quarters_of_a_hole_filled", 20.7, ViolationKind::chain_off_segment},
                      WrongFile{"piece_of_a_square_missing", 20.7, ViolationKind::chain_off_segment},
                      WrongFile{"ends_of_spokes_at_equal_distances", 20.7, ViolationKind::small_angle},
                      WrongFile{"ends_of_spokes_at_equal_distances", 33, ViolationKind::small_angle},
                      WrongFile{"tiny_angle_across_a_shell", 20.7, ViolationKind::small_angle},
                      WrongFile{"tiny_angle_across_a_shell", 33, ViolationKind::small_angle},
                      WrongFile{"chains_of_two_segments_share_an_edge", 0, ViolationKind::chains_meet},
                      WrongFile{"region_in_a_face_without_a_seed", 0, ViolationKind::wrong_region},
                      WrongFile{"attribute_of_an_inserted_vertex", 20.7, ViolationKind::wrong_attribute}),
    name_of_file);

/// UndefinedBehaviorSanitizer reported it.
TEST(WriterRegression, a_mesh_without_vertices_is_written_in_every_format) {
  const Mesh mesh = mesh_of("no_vertices");
  for (const testing::WrittenAs& format : testing::formats_with_constrained_edges()) {
    const TemporaryFolder folder;
    const Status written = write_mesh(mesh, {}, folder / format.file, format.msh);
    ASSERT_TRUE(written) << written.error().message;
    const Result<Mesh> read = read_mesh(folder / format.file);
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_EQ(*read, mesh) << format.file;
  }
}

class RepairRegression : public ::testing::TestWithParam<fs::path> {};

TEST_P(RepairRegression, is_repaired_up_to_rounding) {
  const Result<Pslg> pslg = read_pslg(GetParam());
  ASSERT_TRUE(pslg) << pslg.error().message;
  EXPECT_FALSE(find_problems(*pslg).empty());
  const Result<Repaired> repaired = repair(*pslg, {.snap = 0});
  ASSERT_TRUE(repaired) << repaired.error().message;
  EXPECT_TRUE(find_problems(repaired->domain.pslg()).empty());
  for (std::size_t i = 0; i < repaired->segment_map.size(); ++i) {
    const Segment& old = pslg->segments[repaired->segment_map[i]];
    const Point a = pslg->points[old.a], b = pslg->points[old.b];
    for (const Index v : {repaired->domain.pslg().segments[i].a, repaired->domain.pslg().segments[i].b}) {
      const Point p = repaired->domain.pslg().points[v];
      const double twice_area = (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
      EXPECT_LE(std::abs(twice_area) / std::hypot(b.x - a.x, b.y - a.y), 1e-14);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Files, RepairRegression, ::testing::ValuesIn(inputs(PARDEL_REGRESSIONS "/repair")), test_name);

class WrittenRegression : public ::testing::TestWithParam<fs::path> {};

TEST_P(WrittenRegression, has_the_same_verdict_in_memory_and_in_every_format) {
  const Result<Pslg> pslg = read_pslg(GetParam());
  ASSERT_TRUE(pslg) << pslg.error().message;
  for (const double angle : {5.0, 20.7}) {
    const Goal goal{.min_angle_deg = angle};
    Options options;
    options.max_vertices = 400;
    const Result<Meshed> meshed = mesh(*pslg, goal);
    ASSERT_TRUE(meshed) << meshed.error().message;
    const Certificate certificate = check(*pslg, meshed->mesh, goal);
    for (const testing::WrittenAs& format : testing::formats_with_constrained_edges())
      EXPECT_EQ(testing::verdict_on_file(*pslg, meshed->mesh, goal, format), testing::verdict(certificate))
          << format.file;
  }
}

INSTANTIATE_TEST_SUITE_P(Files, WrittenRegression, ::testing::ValuesIn(inputs(PARDEL_REGRESSIONS "/written")),
                         test_name);

class RefinedRegression : public ::testing::TestWithParam<fs::path> {};

/// The mesh, written and read again, and refined; with the verdict of the checker on it.
Mesh refined_from_file(const Pslg& pslg, const Mesh& mesh, const Goal& goal, testing::WrittenAs format) {
  const TemporaryFolder folder;
  EXPECT_TRUE(write_mesh(mesh, pslg, folder / format.file, format.msh));
  const Result<Mesh> read = read_mesh(folder / format.file);
  EXPECT_TRUE(read && digest(*read) == digest(mesh));
  Result<Meshed> refined = refine(*read, {}, goal);
  EXPECT_TRUE(refined && refined->report.goal_met());
  refined->mesh.origin.clear();
  EXPECT_TRUE(check(pslg, refined->mesh, goal, {.foreign = true}).valid);
  return std::move(refined->mesh);
}

TEST_P(RefinedRegression, does_not_change_if_its_mesh_meets_the_goal) {
  const Result<Pslg> pslg = read_pslg(GetParam());
  ASSERT_TRUE(pslg) << pslg.error().message;
  const Goal goals[] = {{.min_angle_deg = 30},
                        {.min_angle_deg = 20, .conforming = true},
                        {.min_angle_deg = 25, .max_area = 0.1},
                        {.min_angle_deg = 33, .max_edge = 0.2}};
  for (const testing::WrittenAs& format : testing::formats_with_constrained_edges()) {
    Mesh mesh = std::move(pardel::mesh(*pslg, goals[0]).value().mesh);
    for (const Goal& goal : goals) {
      SCOPED_TRACE(std::string(format.file) + " at " + std::to_string(goal.min_angle_deg));
      const Mesh own = std::move(pardel::mesh(*pslg, goal).value().mesh);
      EXPECT_EQ(digest(refined_from_file(*pslg, own, goal, format)), digest(own));
      mesh = refined_from_file(*pslg, mesh, goal, format);
      EXPECT_EQ(digest(refined_from_file(*pslg, mesh, goal, format)), digest(mesh));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Files, RefinedRegression, ::testing::ValuesIn(inputs(PARDEL_REGRESSIONS "/refined")),
                         test_name);

}  // namespace
}  // namespace pardel
