// Edits leave a consistent mesh: the checker finds only violations that the geometry of the edit causes.
#include "../../../properties/defects/edit.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "../../../parallel/mesher.hpp"
#include "../../../properties/checker/check.hpp"
#include "../../../properties/domains/domains.hpp"

namespace pardel {
namespace {

namespace edit = defects::edit;
using edit::Side;

Goal no_quality() {
  Goal goal;
  goal.min_angle_deg = 0;
  goal.region_caps = false;
  return goal;
}

Mesh mesh_of(const Pslg& pslg) {
  Goal goal;
  goal.min_angle_deg = 20.7;
  goal.max_area = 0.05;
  auto result = mesh(pslg, goal);
  EXPECT_TRUE(result.ok());
  return result ? std::move(result->mesh) : Mesh{};
}

/// All violations except edges that are not Delaunay.
std::vector<std::string> violations_except_not_delaunay(const Pslg& pslg, const Mesh& mesh) {
  std::vector<std::string> found;
  for (const Violation& violation : check(pslg, mesh, no_quality()).violations)
    if (violation.kind != ViolationKind::not_delaunay) found.push_back(violation.message());
  return found;
}

const std::vector<std::string> none;

TEST(Edit, a_flip_leaves_a_valid_triangulation_and_flipping_again_restores_the_edge) {
  const Pslg pslg = domains::regions();
  const Mesh original = mesh_of(pslg);
  const auto walls = edit::constrained(original);
  int flips = 0;
  for (Index t = 0; t < original.triangles.size(); ++t) {
    const Side s{t, 1};
    const auto ends = edit::ends(edit::tail(original, s), edit::head(original, s));
    Mesh changed = original;
    if (walls.contains(ends) || !edit::flip(changed, s)) continue;
    if (++flips % 16 == 1) {
      EXPECT_EQ(violations_except_not_delaunay(pslg, changed), none);
    }
    // After a flip {c, d, b}, the new edge is opposite corner 2.
    ASSERT_TRUE(edit::flip(changed, {t, 2}));
    EXPECT_EQ(digest(changed), digest(original));
  }
  EXPECT_GT(flips, 16);
}

TEST(Edit, a_flip_changes_nothing_at_the_boundary_and_in_quadrilaterals_that_are_not_convex) {
  const Pslg pslg = domains::touching_holes();
  const Mesh original = mesh_of(pslg);
  int refused = 0;
  for (Index t = 0; t < original.triangles.size(); ++t)
    for (int i = 0; i < 3; ++i) {
      Mesh changed = original;
      if (edit::flip(changed, {t, i})) continue;
      ++refused;
      EXPECT_EQ(changed, original);
    }
  EXPECT_GT(refused, 0);
}

TEST(Edit, a_split_triangle_leaves_a_valid_triangulation) {
  const Pslg pslg = domains::regions();
  Mesh changed = mesh_of(pslg);
  for (Index t = 0; t < 20; ++t) edit::split_triangle(changed, t, edit::centroid(changed, t));
  EXPECT_EQ(violations_except_not_delaunay(pslg, changed), none);
}

TEST(Edit, a_collapse_leaves_a_valid_triangulation_without_the_vertex) {
  // All segments are parallel to the axes, so rounding leaves no slivers along chains.
  const Pslg pslg = domains::touching_holes();
  Mesh changed = mesh_of(pslg);
  const std::size_t before = changed.points.size();
  std::size_t collapsed = 0;
  for (auto v = static_cast<Index>(before); v-- > pslg.points.size();) {
    if (changed.origin[v] != interior_vertex) continue;
    const auto around = edit::neighbour_vertices(changed, v);
    if (std::ranges::none_of(around, [&](Index to) { return edit::collapse(changed, v, to); })) continue;
    edit::erase_unused_point(changed, v);
    ++collapsed;
  }
  EXPECT_GT(collapsed, 10u);
  EXPECT_EQ(changed.points.size(), before - collapsed);
  EXPECT_EQ(violations_except_not_delaunay(pslg, changed), none);
}

TEST(Edit, renumbering_keeps_the_set_of_triangles) {
  const Pslg pslg = domains::regions();
  const Mesh original = mesh_of(pslg);
  std::vector<Index> to(original.points.size());
  for (Index v = 0; v < to.size(); ++v) to[v] = static_cast<Index>((v + 5) % to.size());
  Mesh changed = original;
  edit::renumber(changed, to);
  EXPECT_NE(changed, original);
  EXPECT_EQ(digest(changed), digest(original));
}

TEST(Edit, faces_are_separated_by_constrained_edges) {
  Mesh mesh = mesh_of(domains::regions());
  auto faces = edit::faces(mesh);
  for (std::size_t t = 0; t < faces.size(); ++t)
    for (std::size_t u = 0; u < t; ++u) EXPECT_EQ(faces[t] == faces[u], mesh.region[t] == mesh.region[u]);
  mesh.constrained_edges.clear();
  faces = edit::faces(mesh);
  EXPECT_EQ(std::ranges::count(faces, 0u), std::ssize(faces));
}

}  // namespace
}  // namespace pardel
