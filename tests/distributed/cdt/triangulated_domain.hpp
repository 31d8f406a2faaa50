// The part of a rank in a triangulation of points, and the triangles of a domain by their corners.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <memory>
#include <tuple>
#include <utility>
#include <vector>

#include "../../../distributed/cdt/common_segments.hpp"
#include "../../../distributed/cdt/own_segments.hpp"
#include "../../../distributed/cdt/sides_of_triangles.hpp"
#include "../../../distributed/delaunay/triangulated_points.hpp"
#include "../../../parallel/construction/insert_constraints.hpp"
#include "../delaunay/part_of_rank.hpp"

namespace pardel::engine {

struct TriangulatedPart {
  TriangulatedPart(const Pslg& pslg, Ranks& ranks)
      : points(std::move(triangulated(part_of(pslg, ranks), ranks, Threads(1))).value()),
        hull(points->delaunay, points->own, ranks) {
    read = send_to_owners_of_ends(part_of_segments(pslg, ranks), *points, ranks);
  }

  void divide(Ranks& ranks) {
    segments = divide_segments(std::vector(read.segments), hull, points->delaunay, points->own, ranks, {});
  }

  void insert_segments(Ranks& ranks) {
    divide(ranks);
    ASSERT_FALSE(segments.pass_points);
    LocalDelaunay& delaunay = points->delaunay;
    const std::vector<Constraint> sides = learn_sides(segments.own, delaunay, points->own, ranks);
    std::vector<Constraint> crossing;
    for (const GivenSegment& s : segments.common) crossing.push_back({delaunay.vertex(s.a), delaunay.vertex(s.b)});
    constrain(sides, delaunay);
    ASSERT_TRUE(insert_in_order(delaunay.triangulation(), crossing, {}));
  }

  std::unique_ptr<TriangulatedPoints> points;
  SharedHull hull;
  OwnSegments read;
  DividedSegments segments;
};

/// The corners, counter-clockwise from the least one.
using Corners = std::array<std::pair<double, double>, 3>;
inline Corners corners_of(const Triangulation& t, const Slot& slot) {
  Corners corners;
  for (unsigned i = 0; i < 3; ++i) corners[i] = {t.points[slot.v[i]].x, t.points[slot.v[i]].y};
  std::rotate(corners.begin(), std::ranges::min_element(corners), corners.end());
  return corners;
}

}  // namespace pardel::engine
