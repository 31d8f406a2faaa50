// The whole mesh that pieces make, and what must hold for pieces of any mesh.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "../../../core/join_pieces.hpp"
#include "../../../core/neighbours.hpp"
#include "../../../distributed/distributed.hpp"

namespace pardel {

/// A mesh without its numbering: sorted lists of points, triangles and edges, each as numbers.
inline std::vector<std::vector<double>> unnumbered(const Mesh& mesh) {
  std::vector<std::vector<double>> all;
  const auto put = [&](std::vector<double>& to, Index v) {
    to.push_back(mesh.points[v].x);
    to.push_back(mesh.points[v].y);
  };
  for (Index v = 0; v < mesh.points.size(); ++v) {
    std::vector<double> point{1};
    put(point, v);
    point.push_back(mesh.point_markers[v]);
    point.push_back(mesh.origin[v]);
    for (std::size_t a = 0; a < mesh.attributes_per_point; ++a)
      point.push_back(mesh.point_attributes[v * mesh.attributes_per_point + a]);
    all.push_back(std::move(point));
  }
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    auto v = mesh.triangles[t].v;
    const auto least =
        std::ranges::min_element(v, {}, [&](Index c) { return std::pair(mesh.points[c].x, mesh.points[c].y); });
    std::rotate(v.begin(), least, v.end());
    std::vector<double> triangle{2};
    for (const Index c : v) put(triangle, c);
    triangle.push_back(mesh.region.empty() ? 0.0 : mesh.region[t]);
    all.push_back(std::move(triangle));
  }
  for (const ConstrainedEdge& e : mesh.constrained_edges) {
    const bool swap =
        std::pair(mesh.points[e.b].x, mesh.points[e.b].y) < std::pair(mesh.points[e.a].x, mesh.points[e.a].y);
    std::vector<double> edge{3};
    put(edge, swap ? e.b : e.a);
    put(edge, swap ? e.a : e.b);
    edge.push_back(e.segment);
    edge.push_back(e.marker);
    all.push_back(std::move(edge));
  }
  std::ranges::sort(all);
  return all;
}

/// Uses up the pieces.
inline Mesh joined(std::vector<MeshPiece>& pieces) {
  std::vector<NumberedMesh> numbered;
  for (MeshPiece& piece : pieces) numbered.push_back({std::move(piece.mesh), std::move(piece.number)});
  Result<Mesh> whole = join_pieces(numbered);
  EXPECT_TRUE(whole) << whole.error().message;
  return whole ? std::move(*whole) : Mesh{};
}

/// Two pieces list the vertices that both have, and no others.
inline void expect_shared_vertices(const std::vector<MeshPiece>& pieces) {
  const auto numbers_with = [&](std::size_t of, std::size_t with) {
    std::vector<std::uint64_t> numbers;
    for (const SharedVertices& shared : pieces[of].shared)
      if (shared.rank == static_cast<int>(with))
        for (const Index v : shared.vertices) numbers.push_back(pieces[of].number[v]);
    return numbers;
  };
  const auto sorted_numbers = [](const MeshPiece& piece) {
    std::vector<std::uint64_t> numbers(piece.number.begin(), piece.number.end());
    std::ranges::sort(numbers);
    return numbers;
  };
  for (std::size_t rank = 0; rank < pieces.size(); ++rank)
    for (std::size_t other = 0; other < pieces.size(); ++other) {
      if (other == rank) continue;
      std::vector<std::uint64_t> both;
      std::ranges::set_intersection(sorted_numbers(pieces[rank]), sorted_numbers(pieces[other]),
                                    std::back_inserter(both));
      EXPECT_EQ(numbers_with(rank, other), both) << rank << " with " << other;
    }
}

inline void expect_neighbours(const MeshPiece& piece) {
  Array<Triangle> expected = piece.mesh.triangles;
  EXPECT_EQ(rebuild_neighbours(expected, piece.mesh.points.size()), 0U);
  EXPECT_TRUE(std::ranges::equal(piece.mesh.triangles, expected));
}

}  // namespace pardel
