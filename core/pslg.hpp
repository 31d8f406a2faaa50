// Pslg: a planar straight-line graph, the input of everything. Plain values; use validate() before trust.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace pardel {

/// Index of a point, triangle, segment or region. Zero-based everywhere inside; only files know base 1.
using Index = std::uint32_t;
inline constexpr Index no_index = std::numeric_limits<Index>::max();

struct Point {
  double x = 0;
  double y = 0;
  friend bool operator==(const Point&, const Point&) = default;
};

/// A straight constraint between two input points. Marker 0 means "none given".
struct Segment {
  Index a = 0;
  Index b = 0;
  int marker = 0;
  friend bool operator==(const Segment&, const Segment&) = default;
};

/// A region: the face of the PSLG that contains `seed`, with an attribute that its triangles carry and an
/// area cap (the file convention: a negative or zero cap means none; here that is +infinity).
struct Region {
  Point seed;
  double attribute = 0;
  double max_area = std::numeric_limits<double>::infinity();
  friend bool operator==(const Region&, const Region&) = default;
};

/// Triangle's model of a domain. Segments meet only at common end points (see validate()); what the
/// exterior or a hole can reach without crossing a segment is not part of the domain. A Pslg without
/// segments stands for the convex hull of its points.
struct Pslg {
  std::vector<Point> points;
  std::size_t attributes_per_point = 0;
  std::vector<double> point_attributes;  ///< row by row, points.size() * attributes_per_point
  std::vector<int> point_markers;        ///< empty, or one per point
  std::vector<Segment> segments;
  bool has_segment_markers = false;
  std::vector<Point> holes;
  std::vector<Region> regions;

  friend bool operator==(const Pslg&, const Pslg&) = default;
};

}  // namespace pardel
