// The files of pardel triangle compared with those of Triangle 1.6, for which tests/cli/triangle_samples/facts has the
// facts on which two correct meshes agree, even if they have different vertices:
//
//   run NAME SWITCHES        the command line, without Q
//   files NAME...            the files that were written
//   node, ele, poly, segments, edge, neigh
//                            the header; without the number of records if the switches allow new vertices
//   point ID X Y ...         an input point as the .node has it, with attributes and marker; left out if all points are
//                            as in the run before
//   area A X                 X is the area of all triangles with the attribute A (0 if they have no attributes)
//   segments marked M X      X is the length of all segments in the .poly with the marker M (0 if they have no markers)
//   edges marked M X         the same for the .edge; edges with the marker 0 are left out
//   seed ...                 a line of the .poly after the segments: a hole, a region, or a number of them
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "program.hpp"

namespace pardel::testing {
namespace {

namespace fs = std::filesystem;
using Row = std::vector<double>;
using Lines = std::vector<std::string>;

std::string text(const std::string& name, const Row& numbers) {
  std::string line = name;
  for (const double number : numbers) line += fmt::format(" {:.6g}", number);
  return line;
}

struct Recorded {
  std::string name, switches;
  Lines expected;

  [[nodiscard]] bool has(char letter) const { return switches.find(letter) != std::string::npos; }
  /// True if the number of vertices is not determined by the input.
  [[nodiscard]] bool adds_vertices() const { return switches.find_first_of("qaDs") != std::string::npos && !has('S'); }
  [[nodiscard]] std::string stem() const {
    if (has('I')) return name;
    return name.ends_with(".1") ? name.substr(0, name.size() - 1) + "2" : name + ".1";
  }
};

std::vector<Recorded> read_runs() {
  std::vector<Recorded> runs;
  std::ifstream in(fs::path(PARDEL_TRIANGLE_SAMPLES) / "facts");
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    std::string first;
    words >> first;
    if (first == "run") {
      words >> runs.emplace_back().name >> runs.back().switches;
    } else if (!first.empty() && first[0] != '#') {
      runs.back().expected.push_back(line);
    }
  }
  return runs;
}

class TriangleFacts : public Workshop {
 protected:
  /// Empties the folder, copies the samples into it and runs the program.
  Ran run_anew(const Recorded& run) {
    for (const std::string& name : files()) fs::remove(folder_ / "work" / name);
    for (const auto& entry : fs::directory_iterator(PARDEL_TRIANGLE_SAMPLES)) {
      if (entry.path().filename() != "facts") fs::copy(entry.path(), folder_ / "work");
    }
    samples_ = files();
    return pardel({"triangle", "-Q" + run.switches.substr(1), run.name});
  }

  Lines facts(const Recorded& run) {
    lines_.clear();
    nodes_ = exists(run.stem() + ".node") ? table(run.stem() + ".node") : std::vector<Row>{};
    std::string written = "files";
    for (const std::string& name : files()) {
      if (!samples_.contains(name)) written += " " + name;
    }
    lines_.push_back(written);
    if (wrote(run, ".node")) node_facts(run);
    if (wrote(run, ".ele")) ele_facts(run);
    if (wrote(run, ".poly")) poly_facts(run);
    if (wrote(run, ".edge")) {
      const std::vector<Row> rows = table(run.stem() + ".edge");
      header(run, "edge", rows[0]);
      lengths("edges marked", rows, 1, rows.size(), false);
    }
    if (wrote(run, ".neigh")) header(run, "neigh", table(run.stem() + ".neigh")[0]);
    return lines_;
  }

 private:
  bool wrote(const Recorded& run, const std::string& suffix) const {
    return exists(run.stem() + suffix) && !samples_.contains(run.stem() + suffix);
  }

  void header(const Recorded& run, const std::string& name, Row numbers) {
    if (run.adds_vertices()) numbers.erase(numbers.begin());
    lines_.push_back(text(name, numbers));
  }

  [[nodiscard]] const Row& node(double id) const { return nodes_[static_cast<std::size_t>(id - nodes_[1][0]) + 1]; }

  void node_facts(const Recorded& run) {
    header(run, "node", nodes_[0]);
    const auto listed = static_cast<std::size_t>(std::count_if(
        run.expected.begin(), run.expected.end(), [](const auto& line) { return line.starts_with("point"); }));
    for (std::size_t i = 1; i <= listed && i < nodes_.size(); ++i) lines_.push_back(text("point", nodes_[i]));
  }

  void ele_facts(const Recorded& run) {
    const std::vector<Row> rows = table(run.stem() + ".ele");
    header(run, "ele", rows[0]);
    if (nodes_.empty()) return;
    std::map<double, double> areas;
    for (std::size_t t = 1; t < rows.size(); ++t) {
      const Row &a = node(rows[t][1]), &b = node(rows[t][2]), &c = node(rows[t][3]);
      const double attribute = rows[0][2] > 0 ? rows[t].back() : 0;
      areas[attribute] += ((b[1] - a[1]) * (c[2] - a[2]) - (b[2] - a[2]) * (c[1] - a[1])) / 2;
    }
    for (const auto& [attribute, area] : areas) lines_.push_back(text("area", {attribute, area}));
  }

  void poly_facts(const Recorded& run) {
    const std::vector<Row> rows = table(run.stem() + ".poly");
    const auto end = static_cast<std::size_t>(rows[1][0]) + 2;
    lines_.push_back(text("poly", rows[0]));
    header(run, "segments", rows[1]);
    lengths("segments marked", rows, 2, end, true);
    for (std::size_t i = end; i < rows.size(); ++i) lines_.push_back(text("seed", rows[i]));
  }

  void lengths(const std::string& name, const std::vector<Row>& rows, std::size_t first, std::size_t last, bool zero) {
    if (nodes_.empty()) return;
    std::map<double, double> sums;
    for (std::size_t i = first; i < last; ++i) {
      const Row &a = node(rows[i][1]), &b = node(rows[i][2]);
      sums[rows[i].size() > 3 ? rows[i][3] : 0] += std::hypot(a[1] - b[1], a[2] - b[2]);
    }
    for (const auto& [marker, length] : sums) {
      if (zero || marker != 0) lines_.push_back(text(name, {marker, length}));
    }
  }

  Files samples_;
  std::vector<Row> nodes_;
  Lines lines_;
};

TEST_F(TriangleFacts, agree_with_triangle_1_6) {
  const std::vector<Recorded> runs = read_runs();
  ASSERT_GT(runs.size(), 100U);
  for (const Recorded& run : runs) {
    SCOPED_TRACE(run.name + " " + run.switches);
    const Ran ran = run_anew(run);
    EXPECT_EQ(ran.exit_code, 0) << ran;
    EXPECT_EQ(ran.out + ran.err, "");
    EXPECT_EQ(facts(run), run.expected);
  }
}

}  // namespace
}  // namespace pardel::testing
