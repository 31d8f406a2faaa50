// Patches are cut out of a domain and laid again.
#include "../../../parallel/filling/filling.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "../../../parallel/patches/cut_out.hpp"
#include "../../../parallel/patches/lay_patches.hpp"
#include "../patches/distance_to.hpp"
#include "../patches/domains_to_fill.hpp"
#include "../samples.hpp"

namespace pardel::engine {
namespace {

Result<std::optional<Filling>> filled(const Pslg& pslg, std::span<const double> edges, const Options& options = {},
                                      int threads = 1) {
  return Filling::make(pslg, false, coarse(pslg), edges, {}, options, Threads(threads));
}

/// Twice the area of each region, and last of the triangles without a region.
std::vector<double> areas(const Triangulation& t, std::size_t regions) {
  std::vector<double> area(regions + 1, 0);
  for (TriangleId id = 0; id < t.slots.size(); ++id) {
    const Slot& slot = t.slots[id];
    const Point a = t.points[slot.v[0]], b = t.points[slot.v[1]], c = t.points[slot.v[2]];
    area[std::min<std::size_t>(t.region.empty() ? no_index : t.region[id], regions)] +=
        (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  }
  return area;
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
      Triangulation t = (*filling)->take_domain().triangulation;
      const double laid = std::sqrt(3.0) / 2 * edge * edge * static_cast<double>((*filling)->triangles());
      EXPECT_GT((*filling)->triangles(), 20U);
      EXPECT_EQ(samples::fault(t), "");
      EXPECT_NEAR(samples::twice_area(t), area - laid, 1e-12 * area);
      EXPECT_GT(edges_on_border(t), 10U);
      EXPECT_EQ(t.points.size(), (*filling)->points().size());

      const std::size_t triangles = t.slots.size(), points = t.points.size();
      ASSERT_TRUE((*filling)->lay(t, Threads(threads)));
      EXPECT_EQ(samples::fault(t), "") << "patches and domain together are a constrained Delaunay triangulation";
      EXPECT_NEAR(samples::twice_area(t), area, 1e-12 * area);
      EXPECT_EQ(edges_on_border(t), 0U);
      EXPECT_EQ(t.slots.size(), triangles + (*filling)->triangles());
      EXPECT_EQ(t.points.size(), points + (*filling)->inner_points());
      EXPECT_EQ(t.origin.size(), t.points.size());
      EXPECT_EQ(std::count(t.origin.begin(), t.origin.end(), border_vertex), 0);
      const auto is_laid = [&](const Slot& slot) {
        const Point a = t.points[slot.v[0]], b = t.points[slot.v[1]], c = t.points[slot.v[2]];
        const auto is_edge = [&](Point p, Point q) { return std::abs(distance_to(p, p, q) - edge) < 1e-9 * edge; };
        return is_edge(a, b) && is_edge(b, c) && is_edge(c, a);
      };
      EXPECT_TRUE(std::all_of(t.slots.begin() + static_cast<std::ptrdiff_t>(triangles), t.slots.end(), is_laid));
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
  Triangulation t = (*filling)->take_domain().triangulation;
  EXPECT_EQ(samples::fault(t), "");
  ASSERT_TRUE((*filling)->lay(t, {}));
  EXPECT_EQ(samples::fault(t), "");
  ASSERT_EQ(t.region.size(), t.slots.size());
  const auto before = areas(coarse(*pslg).triangulation, pslg->regions.size()), after = areas(t, pslg->regions.size());
  for (std::size_t r = 0; r < before.size(); ++r) EXPECT_NEAR(before[r], after[r], 1e-12 * (1 + before[r]));
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

TEST(Filling, has_no_edges_shorter_than_allowed) {
  EXPECT_TRUE(filled(domains::square(), std::array{0.1}, {.min_edge = 0.0999})->has_value());
  EXPECT_FALSE(filled(domains::square(), std::array{0.1}, {.min_edge = 0.1001})->has_value());
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
  const std::vector<BorderEdge> edges = border_edges(patches, border);
  EXPECT_EQ(edges.size(), border.size()) << "the patch has one simple border";
  EXPECT_TRUE(std::ranges::is_sorted(edges, {}, &BorderEdge::ends));
  for (const BorderEdge& e : edges) {
    EXPECT_EQ(std::ranges::count(edges, e.to, &BorderEdge::from), 1);
    EXPECT_LT(e.triangle, patches[0].patch.triangles());
  }
}

TEST(CutOut, notices_that_a_border_is_missing) {
  Triangulation t = coarse(domains::square()).triangulation;
  const auto patches = find_patches(t, std::array{0.1}, {}, {});
  ASSERT_FALSE(patches.empty());
  const std::vector<VertexId> wrong(patches[0].patch.border_points(), 0);
  EXPECT_FALSE(cut_out(t, wrong, border_edges(patches, wrong), {}));
}

TEST(LayPatches, notices_that_a_border_edge_has_been_split) {
  const Pslg pslg = domains::square();
  auto filling = filled(pslg, std::array{0.1});
  ASSERT_TRUE(filling && *filling);
  Triangulation t = (*filling)->take_domain().triangulation;
  *std::find(t.origin.begin(), t.origin.end(), border_vertex) = interior_vertex;
  const Status laid = (*filling)->lay(t, {});
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
