// Whoever moves from one process to ranks finds the same options and the same report, or a reason why not.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "../../core/formats.hpp"
#include "../../properties/domains/domains.hpp"
#include "../docs/documents.hpp"
#include "../docs/json_schema.hpp"
#include "mpi_workshop.hpp"

namespace pardel {
namespace {

using Json = nlohmann::json;
using OptionNames = std::set<std::string>;
using testing::Files;
using testing::holds;
using testing::Ran;

class BothPrograms : public testing::MpiWorkshop {
 protected:
  BothPrograms() {
    EXPECT_TRUE(write_poly(domains::pipe(), folder_ / "work" / "pipe.poly"));
    EXPECT_TRUE(write_poly(domains::wedge(50, 1.8), folder_ / "work" / "wedge.poly"));
    write("crossing.poly",
          "6 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n5 0.2 0.5\n6 1.2 0.5\n5 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n5 5 6\n0\n");
  }
  /// A square with two points to the right of it.
  void write_outside() const {
    write("outside.poly",
          "6 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n5 2 0.5\n6 3 0.5\n4 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n0\n");
  }
  Ran on_ranks(int ranks, const std::vector<std::string>& arguments) const {
    return MpiWorkshop::on_ranks(ranks, PARDEL_MPI_PROGRAM, arguments);
  }
  Ran run_one(const std::string& program, const std::vector<std::string>& arguments) const {
    return program == "pardel" ? pardel(arguments) : on_ranks(1, arguments);
  }

  /// The long options that the help of a command lists.
  OptionNames options_in_help(const std::string& program, const std::string& command) const {
    const std::string help = run_one(program, {command, "--help"}).out;
    const std::regex option("(?:^|\n) +(?:-[a-zA-Z],)?(--[a-z-]+)");
    OptionNames found;
    for (std::sregex_iterator match(help.begin(), help.end(), option), end; match != end; ++match)
      found.insert((*match)[1]);
    return found;
  }
  /// The report of this command, on these ranks or, for 0, of one process.
  Json report(int ranks, std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), "mesh");
    arguments.insert(arguments.end(), {"-o", ranks == 0 ? "out.vtu" : "out.pvtu", "--json", "report.json"});
    const Ran ran = ranks == 0 ? pardel(arguments) : on_ranks(ranks, arguments);
    EXPECT_EQ(ran.exit_code, 0) << ran;
    return Json::parse(read("report.json"));
  }
};

/// The table of docs/distributed.md for a command: for each program, the options that it has.
std::map<std::string, OptionNames> options_in_document(const std::string& command) {
  std::map<std::string, OptionNames> found;
  bool is_in_table = false;
  for (const std::string& line : testing::lines_of(testing::read_document("docs/distributed.md"))) {
    if (line.starts_with("| options |")) is_in_table = line.find("`pardel " + command + "`") != std::string::npos;
    if (!line.starts_with("| `--") || !is_in_table) continue;
    static const std::regex row(R"(\| (.*?) \| (yes|no) \| (yes|no) \|.*)"), option("`(--[a-z-]+)`");
    std::smatch cells;
    EXPECT_TRUE(std::regex_match(line, cells, row)) << line;
    const std::string names = cells[1];
    for (std::sregex_iterator match(names.begin(), names.end(), option), end; match != end; ++match) {
      if (cells[2] == "yes") found["pardel"].insert((*match)[1]);
      if (cells[3] == "yes") found["pardel-mpi"].insert((*match)[1]);
    }
  }
  return found;
}

TEST_F(BothPrograms, have_the_options_that_the_table_of_the_manual_lists) {
  for (const std::string command : {"mesh", "check"}) {
    const auto listed = options_in_document(command);
    for (const std::string program : {"pardel", "pardel-mpi"})
      EXPECT_EQ(options_in_help(program, command), listed.at(program)) << program << ' ' << command;
  }
}

TEST_F(BothPrograms, say_why_they_lack_an_option_of_the_other_one) {
  for (const std::string command : {"mesh", "check"})
    for (const auto& [lacks, has] : {std::pair{"pardel", "pardel-mpi"}, {"pardel-mpi", "pardel"}}) {
      const OptionNames absent_from = options_in_help(lacks, command);
      for (const std::string& option : options_in_help(has, command)) {
        if (absent_from.contains(option)) continue;
        const Ran ran = run_one(lacks, {command, option, "1", "pipe.poly"});
        EXPECT_EQ(ran.exit_code, 2) << ran;
        EXPECT_TRUE(holds(ran.err, {std::string(lacks) + " " + command + ": there is no option '" + option + "': "}));
      }
    }
}

TEST_F(BothPrograms, say_why_ranks_lack_an_option_that_is_given_by_its_letter) {
  const Ran ran = on_ranks(1, {"mesh", "pipe.poly", "-o", "out.pvtu", "-j"});
  EXPECT_EQ(ran.exit_code, 2) << ran;
  EXPECT_TRUE(holds(ran.err, {"pardel-mpi mesh: there is no option '-j': the numbers of vertices in pieces begin",
                              "'pardel convert --drop-unused'"}))
      << ran;
}

TEST_F(BothPrograms, say_why_ranks_do_not_write_an_output_of_one_process) {
  for (const auto& [output, why] :
       {std::pair{"out.2dm",
                  ": a .2dm holds the whole mesh, which no rank has; write OUT.pvtu, and then use 'pardel "
                  "convert OUT.pvtu out.2dm'"},
        {"-", ": the pieces of a mesh do not fit into standard output; write OUT.pvtu, and then use 'pardel convert'"},
        {"out.unknown", "\n"}}) {
    const Ran ran = on_ranks(2, {"mesh", "pipe.poly", "-o", output});
    EXPECT_EQ(ran.exit_code, 2) << ran;
    EXPECT_TRUE(holds(ran.err, {std::string("the output ") + output + " must end in .pvtu, .msh, .node or .ele" + why}))
        << ran;
  }
}

TEST_F(BothPrograms, say_at_the_top_of_the_help_that_their_default_interiors_differ) {
  const std::string help = on_ranks(1, {"mesh", "--help"}).out;
  const std::size_t said = help.find("by default that of 'pardel mesh --interior refine'");
  EXPECT_LT(said, help.find("Usage:"));
}

/// Leaves out the values that depend on time, on memory, and on the order of triangles. (It decides which of several
/// triangles with the same extreme angle is listed, and how often the checker computes exactly.)
void forget_what_may_differ(Json& json) {
  static const std::set<std::string> may_differ = {"seconds", "peak_rss_bytes", "triangle", "where", "decided_exactly"};
  if (json.is_object())
    for (auto& [key, value] : json.items())
      if (may_differ.contains(key) && !value.is_object()) value = nullptr;
  if (json.is_object() && json.contains("read") && json.contains("total")) json = json.size();  // seconds by step
  if (json.is_object() && json.contains("thread_of_cell")) json["thread_of_cell"] = json["thread_of_cell"].size();
  for (const char* list : {"exemptions", "justified"})
    if (json.is_object() && json.contains(list)) {
      for (Json& entry : json[list]) forget_what_may_differ(entry);
      std::sort(json[list].begin(), json[list].end());
    }
  if (json.is_structured())
    for (Json& member : json) forget_what_may_differ(member);
}

void expect_same(Json one, Json ranks) {
  ranks.erase("ranks");
  if (ranks.contains("certificate")) ranks.at("certificate").erase("ranks");
  forget_what_may_differ(one);
  forget_what_may_differ(ranks);
  EXPECT_EQ(Json::diff(one, ranks), Json::array());
}

TEST_F(BothPrograms, write_the_same_report_from_one_process_and_one_rank) {
  const std::vector<std::vector<std::string>> runs = {
      {"pipe.poly", "--interior", "refine", "--max-area", "1e-4", "--threads", "2", "--check"},
      {"pipe.poly", "--interior", "fill", "--max-area", "1e-3", "--threads", "1"},
      {"wedge.poly", "--interior", "refine", "--min-angle", "30", "--threads", "1", "--check"},
      {"crossing.poly", "--interior", "refine", "--repair", "--threads", "1"},
      {"outside.poly", "--interior", "refine", "--max-area", "0.01", "--threads", "1"}};
  write_outside();
  const Json schema = Json::parse(std::ifstream(PARDEL_SOURCE "/docs/report.schema.json"));
  for (const std::vector<std::string>& arguments : runs) {
    const Json ranks = report(1, arguments);
    EXPECT_EQ(testing::schema_violations(schema, ranks), std::vector<std::string>());
    EXPECT_EQ(ranks.at("ranks").at("count"), 1);
    expect_same(report(0, arguments), ranks);
  }
}

TEST_F(BothPrograms, write_the_same_mesh_into_reports_of_several_ranks) {
  const std::vector<std::string> arguments = {"wedge.poly", "--interior", "refine",  "--min-angle",          "30",
                                              "--max-area", "5e-4",       "--check", "--triangles-per-tile", "500"};
  const Json one = report(0, arguments);
  const auto with_reading = [&](const char* reading) {
    std::vector<std::string> all = arguments;
    all.insert(all.end(), {"--read", reading});
    return report(3, all);
  };
  const Json schema = Json::parse(std::ifstream(PARDEL_SOURCE "/docs/report.schema.json"));
  for (const char* reading : {"whole", "parts"}) {
    const Json ranks = with_reading(reading);
    EXPECT_EQ(testing::schema_violations(schema, ranks), std::vector<std::string>());
    EXPECT_EQ(ranks.at("ranks").at("input"), reading);
    EXPECT_EQ(ranks.at("ranks").at("triangles").size(), 3U);
    EXPECT_EQ(ranks.at("gaps").is_null(), std::string(reading) == "parts");
    for (const char* key : {"digest", "input", "goal", "goal_met"}) EXPECT_EQ(ranks.at(key), one.at(key)) << key;
    EXPECT_EQ(ranks.at("mesh").at("triangles"), one.at("mesh").at("triangles"));
    EXPECT_EQ(ranks.at("refine").at("exempt"), one.at("refine").at("exempt"));
    EXPECT_TRUE(ranks.at("certificate").at("valid").get<bool>());
    // The causes of exemptions are points of the input, also if no rank has all of them.
    Json expected = {{"x", one.at("refine").at("exemptions")}}, found = {{"x", ranks.at("refine").at("exemptions")}};
    for (Json* list : {&expected, &found}) {
      for (Json& entry : list->at("x")) entry.erase("triangle");
      std::sort(list->at("x").begin(), list->at("x").end());
    }
    EXPECT_FALSE(expected.at("x").empty());
    EXPECT_EQ(expected, found);
  }
}

/// The smallest angle of a triangle, in degrees.
double smallest_angle(const Mesh& mesh, std::size_t triangle) {
  double smallest = 180;
  for (int i = 0; i < 3; ++i) {
    const auto corner = [&](int k) { return mesh.points[mesh.triangles[triangle].v[(i + k) % 3]]; };
    const Point p = corner(0), a = corner(1), b = corner(2);
    const double cross = (a.x - p.x) * (b.y - p.y) - (a.y - p.y) * (b.x - p.x),
                 dot = (a.x - p.x) * (b.x - p.x) + (a.y - p.y) * (b.y - p.y);
    smallest = std::min(smallest, std::atan2(cross, dot) * 180 / std::numbers::pi);
  }
  return smallest;
}

TEST_F(BothPrograms, name_exempt_triangles_by_their_numbers_in_the_whole_mesh) {
  const Json ranks = report(4, {"wedge.poly", "--interior", "refine", "--min-angle", "30", "--max-area", "5e-4",
                                "--triangles-per-tile", "100"});
  const Result<Mesh> mesh = read_mesh(folder_ / "work" / "out.pvtu");
  ASSERT_TRUE(mesh) << mesh.error().message;
  std::set<std::size_t> named;
  for (const Json& exemption : ranks.at("refine").at("exemptions")) {
    const auto triangle = exemption.at("triangle").get<std::size_t>();
    ASSERT_LT(triangle, mesh->triangles.size());
    EXPECT_LT(smallest_angle(*mesh, triangle), 30);
    EXPECT_TRUE(named.insert(triangle).second) << triangle << " is named twice";
  }
  EXPECT_GT(named.size(), 10U);
}

TEST_F(BothPrograms, count_points_outside_once_whatever_each_rank_reads) {
  write_outside();
  for (const char* reading : {"whole", "parts"}) {
    const Ran ran = on_ranks(
        3, {"mesh", "outside.poly", "-o", "out.pvtu", "--max-area", "1e-3", "--read", reading, "--json", "ranks.json"});
    EXPECT_EQ(ran.exit_code, 0) << ran;
    EXPECT_TRUE(holds(ran.err, {"pardel-mpi: outside.poly: note: 2 points, the first at (2, 0.5), are in no triangle",
                                "'pardel convert "}));
    EXPECT_EQ(Json::parse(read("ranks.json")).at("points_outside"), 2);
  }
}

TEST_F(BothPrograms, name_the_first_point_outside) {
  // The first one is in the part of the second rank, and the ranks have the others in another order.
  std::string nodes = "8 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n5 9 9\n6 -3 0.5\n7 2 0.5\n8 -1 -1\n",
              segments = "4 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n0\n";
  write("first.poly", nodes + segments);
  const Ran one = pardel({"mesh", "first.poly", "-o", "out.vtu", "--max-area", "1e-3"});
  EXPECT_TRUE(holds(one.err, {"first.poly: note: 4 points, the first at (9, 9), are in no triangle"})) << one;
  for (const char* reading : {"whole", "parts"})
    for (const int ranks : {1, 3}) {
      const Ran ran =
          on_ranks(ranks, {"mesh", "first.poly", "-o", "out.pvtu", "--max-area", "1e-3", "--read", reading});
      EXPECT_TRUE(holds(ran.err, {"first.poly: note: 4 points, the first at (9, 9), are in no triangle"})) << ran;
    }
}

TEST_F(BothPrograms, refuse_to_keep_segments_with_a_marker_that_none_has) {
  write("marked.poly", "4 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n4 1\n1 1 2 5\n2 2 3 6\n3 3 4 7\n4 4 1 8\n0\n");
  write("points.node", "5 2 0 0\n1 0 0\n2 1 0\n3 1.1 1\n4 0 1\n5 0.3 0.4\n");
  struct Case {
    std::vector<std::string> arguments;
    int exit_code;
    const char* message;
  };
  for (const auto& [arguments, exit_code, message] : std::vector<Case>{
           {{"marked.poly", "--keep", "5,9"}, 3, "marked.poly: --keep: no segment of the domain has the marker 9\n"},
           {{"marked.poly", "--keep", "1"}, 3, "marked.poly: --keep: no segment of the domain has the marker 1\n"},
           {{"marked.poly", "--keep", "5,8"}, 0, ""},
           {{"marked.poly", "--keep", "1", "--convex-hull"}, 0, ""},
           {{"points.node", "--keep", "1"}, 0, ""},
           {{"points.node", "--keep", "2"}, 3, "points.node: --keep: no segment of the domain has the marker 2\n"},
           {{"crossing.poly", "--keep", "1,2"}, 3, "crossing.poly: Segments "}}) {
    for (const char* reading : {"one process", "whole", "parts"}) {
      std::vector<std::string> all = arguments;
      all.insert(all.begin(), "mesh");
      const bool is_one = reading == std::string("one process");
      if (is_one) all.insert(all.end(), {"-o", "out.vtu"});
      if (!is_one) all.insert(all.end(), {"-o", "out.pvtu", "--read", reading});
      const Ran ran = is_one ? pardel(all) : on_ranks(2, all);
      EXPECT_EQ(ran.exit_code, exit_code) << reading << ran;
      EXPECT_TRUE(holds(ran.err, {message})) << reading << ran;
      EXPECT_EQ(exists(is_one ? "out.vtu" : "out.pvtu"), exit_code == 0) << reading << ran;
      std::filesystem::remove(folder_ / "work" / "out.vtu");
      std::filesystem::remove(folder_ / "work" / "out.pvtu");
    }
  }
}

TEST_F(BothPrograms, repair_a_domain_that_each_rank_reads_whole) {
  const Ran ran = on_ranks(2, {"mesh", "crossing.poly", "-o", "out.pvtu", "--repair", "--json", "ranks.json"});
  EXPECT_EQ(ran.exit_code, 0) << ran;
  EXPECT_TRUE(holds(ran.err, {"pardel-mpi: crossing.poly: repaired: "})) << ran;
  const Json one = report(0, {"crossing.poly", "--repair", "--interior", "refine"});
  EXPECT_EQ(Json::parse(read("ranks.json")).at("digest"), one.at("digest"));
  const Ran parts = on_ranks(2, {"mesh", "crossing.poly", "-o", "out.pvtu", "--repair", "--read", "parts"});
  EXPECT_EQ(parts.exit_code, 2) << parts;
  EXPECT_TRUE(holds(parts.err, {"--repair needs the whole input", "pardel doctor --repair"})) << parts;
}

TEST_F(BothPrograms, write_why_a_domain_is_refused) {
  EXPECT_EQ(pardel({"mesh", "crossing.poly", "-o", "out.vtu", "--json", "one.json"}).exit_code, 3);
  const Json one = Json::parse(read("one.json"));
  for (const char* reading : {"whole", "parts"}) {
    const Ran ran = on_ranks(2, {"mesh", "crossing.poly", "-o", "out.pvtu", "--read", reading, "--json", "ranks.json"});
    EXPECT_EQ(ran.exit_code, 3) << ran;
    EXPECT_EQ(Json::parse(read("ranks.json")), one);
    EXPECT_FALSE(exists("out.pvtu"));
  }
}

TEST_F(BothPrograms, say_that_a_mesh_that_misses_bounds_is_right_otherwise) {
  const std::vector<std::string> arguments = {"mesh",       "pipe.poly", "--max-area", "1e-3",
                                              "--min-edge", "0.1",       "--check"};
  for (const int ranks : {0, 2}) {
    std::vector<std::string> all = arguments;
    all.insert(all.end(), {"-o", ranks == 0 ? "out.vtu" : "out.pvtu"});
    const Ran ran = ranks == 0 ? pardel(all) : on_ranks(ranks, all);
    EXPECT_EQ(ran.exit_code, 4) << ran;
    EXPECT_TRUE(holds(ran.err, {"pipe.poly: the check found missed bounds only"})) << ran;
    EXPECT_TRUE(holds(ran.out, {"check   NOT VALID"})) << ran;
  }
}

/// Without the lines on times, memory, files and ranks.
std::vector<std::string> summary(const Ran& ran) {
  static const std::regex of_run("(time|wrote|output|ranks|edges|pieces|memory) .*");
  std::vector<std::string> lines = testing::lines_of(ran.out);
  std::erase_if(lines, [](const std::string& line) { return std::regex_match(line, of_run); });
  return lines;
}

/// The messages without the name of the program and without those of mpirun, sorted: the pieces of two ranks list
/// triangles in another order than the mesh of one process.
std::vector<std::string> messages(const Ran& ran) {
  static const std::regex message(
      "(?:pardel|pardel-mpi): (.*)|(  .*: triangle .*|  [.]{3} .*|  The distance .*|--repair .*)");
  std::vector<std::string> found;
  for (const std::string& line : testing::lines_of(ran.err))
    if (std::smatch match; std::regex_match(line, match, message)) found.push_back(match[1].str() + match[2].str());
  std::ranges::sort(found);
  return found;
}

TEST_F(BothPrograms, print_the_same_summary_and_the_same_messages) {
  EXPECT_TRUE(write_poly(domains::regions(), folder_ / "work" / "regions.poly"));
  write("caps.poly", "4 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n4 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n0\n1\n1 0.5 0.5 7 0.01\n");
  write("kept.poly", "4 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n4 1\n1 1 2 1\n2 2 3 2\n3 3 4 2\n4 4 1 2\n0\n");
  write("gap.poly", "5 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n5 0.5 1e-13\n4 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n0\n");
  struct Case {
    std::vector<std::string> arguments;
    int exit_code;
    const char* line;  ///< one that both print
  };
  for (const auto& [arguments, exit_code, line] : std::vector<Case>{
           {{"pipe.poly", "--max-area", "1e-3", "--check"}, 0, "check   valid"},
           {{"pipe.poly", "--max-area", "1e-3", "--interior", "fill"}, 0, "laid    "},
           {{"wedge.poly", "--min-angle", "30", "--max-area", "5e-4", "--triangles-per-tile", "100"}, 0, "exempt  "},
           {{"regions.poly", "--max-area", "0.05"}, 0, "degrees, area "},
           {{"caps.poly"}, 0, "note    the area caps of the regions are ignored"},
           {{"caps.poly", "--regions"}, 0, "mesh    "},
           {{"kept.poly", "--max-area", "0.01", "--keep", "1"}, 4, "missed  "},
           {{"gap.poly"}, 4, "missed  1 min_edge"}})
    for (const char* reading : {"whole", "parts"}) {
      SCOPED_TRACE(arguments.front() + " " + reading);
      const bool is_filled = std::ranges::find(arguments, "fill") != arguments.end();
      const bool is_divided = reading == std::string("parts");
      // Ranks that have read parts do not look for gaps.
      if (is_divided && (is_filled || arguments.front() == "gap.poly")) continue;
      std::vector<std::string> all = arguments;
      all.insert(all.begin(), "mesh");
      if (!is_filled) all.insert(all.end(), {"--interior", "refine"});
      all.insert(all.end(), {"-o", "out.node"});
      const Ran one = pardel(all);
      all.insert(all.end(), {"--read", reading});
      const Ran ranks = on_ranks(2, all);
      EXPECT_EQ(one.exit_code, exit_code) << one;
      EXPECT_EQ(ranks.exit_code, exit_code) << ranks;
      EXPECT_TRUE(holds(one.out, {line})) << one;
      EXPECT_EQ(summary(ranks), summary(one));
      EXPECT_EQ(messages(ranks), messages(one));
    }
}

TEST_F(BothPrograms, warn_of_the_same_gaps) {
  write("gap.poly", "5 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n5 0.5 1e-13\n4 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n0\n");
  const Ran ran = on_ranks(2, {"mesh", "gap.poly", "-o", "out.pvtu"});
  const std::string warning = "pardel-mpi: gap.poly: warning: 1 gap is much narrower than the segments around";
  EXPECT_TRUE(holds(ran.err, {warning, "\n--repair with --snap 2.2e-13 closes the narrowest"})) << ran;
  EXPECT_EQ(ran.err.find(warning, ran.err.find(warning) + 1), std::string::npos) << "one rank warns\n" << ran;
}

/// Which ones are listed depends on the order of the triangles.
TEST_F(BothPrograms, count_the_triangles_that_miss_a_bound_by_reason_and_list_the_first_ten) {
  const std::vector<std::string> arguments = {"mesh", "pipe.poly", "--max-area", "1e-3", "--min-edge", "0.05"};
  std::vector<std::vector<std::string>> said;
  for (const int ranks : {0, 2}) {
    std::vector<std::string> all = arguments;
    all.insert(all.end(), {"--interior", "refine", "-o", ranks == 0 ? "out.vtu" : "out.pvtu"});
    const Ran ran = ranks == 0 ? pardel(all) : on_ranks(ranks, all);
    EXPECT_EQ(ran.exit_code, 4) << ran;
    std::vector<std::string> lines = messages(ran);
    EXPECT_EQ(std::erase_if(lines, [](const std::string& line) { return line.starts_with("  min_edge: "); }), 10U);
    EXPECT_EQ(lines.size(), 2U) << ran;
    EXPECT_TRUE(holds(ran.err, {"pipe.poly: the goal is missed at some triangles (", " min_edge):\n", "  ... and ",
                                " more (all in --json)\n"}))
        << ran;
    EXPECT_TRUE(exists(ranks == 0 ? "out.vtu" : "out.pvtu"));
    said.push_back(lines);
  }
  EXPECT_EQ(said[0], said[1]);
}

TEST_F(BothPrograms, say_that_points_without_segments_have_their_convex_hull_as_domain) {
  write("points.node", "5 2 0 0\n1 0 0\n2 1 0\n3 1.1 1\n4 0 1\n5 0.3 0.4\n");
  const char* note = "note    the input has no segments, so the domain is the convex hull of its points; ";
  EXPECT_TRUE(holds(pardel({"mesh", "points.node", "-o", "out.vtu"}).out, {std::string(note) + "--refine refines"}));
  for (const char* reading : {"whole", "parts"}) {
    const Ran ran = on_ranks(2, {"mesh", "points.node", "-o", "out.pvtu", "--read", reading});
    EXPECT_TRUE(holds(ran.out, {std::string(note) + "'pardel mesh --refine' refines a mesh\n"})) << ran;
  }
}

TEST_F(BothPrograms, keep_to_a_limit_on_memory) {
  if (testing::sanitized) GTEST_SKIP() << "a sanitizer's shadow memory alone is larger than the limit";
  const Ran ran = on_ranks(2, {"mesh", "pipe.poly", "-o", "out.pvtu", "--max-area", "1e-6", "--max-memory", "0.03"});
  EXPECT_EQ(ran.exit_code, 5) << ran;
  EXPECT_TRUE(holds(ran.err, {"pardel-mpi: rank ", "memory"})) << ran;
  EXPECT_FALSE(exists("out.pvtu"));
}

TEST_F(BothPrograms, refuse_at_once_a_mesh_that_cannot_fit) {
  if (testing::sanitized) GTEST_SKIP() << "a sanitizer's shadow memory alone is larger than the limit";
  for (const int ranks : {0, 2}) {
    const std::string output = ranks == 0 ? "out.vtu" : "out.pvtu";
    const std::vector<std::string> all = {"mesh", "pipe.poly",  "-o",     output,         "--max-area",
                                          "1e-8", "--interior", "refine", "--max-memory", "0.5"};
    const Ran ran = ranks == 0 ? pardel(all) : on_ranks(ranks, all);
    EXPECT_EQ(ran.exit_code, 5) << ran;
    EXPECT_TRUE(holds(ran.err, {"the mesh will have more than ", "million triangles", "GiB", "512 MiB"})) << ran;
  }
}

/// The mesh does not fit into the memory, so the run ends after the warning.
TEST_F(BothPrograms, warn_of_very_many_triangles) {
  if (testing::sanitized) GTEST_SKIP() << "a sanitizer's shadow memory alone is larger than the limit";
  for (const int ranks : {0, 2}) {
    const std::string output = ranks == 0 ? "out.vtu" : "out.pvtu";
    for (const char* bound : {"--max-area", "--max-edge"}) {
      const std::vector<std::string> all = {"mesh", "pipe.poly",  "-o",     output,         bound,
                                            "1e-8", "--interior", "refine", "--max-memory", "0.1"};
      const Ran ran = ranks == 0 ? pardel(all) : on_ranks(ranks, all);
      EXPECT_EQ(ran.exit_code, 5) << ran;
      const std::string program = ranks == 0 ? "pardel" : "pardel-mpi";
      const std::string warning = program + ": pipe.poly: warning: With these bounds on sizes, the mesh will have ";
      const std::size_t at = ran.err.find(warning);
      EXPECT_NE(at, std::string::npos) << ran;
      EXPECT_EQ(ran.err.find(warning, at + 1), std::string::npos) << "one rank warns\n" << ran;
    }
  }
}

TEST_F(BothPrograms, print_only_the_report_where_standard_output_is_its_file) {
  const Ran ran = on_ranks(2, {"mesh", "pipe.poly", "-o", "out.pvtu", "--max-area", "1e-3", "--json", "-"});
  EXPECT_EQ(ran.exit_code, 0) << ran;
  EXPECT_EQ(Json::parse(ran.out).at("schema"), "pardel.report/1");
  const Ran mixed = on_ranks(2, {"mesh", "pipe.poly", "-o", "out.pvtu", "--json", "out_0001.vtu"});
  EXPECT_EQ(mixed.exit_code, 2) << mixed;
  EXPECT_TRUE(holds(mixed.err, {"--json out_0001.vtu"})) << mixed;
}

}  // namespace
}  // namespace pardel
