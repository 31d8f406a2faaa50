#include "../../off_the_shelf/meshers/hole_seeds.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "../../core/neighbours.hpp"
#include "../../parallel/mesher.hpp"
#include "../../properties/domains/domains.hpp"

namespace pardel::engine {
namespace {

/// The triangles of a domain that `wanted` accepts by their centroids.
template <class Wanted>
Subdomain part_of(const Pslg& pslg, const Wanted& wanted) {
  const Result<Meshed> meshed = triangulate(pslg);
  const Mesh& mesh = meshed->mesh;
  Subdomain part;
  part.points.assign(mesh.points.begin(), mesh.points.end());
  const auto is_in = [&](const Triangle& t) {
    const Point a = mesh.points[t.v[0]], b = mesh.points[t.v[1]], c = mesh.points[t.v[2]];
    return wanted(Point{(a.x + b.x + c.x) / 3, (a.y + b.y + c.y) / 3});
  };
  for (const Triangle& t : mesh.triangles) {
    if (!is_in(t)) continue;
    part.triangles.push_back(t.v);
    for (int i = 0; i < 3; ++i)
      if (t.n[i] == no_index || !is_in(mesh.triangles[t.n[i]]))
        part.edges.push_back({t.v[(i + 1) % 3], t.v[(i + 2) % 3]});
  }
  return part;
}

bool everywhere(Point) { return true; }

std::vector<Point> seeds_of(const Subdomain& part) {
  const Result<std::vector<Point>> seeds = hole_seeds(part);
  if (seeds) return *seeds;
  ADD_FAILURE() << seeds.error().message;
  return {};
}

/// True if the seeds, with the border, stand for the triangles of the part.
bool fits(const Subdomain& part, const std::vector<Point>& seeds) {
  Pslg pslg;
  pslg.points = part.points;
  for (const SubdomainEdge& e : part.edges) pslg.segments.push_back({e.a, e.b});
  pslg.holes = seeds;
  const Result<Meshed> again = triangulate(pslg);
  return again.ok() && again->mesh.triangles.size() == part.triangles.size();
}

TEST(HoleSeeds, are_none_without_holes) {
  EXPECT_TRUE(seeds_of(part_of(domains::square(), everywhere)).empty());
  EXPECT_TRUE(seeds_of(part_of(domains::grid(4), [](Point p) { return p.x < 3 || p.y < 1; })).empty());
}

TEST(HoleSeeds, lie_in_each_hole) {
  const Subdomain pipe = part_of(domains::pipe(), everywhere);
  EXPECT_EQ(seeds_of(pipe).size(), 7U);
  EXPECT_TRUE(fits(pipe, seeds_of(pipe)));
}

TEST(HoleSeeds, lie_in_holes_that_touch) {
  const Subdomain part = part_of(domains::touching_holes(), everywhere);
  EXPECT_TRUE(fits(part, seeds_of(part)));
  EXPECT_FALSE(fits(part, {}));
}

TEST(HoleSeeds, lie_around_islands_in_holes) {
  const auto ring = [](Point p) {
    const double far = std::max(std::abs(p.x - 4.5), std::abs(p.y - 4.5));
    return far > 3.5 || far < 1.5;
  };
  const Subdomain part = part_of(domains::grid(9), ring);
  EXPECT_EQ(seeds_of(part).size(), 1U);
  EXPECT_TRUE(std::ranges::none_of(seeds_of(part), ring));
}

TEST(HoleSeeds, are_an_error_if_borders_cross) {
  Subdomain crossed;
  crossed.points = {{0, 0}, {1, 1}, {1, 0}, {0, 1}};
  crossed.edges = {{0, 1}, {1, 2}, {2, 3}, {3, 0}};
  EXPECT_FALSE(hole_seeds(crossed).ok());
}

}  // namespace
}  // namespace pardel::engine
