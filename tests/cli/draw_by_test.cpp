// pardel draw --by: colours by tile, phase or thread.
#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

#include "program.hpp"

namespace pardel::testing {
namespace {

using nlohmann::json;

/// The paths of filled triangles: colours, and data.
std::vector<std::pair<std::string, std::string>> filled_paths(const std::string& svg) {
  std::vector<std::pair<std::string, std::string>> found;
  const std::string begin = "<path style=\" stroke:none;fill-rule:nonzero;fill:";
  for (std::size_t at = 0; (at = svg.find(begin, at)) != std::string::npos;) {
    at += begin.size();
    const std::size_t data = svg.find(" d=\"", at) + 4;
    found.emplace_back(svg.substr(at, svg.find(';', at) - at), svg.substr(data, svg.find('"', data) - data));
  }
  return found;
}

constexpr const char* svg_white = "rgb(100%,100%,100%)";

/// The colours of the triangles, except svg_white.
std::set<std::string> fills(const std::string& svg) {
  std::set<std::string> found;
  for (const auto& [colour, data] : filled_paths(svg)) found.insert(colour);
  found.erase(svg_white);
  return found;
}

class DrawBy : public Workshop {
 protected:
  DrawBy() {
    write("square.poly", square_poly);
    const Ran ran = pardel({"mesh", "square.poly", "-o", "m.ele", "-o", "m.vtu", "--max-area", "0.001", "--cells",
                            "4,3", "--threads", "2", "--json", "r.json"});
    EXPECT_EQ(ran.exit_code, 0) << ran;
  }
  std::string drawn(const std::string& by) const {
    const Ran ran = pardel({"draw", "m.ele", "-o", by + ".svg", "--by", by, "--report", "r.json", "--no-legend"});
    EXPECT_EQ(ran.exit_code, 0) << ran;
    return read(by + ".svg");
  }
  void expect_refused(const std::string& report, int code, const std::vector<std::string>& words) {
    write("other.json", report);
    const Ran ran = pardel({"draw", "m.ele", "-o", "x.svg", "--by", "tile", "--report", "other.json"});
    EXPECT_EQ(ran.exit_code, code) << ran;
    EXPECT_TRUE(holds(ran.err, words));
    EXPECT_FALSE(exists("x.svg"));
  }
};

TEST_F(DrawBy, tile_gives_each_of_twelve_cells_a_colour_of_its_own) { EXPECT_EQ(fills(drawn("tile")).size(), 12U); }

TEST_F(DrawBy, phase_gives_four_colours) { EXPECT_EQ(fills(drawn("phase")).size(), 4U); }

TEST_F(DrawBy, thread_gives_a_colour_to_each_thread_that_worked) {
  json r = json::parse(read("r.json"));
  json& threads = r["decomposition"]["thread_of_cell"];
  ASSERT_EQ(threads.size(), 12U);
  threads = {0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, -1};
  write("r.json", r.dump());
  const std::string svg = drawn("thread");
  EXPECT_EQ(fills(svg).size(), 3U);
  const auto is_white = [](const auto& path) { return path.first == svg_white; };
  EXPECT_TRUE(std::ranges::any_of(filled_paths(svg), is_white));
}

TEST_F(DrawBy, all_triangles_are_drawn_in_any_format) {
  const auto triangles = [](const std::string& svg) {
    std::ptrdiff_t n = 0;
    for (const auto& [colour, data] : filled_paths(svg)) n += std::ranges::count(data, 'Z');
    return n;
  };
  EXPECT_EQ(triangles(drawn("tile")), json::parse(read("r.json"))["mesh"]["triangles"]);
  ASSERT_EQ(pardel({"draw", "m.vtu", "-o", "v.svg", "--by", "tile", "--report", "r.json", "--no-legend"}).exit_code, 0);
  EXPECT_EQ(fills(read("v.svg")).size(), 12U);
}

TEST_F(DrawBy, the_options_report_and_by_require_each_other) {
  EXPECT_EQ(pardel({"draw", "m.ele", "-o", "x.svg", "--by", "tile"}).exit_code, 2);
  EXPECT_EQ(pardel({"draw", "m.ele", "-o", "x.svg", "--report", "r.json"}).exit_code, 2);
  EXPECT_EQ(pardel({"draw", "m.ele", "-o", "x.svg", "--report", "r.json", "--by", "quality"}).exit_code, 2);
  const Ran ran = pardel({"draw", "m.ele", "-o", "x.svg", "--by", "colour", "--report", "r.json"});
  EXPECT_EQ(ran.exit_code, 2);
  EXPECT_TRUE(holds(ran.err, {"colour", "tile", "phase", "thread"}));
  EXPECT_FALSE(exists("x.svg"));
}

TEST_F(DrawBy, a_domain_cannot_be_drawn_by_tile) {
  const Ran ran = pardel({"draw", "square.poly", "-o", "x.svg", "--by", "tile", "--report", "r.json"});
  EXPECT_EQ(ran.exit_code, 2) << ran;
  EXPECT_TRUE(holds(ran.err, {"square.poly", "--by"}));
}

TEST_F(DrawBy, a_report_of_another_mesh_is_refused) {
  const json right = json::parse(read("r.json"));
  expect_refused("{\"schema\": \"pardel", 3, {"other.json", "invalid JSON"});
  expect_refused("[1, 2]", 3, {"other.json", "not a report"});
  expect_refused("{\"schema\": \"pardel.certificate/1\"}", 3, {"other.json", "pardel.report/1"});
  json r = right;
  r["mesh"]["triangles"] = 17;
  expect_refused(r.dump(), 3, {"other.json", "17 triangles"});
  r = right;
  r["decomposition"].erase("thread_of_cell");
  expect_refused(r.dump(), 3, {"other.json", "without a lattice"});
  r = right;
  r["decomposition"]["thread_of_cell"].erase(0);
  expect_refused(r.dump(), 3, {"other.json", "lattice"});
  r = right;
  r["decomposition"]["columns"] = 0;
  expect_refused(r.dump(), 3, {"other.json", "lattice"});
  r = right;
  r["decomposition"]["high"] = r["decomposition"]["low"];
  expect_refused(r.dump(), 3, {"other.json", "lattice"});
}

TEST_F(DrawBy, a_report_that_does_not_exist_is_an_io_error) {
  const Ran ran = pardel({"draw", "m.ele", "-o", "x.svg", "--by", "tile", "--report", "missing.json"});
  EXPECT_EQ(ran.exit_code, 5) << ran;
  EXPECT_TRUE(holds(ran.err, {"missing.json"}));
}

}  // namespace
}  // namespace pardel::testing
