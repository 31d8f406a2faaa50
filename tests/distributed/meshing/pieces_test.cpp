// Several ranks make the mesh that one process makes, and no rank holds all of it.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "../../../distributed/distributed.hpp"
#include "../../../parallel/mesher.hpp"
#include "../../../properties/checker/check.hpp"
#include "../../../properties/domains/domains.hpp"
#include "../../../properties/theorems/framework/local_ranks.hpp"
#include "square_with_data.hpp"
#include "whole_of_pieces.hpp"

namespace pardel {
namespace {

using properties::on_ranks;

struct Case {
  std::string name;
  Pslg pslg;
  Goal goal;
  Options options;
};

/// Two triangles that touch at a corner.
Pslg touching_triangles() {
  Pslg pslg;
  pslg.points = {{0, 0}, {-1, 1}, {-1, -1}, {1, -1}, {1, 1}};
  pslg.segments = {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {3, 4}, {4, 0}};
  return pslg;
}

/// A domain in which, if its boundary may not be split, a triangle is blocked until a vertex comes in between.
Pslg square_with_a_crack() {
  Pslg pslg = domains::moved(domains::square(), 0, 0, 32);
  pslg.points.insert(pslg.points.end(), {{9, 4}, {18, 4}, {10, 10}, {9, 24}, {6, 12}});
  pslg.segments.push_back({4, 5});
  return pslg;
}

const std::vector<Case>& cases() {
  static const std::vector<Case> all = [] {
    std::vector<Case> list;
    const auto add = [&](std::string name, Pslg pslg, Goal goal, Options options = {}) {
      options.threads = 1;
      list.push_back({std::move(name), std::move(pslg), std::move(goal), std::move(options)});
    };
    add("square", domains::square(), {.max_area = 1e-4}, {.cells = {5, 5}});
    add("square_in_strips", domains::square(), {.max_area = 1e-4}, {.cells = {1, 9}});
    add("pipe", domains::pipe(), {.max_area = 1e-3}, {.cells = {7, 8}});
    add("pipe_of_30_degrees", domains::pipe(), {.min_angle_deg = 30, .max_area = 1e-3}, {.cells = {4, 4}});
    add("points", domains::random_points(3000, 3), {.min_angle_deg = 28}, {.triangles_per_tile = 100});
    add("cracks", domains::cracks(), {.min_angle_deg = 30, .max_area = 0.0005, .conforming = true}, {.cells = {6, 6}});
    add("wedge", domains::wedge(12, 7), {.min_angle_deg = 28, .max_area = 0.0005}, {.cells = {6, 8}});
    add("key", domains::key(), {.max_area = 0.02}, {.triangles_per_tile = 50});
    add("regions_with_data", square_with_data(), {.max_area = 0.001}, {.cells = {6, 6}});
    add("touching_triangles", touching_triangles(), {.max_area = 0.002}, {.cells = {6, 6}});
    add("one_tile", domains::square(), {.max_area = 0.01}, {.decomposition = Decomposition::none});
    add("graded", domains::square(), {.size = [](Point p) { return 0.004 + 0.1 * (p.x + p.y); }, .size_slope = 0.15},
        {.decomposition = Decomposition::quadtree, .triangles_per_tile = 100});
    add("filled_square", domains::square(), {.max_area = 1e-4}, {.interior = Interior::fill});
    add("filled_pipe", domains::pipe(), {.min_angle_deg = 28, .max_area = 5e-4}, {.interior = Interior::fill});
    add("filled_regions_with_data", square_with_data(), {.max_area = 0.001, .region_caps = true},
        {.interior = Interior::fill});
    add("kept_boundary", square_with_a_crack(), {.min_angle_deg = 25, .max_area = 2},
        {.cells = {4, 4}, .no_boundary_splits = true});
    add("papers_lattice", domains::pipe(), {.max_area = 1e-3}, {.decomposition = Decomposition::paper});
    return list;
  }();
  return all;
}

/// The pieces of all ranks. A rank with an error makes the test fail.
std::vector<MeshPiece> pieces_of(const Case& c, int count) {
  const ValidPslg domain = std::move(validate(c.pslg)).value();
  std::vector<MeshPiece> pieces(count);
  on_ranks(count, [&](Ranks& ranks) {
    Result<MeshPiece> piece = mesh(domain, c.goal, c.options, ranks);
    ASSERT_TRUE(piece) << c.name << ", rank " << ranks.rank() << ": " << piece.error().message;
    pieces[ranks.rank()] = std::move(*piece);
  });
  return pieces;
}

class Pieces : public testing::TestWithParam<std::size_t> {
 protected:
  const Case& case_ = cases()[GetParam()];
};

TEST_P(Pieces, are_together_the_mesh_of_one_process) {
  const Result<Meshed> whole = mesh(case_.pslg, case_.goal, case_.options);
  ASSERT_TRUE(whole) << whole.error().message;
  const auto expected = unnumbered(whole->mesh);
  for (const int count : {1, 2, 3, 4, 8}) {
    std::vector<MeshPiece> pieces = pieces_of(case_, count);
    for (const MeshPiece& piece : pieces) {
      EXPECT_EQ(piece.points, whole->mesh.points.size());
      EXPECT_EQ(piece.triangles, whole->mesh.triangles.size());
      EXPECT_EQ(piece.constrained_edges, whole->mesh.constrained_edges.size());
      EXPECT_EQ(piece.report.inserted, whole->report.inserted);
      EXPECT_EQ(piece.report.segment_splits, whole->report.segment_splits);
    }
    EXPECT_TRUE(unnumbered(joined(pieces)) == expected) << count << " ranks";
  }
}

TEST_P(Pieces, have_the_same_numbers_on_any_number_of_ranks) {
  std::vector<MeshPiece> one = pieces_of(case_, 1);
  const Mesh expected = joined(one);
  EXPECT_TRUE(std::ranges::equal(expected.points.span().first(case_.pslg.points.size()), case_.pslg.points));
  for (const int count : {2, 5}) {
    std::vector<MeshPiece> pieces = pieces_of(case_, count);
    EXPECT_TRUE(std::ranges::equal(joined(pieces).points, expected.points)) << count << " ranks";
  }
}

TEST_P(Pieces, list_the_vertices_that_they_share) { expect_shared_vertices(pieces_of(case_, 3)); }

TEST_P(Pieces, have_only_the_vertices_of_their_triangles) {
  for (const int count : {1, 3, 6})
    for (const MeshPiece& piece : pieces_of(case_, count)) {
      std::vector<char> is_corner(piece.mesh.points.size(), 0);
      for (const Triangle& triangle : piece.mesh.triangles)
        for (const Index v : triangle.v) is_corner[v] = 1;
      for (Index v = 0; v < is_corner.size(); ++v)  // a point of the input may be in no triangle
        EXPECT_TRUE(is_corner[v] != 0 || piece.number[v] < case_.pslg.points.size()) << count << " ranks, vertex " << v;
    }
}

TEST_P(Pieces, have_the_neighbours_that_their_triangles_imply) {
  for (const int count : {1, 3, 6})
    for (const MeshPiece& piece : pieces_of(case_, count)) expect_neighbours(piece);
}

TEST_P(Pieces, have_one_mesh_whatever_the_delays) {
  const ValidPslg domain = std::move(validate(case_.pslg)).value();
  std::optional<Digest> expected;
  for (const std::uint64_t seed : {1U, 2U, 3U})
    on_ranks(
        4,
        [&](Ranks& ranks) {
          const Result<MeshPiece> piece = mesh(domain, case_.goal, case_.options, ranks);
          ASSERT_TRUE(piece) << piece.error().message;
          const Digest found = digest(*piece, ranks);
          if (ranks.rank() > 0) return;
          if (!expected) expected = found;
          EXPECT_TRUE(found == *expected);
        },
        seed);
}

INSTANTIATE_TEST_SUITE_P(Every, Pieces, testing::Range(std::size_t{0}, cases().size()),
                         [](const auto& parameter) { return cases()[parameter.param].name; });

Case large() { return {"square", domains::square(), {.max_area = 5e-6}, {.threads = 1, .cells = {12, 12}}}; }

TEST(PiecesOfALargeMesh, are_of_about_equal_size) {
  const std::vector<MeshPiece> pieces = pieces_of(large(), 4);
  for (const MeshPiece& piece : pieces) {
    EXPECT_GT(piece.mesh.triangles.size(), piece.triangles / 6);
    EXPECT_LT(piece.mesh.triangles.size(), piece.triangles / 3);
  }
}

/// With twice as many ranks, the rank that holds the most triangles holds less than three quarters.
TEST(PiecesOfALargeMesh, are_held_with_margins_that_are_small_beside_them) {
  std::size_t most_before = SIZE_MAX;
  for (const int count : {1, 2, 4, 8}) {
    std::size_t most = 0;
    for (const MeshPiece& piece : pieces_of(large(), count)) {
      EXPECT_EQ(piece.margin == 0, count == 1);
      most = std::max(most, piece.mesh.triangles.size() + piece.margin);
    }
    EXPECT_LT(most, most_before / 4 * 3) << count << " ranks";
    most_before = most;
  }
}

/// Writers of common files divide the records by these numbers. If they were wrong, one rank would write all of them.
TEST(PiecesOfALargeMesh, are_near_the_points_of_ranges_of_numbers_of_about_equal_size) {
  const Case c = large();
  const std::vector<MeshPiece> pieces = pieces_of(c, 4);
  EXPECT_EQ(pieces.front().first_point, c.pslg.points.size());
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const std::uint64_t first = pieces[i].first_point, all = pieces[i].points;
    const std::uint64_t last = i + 1 < pieces.size() ? pieces[i + 1].first_point : all;
    ASSERT_LE(first, last);
    EXPECT_GT(last - first, all / 6);
    EXPECT_LT(last - first, all / 3);
    const auto near = std::ranges::count_if(pieces[i].number, [&](std::uint64_t n) { return n >= first && n < last; });
    EXPECT_GT(static_cast<std::size_t>(near), pieces[i].number.size() / 2) << "they are points of other pieces";
  }
}

TEST(PiecesOfALargeMesh, are_certified_when_joined) {
  const Case c{"pipe", domains::pipe(), {.min_angle_deg = 25, .max_area = 2e-4}, {.threads = 2, .cells = {6, 6}}};
  std::vector<MeshPiece> pieces = pieces_of(c, 3);
  EXPECT_TRUE(check(c.pslg, joined(pieces), c.goal).valid);
}

TEST(PiecesOfAMeshWithAFloor, list_the_triangles_that_miss_the_goal) {
  const Case c{"key",
               domains::key(),
               {.min_angle_deg = 25, .max_area = 0.002},
               {.threads = 1, .cells = {4, 4}, .min_edge = 0.05}};
  const Result<Meshed> whole = mesh(c.pslg, c.goal, c.options);
  ASSERT_TRUE(whole);
  ASSERT_FALSE(whole->report.goal_met());
  std::size_t expected = 0, found = 0;
  for (const Exemption& e : whole->report.exempt) expected += justified(e.reason) ? 0 : 1;
  const std::vector<MeshPiece> pieces = pieces_of(c, 3);
  for (const MeshPiece& piece : pieces) {
    EXPECT_EQ(piece.missed, expected);
    for (const Exemption& e : piece.report.exempt) {
      EXPECT_LT(e.triangle, piece.mesh.triangles.size());
      found += justified(e.reason) ? 0 : 1;
    }
  }
  EXPECT_EQ(found, expected);
}

/// Points beside long segments that must not be split and are not Delaunay. (The reason may be `precision` instead of
/// `kept_segment`, if a rank does not hold all that it depends on.)
TEST(PiecesOfAConformingMesh, list_the_triangles_at_segments_that_are_kept) {
  Case c{"kept segments",
         domains::square(),
         {.min_angle_deg = 0, .max_area = 0.001, .conforming = true},
         {.threads = 1, .cells = {16, 16}}};
  c.options.no_segment_splits = true;
  for (const double x : {0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9})
    for (const double y : {0.05, 0.55}) {
      const auto first = static_cast<Index>(c.pslg.points.size());
      c.pslg.points.insert(c.pslg.points.end(), {{x, y}, {x, y + 0.4}, {x - 0.003, y + 0.2}});
      c.pslg.segments.push_back({first, first + 1});
    }
  using Place = std::array<std::pair<double, double>, 3>;
  const auto add_places = [](const Mesh& mesh, const Report& report, std::vector<Place>& all) {
    for (const Exemption& e : report.exempt) {
      EXPECT_TRUE(e.reason == ExemptReason::kept_segment || e.reason == ExemptReason::precision);
      Place& place = all.emplace_back();
      for (std::size_t i = 0; i < 3; ++i) {
        const Point p = mesh.points[mesh.triangles[e.triangle].v[i]];
        place[i] = {p.x, p.y};
      }
      std::ranges::sort(place);
    }
    std::ranges::sort(all);
  };
  const Result<Meshed> whole = mesh(c.pslg, c.goal, c.options);
  ASSERT_TRUE(whole) << whole.error().message;
  std::vector<Place> expected;
  add_places(whole->mesh, whole->report, expected);
  EXPECT_GT(expected.size(), 18U);
  for (const int count : {1, 2, 5}) {
    std::vector<Place> found;
    for (const MeshPiece& piece : pieces_of(c, count)) add_places(piece.mesh, piece.report, found);
    EXPECT_TRUE(found == expected) << count << " ranks: " << found.size() << " of " << expected.size();
  }
}

/// Many places beside segments, beside points, and at short segments.
TEST(PiecesOfADomainWithGaps, report_the_gaps_that_one_process_reports) {
  Pslg pslg = domains::square();
  for (const Point p : domains::random_points(40, 5).points) {
    const auto first = static_cast<Index>(pslg.points.size());
    pslg.points.insert(pslg.points.end(), {p, {p.x, p.y + 0x1p-30}, {p.x, 0x1p-26}});
    if (first % 2 == 0) pslg.segments.push_back({first, first + 1});
  }
  const Goal goal{.min_angle_deg = 0, .max_area = 0.01};
  const auto messages = [](const std::vector<Gap>& gaps) {
    std::vector<std::string> list;
    for (const Gap& gap : gaps) list.push_back(gap.message());
    return list;
  };
  const Result<Meshed> whole = mesh(*validate(pslg), goal, {.threads = 1});
  ASSERT_TRUE(whole) << whole.error().message;
  EXPECT_GT(whole->report.gaps.size(), 50U);
  for (const int count : {1, 2, 5})
    on_ranks(count, [&](Ranks& ranks) {
      const Result<MeshPiece> piece = mesh(*validate(pslg), goal, {.threads = 1}, ranks);
      ASSERT_TRUE(piece) << piece.error().message;
      EXPECT_EQ(messages(piece->report.gaps), messages(whole->report.gaps));
    });
}

TEST(PiecesAreRefused, with_options_for_one_process) {
  const ValidPslg domain = std::move(validate(domains::square())).value();
  const auto error_of = [&](const Options& options) {
    std::optional<Error> error;
    on_ranks(1, [&](Ranks& ranks) {
      const Result<MeshPiece> piece = mesh(domain, {.max_area = 0.01}, options, ranks);
      if (!piece) error = piece.error();
    });
    return error ? error->message : "";
  };
  EXPECT_EQ(error_of({.max_vertices = 10}),
            "a limit on the number of vertices works in one process only, not in several ranks");
  EXPECT_EQ(error_of({.after_sweep = [](const Mesh&, const Sweep&) -> Status { return Done{}; }}),
            "a function that is called after each sweep works in one process only, not in several ranks");
}

}  // namespace
}  // namespace pardel
