// Pslg: a planar straight-line graph, the input of the mesher and of the checker.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace pardel {

/// Index of a point, triangle, segment, hole or region, counted from 0. Files may count from 1: see FirstId.
using Index = std::uint32_t;
/// Stands for "none".
inline constexpr Index no_index = std::numeric_limits<Index>::max();

struct Point {
  double x = 0;
  double y = 0;
  friend bool operator==(const Point&, const Point&) = default;
};

/// A straight constraint between two points of a Pslg. Marker 0 means "none given".
struct Segment {
  Index a = 0;
  Index b = 0;
  int marker = 0;
  friend bool operator==(const Segment&, const Segment&) = default;
};

/// A face of a Pslg, with an attribute and an area cap for the triangles in the face.
struct Region {
  Point seed;  ///< a point inside the face
  double attribute = 0;
  double max_area = std::numeric_limits<double>::infinity();  ///< > 0; in files, a number <= 0 means no cap
  friend bool operator==(const Region&, const Region&) = default;
};

/// The number of the first point, 0 or 1, in the file that a Pslg or a Mesh was read from. Only messages use it: they
/// number points, segments, holes and regions as the file does. No result depends on it, so all values compare equal.
struct FirstId {
  int value = 0;
  friend constexpr bool operator==(FirstId, FirstId) { return true; }
};

/// Triangle's model of a domain. Segments meet only at common end points. A place is outside the domain if infinity or
/// a hole point can be reached from it without crossing a segment. A Pslg without segments stands for the convex hull
/// of its points. A Pslg may contain invalid data; validate() in parallel/validate.hpp finds the problems.
struct Pslg {
  std::vector<Point> points;
  std::size_t attributes_per_point = 0;
  std::vector<double> point_attributes;  ///< point by point: points.size() * attributes_per_point numbers
  std::vector<int> point_markers;        ///< empty, or one per point
  std::vector<Segment> segments;
  bool has_segment_markers = false;
  std::vector<Point> holes;  ///< one point inside each face that is a hole
  std::vector<Region> regions;
  FirstId first_id{};

  friend bool operator==(const Pslg&, const Pslg&) = default;
};

/// True if the Pslg has points only: no segments, holes or regions.
[[nodiscard]] inline bool is_point_set(const Pslg& pslg) {
  return pslg.segments.empty() && pslg.holes.empty() && pslg.regions.empty();
}

}  // namespace pardel
