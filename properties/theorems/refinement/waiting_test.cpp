// Lattice (g): refinement on a lattice ends. The proof needs that no vertex lies in the circumdisk of a triangle that
// is split, although subsegments may be encroached and wait for their split in other cells.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "../../../ref/insertion.hpp"
#include "refined_channels.hpp"

namespace pardel::properties {
namespace {
using generators::Random;
using ref::ExactPoint;
using ref::PlainMesh;

/// A rectangle with long segments side by side in its middle.
struct Shelves {
  Pslg pslg;
  double max_area = 8, coarse_area = 16;
};
Shelves some_shelves(Random& random) {
  Shelves s;
  const double length = 2.0 * random.between(16, 24), width = 2.0 * random.between(16, 24);
  s.pslg.points = {{0, 0}, {length, 0}, {length, width}, {0, width}};
  s.pslg.segments = {{0, 1}, {1, 2}, {2, 3}, {3, 0}};
  const double slope = random.one_of<double>({-1, -0.5, 0.5, 1}), middle = width / 2 + random.between(-6, 6);
  double shift = 0;
  for (int shelves = random.between(2, 4); shelves > 0; --shelves) {
    const double reach = std::min(length / 2 - 3, (width / 2 - 12) / std::abs(slope));
    const double from = length / 2 - reach + random.between(0, 4), to = length / 2 + reach - random.between(0, 4);
    const auto height = [&](double x) { return middle + shift + slope * (x - length / 2); };
    const auto first = static_cast<Index>(s.pslg.points.size());
    s.pslg.points.push_back({from, height(from)});
    s.pslg.points.push_back({to, height(to)});
    s.pslg.segments.push_back({first, first + 1});
    shift += random.one_of<double>({0.5, 0.75, 1, 1.5});
  }
  s.coarse_area = random.one_of<double>({12, 16, 32, 64});
  s.max_area = s.coarse_area / random.one_of<double>({1, 2, 4});
  return s;
}

/// Is there a triangle with this circumcentre, rounded, whose circumdisk contains no vertex at all, and meets none of
/// the subsegments that wait?
bool splits_an_empty_circumdisk(const PlainMesh& mesh, const ExactPoint& p, const std::set<ref::Edge>& waiting) {
  return std::ranges::any_of(ref::cavity(mesh, p), [&](Index i) {
    const ref::Corners& t = mesh.triangles[i];
    const ExactPoint centre = circumcentre(mesh, t);
    if (ref::exact(ref::rounded(centre)) != p) return false;
    const auto is_met_by = [&](const ref::Edge& e) {
      const ref::Kernel::Segment_2 segment(mesh.points[e[0]], mesh.points[e[1]]);
      return CGAL::squared_distance(centre, segment) < squared_circumradius(mesh, t);
    };
    return std::ranges::none_of(waiting, is_met_by) &&
           std::ranges::none_of(mesh.points, [&](const ExactPoint& v) { return circumdisk_contains(mesh, t, v); });
  });
}

PARDEL_FACT(
    Lattice, no_triangle_is_split_while_a_subsegment_that_meets_its_circumdisk_waits,
    {.statement = "When a cell inserts the circumcentre of a bad triangle, no subsegment that has waited for its "
                  "split since the phase began meets the circumdisk of this triangle, and no vertex lies in it, "
                  "whether or not the triangle sees it. So the circumcentre is as far away from all vertices "
                  "as from the corners.",
     .source = "properties/THEORY.md, Lattice (g)",
     .families = "120 rectangles with two to four long segments side by side"}) {
  std::uint64_t triangles = 0;  // that are split while a subsegment waits
  for (std::uint64_t seed = 1; seed <= 120 && !testing::Test::HasFailure(); ++seed, ++facts.cases) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const Shelves shelves = some_shelves(random);
    Goal goal, coarse;
    goal.min_angle_deg = 20;
    goal.max_area = shelves.max_area;
    coarse.min_angle_deg = 0;
    coarse.max_area = shelves.coarse_area;
    const auto made = ref::refine_on_lattice(shelves.pslg, goal, coarse);
    ASSERT_TRUE(made) << made.error().message;
    for_each_phase(*made, [&](const LatticeSweep&, const ref::Phase& phase, const PlainMesh& before) {
      PlainMesh mesh = before;
      std::set<ref::Edge> waiting = phase.waiting_before;
      for (const auto& [cell, point] : phase.insertions) {
        const auto split = ref::constraint_through(mesh, point);
        if (split) waiting.erase(ref::edge((*split)[0], (*split)[1]));
        if (!split) {
          EXPECT_TRUE(splits_an_empty_circumdisk(mesh, point, waiting));
          triangles += !waiting.empty();
        }
        ref::insert(mesh, point);
      }
    });
  }
  EXPECT_GE(triangles, 50U);
  facts.notes.push_back(std::to_string(triangles) + " triangles were split while a subsegment waited");
}

}  // namespace
}  // namespace pardel::properties
