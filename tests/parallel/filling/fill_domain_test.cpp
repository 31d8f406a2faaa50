// Patches in whole domains: they keep their distance, miss no place, and fit into the triangulation.
#include "../../../parallel/filling/fill_domain.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

#include "../../../parallel/filling/find_patches.hpp"
#include "../../../parallel/filling/lay_patches.hpp"
#include "../../../properties/domains/domains.hpp"
#include "../samples.hpp"
#include "distance_to.hpp"

namespace pardel::engine {
namespace {

/// The distance from p to the nearest point or segment of a domain.
double clearance(const Pslg& pslg, Point p) {
  double least = INFINITY;
  for (const Point q : pslg.points) least = std::min(least, distance_to(q, q, p));
  for (const Segment& s : pslg.segments) least = std::min(least, distance_to(pslg.points[s.a], pslg.points[s.b], p));
  return least;
}

DomainTriangulation coarse(const Pslg& pslg) {
  Result<DomainTriangulation> domain = triangulate_domain(pslg, false);
  EXPECT_TRUE(domain);
  return std::move(domain).value();
}

bool is_in_domain(const DomainTriangulation& domain, Point p) {
  const Triangulation& t = domain.triangulation;
  return std::any_of(t.slots.begin(), t.slots.end(), [&](const Slot& slot) {
    const Point a = t.points[slot.v[0]], b = t.points[slot.v[1]], c = t.points[slot.v[2]];
    const auto left = [&](Point from, Point to) {
      return (to.x - from.x) * (p.y - from.y) - (to.y - from.y) * (p.x - from.x) >= 0;
    };
    return left(a, b) && left(b, c) && left(c, a);
  });
}

std::vector<Pslg> domains_to_fill() {
  std::vector<Pslg> all{domains::square(), domains::pipe()};
  for (const char* name : {"key", "star", "cracks", "touching-holes"})
    if (auto domain = domains::generate(name, 0, 1)) all.push_back(std::move(*domain));
  all.front().points.push_back({0.4, 0.6});  // a point without segments
  return all;
}

double extent(const Pslg& pslg) {
  double extent = 0;
  for (const Point p : pslg.points) extent = std::max({extent, p.x - pslg.points[0].x, p.y - pslg.points[0].y});
  return extent;
}

TEST(FindPatches, takes_all_triangles_of_the_lattice_that_are_far_enough_from_everything) {
  for (const Pslg& pslg : domains_to_fill()) {
    const DomainTriangulation domain = coarse(pslg);
    const double edge = extent(pslg) / 23;
    const auto found = find_patches(domain.triangulation, std::array{edge}, {});
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].region, no_index);
    const Patch& patch = found[0].patch;
    std::set<std::pair<int, int>> places;
    for (const Piece& piece : patch.pieces())
      for (int x = piece.low; x <= piece.high; x += 2) {
        places.emplace(piece.row, x);
        EXPECT_GE(clearance(pslg, patch.lattice().at(x, piece.row)), 0.7 * edge * (1 - 1e-9));
        EXPECT_TRUE(is_in_domain(domain, patch.lattice().at(x, piece.row)));
      }
    const auto fits = [&](int x, int row) {
      const Point p = patch.lattice().at(x, row);
      return is_in_domain(domain, p) && clearance(pslg, p) > 0.7 * edge * (1 + 1e-9);
    };
    for (int row = 0; row < 60; ++row)
      for (int x = row % 2; x < 120; x += 2)
        if (fits(x, row) && fits(x + 2, row) && fits(x + 1, row + 1)) {
          EXPECT_TRUE(places.contains({row, x}));
        }
  }
}

TEST(FindPatches, makes_none_without_a_bound_or_beyond_double_precision) {
  const DomainTriangulation square = coarse(domains::square());
  EXPECT_TRUE(find_patches(square.triangulation, std::array{double{INFINITY}}, {}).empty());
  EXPECT_TRUE(find_patches(square.triangulation, std::array{3.0}, {}).empty()) << "no triangle fits";
  EXPECT_FALSE(find_patches(square.triangulation, std::array{0.1}, {}).empty());
  const DomainTriangulation far = coarse(domains::moved(domains::square(), 1e9, 0));
  EXPECT_TRUE(find_patches(far.triangulation, std::array{0.1}, {}).empty());
}

TEST(FillDomain, gives_a_constrained_delaunay_triangulation_of_the_same_area) {
  for (const Pslg& pslg : domains_to_fill()) {
    const DomainTriangulation domain = coarse(pslg);
    const double edge = extent(pslg) / 31, area = samples::twice_area(domain.triangulation);
    for (const int threads : {1, 3}) {
      const auto filled = fill_domain(pslg, false, domain, std::array{edge}, {}, Threads(threads));
      ASSERT_TRUE(filled && *filled);
      const Triangulation& t = (*filled)->domain.triangulation;
      EXPECT_EQ(samples::fault(t), "");
      EXPECT_NEAR(samples::twice_area(t), area, 1e-12 * area);
      EXPECT_EQ(t.origin.size(), t.points.size());
      const auto laid = std::count_if(t.slots.begin(), t.slots.end(), [&](const Slot& slot) {
        const Point a = t.points[slot.v[0]], b = t.points[slot.v[1]], c = t.points[slot.v[2]];
        const auto is_edge = [&](Point p, Point q) { return std::abs(distance_to(p, p, q) - edge) < 1e-9 * edge; };
        return is_edge(a, b) && is_edge(b, c) && is_edge(c, a);
      });
      EXPECT_GE(static_cast<std::size_t>(laid), (*filled)->triangles);
      const auto settled = static_cast<std::ptrdiff_t>((*filled)->domain.settled_from);
      EXPECT_TRUE(
          std::none_of(t.slots.begin() + settled, t.slots.end(), [](const Slot& s) { return s.any_constrained(); }));
      EXPECT_GT((*filled)->triangles, 20U);
    }
  }
}

TEST(FillDomain, gives_each_region_its_own_lattice) {
  const auto pslg = domains::generate("regions", 0, 1);
  ASSERT_TRUE(pslg);
  const DomainTriangulation domain = coarse(*pslg);
  std::vector<double> edges(pslg->regions.size() + 1, INFINITY);
  for (std::size_t r = 0; r < pslg->regions.size(); ++r) edges[r] = extent(*pslg) / (20 + 9 * static_cast<double>(r));
  const auto filled = fill_domain(*pslg, false, domain, edges, {}, {});
  ASSERT_TRUE(filled && *filled);
  const Triangulation& t = (*filled)->domain.triangulation;
  EXPECT_EQ(samples::fault(t), "");
  ASSERT_EQ(t.region.size(), t.slots.size());
  // The area of each region stays the same.
  const auto areas = [&](const Triangulation& of) {
    std::vector<double> area(edges.size(), 0);
    for (TriangleId id = 0; id < of.slots.size(); ++id) {
      const Slot& slot = of.slots[id];
      const Point a = of.points[slot.v[0]], b = of.points[slot.v[1]], c = of.points[slot.v[2]];
      area[std::min<std::size_t>(of.region[id], edges.size() - 1)] +=
          (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    }
    return area;
  };
  const auto before = areas(domain.triangulation), after = areas(t);
  for (std::size_t r = 0; r < before.size(); ++r) EXPECT_NEAR(before[r], after[r], 1e-12 * (1 + before[r]));
}

TEST(FillDomain, keeps_the_limits_on_vertices_and_memory) {
  const Pslg pslg = domains::square();
  const DomainTriangulation square = coarse(pslg);
  const auto filled = [&](const Options& options) {
    return fill_domain(pslg, false, square, std::array{0.01}, options, {});
  };
  const auto whole = filled({});
  ASSERT_TRUE(whole && *whole);
  const std::uint64_t vertices = (*whole)->domain.triangulation.points.size();
  Options options;
  options.max_vertices = vertices;
  EXPECT_TRUE(filled(options)->has_value());
  options.max_vertices = vertices - 1;
  EXPECT_FALSE(filled(options)->has_value());
  options.max_vertices = 0;
  options.max_memory = 1000;
  ASSERT_FALSE(filled(options));
  EXPECT_EQ(filled(options).error().kind, ErrorKind::resources);
}

TEST(FillDomain, refuses_more_triangles_than_the_engine_can_number) {
  const Pslg pslg = domains::square();
  const auto filled = fill_domain(pslg, false, coarse(pslg), std::array{4e-5}, {}, {});
  ASSERT_FALSE(filled);
  EXPECT_EQ(filled.error().kind, ErrorKind::resources);
}

TEST(LayPatches, notices_that_a_border_is_missing) {
  const DomainTriangulation square = coarse(domains::square());
  const auto patches = find_patches(square.triangulation, std::array{0.1}, {});
  ASSERT_FALSE(patches.empty());
  Triangulation t = square.triangulation;
  const std::vector<VertexId> wrong(patches[0].patch.border_points(), 0);
  EXPECT_FALSE(lay_patches(t, patches, wrong, {}));
}

TEST(EdgeOfPatch, keeps_both_bounds) {
  EXPECT_NEAR(edge_of_patch(std::sqrt(3.0) / 4, INFINITY), 0.9995, 1e-15);
  EXPECT_NEAR(edge_of_patch(INFINITY, 2), 1.999, 1e-15);
  EXPECT_EQ(edge_of_patch(1, 0.5), edge_of_patch(INFINITY, 0.5));
  EXPECT_EQ(edge_of_patch(INFINITY, INFINITY), INFINITY);
}

}  // namespace
}  // namespace pardel::engine
