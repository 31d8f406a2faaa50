// Reads Triangle's input files .poly, .node and .area, and the similar files with one size per vertex.
#include <limits>

#include "../formats.hpp"
#include "../support/byte_order_mark.hpp"
#include "../support/open_file.hpp"
#include "../support/shortest.hpp"
#include "mesh_readers.hpp"
#include "triangle_sections.hpp"

namespace pardel {
using namespace files;
namespace {

namespace fs = std::filesystem;

/// Reads the points from a .node file.
Status read_node(const fs::path& node, Pslg& pslg, StopSignal* stop) {
  const auto text = read_file(node, stop);
  if (!text.ok()) return text.error();
  TextReader in(*text, node.string(), stop);
  pslg.first_id = {read_points(in, read_point_header(in), pslg)};
  if (in.failed()) return in.error();
  return Done{};
}

/// `node`: the file that has the points if the point section is empty; null if the text itself must have the points.
Result<Pslg> read_poly(TextReader& in, const fs::path* node, StopSignal* stop) {
  Pslg pslg;
  const PointHeader header = read_point_header(in);
  if (header.points > 0) {
    pslg.first_id = {read_points(in, header, pslg)};
  } else if (node == nullptr) {
    in.fail("expected points here: only a file can have them in a .node of the same name");
  } else if (!in.failed()) {
    if (const Status points = read_node(*node, pslg, stop); !points.ok()) return points.error();
  }
  if (in.failed()) return in.error();
  SegmentSection section = read_segments(in, pslg.points.size(), pslg.first_id.value);
  pslg.segments = std::move(section.segments);
  pslg.has_segment_markers = section.markers;
  read_holes(in, pslg.holes);
  read_regions(in, pslg.regions);
  if (in.failed()) return in.error();
  return pslg;
}

/// Reads a line `n`, then n lines `i value`: one number per `thing`, numbered from 0 or 1.
Result<std::vector<double>> read_numbered_values(const fs::path& file, std::string_view thing, bool positive,
                                                 StopSignal* stop) {
  const auto text = read_file(file, stop);
  if (!text.ok()) return text.error();
  TextReader in(*text, file.string(), stop);
  in.expect_line("the number of values");
  const std::size_t n = in.count("the number of values");
  if (!in.room_for(n, text_bytes(2), "values")) return in.error();
  std::vector<double> values(n);
  read_numbered_records(in, thing, "the first number", n, [&](TextReader& line, std::size_t i) {
    values[i] = line.number("a value");
    if (positive && !(values[i] > 0)) line.fail("expected a value greater than 0, found " + shortest(values[i]));
  });
  if (in.failed()) return in.error();
  return values;
}

Result<Pslg> pslg_in(const fs::path& file, StopSignal* stop) {
  if (file.extension() == ".node") {
    Pslg pslg;
    if (const Status points = read_node(file, pslg, stop); !points.ok()) return points.error();
    return pslg;
  }
  const auto text = read_file(file, stop);
  if (!text.ok()) return text.error();
  return parse_pslg(*text, file, stop);
}

}  // namespace

Result<Pslg> files::parse_pslg(std::string_view text, const fs::path& file, StopSignal* stop) {
  TextReader in(text, file.string(), stop);
  const fs::path node = fs::path(file).replace_extension(".node");
  return read_poly(in, is_standard_input(file) ? nullptr : &node, stop);
}

Result<Pslg> read_pslg(const fs::path& file, const GoOn& go_on) {
  return stoppable(go_on, [&](StopSignal* stop) { return pslg_in(file, stop); });
}

Result<Pslg> parse_poly(std::string_view text, const std::string& name) {
  TextReader in(without_byte_order_mark(text), name);
  return read_poly(in, nullptr, nullptr);
}

Result<std::vector<double>> read_area(const fs::path& file) {
  auto areas = read_numbered_values(file, "triangle", false, nullptr);
  if (!areas.ok()) return areas;
  for (double& area : *areas) {
    if (!(area > 0)) area = std::numeric_limits<double>::infinity();
  }
  return areas;
}

Result<std::vector<double>> read_sizes(const fs::path& file, const GoOn& go_on) {
  return stoppable(go_on, [&](StopSignal* stop) { return read_numbered_values(file, "vertex", true, stop); });
}

}  // namespace pardel
