#include "triangle_sections.hpp"

namespace pardel::files {

PointHeader read_point_header(TextReader& in) {
  PointHeader header;
  in.expect_line("the number of points");
  header.points = in.count("the number of points");
  in.integer_or("the dimension", 2, 2, 2);
  header.attributes = static_cast<std::size_t>(
      in.integer_or("the number of attributes per point", 0, std::numeric_limits<std::int32_t>::max(), 0));
  header.markers = in.integer_or("the number of markers per point", 0, 1, 0) == 1;
  if (header.points > max_points) in.fail("announces more than " + std::to_string(max_points) + " points");
  return header;
}

SegmentHeader read_segment_header(TextReader& in) {
  SegmentHeader header;
  in.expect_line("the number of segments");
  header.segments = in.count("the number of segments");
  header.markers = in.integer_or("the number of markers per segment", 0, 1, 0) == 1;
  return header;
}

Segment read_segment(TextReader& line, const SegmentHeader& header, std::size_t points, int base) {
  Segment segment;
  line.integer("a segment's number", any_marker_low, any_marker_high);
  segment.a = read_point_index(line, "an end of a segment", points, base);
  segment.b = read_point_index(line, "an end of a segment", points, base);
  if (header.markers) {
    segment.marker = static_cast<int>(line.integer("a segment's marker", any_marker_low, any_marker_high));
  }
  return segment;
}

SegmentSection read_segments(TextReader& in, std::size_t points, int base) {
  const SegmentHeader header = read_segment_header(in);
  SegmentSection section{{}, header.markers};
  if (!in.room_for(header.segments, bytes_of_segment(header), "segments")) return section;
  section.segments.resize(header.segments);
  read_records(in, "segment", 0, header.segments, [&](TextReader& line, std::size_t i) {
    section.segments[i] = read_segment(line, header, points, base);
  });
  return section;
}

void read_holes(TextReader& in, std::vector<Point>& holes) {
  in.expect_line("the number of holes");
  const std::size_t n = in.count("the number of holes");
  if (!in.room_for(n, text_bytes(3), "holes")) return;
  holes.resize(n);
  for (std::size_t i = 0; i < n && in.expect_record("hole", i, n); ++i) {
    in.integer("a hole's number", any_marker_low, any_marker_high);
    holes[i].x = in.number("an x coordinate");
    holes[i].y = in.number("a y coordinate");
    if (in.failed()) return;
  }
}

void read_regions(TextReader& in, std::vector<Region>& regions) {
  if (!in.next_line()) return;
  const std::size_t n = in.count("the number of regions");
  if (!in.room_for(n, text_bytes(4), "regions")) return;
  regions.resize(n);
  for (std::size_t i = 0; i < n && in.expect_record("region", i, n); ++i) {
    in.integer("a region's number", any_marker_low, any_marker_high);
    regions[i].seed.x = in.number("an x coordinate");
    regions[i].seed.y = in.number("a y coordinate");
    regions[i].attribute = in.number("a region's attribute");
    const double area = in.has_field() ? in.number("a region's maximum area") : regions[i].attribute;
    if (area > 0) regions[i].max_area = area;
    if (in.failed()) return;
  }
}

}  // namespace pardel::files
