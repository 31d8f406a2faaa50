// Sections of Triangle's files: points (.node, .poly) and segments (.poly). The conventions are those of "Triangle's
// file formats" (www.cs.cmu.edu/~quake/triangle.html).
#pragma once

#include <limits>
#include <vector>

#include "../pslg.hpp"
#include "read_records.hpp"
#include "text_reader.hpp"

namespace pardel::files {

/// The largest number of points of a mesh. The three largest indices have other meanings (see mesh.hpp).
inline constexpr std::size_t max_points = no_index - 3;

inline constexpr std::int64_t any_marker_low = std::numeric_limits<int>::min();
inline constexpr std::int64_t any_marker_high = std::numeric_limits<int>::max();

/// `<# of points> <dimension, 2> <# of attributes> <# of markers, 0 or 1>`. The last three default to 2, 0, 0.
struct PointHeader {
  std::size_t points = 0;
  std::size_t attributes = 0;
  bool markers = false;
};
PointHeader read_point_header(TextReader& in);

/// Reads the number of record i, which must be base + i.
inline void read_number(TextReader& in, std::string_view what, std::size_t i, int base) {
  const auto number = static_cast<std::int64_t>(i) + base;
  const std::int64_t found = in.integer(what, 0, std::numeric_limits<std::int64_t>::max());
  if (found != number && !in.failed()) {
    in.fail("expected " + std::string(what) + " " + std::to_string(number) + " (numbers are consecutive), found " +
            std::to_string(found));
  }
}

/// Reads n records with consecutive numbers: read(in, i) reads what follows the number of record i. Returns the first
/// number, 0 or 1; `first` is its name in messages. Returns 1 if there is no record.
template <class Read>
int read_numbered_records(TextReader& in, std::string_view what, std::string_view first, std::size_t n,
                          const Read& read) {
  if (n == 0 || !in.expect_record(what, 0, n)) return 1;
  const int base = static_cast<int>(in.integer(first, 0, 1));
  read(in, 0);
  read_records(in, what, 1, n, [&](TextReader& line, std::size_t i) {
    read_number(line, what, i, base);
    read(line, i);
  });
  return base;
}

/// Makes room for n points with attributes and markers. PointSet: a Pslg, a Mesh or a PartOfPoints.
template <class PointSet>
void resize_points(PointSet& set, std::size_t n, const PointHeader& header) {
  set.points.resize(n);
  set.attributes_per_point = header.attributes;
  set.point_attributes.resize(n * header.attributes);
  set.point_markers.resize(header.markers ? n : 0);
}

/// Reads what follows the number of point i: `<x> <y> [attributes] [marker]`.
template <class PointSet>
void read_point(TextReader& line, const PointHeader& header, PointSet& set, std::size_t i) {
  const double x = line.number("an x coordinate");
  const double y = line.number("a y coordinate");
  set.points[i] = {x, y};
  for (std::size_t k = 0; k < header.attributes; ++k) {
    set.point_attributes[i * header.attributes + k] = line.number("a point's attribute");
  }
  if (header.markers) {
    set.point_markers[i] = static_cast<int>(line.integer("a point's marker", any_marker_low, any_marker_high));
  }
}

/// The least number of bytes of a point.
[[nodiscard]] constexpr std::size_t bytes_of_point(const PointHeader& header) {
  return text_bytes(3 + header.attributes + (header.markers ? 1 : 0));
}

/// Reads `<point #> <x> <y> [attributes] [marker]`, header.points times. Returns the base: the number of the first
/// point, 0 or 1. Returns 1 if there is no point.
template <class PointSet>
int read_points(TextReader& in, const PointHeader& header, PointSet& set) {
  if (!in.room_for(header.points, bytes_of_point(header), "points")) return 1;
  resize_points(set, header.points, header);
  return read_numbered_records(in, "point", "the first point's number", header.points,
                               [&](TextReader& line, std::size_t i) { read_point(line, header, set, i); });
}

/// `<# of segments> <# of markers, 0 or 1>`.
struct SegmentHeader {
  std::size_t segments = 0;
  bool markers = false;
};
SegmentHeader read_segment_header(TextReader& in);

/// The least number of bytes of a segment.
[[nodiscard]] constexpr std::size_t bytes_of_segment(const SegmentHeader& header) {
  return text_bytes(header.markers ? 4 : 3);
}

/// `<segment #> <end> <end> [marker]`. The number of the segment is ignored. `points`: how many points there are.
/// `base`: the number of the first point.
[[nodiscard]] Segment read_segment(TextReader& line, const SegmentHeader& header, std::size_t points, int base);

/// The header, then the segments.
struct SegmentSection {
  std::vector<Segment> segments;
  bool markers = false;
};
SegmentSection read_segments(TextReader& in, std::size_t points, int base);

/// `<# of holes>`, then `<hole #> <x> <y>`.
void read_holes(TextReader& in, std::vector<Point>& holes);

/// Optional: `<# of regions>`, then `<region #> <x> <y> <attribute> <maximum area>`. If there is only one value after
/// y, it is both the attribute and the area. An area that is not positive means no bound.
void read_regions(TextReader& in, std::vector<Region>& regions);

/// Reads the number of a point and returns its index.
inline Index read_point_index(TextReader& in, std::string_view what, std::size_t points, int base) {
  if (points == 0) {
    in.fail("expected no point, as there are none, found one as " + std::string(what));
    return 0;
  }
  return static_cast<Index>(in.integer(what, base, static_cast<std::int64_t>(points) - 1 + base) - base);
}

}  // namespace pardel::files
