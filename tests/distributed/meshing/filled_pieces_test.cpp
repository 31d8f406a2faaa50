// Pieces of a filled mesh, made one after another.
#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "../../../core/digest.hpp"
#include "../../../core/join_pieces.hpp"
#include "../../../distributed/distributed.hpp"
#include "../../../parallel/mesher.hpp"
#include "../../../properties/domains/domains.hpp"
#include "../../../properties/theorems/framework/local_ranks.hpp"
#include "square_with_data.hpp"

namespace pardel::filled {
namespace {

using properties::on_ranks;

const Options filling{.interior = Interior::fill, .threads = 1};

/// All pieces, in the order of their numbers.
std::vector<MeshPiece> pieces_of(const Pslg& pslg, const Goal& goal, const Options& options, int ranks, int pieces) {
  const ValidPslg domain = std::move(validate(pslg)).value();
  std::vector<MeshPiece> all(pieces);
  on_ranks(ranks, [&](Ranks& of_rank) {
    const Status made =
        mesh_in_pieces(domain, goal, options, of_rank, pieces, [&](MeshPiece&& piece, int number) -> Status {
          EXPECT_EQ(number % ranks, of_rank.rank());
          all.at(number) = std::move(piece);
          return Done{};
        });
    ASSERT_TRUE(made) << made.error().message;
  });
  return all;
}

Mesh joined(const std::vector<MeshPiece>& pieces) {
  std::vector<NumberedMesh> numbered;
  for (const MeshPiece& piece : pieces)
    if (!piece.mesh.points.empty()) numbered.push_back({piece.mesh, piece.number});
  Result<Mesh> whole = join_pieces(numbered);
  EXPECT_TRUE(whole) << whole.error().message;
  return whole ? std::move(*whole) : Mesh{};
}

struct Case {
  std::string name;
  Pslg pslg;
  Goal goal;
};

const std::vector<Case>& cases() {
  static const std::vector<Case> all = {
      {"square", domains::square(), {.max_area = 1e-4}},
      {"pipe", domains::pipe(), {.min_angle_deg = 28, .max_area = 5e-4}},
      {"regions", square_with_data(), {.max_area = 0.0005, .region_caps = true}},
      {"edges", domains::cracks(), {.max_edge = 0.02}},
      {"key", domains::key(), {.min_angle_deg = 25, .max_area = 0.005}},
  };
  return all;
}

class FilledPieces : public testing::TestWithParam<std::size_t> {
 protected:
  const Case& case_ = cases()[GetParam()];
};

TEST_P(FilledPieces, are_together_the_mesh_of_one_process_with_its_numbers) {
  const Result<Meshed> whole = mesh(case_.pslg, case_.goal, filling);
  ASSERT_TRUE(whole) << whole.error().message;
  ASSERT_GT(whole->report.laid, 0U);
  for (const int ranks : {1, 2, 3, 5})
    for (const int count : {ranks, 8, 31}) {
      const std::vector<MeshPiece> pieces = pieces_of(case_.pslg, case_.goal, filling, ranks, count);
      std::uint64_t triangles = 0;
      for (const MeshPiece& piece : pieces) {
        EXPECT_EQ(piece.first_triangle, triangles);
        triangles += piece.mesh.triangles.size();
        EXPECT_EQ(piece.points, whole->mesh.points.size());
        EXPECT_EQ(piece.triangles, whole->mesh.triangles.size());
        EXPECT_EQ(piece.constrained_edges, whole->mesh.constrained_edges.size());
        EXPECT_EQ(piece.report.laid, whole->report.laid);
        EXPECT_EQ(piece.report.inserted, whole->report.inserted);
      }
      EXPECT_TRUE(joined(pieces) == whole->mesh) << ranks << " ranks, " << count << " pieces";
    }
}

TEST_P(FilledPieces, list_the_vertices_that_they_share) {
  const std::vector<MeshPiece> pieces = pieces_of(case_.pslg, case_.goal, filling, 2, 9);
  std::size_t shared_vertices = 0;
  for (int number = 0; number < 9; ++number)
    for (int other = 0; other < 9; ++other) {
      if (other == number) continue;
      std::vector<std::uint64_t> listed;
      for (const SharedVertices& shared : pieces[number].shared)
        if (shared.rank == other)
          for (const Index v : shared.vertices) listed.push_back(pieces[number].number[v]);
      std::vector<std::uint64_t> both;
      std::ranges::set_intersection(pieces[number].number, pieces[other].number, std::back_inserter(both));
      EXPECT_EQ(listed, both) << number << " with " << other;
      shared_vertices += both.size();
    }
  EXPECT_GT(shared_vertices, 0U);
}

TEST_P(FilledPieces, are_of_about_equal_size) {
  for (const MeshPiece& piece : pieces_of(case_.pslg, case_.goal, filling, 1, 4)) {
    EXPECT_GT(piece.mesh.triangles.size(), piece.triangles / 5);
    EXPECT_LT(piece.mesh.triangles.size(), piece.triangles / 3);
  }
}

INSTANTIATE_TEST_SUITE_P(Every, FilledPieces, testing::Range(std::size_t{0}, cases().size()),
                         [](const auto& parameter) { return cases()[parameter.param].name; });

TEST(FilledPiecesWithoutPatches, are_the_refined_pieces_and_empty_ones) {
  const Goal goal{.max_area = 1};
  const Result<Meshed> whole = mesh(domains::key(), goal, filling);
  ASSERT_TRUE(whole);
  ASSERT_EQ(whole->report.laid, 0U);
  const std::vector<MeshPiece> pieces = pieces_of(domains::key(), goal, filling, 2, 5);
  EXPECT_TRUE(digest(joined(pieces)) == digest(whole->mesh));
  for (const MeshPiece& piece : pieces) {
    EXPECT_EQ(piece.points, whole->mesh.points.size());
    EXPECT_EQ(piece.triangles, whole->mesh.triangles.size());
    EXPECT_EQ(piece.constrained_edges, whole->mesh.constrained_edges.size());
  }
  for (const int number : {2, 3, 4}) EXPECT_TRUE(pieces[number].mesh.triangles.empty());
}

TEST(FilledPiecesWithAFloor, list_the_triangles_that_miss_the_goal) {
  const Goal goal{.min_angle_deg = 25, .max_area = 0.002};
  Options options = filling;
  options.min_edge = 0.04;
  const Result<Meshed> whole = mesh(domains::key(), goal, options);
  ASSERT_TRUE(whole);
  ASSERT_FALSE(whole->report.goal_met());
  const auto missed =
      std::ranges::count_if(whole->report.exempt, [](const Exemption& e) { return !justified(e.reason); });
  std::size_t listed = 0;
  for (const MeshPiece& piece : pieces_of(domains::key(), goal, options, 2, 5)) {
    EXPECT_EQ(piece.missed, missed);
    for (const Exemption& e : piece.report.exempt) {
      ASSERT_LT(e.triangle, piece.mesh.triangles.size());
      ++listed;
    }
  }
  EXPECT_EQ(listed, whole->report.exempt.size());
}

/// The error of the first rank, and how many pieces were made before it.
std::pair<std::optional<Error>, int> error_of(const Goal& goal, const Options& options, int ranks, int pieces,
                                              int failing = -1) {
  const ValidPslg domain = std::move(validate(domains::square())).value();
  std::pair<std::optional<Error>, int> result;
  on_ranks(ranks, [&](Ranks& of_rank) {
    int made = 0;
    const Status status =
        mesh_in_pieces(domain, goal, options, of_rank, pieces, [&](MeshPiece&&, int number) -> Status {
          if (number == failing) return Error{ErrorKind::io, "the disk is full"};
          ++made;
          return Done{};
        });
    if (of_rank.rank() == 0) result = {status ? std::optional<Error>() : status.error(), made};
  });
  return result;
}

TEST(FilledPiecesAreRefused, if_they_are_fewer_than_the_ranks) {
  const auto [error, made] = error_of({.max_area = 0.01}, filling, 3, 2);
  ASSERT_TRUE(error);
  EXPECT_EQ(error->kind, ErrorKind::usage);
  EXPECT_EQ(error->message, "there must be at least as many pieces as ranks, 3, not 2");
}

TEST(FilledPiecesAreRefused, if_the_interior_is_not_to_be_filled) {
  const Options refining{.interior = Interior::refine, .threads = 1};
  for (const auto& [goal, options] :
       {std::pair<Goal, Options>({.max_area = 0.01}, refining), std::pair<Goal, Options>({}, filling)}) {
    const auto [error, made] = error_of(goal, options, 2, 4);
    ASSERT_TRUE(error);
    EXPECT_EQ(error->kind, ErrorKind::usage);
    EXPECT_EQ(made, 0);
  }
}

TEST(FilledPiecesEnd, with_an_error_of_the_visitor) {
  const auto [error, made] = error_of({.max_area = 1e-3}, filling, 1, 5, 2);
  ASSERT_TRUE(error);
  EXPECT_EQ(error->message, "the disk is full");
  EXPECT_EQ(made, 2);
}

}  // namespace
}  // namespace pardel::filled
