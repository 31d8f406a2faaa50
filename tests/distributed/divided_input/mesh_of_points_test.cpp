// Several ranks make the mesh of points that none of them has as a whole.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "../../../parallel/mesher.hpp"
#include "../../../properties/domains/domains.hpp"
#include "../../../properties/theorems/framework/local_ranks.hpp"
#include "../../../properties/theorems/framework/segments_in_pieces.hpp"
#include "../../parallel/samples.hpp"
#include "../delaunay/part_of_rank.hpp"
#include "../meshing/whole_of_pieces.hpp"

namespace pardel {
namespace {

using properties::on_ranks;

std::vector<MeshPiece> meshed_pieces(const Pslg& pslg, const Goal& goal, const Options& options, int count) {
  std::vector<MeshPiece> pieces(static_cast<std::size_t>(count));
  on_ranks(count, [&](Ranks& ranks) {
    Result<MeshPiece> piece = mesh(part_of_domain_of(pslg, ranks), goal, options, ranks);
    ASSERT_TRUE(piece) << count << " ranks, rank " << ranks.rank() << ": " << piece.error().message;
    pieces[ranks.rank()] = std::move(*piece);
  });
  return pieces;
}

/// The pieces are those of the mesh of one process, and have the numbers that ranks give that know the whole domain.
void expect_the_mesh_of_one_process(const Pslg& pslg, const Goal& goal, Options options, const std::string& name) {
  SCOPED_TRACE(name);
  options.threads = 1;
  const Result<Meshed> whole = mesh(pslg, goal, options);
  ASSERT_TRUE(whole) << whole.error().message;
  const auto expected = unnumbered(whole->mesh);
  const ValidPslg domain = std::move(validate(pslg)).value();
  std::vector<MeshPiece> known(2);
  on_ranks(2, [&](Ranks& ranks) {
    Result<MeshPiece> piece = mesh(domain, goal, options, ranks);
    ASSERT_TRUE(piece);
    known[ranks.rank()] = std::move(*piece);
  });
  const std::uint64_t missed = known[0].missed;
  const Mesh numbered = joined(known);
  for (const int count : {1, 2, 3, 5, 8}) {
    std::vector<MeshPiece> pieces = meshed_pieces(pslg, goal, options, count);
    expect_shared_vertices(pieces);
    for (const MeshPiece& piece : pieces) {
      expect_neighbours(piece);
      EXPECT_EQ(piece.points, whole->mesh.points.size());
      EXPECT_EQ(piece.triangles, whole->mesh.triangles.size());
      EXPECT_EQ(piece.constrained_edges, whole->mesh.constrained_edges.size());
      EXPECT_EQ(piece.report.inserted, whole->report.inserted);
      EXPECT_EQ(piece.report.segment_splits, whole->report.segment_splits);
      EXPECT_EQ(piece.missed, missed);
    }
    const Mesh joint = joined(pieces);
    EXPECT_TRUE(std::ranges::equal(joint.points, numbered.points)) << count << " ranks";
    EXPECT_TRUE(unnumbered(joint) == expected) << count << " ranks";
  }
}

TEST(MeshOfPoints, is_the_mesh_of_one_process) {
  const Pslg points = domains::random_points(3'000, 3);
  expect_the_mesh_of_one_process(points, {.min_angle_deg = 28}, {.triangles_per_tile = 100}, "angles");
  expect_the_mesh_of_one_process(points, {.min_angle_deg = 20}, {}, "few tiles");
  expect_the_mesh_of_one_process(points, {.max_area = 1e-5}, {.triangles_per_tile = 300}, "areas");
  expect_the_mesh_of_one_process(points, {.min_angle_deg = 25, .max_edge = 0.02}, {.cells = {7, 5}}, "edges");
  expect_the_mesh_of_one_process(points, {.min_angle_deg = 30}, {.decomposition = Decomposition::none}, "one tile");
}

TEST(MeshOfPoints, in_difficult_positions_is_the_mesh_of_one_process) {
  for (const engine::samples::Family& family : engine::samples::families(400, 5))
    expect_the_mesh_of_one_process(with_points(family.points), {.min_angle_deg = 25},
                                   {.triangles_per_tile = 50, .min_edge = 0}, family.name);
}

/// The first rank needs more triangles than the first submesh has.
TEST(MeshOfPoints, close_to_a_line_is_the_mesh_of_one_process) {
  expect_the_mesh_of_one_process(domains::line_points(10'000, 1), {.min_angle_deg = 30}, {}, "line");
}

/// Two squares, one of them 2^40 times as large as the other, and a point far away from both.
TEST(MeshOfPoints, of_very_different_sizes_is_the_mesh_of_one_process) {
  Pslg pslg = domains::square();
  const Pslg large = domains::moved(domains::square(), 0x1p41, 0x1p39, 0x1p40);
  for (const Segment& s : large.segments) pslg.segments.push_back({s.a + 4, s.b + 4});
  pslg.points.insert(pslg.points.end(), large.points.begin(), large.points.end());
  pslg.points.insert(pslg.points.end(), {{0.5, 0x1p-10}, {0x1p41 + 0x1p30, 0x1p40}, {0x1p90, 3}});
  expect_the_mesh_of_one_process(pslg, {.min_angle_deg = 30}, {}, "squares");
  expect_the_mesh_of_one_process(pslg, {.min_angle_deg = 25}, {.triangles_per_tile = 20}, "squares in tiles");
}

/// Adds points at random places in and around the domain.
Pslg with_loose_points(Pslg pslg, std::size_t count) {
  const auto [low_x, high_x] = std::ranges::minmax(pslg.points, {}, &Point::x);
  const auto [low_y, high_y] = std::ranges::minmax(pslg.points, {}, &Point::y);
  const Pslg loose = domains::random_points(count, 11);  // in the unit square
  const double width = high_x.x - low_x.x, height = high_y.y - low_y.y;
  for (const Point p : loose.points)
    pslg.points.push_back({low_x.x + width * (1.2 * p.x - 0.1), low_y.y + height * (1.2 * p.y - 0.1)});
  if (!pslg.point_markers.empty()) pslg.point_markers.resize(pslg.points.size(), 0);
  return pslg;
}

struct NamedDomain {
  const char* name;
  Pslg pslg;
};

std::vector<NamedDomain> domains_with_segments() {
  return {
      {"square", domains::square()},   {"pipe", domains::pipe()},       {"key", domains::key()},
      {"star", domains::star(5, 20)},  {"comb", domains::comb(4, 0.1)}, {"wedge", domains::wedge(5, 10)},
      {"grid", domains::grid(5)},      {"cracks", domains::cracks()},   {"touching holes", domains::touching_holes()},
      {"regions", domains::regions()}, {"radial", domains::radial(2)}};
}

/// The first four points along the curve are on a line. So a later point is inserted as the third one.
TEST(MeshOfPoints, whose_first_points_are_on_a_line_is_the_mesh_of_one_process) {
  Pslg pslg = with_points({{5, 1},
                           {96, 48},
                           {30, 96},
                           {72, 96},
                           {51, 96},
                           {51, 0},
                           {4, 2},
                           {96, 24},
                           {6, 0},
                           {13, 5},
                           {3, 3},
                           {28, 0},
                           {73, 0},
                           {-2.8125, 12},
                           {-2.8125, 18},
                           {-2.8125, 24},
                           {14.625, -24}});
  pslg.segments = {{1, 7}, {7, 12}, {11, 8}, {3, 4},  {2, 10}, {1, 3},
                   {8, 0}, {12, 5}, {5, 11}, {10, 6}, {4, 2},  {0, 6}};
  expect_the_mesh_of_one_process(pslg, {}, {.triangles_per_tile = 4}, "lattice points");
}

TEST(MeshOfPoints, with_segments_is_the_mesh_of_one_process) {
  for (const NamedDomain& domain : domains_with_segments()) {
    expect_the_mesh_of_one_process(domain.pslg, {.min_angle_deg = 25}, {}, domain.name);
    expect_the_mesh_of_one_process(with_loose_points(domain.pslg, 500), {.min_angle_deg = 25},
                                   {.triangles_per_tile = 50}, domain.name);
    expect_the_mesh_of_one_process(with_loose_points(domain.pslg, 300), {.min_angle_deg = 20, .convex_hull = true},
                                   {.triangles_per_tile = 100}, domain.name);
    expect_the_mesh_of_one_process(with_loose_points(domain.pslg, 200),
                                   {.min_angle_deg = 20, .region_caps = true, .conforming = true},
                                   {.triangles_per_tile = 40}, domain.name);
  }
}

/// Adds attributes that are not linear, so that each vertex shows in which triangle it was located.
Pslg with_attributes(Pslg pslg, std::size_t per_point) {
  pslg.attributes_per_point = per_point;
  for (const Point p : pslg.points)
    for (std::size_t a = 0; a < per_point; ++a)
      pslg.point_attributes.push_back(std::sin(static_cast<double>(a + 3) * p.x) * std::cos(7 * p.y));
  return pslg;
}

TEST(MeshOfPoints, dense_on_segments_is_the_mesh_of_one_process) {
  for (const NamedDomain& domain : domains_with_segments()) {
    const Pslg dense = properties::with_segments_in_pieces(domain.pslg, 24);
    ASSERT_TRUE(find_problems(dense).empty()) << domain.name;
    expect_the_mesh_of_one_process(dense, {.min_angle_deg = 28}, {.triangles_per_tile = 60}, domain.name);
    expect_the_mesh_of_one_process(with_loose_points(dense, 100), {.min_angle_deg = 25, .conforming = true},
                                   {.triangles_per_tile = 40}, domain.name);
    expect_the_mesh_of_one_process(with_attributes(dense, 1), {.min_angle_deg = 25, .convex_hull = true},
                                   {.decomposition = Decomposition::none}, domain.name);
  }
}

/// Spokes of three lengths in a box. Where a spoke passes the end of a shorter one at a small distance, it is split.
Pslg spokes(double degrees_apart) {
  Pslg pslg;
  pslg.points = {{0, 0}, {-4, -4}, {4, -4}, {4, 4}, {-4, 4}};
  pslg.segments = {{1, 2}, {2, 3}, {3, 4}, {4, 1}};
  for (int i = 0; i < 24; ++i) {
    const double angle = i * degrees_apart * std::numbers::pi / 180, length = 1 + i % 3;
    pslg.segments.push_back({0, static_cast<Index>(pslg.points.size())});
    pslg.points.push_back({length * std::cos(angle), length * std::sin(angle)});
  }
  return pslg;
}

TEST(MeshOfPoints, with_spokes_of_three_lengths_is_the_mesh_of_one_process) {
  for (const double degrees_apart : {4.0, 0.5}) {
    const Pslg pslg = spokes(degrees_apart);
    expect_the_mesh_of_one_process(pslg, {.min_angle_deg = 25}, {}, "few triangles");
    expect_the_mesh_of_one_process(with_loose_points(pslg, 300), {.min_angle_deg = 25, .max_area = 0.01},
                                   {.triangles_per_tile = 50}, "many triangles");
  }
}

TEST(MeshOfPoints, on_a_coast_is_the_mesh_of_one_process) {
  expect_the_mesh_of_one_process(domains::coast(2'000, 1), {.min_angle_deg = 28}, {.triangles_per_tile = 100},
                                 "angles");
  expect_the_mesh_of_one_process(domains::coast(2'000, 2), {.max_area = 1e-4}, {}, "areas");
  expect_the_mesh_of_one_process(domains::coast(200, 4), {.max_area = 1e-4}, {}, "segments that are split often");
  expect_the_mesh_of_one_process(with_loose_points(domains::coast(1'000, 3), 500),
                                 {.min_angle_deg = 30, .conforming = true}, {.triangles_per_tile = 50}, "conforming");
}

TEST(MeshOfPoints, has_the_attributes_of_the_mesh_of_one_process) {
  expect_the_mesh_of_one_process(with_attributes(domains::random_points(1'000, 4), 1), {.min_angle_deg = 28},
                                 {.triangles_per_tile = 100}, "random points");
  for (const engine::samples::Family& family : engine::samples::families(150, 6))
    expect_the_mesh_of_one_process(with_attributes(with_points(family.points), 2), {.min_angle_deg = 25},
                                   {.triangles_per_tile = 50, .min_edge = 0}, family.name);
  for (const NamedDomain& domain : domains_with_segments()) {
    const Pslg pslg = with_attributes(with_loose_points(domain.pslg, 150), 1);
    expect_the_mesh_of_one_process(pslg, {.min_angle_deg = 25}, {.triangles_per_tile = 50}, domain.name);
    expect_the_mesh_of_one_process(pslg, {.max_area = 1e-3}, {.placement = Placement::circumcentre}, domain.name);
  }
}

/// The message of mesh(), the same on all ranks.
std::string failure(const Pslg& pslg, const Goal& goal = {}, const Options& options = {}) {
  std::vector<std::string> messages(3);
  on_ranks(3, [&](Ranks& ranks) {
    const Result<MeshPiece> piece = mesh(part_of_domain_of(pslg, ranks), goal, options, ranks);
    messages[ranks.rank()] = piece ? "none" : piece.error().message;
  });
  EXPECT_EQ(messages[1], messages[0]);
  EXPECT_EQ(messages[2], messages[0]);
  return messages[0];
}

TEST(MeshOfPoints, with_invalid_segments_has_an_error_on_all_ranks) {
  const Pslg valid = with_loose_points(domains::regions(), 300);
  const auto changed = [&](const auto& change) {
    Pslg pslg = valid;
    change(pslg);
    return failure(pslg);
  };
  EXPECT_EQ(failure(valid), "none");
  EXPECT_EQ(changed([](Pslg& p) {
              p.segments.push_back({2, 1'000, 0});
            }),
            "Segment 11 names a point that does not exist.");
  EXPECT_EQ(changed([](Pslg& p) { p.segments.push_back(p.segments[3]); }),
            "Segments 3 and 11, from (3, 0), have the same ends.");
  EXPECT_EQ(changed([](Pslg& p) {
              p.holes.push_back({3.2, 0.5});
            }),
            "Hole 0 at (3.2, 0.5) lies outside every closed outline.");
  EXPECT_EQ(changed([](Pslg& p) {
              p.regions.clear();
              p.segments = {{0, 1, 0}, {20, 40, 0}};
            }).substr(0, 24),
            "No outline is closed: th");
  EXPECT_EQ(changed([](Pslg& p) {
              p.regions.clear();
              for (const Region& region : domains::regions().regions) p.holes.push_back(region.seed);
            }).substr(0, 24),
            "Nothing is left to mesh:");
  EXPECT_EQ(changed([](Pslg& p) {
              p.segments.push_back({11, 200, 0});
              p.segments.push_back({50, 250, 0});
              p.segments.push_back({120, 280, 0});
            }).substr(0, 9),
            "Segments ");
  EXPECT_EQ(changed([](Pslg& p) {
              p.regions[1].seed = {0.25, 0.25};
            }),
            "Regions 0 and 1 lie in one face, the second at (0.25, 0.25).");
  EXPECT_EQ(changed([](Pslg& p) {
              p.points[100] = {0.5, 0};
            }),
            "Point 100 at (0.5, 0) lies in the interior of segment 0.");
  EXPECT_EQ(failure(valid, {.grading = 0.5}).substr(0, 36), "points that are divided among ranks ");
  on_ranks(2, [&](Ranks& ranks) {
    EXPECT_EQ(mesh({part_of(valid, ranks), {}, valid}, {}, {}, ranks).error().kind, ErrorKind::usage);
  });
}

}  // namespace
}  // namespace pardel
