// Drawings of domains: points, lines and polygons, of any program or file.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "../core/pslg.hpp"
#include "../core/size_source.hpp"

namespace pardel::cli {

/// A polygon as it was drawn: the outer ring, then the rings of its holes. The first point of a ring is not repeated.
struct DrawnPolygon {
  std::vector<std::vector<Point>> rings;
  bool is_hole = false;
  std::optional<double> attribute;  ///< of its region
  std::optional<double> max_area;   ///< > 0
  std::optional<double> length{};   ///< > 0, wanted inside
};

/// The points and segments of all shapes, and the polygons, whose faces are not yet known.
struct DrawnDomain {
  Pslg pslg;  ///< without holes and regions
  std::vector<DrawnPolygon> polygons;
  std::vector<SizeSource> sources{};  ///< the points, lines and borders of polygons that have a length
};

/// True if a hole is not in the outline of its polygon: one of its points lies outside, and none lies inside. Points
/// that lie on a side, up to rounding, do not count. O(n) if the first point lies inside, else O(n m).
[[nodiscard]] bool lies_outside(std::span<const Point> hole, std::span<const Point> outline);

/// What is known about a shape. `marker`: of its segments; 0: none. The others: as in DrawnPolygon.
struct ShapeProperties {
  int marker = 0;
  bool has_marker = false;
  bool is_hole = false;
  std::optional<double> attribute{}, max_area{}, length{};
};

/// Collects shapes. Equal points become one, and so do segments with the same ends, which get the first marker that is
/// not 0. A segment without length is left out. Coordinates are finite. Time O(log n) for each point.
class Drawing {
 public:
  void add_point(Point p, const ShapeProperties& properties);
  void add_line(std::span<const Point> line, const ShapeProperties& properties);
  /// No ring: no polygon. The first point of a ring is not repeated.
  void add_polygon(std::vector<std::vector<Point>> rings, const ShapeProperties& properties);

  [[nodiscard]] DrawnDomain take() && { return std::move(domain_); }

 private:
  [[nodiscard]] Index index_of(Point p);
  void add_source(Point from, Point to, const ShapeProperties& properties);
  void add_segment(Point from, Point to, const ShapeProperties& properties);

  DrawnDomain domain_;
  std::map<std::pair<double, double>, Index> index_of_point_;
  std::map<std::pair<Index, Index>, std::size_t> segment_between_;
};

}  // namespace pardel::cli
