// Several ranks make the Delaunay triangulation that one process makes, and no rank holds all of it.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "../../../parallel/mesher.hpp"
#include "../../../parallel/validate.hpp"
#include "../../../properties/domains/domains.hpp"
#include "../../../properties/domains/generators/random.hpp"
#include "../../../properties/theorems/framework/local_ranks.hpp"
#include "../../parallel/samples.hpp"
#include "../meshing/whole_of_pieces.hpp"
#include "part_of_rank.hpp"

namespace pardel {
namespace {

using properties::on_ranks;

std::vector<MeshPiece> pieces_of(const Pslg& pslg, int count, int threads = 1) {
  std::vector<MeshPiece> pieces(static_cast<std::size_t>(count));
  on_ranks(count, [&](Ranks& ranks) {
    Result<MeshPiece> piece = triangulate(part_of(pslg, ranks), {.threads = threads}, ranks);
    ASSERT_TRUE(piece) << count << " ranks, rank " << ranks.rank() << ": " << piece.error().message;
    pieces[ranks.rank()] = std::move(*piece);
  });
  return pieces;
}

Pslg with_data() {
  Pslg pslg = domains::random_points(700, 8);
  pslg.attributes_per_point = 2;
  for (std::size_t i = 0; i < pslg.points.size(); ++i) {
    pslg.point_markers.push_back(i % 5 == 0 ? static_cast<int>(i) : 0);
    pslg.point_attributes.push_back(pslg.points[i].x);
    pslg.point_attributes.push_back(static_cast<double>(i));
  }
  return pslg;
}

/// All points are corners of the convex hull.
Pslg on_a_circle(int n) {
  Pslg pslg;
  for (int i = 0; i < n; ++i) pslg.points.push_back({std::cos(6.28 * i / n), std::sin(6.28 * i / n)});
  return pslg;
}

void expect_the_triangulation_of_one_process(const Pslg& pslg, const std::string& name) {
  SCOPED_TRACE(name);
  const Result<Meshed> whole = triangulate(pslg);
  ASSERT_TRUE(whole) << whole.error().message;
  const auto expected = unnumbered(whole->mesh);
  for (const int count : {1, 2, 3, 5, 8}) {
    std::vector<MeshPiece> pieces = pieces_of(pslg, count);
    expect_shared_vertices(pieces);
    std::uint64_t first_triangle = 0;
    for (const MeshPiece& piece : pieces) {
      expect_neighbours(piece);
      EXPECT_EQ(piece.first_triangle, first_triangle);
      first_triangle += piece.mesh.triangles.size();
      EXPECT_EQ(piece.points, pslg.points.size());
      EXPECT_EQ(piece.triangles, whole->mesh.triangles.size());
      EXPECT_EQ(piece.constrained_edges, whole->mesh.constrained_edges.size());
    }
    const Mesh joint = joined(pieces);
    EXPECT_TRUE(std::ranges::equal(joint.points, pslg.points)) << count << " ranks";
    EXPECT_TRUE(unnumbered(joint) == expected) << count << " ranks";
  }
}

TEST(TriangulatedPieces, are_together_the_triangulation_of_one_process) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed)
    for (const engine::samples::Family& family : engine::samples::families(500, seed))
      expect_the_triangulation_of_one_process(with_points(family.points), family.name);
  expect_the_triangulation_of_one_process(on_a_circle(300), "circle");
  expect_the_triangulation_of_one_process(with_data(), "with data");
}

TEST(TriangulatedPieces, of_few_points_are_together_the_triangulation_of_one_process) {
  generators::Random random(1);
  for (int round = 0; round < 60; ++round) {
    std::vector<Point> points = engine::samples::lattice_points(5);
    random.shuffle(points);
    points.resize(3 + random.below(20));
    if (triangulate(with_points(points)))
      expect_the_triangulation_of_one_process(with_points(points), "round " + std::to_string(round));
  }
}

TEST(TriangulatedPieces, do_not_depend_on_threads) {
  const Pslg pslg = domains::random_points(20'000, 4);
  std::vector<MeshPiece> one = pieces_of(pslg, 3, 1), two = pieces_of(pslg, 3, 2);
  for (std::size_t rank = 0; rank < one.size(); ++rank) EXPECT_EQ(one[rank].mesh, two[rank].mesh);
}

TEST(TriangulatedPieces, are_about_equally_large_and_share_few_vertices) {
  const std::vector<MeshPiece> pieces = pieces_of(domains::random_points(40'000, 5), 8);
  for (const MeshPiece& piece : pieces) {
    EXPECT_NEAR(static_cast<double>(piece.mesh.triangles.size()), 10'000, 700);
    EXPECT_LT(piece.mesh.points.size(), 5'600U);
  }
}

std::string refusal(const Pslg& pslg, int count) {
  std::vector<std::string> messages(static_cast<std::size_t>(count));
  on_ranks(count, [&](Ranks& ranks) {
    const Result<MeshPiece> piece = triangulate(part_of(pslg, ranks), {.threads = 1}, ranks);
    ASSERT_FALSE(piece);
    EXPECT_EQ(piece.error().kind, ErrorKind::invalid_input);
    messages[ranks.rank()] = piece.error().message;
  });
  for (const std::string& message : messages) EXPECT_EQ(message, messages.front());
  return messages.front();
}

TEST(TriangulatedPieces, refuse_equal_points_with_their_numbers) {
  for (const int count : {1, 2, 4, 7}) {
    Pslg pslg = domains::random_points(400, 6);
    pslg.points[371] = pslg.points[5];
    EXPECT_NE(refusal(pslg, count).find("Points 5 and 371 are both at"), std::string::npos) << refusal(pslg, count);
  }
}

TEST(TriangulatedPieces, refuse_points_on_a_line_and_unusable_coordinates) {
  for (const int count : {1, 2, 4}) {
    Pslg line;
    for (int i = 0; i < 50; ++i) line.points.push_back({1.0 * i, 2.0 * i});
    EXPECT_EQ(refusal(line, count), "There are no three points that make a triangle: all lie on one line.");
    EXPECT_EQ(refusal(Pslg{}, count), "There are no three points that make a triangle: all lie on one line.");
    Pslg far = domains::random_points(50, 6);
    far.points[49].x = 1e90;
    EXPECT_NE(refusal(far, count).find("Point 49 at (1e+90"), std::string::npos);
    far.points[49].x = NAN;
    EXPECT_NE(refusal(far, count).find("is not a finite number"), std::string::npos);
  }
}

/// Without this, what is listed would depend on the number of ranks.
TEST(ProblemsOfPoints, are_those_that_one_process_finds) {
  Pslg duplicates = domains::random_points(600, 9);
  for (const Index i : {3U, 99U, 204U, 512U}) duplicates.points[i] = duplicates.points[50];
  for (const Index i : {7U, 580U}) duplicates.points[i] = duplicates.points[300];
  Pslg unusable = domains::random_points(600, 10);
  for (const Index i : {2U, 350U, 599U}) unusable.points[i].x = 1e-99;
  unusable.points[111].y = INFINITY;
  Pslg line;
  for (int i = 0; i < 40; ++i) line.points.push_back({1.0 * i, 2.0 * i});
  Pslg line_with_duplicates = line;
  line_with_duplicates.points[30] = line.points[4];
  const Pslg none = domains::random_points(100, 11), one_place = with_points(std::vector<Point>(9, Point{1, 2}));
  for (const Pslg& pslg : {duplicates, unusable, line, line_with_duplicates, none, one_place, Pslg{}}) {
    const std::string expected = messages(find_problems(pslg));
    for (const int count : {1, 2, 5}) {
      on_ranks(count, [&](Ranks& ranks) {
        EXPECT_EQ(messages(find_problems(part_of(pslg, ranks), 1, ranks)), expected);
        const Result<MeshPiece> piece = triangulate(part_of(pslg, ranks), {.threads = 1}, ranks);
        EXPECT_EQ(piece ? "" : piece.error().message, expected);
      });
    }
  }
}

/// Of each kind, at most 10,000 are listed.
TEST(ProblemsOfPoints, are_listed_as_often_as_by_one_process) {
  Pslg pairs_on_a_line, unusable;
  for (int i = 0; i < 11'000; ++i)
    pairs_on_a_line.points.insert(pairs_on_a_line.points.end(), {{1.0 * i, 1}, {1.0 * i, 1}});
  for (int i = 0; i < 11'000; ++i)
    unusable.points.insert(unusable.points.end(), {{1.0 * i, 1e-99}, {INFINITY, 1.0 * i}});
  const auto counts = [](const std::vector<Problem>& problems) {
    std::map<ProblemKind, int> count;
    for (const Problem& problem : problems) ++count[problem.kind];
    return count;
  };
  for (const Pslg& pslg : {pairs_on_a_line, unusable}) {
    const auto expected = counts(find_problems(pslg));
    EXPECT_EQ(expected.size(), 2U);
    for (const int count : {1, 3})
      on_ranks(count,
               [&](Ranks& ranks) { EXPECT_TRUE(counts(find_problems(part_of(pslg, ranks), 1, ranks)) == expected); });
  }
}

TEST(ProblemsOfPoints, are_counts_that_do_not_fit_the_points_of_a_rank) {
  Pslg whole = domains::random_points(60, 12);
  whole.attributes_per_point = 2;
  whole.point_attributes.assign(120, 0.5);
  whole.point_markers.assign(60, 1);
  Pslg wrong = whole;
  wrong.point_markers.pop_back();
  const std::string expected = messages(find_problems(wrong));
  const auto found = [&](const auto& change) {
    std::string first;
    on_ranks(3, [&](Ranks& ranks) {
      const auto changed = [&] {
        PartOfPoints part = part_of(whole, ranks);
        if (ranks.rank() == 1) change(part);
        return part;
      };
      const std::string here = messages(find_problems(changed(), 1, ranks));
      const Result<MeshPiece> piece = triangulate(changed(), {.threads = 1}, ranks);
      const Result<MeshPiece> meshed = mesh({changed()}, {}, {.threads = 1}, ranks);
      EXPECT_EQ(piece ? "" : piece.error().message, here);
      EXPECT_EQ(meshed ? "" : meshed.error().message, here);
      if (ranks.rank() == 0) first = here;
    });
    return first;
  };
  EXPECT_EQ(found([](PartOfPoints&) {}), "");
  EXPECT_EQ(found([](PartOfPoints& part) { part.point_markers.pop_back(); }), expected);
  EXPECT_EQ(found([](PartOfPoints& part) { part.point_markers.clear(); }), expected);
  EXPECT_EQ(found([](PartOfPoints& part) { part.point_attributes.push_back(1); }), expected);
  EXPECT_EQ(found([](PartOfPoints& part) {
              part.attributes_per_point = 1;
              part.point_attributes.resize(part.points.size());
            }),
            expected);
}

}  // namespace
}  // namespace pardel
