// The part of a rank in a triangulation of points, and the triangles of a domain by their corners.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <memory>
#include <tuple>
#include <utility>

#include "../../../parallel/construction/insert_constraints.hpp"
#include "../../../parallel/divided_points/common_vertices.hpp"
#include "../../../parallel/divided_points/crossed_triangles.hpp"
#include "../../../parallel/given_points/triangulated_points.hpp"
#include "../given_points/part_of_rank.hpp"

namespace pardel::engine {

struct TriangulatedPart {
  TriangulatedPart(const Pslg& pslg, Ranks& ranks)
      : points(std::move(triangulated(part_of(pslg, ranks), ranks, Threads(1))).value()),
        hull(points->delaunay, points->own, ranks),
        common(hull, pslg.segments, points->delaunay, points->own, ranks) {}

  void insert_segments(Ranks& ranks) {
    LocalDelaunay& delaunay = points->delaunay;
    const OrderedConstraints constraints = ordered_constraints(common, delaunay);
    ASSERT_TRUE(learn_crossed_triangles(constraints, delaunay, points->own, ranks, {}).empty());
    ASSERT_TRUE(insert_in_order(delaunay.triangulation(), constraints.edges, {}));
  }

  std::unique_ptr<TriangulatedPoints> points;
  SharedHull hull;
  CommonVertices common;
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
