// Patches are cut out of a domain and laid again.
#include "../../../parallel/filling/filling.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "../../../parallel/conversion/export_mesh.hpp"
#include "../../../parallel/patches/border_edges.hpp"
#include "../../../parallel/patches/cut_out.hpp"
#include "../../../properties/checker/check.hpp"
#include "../patches/distance_to.hpp"
#include "../patches/domains_to_fill.hpp"
#include "../samples.hpp"

namespace pardel::engine {
namespace {

Result<std::optional<Filling>> filled(const Pslg& pslg, std::span<const double> edges, const Options& options = {},
                                      int threads = 1) {
  return Filling::make(pslg, false, coarse(pslg), edges, {}, options, Threads(threads));
}

/// The mesh of the domain without its patches, as it is before patches are laid.
Mesh mesh_around_patches(Filling& filling, const Pslg& pslg, const Threads& threads = {}) {
  DomainTriangulation domain = filling.take_domain();
  std::vector<double> attributes;
  for (const Region& region : pslg.regions) attributes.push_back(region.attribute);
  return export_triangulation(domain, attributes, filling.points(), threads);
}

std::size_t edges_on_border(const Triangulation& t) {
  std::size_t count = 0;
  for (TriangleId id = 0; id < t.slots.size(); ++id)
    for (unsigned side = 0; side < 3; ++side) count += t.on_border_of_patch(EdgeRef(id, side));
  return count;
}

TEST(Filling, cuts_patches_out_of_the_domain_and_lays_them_again) {
  for (const Pslg& pslg : domains_to_fill()) {
    const double edge = extent(pslg) / 31, area = samples::twice_area(coarse(pslg).triangulation);
    for (const int threads : {1, 3}) {
      auto filling = filled(pslg, std::array{edge}, {}, threads);
      ASSERT_TRUE(filling && *filling);
      DomainTriangulation domain = (*filling)->take_domain();
      const Triangulation& t = domain.triangulation;
      const double laid = std::sqrt(3.0) / 2 * edge * edge * static_cast<double>((*filling)->triangles());
      EXPECT_GT((*filling)->triangles(), 20U);
      EXPECT_EQ(samples::fault(t), "");
      EXPECT_NEAR(samples::twice_area(t), area - laid, 1e-12 * area);
      EXPECT_GT(edges_on_border(t), 10U);
      EXPECT_EQ(t.points.size(), (*filling)->points().size());

      const std::size_t triangles = t.slots.size(), points = t.points.size();
      Mesh mesh = export_triangulation(domain, {}, (*filling)->points(), Threads(threads));
      ASSERT_TRUE((*filling)->lay(mesh, Threads(threads)));
      const Certificate certificate = check(pslg, mesh, {.min_angle_deg = 0});
      EXPECT_TRUE(certificate.valid) << "patches and domain together are a constrained Delaunay triangulation\n"
                                     << to_text(certificate);
      EXPECT_EQ(mesh.triangles.size(), triangles + (*filling)->triangles());
      EXPECT_EQ(mesh.points.size(), points + (*filling)->inner_points());
      EXPECT_EQ(mesh.origin.size(), mesh.points.size());
      const auto is_laid = [&](const Triangle& triangle) {
        const Point a = mesh.points[triangle.v[0]], b = mesh.points[triangle.v[1]], c = mesh.points[triangle.v[2]];
        const auto is_edge = [&](Point p, Point q) { return std::abs(distance_to(p, p, q) - edge) < 1e-9 * edge; };
        return is_edge(a, b) && is_edge(b, c) && is_edge(c, a);
      };
      EXPECT_TRUE(std::all_of(mesh.triangles.begin() + triangles, mesh.triangles.end(), is_laid));
    }
  }
}

TEST(Filling, gives_each_region_its_own_lattice) {
  const auto pslg = domains::generate("regions", 0, 1);
  ASSERT_TRUE(pslg);
  std::vector<double> edges(pslg->regions.size() + 1, INFINITY);
  for (std::size_t r = 0; r < pslg->regions.size(); ++r) edges[r] = extent(*pslg) / (20 + 9 * static_cast<double>(r));
  auto filling = filled(*pslg, edges);
  ASSERT_TRUE(filling && *filling);
  Mesh mesh = mesh_around_patches(**filling, *pslg);
  ASSERT_TRUE((*filling)->lay(mesh, {}));
  ASSERT_EQ(mesh.region.size(), mesh.triangles.size());
  const Certificate certificate = check(*pslg, mesh, {.min_angle_deg = 0});
  EXPECT_TRUE(certificate.valid) << "each triangle belongs to its region\n" << to_text(certificate);
}

TEST(Filling, keeps_the_limits_on_vertices_and_memory) {
  const Pslg pslg = domains::square();
  const auto with = [&](const Options& options) { return filled(pslg, std::array{0.01}, options); };
  auto whole = with({});
  ASSERT_TRUE(whole && *whole);
  const std::uint64_t vertices = (*whole)->points().size() + (*whole)->inner_points();
  Options options;
  options.max_vertices = vertices;
  EXPECT_TRUE(with(options)->has_value());
  options.max_vertices = vertices - 1;
  EXPECT_FALSE(with(options)->has_value());
  options.max_vertices = 0;
  options.max_memory = 1000;
  ASSERT_FALSE(with(options));
  EXPECT_EQ(with(options).error().kind, ErrorKind::resources);
}

TEST(Filling, has_no_edges_shorter_than_allowed_and_keeps_such_a_distance_from_everything) {
  EXPECT_TRUE(filled(domains::square(), std::array{0.1}, {.min_edge = 0.0699})->has_value());
  EXPECT_FALSE(filled(domains::square(), std::array{0.1}, {.min_edge = 0.0701})->has_value());
}

TEST(Filling, refuses_more_triangles_than_the_engine_can_number) {
  const auto filling = filled(domains::square(), std::array{4e-5});
  ASSERT_FALSE(filling);
  EXPECT_EQ(filling.error().kind, ErrorKind::resources);
}

TEST(BorderEdges, go_around_each_patch_and_lie_on_the_right_of_no_patch) {
  const DomainTriangulation square = coarse(domains::square());
  const auto patches = find_patches(square.triangulation, std::array{0.1}, {}, {});
  std::vector<VertexId> border(patches[0].patch.border_points());
  for (std::size_t i = 0; i < border.size(); ++i) border[i] = static_cast<VertexId>(1000 - i);
  const BorderEdges edges(patches, border);
  EXPECT_EQ(edges.all().size(), border.size()) << "the patch has one simple border";
  for (const BorderEdge& e : edges.all()) {
    EXPECT_EQ(std::ranges::count(edges.all(), e.to, &BorderEdge::from), 1);
    EXPECT_EQ(edges.find(e.from, e.to), &e);
    EXPECT_EQ(edges.find(e.to, e.from), nullptr);
    EXPECT_EQ(edges.find(e.from, 2000), nullptr);
    EXPECT_LT(e.triangle, patches[0].patch.triangles());
  }
}

TEST(CutOut, notices_that_a_border_is_missing) {
  Triangulation t = coarse(domains::square()).triangulation;
  const auto patches = find_patches(t, std::array{0.1}, {}, {});
  ASSERT_FALSE(patches.empty());
  const std::vector<VertexId> wrong(patches[0].patch.border_points(), 0);
  EXPECT_FALSE(cut_out(t, wrong, BorderEdges(patches, wrong), {}));
}

TEST(LayPatches, notices_that_a_border_edge_has_been_split) {
  const Pslg pslg = domains::square();
  auto filling = filled(pslg, std::array{0.1});
  ASSERT_TRUE(filling && *filling);
  Mesh mesh = mesh_around_patches(**filling, pslg);
  // Points on the border follow those of the domain.
  const auto split = std::ranges::find_if(mesh.triangles.span(), [&](const Triangle& triangle) {
    return triangle.n[0] == no_index && std::min(triangle.v[1], triangle.v[2]) >= pslg.points.size();
  });
  ASSERT_TRUE(split != mesh.triangles.span().end());
  split->v[1] = split->v[0];
  const Status laid = (*filling)->lay(mesh, {});
  ASSERT_FALSE(laid);
  EXPECT_EQ(laid.error().kind, ErrorKind::internal);
}

TEST(EdgeOfPatch, keeps_both_bounds) {
  EXPECT_NEAR(edge_of_patch(std::sqrt(3.0) / 4, INFINITY), 0.9995, 1e-15);
  EXPECT_NEAR(edge_of_patch(INFINITY, 2), 1.999, 1e-15);
  EXPECT_EQ(edge_of_patch(1, 0.5), edge_of_patch(INFINITY, 0.5));
  EXPECT_EQ(edge_of_patch(INFINITY, INFINITY), INFINITY);
}

}  // namespace
}  // namespace pardel::engine
