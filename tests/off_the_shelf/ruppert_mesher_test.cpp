// The reference as a mesher: an algorithm that shares no code with the engine meshes in every scheme.
#include "ruppert_mesher.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "../../core/digest.hpp"
#include "../../off_the_shelf/in_processes.hpp"
#include "../../off_the_shelf/mesh_with_mesher.hpp"
#include "../../parallel/validate.hpp"
#include "../../properties/checker/check.hpp"
#include "../../properties/domains/domains.hpp"

namespace pardel {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// The square from (0, 0) to (4, 4) in two triangles.
Subdomain square_of_four(bool may_be_split) {
  Subdomain subdomain;
  subdomain.points = {{0, 0}, {4, 0}, {4, 4}, {0, 4}};
  subdomain.triangles = {{0, 1, 2}, {0, 2, 3}};
  for (Index i = 0; i < 4; ++i) subdomain.edges.push_back({i, (i + 1) % 4, false, may_be_split});
  subdomain.goal = {.max_area = 0.5};
  subdomain.most_new_points = 1000;
  subdomain.seconds = 60;
  return subdomain;
}

class RuppertMesher : public testing::TestWithParam<Scheme> {
 protected:
  static MeshedWithMesher run(const Pslg& pslg, const Goal& goal, SubdomainMesher& mesher, int threads = 1) {
    auto made = mesh_with_mesher(*validate(pslg), goal, mesher, {.scheme = GetParam(), .triangles_per_task = 250},
                                 {.threads = threads});
    if (!made) ADD_FAILURE() << made.error().message;
    return std::move(made).value();
  }
  static void expect_good(const Pslg& pslg, const Goal& goal) {
    const auto mesher = ruppert_mesher();
    const MeshedWithMesher made = run(pslg, goal, *mesher);
    EXPECT_TRUE(check(pslg, made.mesh, goal).valid);
    for (std::size_t kind = 0; kind < breach_kinds; ++kind)
      EXPECT_EQ(made.mesher.breaches.count[kind], 0U) << made.mesher.breaches.first[kind].what;
    // Along the frozen edges of such small parts, there is not much that it may insert.
    EXPECT_GT(4 * made.mesher.inserted, made.mesher.completed);
  }
};

TEST_P(RuppertMesher, makes_a_certified_mesh_of_a_square) {
  expect_good(domains::square(), {.min_angle_deg = 20.7, .max_area = 1.0 / 1024});
}

TEST_P(RuppertMesher, makes_a_certified_mesh_with_area_caps_of_regions) {
  expect_good(domains::regions(), {.min_angle_deg = 20, .max_area = 1.0 / 256, .region_caps = true});
}

TEST_P(RuppertMesher, makes_a_certified_mesh_with_sizes_that_depend_on_the_place) {
  expect_good(domains::square(), {.size = [](Point p) { return 0.025 + 0.0625 * p.x; }});
}

TEST_P(RuppertMesher, makes_the_same_mesh_in_processes) {
  const Pslg pslg = domains::touching_holes();
  const Goal goal{.min_angle_deg = 20, .max_area = 0.02};
  const auto mesher = ruppert_mesher();
  const auto processes = std::move(in_processes(ruppert_mesher(), 2)).value();
  EXPECT_EQ(digest(run(pslg, goal, *mesher, 2).mesh), digest(run(pslg, goal, *processes, 2).mesh));
}

INSTANTIATE_TEST_SUITE_P(Schemes, RuppertMesher, testing::Values(Scheme::frozen, Scheme::cells, Scheme::decoupled),
                         [](const auto& scheme) { return std::string(name(scheme.param)); });

TEST(RuppertMesherAnswers, with_points_in_the_cell_only) {
  const auto mesher = ruppert_mesher();
  Subdomain subdomain = square_of_four(true);
  const std::size_t everywhere = mesher->refine(subdomain).points.size();
  subdomain.cell = SubdomainCell{{-infinity, -infinity}, {2.5, 2.5}};
  const RefinedSubdomain answer = mesher->refine(subdomain);
  EXPECT_GT(answer.points.size(), 4U);
  EXPECT_LT(answer.points.size(), everywhere);
  for (std::size_t i = 4; i < answer.points.size(); ++i) EXPECT_TRUE(subdomain.cell->contains(answer.points[i]));
}

TEST(RuppertMesherAnswers, without_a_point_that_encroaches_upon_a_frozen_edge) {
  // Only the centre of the square lies in no diametral disk, but on all their borders.
  EXPECT_EQ(ruppert_mesher()->refine(square_of_four(false)).points.size(), 4U);
}

TEST(RuppertMesherAnswers, with_the_split_edge_of_each_point_on_it) {
  const Subdomain subdomain = square_of_four(true);
  const RefinedSubdomain answer = ruppert_mesher()->refine(subdomain);
  int on_edges = 0;
  for (std::size_t i = 4; i < answer.points.size(); ++i) {
    const Point p = answer.points[i];
    const Index edge = answer.edge_of_new_point[i - 4];
    const Index expected = p.y == 0 ? 0 : p.x == 4 ? 1 : p.y == 4 ? 2 : p.x == 0 ? 3 : no_index;
    EXPECT_EQ(edge, expected);
    on_edges += edge != no_index ? 1 : 0;
  }
  EXPECT_GE(on_edges, 12);
}

TEST(RuppertMesherAnswers, at_its_limit_of_points) {
  Subdomain subdomain = square_of_four(true);
  subdomain.most_new_points = 3;
  const RefinedSubdomain answer = ruppert_mesher()->refine(subdomain);
  EXPECT_EQ(answer.ending, RefinedSubdomain::Ending::limit);
  EXPECT_EQ(answer.points.size(), 7U);
}

}  // namespace
}  // namespace pardel
