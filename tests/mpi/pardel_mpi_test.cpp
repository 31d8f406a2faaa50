// The program pardel-mpi from outside: files, messages and exit codes.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <string>
#include <utility>
#include <vector>

#include "../../core/digest.hpp"
#include "../../core/formats.hpp"
#include "../../parallel/mesher.hpp"
#include "../../properties/checker/check.hpp"
#include "../../properties/domains/domains.hpp"
#include "mpi_workshop.hpp"

namespace pardel {
namespace {

namespace fs = std::filesystem;
using testing::Files;
using testing::holds;
using testing::Ran;

class PardelMpi : public testing::MpiWorkshop {
 protected:
  PardelMpi() { EXPECT_TRUE(write_poly(domains::pipe(), folder_ / "work" / "pipe.poly")); }
  Ran on_ranks(int ranks, const std::vector<std::string>& arguments) const {
    return MpiWorkshop::on_ranks(ranks, PARDEL_MPI_PROGRAM, arguments);
  }
};

TEST_F(PardelMpi, writes_pieces_that_are_together_a_valid_mesh) {
  const Ran ran = on_ranks(3, {"mesh", "pipe.poly", "-o", "out.pvtu", "--max-area", "1e-4", "--threads", "1"});
  ASSERT_EQ(ran.exit_code, 0) << ran;
  EXPECT_EQ(files(), (Files{"pipe.poly", "out.pvtu", "out_0000.vtu", "out_0001.vtu", "out_0002.vtu"}));
  const Result<Mesh> whole = read_mesh(folder_ / "work" / "out.pvtu");
  ASSERT_TRUE(whole) << whole.error().message;
  const Goal goal{.max_area = 1e-4};
  EXPECT_TRUE(check(domains::pipe(), *whole, goal, {.foreign = true}).valid);
  const Result<Meshed> expected = mesh(domains::pipe(), goal);
  EXPECT_EQ(to_string(digest(*whole)), to_string(digest(expected->mesh)));
  EXPECT_TRUE(holds(ran.out, {"digest  " + to_string(digest(*whole)),
                              "ranks   3, with 1 threads each; each has read the whole input"}));
}

TEST_F(PardelMpi, a_sequential_mesher_makes_the_mesh_of_one_process_on_any_number_of_ranks) {
  const std::string program = PARDEL_PROGRAM " triangle -rpBPQYYq{min-angle}aS{max-points} {mesh}";
  const std::vector<std::pair<std::string, std::string>> ways = {
      {"own", "frozen"}, {"own", "cells"}, {"own", "decoupled"}, {program, "frozen"}};
  for (const auto& [mesher, scheme] : ways) {
    const std::vector<std::string> how{
        "mesh", "pipe.poly", "--mesher",   mesher, "--scheme", scheme, "--max-area", "2e-4", "--triangles-per-task",
        "1000", "--json",    "report.json"};
    const auto report_on = [&](int ranks) {
      std::vector<std::string> arguments = how;
      arguments.insert(arguments.end(), {"-o", ranks == 0 ? "out.vtu" : "out.pvtu"});
      if (ranks > 0) arguments.emplace_back("--check");
      const Ran ran = ranks == 0 ? pardel(arguments) : on_ranks(ranks, arguments);
      EXPECT_EQ(ran.exit_code, 0) << ran;
      auto report = nlohmann::json::parse(read("report.json"));
      report["mesher"].erase("seconds");
      return report;
    };
    const auto expected = report_on(0);
    EXPECT_GT(expected["mesher"]["tasks"], 10);
    const auto report = report_on(3);
    EXPECT_EQ(report["digest"], expected["digest"]) << mesher << ' ' << scheme;
    EXPECT_EQ(report["mesher"], expected["mesher"]) << mesher << ' ' << scheme;
    EXPECT_TRUE(report["certificate"]["valid"]);
  }
}

TEST_F(PardelMpi, a_mesher_that_cannot_be_used_is_refused_on_all_ranks) {
  const auto refused = [&](const std::vector<std::string>& options, const std::string& message) {
    std::vector<std::string> arguments{"mesh", "pipe.poly", "-o", "out.pvtu", "--max-area", "1e-3"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Ran ran = on_ranks(2, arguments);
    EXPECT_NE(ran.exit_code, 0) << ran;
    EXPECT_TRUE(holds(ran.err, {message})) << ran;
    EXPECT_EQ(files(), Files{"pipe.poly"});
  };
  refused({"--mesher", "no-such-program {mesh}"}, "there is no program 'no-such-program' on the PATH");
  refused({"--mesher", PARDEL_PROGRAM " triangle -rpq {mesh}", "--scheme", "cells"},
          "pardel-mpi: the scheme 'cells' needs a mesher that inserts points in a given cell only");
  refused({"--mesher", "own", "--pieces", "2"}, "--mesher cannot be used with --pieces");
  refused({"--mesher", "own", "--interior", "fill"}, "--mesher cannot be used with --interior fill");
  refused({"--mesher", "own", "--read", "parts"}, "--read parts needs");
}

/// The numbers in the part of the output that matches.
std::vector<double> numbers_in(const std::string& out, const std::string& pattern) {
  std::smatch found;
  std::vector<double> numbers;
  if (!std::regex_search(out, found, std::regex(pattern))) return numbers;
  for (std::size_t i = 1; i < found.size(); ++i) numbers.push_back(std::stod(found[i]));
  return numbers;
}

TEST_F(PardelMpi, prints_what_the_mesh_and_its_pieces_have) {
  const Ran ran =
      on_ranks(3, {"mesh", "pipe.poly", "-o", "out.pvtu", "--max-area", "1e-4", "--threads", "1", "--json", "r.json"});
  ASSERT_EQ(ran.exit_code, 0) << ran;
  const auto size_of = [&](const std::string& file) {
    const Result<Mesh> mesh = read_mesh(folder_ / "work" / file);
    return std::pair<double, double>(mesh->triangles.size(), mesh->constrained_edges.size());
  };
  const double sizes[] = {size_of("out_0000.vtu").first, size_of("out_0001.vtu").first, size_of("out_0002.vtu").first};
  const auto [least, most] = std::minmax_element(std::begin(sizes), std::end(sizes));
  ASSERT_LT(*least, *most);
  EXPECT_EQ(numbers_in(ran.out, "\npieces  (\\d+) to (\\d+) triangles"), (std::vector<double>{*least, *most})) << ran;
  const auto [triangles, edges] = size_of("out.pvtu");
  EXPECT_EQ(numbers_in(ran.out, "\nedges   (\\d+) constrained\n"), std::vector<double>{edges}) << ran;
  double bytes = 0;
  const auto report = nlohmann::json::parse(read("r.json"));
  for (const auto& of_rank : report["ranks"]["peak_rss_bytes"]) bytes += of_rank.get<double>();
  const std::vector<double> printed = numbers_in(ran.out, "\nmemory  (\\d+) bytes per triangle");
  ASSERT_EQ(printed.size(), 1U) << ran;
  EXPECT_NEAR(printed[0] / (bytes / triangles), 1, 0.2) << "memory grows a little between the two lines";
}

/// The certificate of one process, as several ranks write it.
std::string with_ranks(std::string certificate, int ranks) {
  const std::string last = "\n}\n";
  EXPECT_TRUE(certificate.ends_with(last)) << certificate;
  return certificate.replace(certificate.size() - last.size(), last.size(),
                             ",\n  \"ranks\": " + std::to_string(ranks) + last);
}

TEST_F(PardelMpi, check_writes_the_certificate_of_one_process_on_any_number_of_ranks) {
  ASSERT_EQ(on_ranks(3, {"mesh", "pipe.poly", "-o", "out.pvtu", "--max-area", "1e-4"}).exit_code, 0);
  ASSERT_EQ(
      run(PARDEL_PROGRAM, {"check", "pipe.poly", "out.pvtu", "--max-area", "1e-4", "--json", "one.json"}).exit_code, 0);
  for (const int ranks : {1, 2, 3, 5}) {
    const Ran ran = on_ranks(ranks, {"check", "pipe.poly", "out.pvtu", "--max-area", "1e-4", "--json", "ranks.json"});
    EXPECT_EQ(ran.exit_code, 0) << ran;
    EXPECT_TRUE(holds(ran.out, {"valid: ", "ranks   " + std::to_string(ranks) + ", "})) << ran;
    EXPECT_EQ(read("ranks.json"), with_ranks(read("one.json"), ranks));
  }
}

TEST_F(PardelMpi, check_holds_one_of_several_pieces_at_a_time_and_writes_the_certificate_of_one_process) {
  const std::vector<std::string> goal{"--max-area", "2e-4"};
  const auto with_goal = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.end(), goal.begin(), goal.end());
    return arguments;
  };
  const Ran made =
      on_ranks(2, with_goal({"mesh", "pipe.poly", "-o", "out.pvtu", "--interior", "fill", "--pieces", "8"}));
  ASSERT_EQ(made.exit_code, 0) << made;
  ASSERT_TRUE(exists("out_0007.vtu"));
  ASSERT_EQ(pardel(with_goal({"check", "pipe.poly", "out.pvtu", "--json", "one.json"})).exit_code, 0);
  for (const int ranks : {1, 2, 3, 9}) {
    const Ran ran = on_ranks(ranks, with_goal({"check", "pipe.poly", "out.pvtu", "--json", "ranks.json"}));
    EXPECT_EQ(ran.exit_code, 0) << ran;
    EXPECT_EQ(read("ranks.json"), with_ranks(read("one.json"), ranks));
  }
  for (const int ranks : {1, 2, 3}) {
    const Ran ran = on_ranks(ranks, {"check", "pipe.poly", "out.pvtu", "--max-area", "1.9e-4", "--min-angle", "25"});
    EXPECT_EQ(ran.exit_code, 1) << ran;
    EXPECT_TRUE(holds(ran.out, {"NOT VALID", "large area: ", "small angle: "})) << ran;
  }
}

TEST_F(PardelMpi, check_reports_a_piece_that_one_rank_cannot_read) {
  ASSERT_EQ(
      on_ranks(2, {"mesh", "pipe.poly", "-o", "out.pvtu", "--max-area", "2e-4", "--interior", "fill", "--pieces", "4"})
          .exit_code,
      0);
  fs::remove(folder_ / "work" / "out_0003.vtu");
  for (const int ranks : {1, 2, 3}) {
    const Ran ran = on_ranks(ranks, {"check", "pipe.poly", "out.pvtu", "--max-area", "2e-4"});
    EXPECT_EQ(ran.exit_code, 5) << ran;
    EXPECT_TRUE(holds(ran.err, {"out.pvtu: ", "out_0003.vtu: cannot be opened"})) << ran;
  }
}

/// A .vtu lists the attributes of its own triangles only. A rank that joined several pieces took the regions of all for
/// those of the first.
TEST_F(PardelMpi, check_finds_the_regions_of_pieces_right_on_fewer_ranks_than_pieces) {
  EXPECT_TRUE(write_poly(domains::regions(), folder_ / "work" / "regions.poly"));
  ASSERT_EQ(on_ranks(4, {"mesh", "regions.poly", "-o", "out.pvtu", "--max-area", "2e-5"}).exit_code, 0);
  for (const int ranks : {1, 2, 3, 4}) {
    const Ran ran = on_ranks(ranks, {"check", "regions.poly", "out.pvtu", "--max-area", "2e-5"});
    EXPECT_EQ(ran.exit_code, 0) << ran;
  }
}

TEST_F(PardelMpi, check_lists_what_is_wrong) {
  ASSERT_EQ(on_ranks(2, {"mesh", "pipe.poly", "-o", "out.pvtu", "--max-area", "1e-3"}).exit_code, 0);
  const Ran ran = on_ranks(2, {"check", "pipe.poly", "out.pvtu", "--max-area", "9e-4", "--min-angle", "25"});
  EXPECT_EQ(ran.exit_code, 1) << ran;
  EXPECT_TRUE(holds(ran.out, {"NOT VALID", "large area: ", "small angle: "})) << ran;
}

TEST_F(PardelMpi, check_writes_why_a_domain_is_refused) {
  ASSERT_EQ(on_ranks(2, {"mesh", "pipe.poly", "-o", "out.pvtu", "--max-area", "1e-3"}).exit_code, 0);
  std::ofstream(folder_ / "work" / "two.poly") << "2 2 0 0\n1 0 0\n2 1 0\n0 0\n0\n";
  const Ran ran = on_ranks(2, {"check", "two.poly", "out.pvtu", "--json", "refused.json"});
  EXPECT_EQ(ran.exit_code, 3) << ran;
  EXPECT_TRUE(holds(read("refused.json"), {"\"schema\": \"pardel.error/1\"", "\"file\": \"two.poly\"", "one line"}));
}

TEST_F(PardelMpi, check_refuses_pieces_that_do_not_belong_together) {
  ASSERT_EQ(on_ranks(2, {"mesh", "pipe.poly", "-o", "out.pvtu", "--max-area", "1e-4"}).exit_code, 0);
  ASSERT_EQ(on_ranks(2, {"mesh", "pipe.poly", "-o", "other.pvtu", "--max-area", "2e-4"}).exit_code, 0);
  fs::rename(folder_ / "work" / "other_0001.vtu", folder_ / "work" / "out_0001.vtu");
  const Ran ran = on_ranks(2, {"check", "pipe.poly", "out.pvtu"});
  EXPECT_EQ(ran.exit_code, 3) << ran;
  EXPECT_TRUE(holds(ran.err, {"out.pvtu: "})) << ran;
  EXPECT_EQ(on_ranks(2, {"check", "pipe.poly", "missing.pvtu"}).exit_code, 5);
  EXPECT_EQ(on_ranks(2, {"check", "pipe.poly", "out_0000.vtu"}).exit_code, 2);
}

TEST_F(PardelMpi, writes_the_same_files_of_triangle_on_any_number_of_ranks_and_threads) {
  const Result<Meshed> whole = mesh(domains::pipe(), Goal{.max_area = 2e-4});
  std::map<std::string, std::string> expected;
  for (const auto& [ranks, threads] : {std::pair{1, "1"}, {2, "3"}, {3, "1"}, {4, "2"}, {8, "1"}}) {
    const Ran ran =
        on_ranks(ranks, {"mesh", "pipe.poly", "-o", "out.node", "--max-area", "2e-4", "--threads", threads});
    ASSERT_EQ(ran.exit_code, 0) << ran;
    EXPECT_EQ(files(), (Files{"pipe.poly", "out.node", "out.ele", "out.poly"}));
    for (const char* file : {"out.node", "out.ele", "out.poly"})
      EXPECT_TRUE(expected.try_emplace(file, read(file)).first->second == read(file)) << file << ranks;
  }
  const Result<Mesh> together = read_mesh(folder_ / "work" / "out.ele");
  ASSERT_TRUE(together) << together.error().message;
  EXPECT_EQ(to_string(digest(*together)), to_string(digest(whole->mesh)));
}

TEST_F(PardelMpi, writes_several_outputs_and_pieces_for_gmsh_that_pardel_reads) {
  const Ran ran = on_ranks(3, {"mesh", "pipe.poly", "-o", "out.msh", "-o", "out.ele", "--max-area", "1e-3"});
  ASSERT_EQ(ran.exit_code, 0) << ran;
  EXPECT_EQ(files(), (Files{"pipe.poly", "out_1.msh", "out_2.msh", "out_3.msh", "out.node", "out.ele", "out.poly"}));
  for (const char* file : {"out.msh", "out.ele"}) {
    const Ran checked = pardel({"check", "pipe.poly", file, "--max-area", "1e-3"});
    EXPECT_EQ(checked.exit_code, 0) << checked;
  }
  const Ran converted = pardel({"convert", "out.msh", "whole.off"});
  EXPECT_EQ(converted.exit_code, 0) << converted;
  const Ran drawn = pardel({"draw", "out_2.msh", "piece.svg"});
  EXPECT_EQ(drawn.exit_code, 0) << drawn;
}

TEST_F(PardelMpi, triangulates_points_that_no_rank_has_as_a_whole) {
  const Pslg points = domains::random_points(4'000, 5);
  ASSERT_TRUE(write_poly(points, folder_ / "work" / "points.poly"));
  const Result<Meshed> whole = triangulate(points);
  ASSERT_TRUE(whole);
  std::map<std::string, std::string> expected;
  for (const int ranks : {1, 2, 3, 5}) {
    const Ran ran = on_ranks(ranks, {"triangulate", "points.poly", "-o", "out.pvtu", "-o", "out.node"});
    ASSERT_EQ(ran.exit_code, 0) << ran;
    EXPECT_TRUE(holds(ran.out, {"digest  " + to_string(digest(whole->mesh)), "mesh    4000 vertices, "})) << ran;
    for (const char* file : {"out.node", "out.ele", "out.poly"})
      EXPECT_TRUE(expected.try_emplace(file, read(file)).first->second == read(file)) << file << ranks;
    const Ran checked = pardel({"check", "points.poly", "out.pvtu", "--min-angle", "0"});
    EXPECT_EQ(checked.exit_code, 0) << checked;
  }
}

TEST_F(PardelMpi, meshes_points_that_no_rank_has_as_a_whole) {
  Pslg points = domains::random_points(4'000, 6);
  for (int i = 0; i < 4'000; ++i) points.point_markers.push_back(i % 7);
  ASSERT_TRUE(write_poly(points, folder_ / "work" / "points.poly"));
  const Result<Meshed> whole = mesh(points, Goal{.min_angle_deg = 26});
  ASSERT_TRUE(whole);
  std::map<std::string, std::string> expected;
  for (const auto& [ranks, threads] : {std::pair{1, "1"}, {2, "2"}, {3, "1"}, {5, "1"}}) {
    const Ran ran = on_ranks(ranks, {"mesh", "points.poly", "-o", "out.pvtu", "-o", "out.node", "--min-angle", "26",
                                     "--triangles-per-tile", "300", "--read", "parts", "--threads", threads});
    ASSERT_EQ(ran.exit_code, 0) << ran;
    for (const char* file : {"out.node", "out.ele", "out.poly"})
      EXPECT_TRUE(expected.try_emplace(file, read(file)).first->second == read(file)) << file << ranks;
    const Ran checked = on_ranks(2, {"check", "points.poly", "out.pvtu", "--min-angle", "26"});
    EXPECT_EQ(checked.exit_code, 0) << checked;
  }
}

/// Three regions and a hole, with points in and around them; markers of points and segments.
Pslg survey() {
  Pslg pslg = domains::regions();
  pslg.points.insert(pslg.points.end(), {{0.2, 0.2}, {0.4, 0.2}, {0.3, 0.4}});
  const auto last = static_cast<Index>(pslg.points.size() - 1);
  for (const Segment side : {Segment{last - 2, last - 1, 5}, {last - 1, last, 6}, {last, last - 2, 7}})
    pslg.segments.push_back(side);
  pslg.has_segment_markers = true;
  pslg.holes.push_back({0.3, 0.3});
  for (const Point p : domains::random_points(4'000, 8).points)
    pslg.points.push_back({3.3 * p.x - 0.15, 1.1 * p.y - 0.05});
  for (Index i = 0; i < pslg.points.size(); ++i) pslg.point_markers.push_back(static_cast<int>(i % 7));
  return pslg;
}

TEST_F(PardelMpi, meshes_a_domain_whose_points_no_rank_has_as_a_whole) {
  ASSERT_TRUE(write_poly(survey(), folder_ / "work" / "survey.poly"));
  std::map<std::string, std::string> expected;
  for (const auto& [ranks, threads] : {std::pair{1, "1"}, {2, "2"}, {3, "1"}, {5, "1"}}) {
    const Ran ran =
        on_ranks(ranks, {"mesh", "survey.poly", "-o", "out.pvtu", "-o", "out.node", "--min-angle", "26", "--regions",
                         "--triangles-per-tile", "300", "--read", "parts", "--threads", threads});
    ASSERT_EQ(ran.exit_code, 0) << ran;
    for (const char* file : {"out.node", "out.ele", "out.poly"})
      EXPECT_TRUE(expected.try_emplace(file, read(file)).first->second == read(file)) << file << ranks;
    const Ran checked = on_ranks(2, {"check", "survey.poly", "out.pvtu", "--min-angle", "26", "--regions"});
    EXPECT_EQ(checked.exit_code, 0) << checked;
  }
}

/// The text of a file, with comments that make it larger than what all ranks read.
std::string with_comments(std::string text) {
  const std::string comment = "# " + std::string(97, '-') + "\n";
  while (text.size() <= 8 << 20) text += comment;
  return text;
}

TEST_F(PardelMpi, reads_a_large_input_in_parts_and_makes_the_same_mesh_of_the_whole) {
  ASSERT_TRUE(write_poly(survey(), folder_ / "work" / "survey.poly"));
  write("large.poly", with_comments(read("survey.poly")));
  const auto mesh_of = [&](const std::string& input, const std::vector<std::string>& more) {
    std::vector<std::string> arguments = {"mesh", input, "-o", "out.pvtu", "--min-angle", "26", "--regions"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return on_ranks(2, arguments);
  };
  const auto digest_in = [](const Ran& ran) { return ran.out.substr(ran.out.find("digest"), 40); };
  const Ran of_small = mesh_of("survey.poly", {}), of_large = mesh_of("large.poly", {});
  EXPECT_TRUE(holds(of_small.out, {"each has read the whole input"})) << of_small;
  EXPECT_TRUE(holds(of_large.out, {"each has read a part of the input"})) << of_large;
  EXPECT_EQ(digest_in(of_small), digest_in(of_large));
  EXPECT_TRUE(holds(mesh_of("survey.poly", {"--read", "parts"}).out, {"each has read a part of the input"}));
  EXPECT_TRUE(holds(mesh_of("large.poly", {"--read", "whole"}).out, {"each has read the whole input"}));
  // A gradation needs all of the input.
  EXPECT_TRUE(holds(mesh_of("large.poly", {"--grading", "0.3"}).out, {"each has read the whole input"}));
  const Ran refused = mesh_of("survey.poly", {"--grading", "0.3", "--read", "parts"});
  EXPECT_EQ(refused.exit_code, 2) << refused;
  EXPECT_TRUE(holds(refused.err, {"--read parts needs"})) << refused;
}

TEST_F(PardelMpi, meshes_and_checks_with_the_lengths_of_a_drawing) {
  // Two polygons that cross. Without the repair they are refused, as by pardel.
  write("lengths.geojson", R"({"type": "Feature", "properties": {"length": 0.02}, "geometry": {"type": "MultiPolygon",
    "coordinates": [[[[-1, -1], [0, -1], [0, 0], [-1, 0], [-1, -1]]], [[[-0.5, -0.5], [1, -0.5], [1, 1], [-0.5, -0.5]]]]}})");
  const std::vector<std::string> goal = {"--grading", "0.5", "--sources", "lengths.geojson"};
  const auto with_goal = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.end(), goal.begin(), goal.end());
    return arguments;
  };
  EXPECT_EQ(on_ranks(2, with_goal({"mesh", "pipe.poly", "-o", "out.pvtu"})).exit_code, 3);
  const Ran ran = on_ranks(2, with_goal({"mesh", "pipe.poly", "-o", "out.pvtu", "--repair", "--check"}));
  ASSERT_EQ(ran.exit_code, 0) << ran;
  const Ran check = on_ranks(2, with_goal({"check", "pipe.poly", "out.pvtu"}));
  EXPECT_EQ(check.exit_code, 0) << check;
  const Ran alone = run(PARDEL_PROGRAM, with_goal({"mesh", "pipe.poly", "-o", "one.vtu", "--repair"}));
  const std::string digest_of_ranks = ran.out.substr(ran.out.find("digest"), 40);
  EXPECT_TRUE(holds(alone.out, {digest_of_ranks})) << alone;
}

TEST_F(PardelMpi, counts_the_points_in_a_node_file_as_input) {
  const Pslg points = domains::random_points(1'000, 9);
  ASSERT_TRUE(write_poly(points, folder_ / "work" / "points.poly"));
  std::string node = read("points.poly");
  std::size_t end = 0;
  for (int lines = 0; lines < 1 + 1'000; ++lines) end = node.find('\n', end) + 1;  // the header and the points
  node.resize(end);
  write("points.node", with_comments(node));
  write("points.poly", "0 2 0 0\n0 0\n0\n");
  const Ran ran = on_ranks(2, {"mesh", "points.poly", "-o", "out.pvtu", "--min-angle", "26", "--convex-hull"});
  EXPECT_EQ(ran.exit_code, 0) << ran;
  EXPECT_TRUE(holds(ran.out, {"each has read a part of the input"})) << ran;
}

TEST_F(PardelMpi, says_what_is_wrong_with_a_domain_as_pardel_does) {
  Pslg inside = survey(), crossing = survey(), open = survey();
  inside.points[20] = {0.3, 0.2};
  crossing.segments.push_back({30, 900, 0});
  open.segments = {{0, 1, 0}};
  for (const Pslg& pslg : {inside, crossing, open}) {
    ASSERT_TRUE(write_poly(pslg, folder_ / "work" / "survey.poly"));
    const Ran expected = pardel({"mesh", "survey.poly", "-o", "out.msh"});
    for (const char* what : {"whole", "parts"}) {
      const Ran ran = on_ranks(3, {"mesh", "survey.poly", "-o", "out.pvtu", "--read", what});
      EXPECT_EQ(ran.exit_code, 3) << ran;
      EXPECT_TRUE(holds(ran.err, {expected.err.substr(expected.err.find(": "))})) << ran << expected;
      EXPECT_EQ(files(), (Files{"pipe.poly", "survey.poly"}));
    }
  }
}

TEST_F(PardelMpi, says_once_what_is_wrong_with_points) {
  Pslg points = domains::random_points(500, 7);
  points.points[420] = points.points[3];
  ASSERT_TRUE(write_poly(points, folder_ / "work" / "points.poly"));
  const std::vector<std::vector<std::string>> commands = {
      {"triangulate"}, {"mesh", "--read", "parts"}, {"mesh", "--read", "whole"}};
  for (std::vector<std::string> command : commands) {
    command.insert(command.end(), {"points.poly", "-o", "out.pvtu"});
    const Ran ran = on_ranks(3, command);
    EXPECT_EQ(ran.exit_code, 3) << ran;
    EXPECT_TRUE(holds(ran.err, {"pardel-mpi: points.poly: Points 4 and 421 are both at", "repairs such problems"}))
        << ran;
  }
  const Ran segments = on_ranks(2, {"triangulate", "pipe.poly", "-o", "out.pvtu"});
  EXPECT_EQ(segments.exit_code, 2) << segments;
  EXPECT_TRUE(holds(segments.err, {"pipe.poly: it has segments"})) << segments;
  EXPECT_EQ(on_ranks(2, {"triangulate", "missing.node", "-o", "out.pvtu"}).exit_code, 5);
  EXPECT_EQ(files(), (Files{"pipe.poly", "points.poly"}));
}

TEST_F(PardelMpi, writes_pieces_of_a_filled_mesh_for_gmsh) {
  const std::vector<std::string> arguments{"mesh",       "pipe.poly", "-o",         "out.msh",
                                           "--max-area", "2e-4",      "--interior", "fill"};
  const Ran ran = on_ranks(3, arguments);
  ASSERT_EQ(ran.exit_code, 0) << ran;
  EXPECT_EQ(files(), (Files{"pipe.poly", "out_1.msh", "out_2.msh", "out_3.msh"}));
  const Result<Mesh> whole = read_mesh(folder_ / "work" / "out.msh");
  ASSERT_TRUE(whole) << whole.error().message;
  const Result<Meshed> expected = mesh(domains::pipe(), Goal{.max_area = 2e-4}, {.interior = Interior::fill});
  ASSERT_TRUE(expected);
  EXPECT_GT(expected->report.laid, 1000U);
  EXPECT_EQ(whole->triangles.size(), expected->mesh.triangles.size());
  const Certificate certificate = check(domains::pipe(), *whole, Goal{.max_area = 2e-4}, {.foreign = true});
  EXPECT_TRUE(certificate.valid) << to_text(certificate);
  EXPECT_GT(certificate.equilateral, 1000U);
  const Ran checked = pardel({"check", "pipe.poly", "out.msh", "--max-area", "2e-4"});
  EXPECT_EQ(checked.exit_code, 0) << checked;

  std::vector<std::string> in_turn = arguments;
  in_turn.insert(in_turn.end(), {"--pieces", "6"});
  const Ran refused = on_ranks(3, in_turn);
  EXPECT_EQ(refused.exit_code, 2) << refused;
  EXPECT_TRUE(holds(refused.err, {"--pieces needs one output, OUT.pvtu"})) << refused;
}

TEST_F(PardelMpi, replaces_no_piece_that_it_reads_and_hides_none_that_it_writes) {
  ASSERT_EQ(on_ranks(2, {"mesh", "pipe.poly", "-o", "out.pvtu", "-q"}).exit_code, 0);
  const std::string piece = read("out_0001.vtu");
  const Ran check = on_ranks(2, {"check", "pipe.poly", "out.pvtu", "--json", "out_0001.vtu"});
  EXPECT_EQ(check.exit_code, 2) << check;
  EXPECT_TRUE(holds(check.err, {"would replace files of the input", "out_0001.vtu"})) << check;
  const Ran convert = pardel({"convert", "out.pvtu", "out_0001.vtu"});
  EXPECT_EQ(convert.exit_code, 2) << convert;
  EXPECT_TRUE(holds(convert.err, {"would replace files of the input", "out_0001.vtu"})) << convert;
  EXPECT_TRUE(read("out_0001.vtu") == piece);
  const Ran mesh = on_ranks(2, {"mesh", "pipe.poly", "-o", "y.msh", "-o", "y_1.msh"});
  EXPECT_EQ(mesh.exit_code, 2) << mesh;
  EXPECT_TRUE(holds(mesh.err, {"y_1.msh"})) << mesh;
  EXPECT_FALSE(exists("y_1.msh"));
}

TEST_F(PardelMpi, refuses_what_pardel_refuses_and_standard_input) {
  const Ran fill = on_ranks(2, {"mesh", "pipe.poly", "-o", "out.pvtu", "--interior", "fill"});
  EXPECT_EQ(fill.exit_code, 2) << fill;
  EXPECT_TRUE(holds(fill.err, {"--interior fill needs --max-area, --max-edge or --regions"})) << fill;
  for (const std::vector<std::string>& arguments :
       std::vector<std::vector<std::string>>{{"mesh", "-", "-o", "out.pvtu"},
                                             {"mesh", "pipe.poly", "--sizes", "-", "-o", "out.pvtu"},
                                             {"check", "-", "out.pvtu"}}) {
    const Ran ran = on_ranks(2, arguments);
    EXPECT_EQ(ran.exit_code, 2) << ran;
    EXPECT_TRUE(holds(ran.err, {"standard input goes to one rank only"})) << ran;
  }
  EXPECT_EQ(files(), Files{"pipe.poly"});
}

TEST_F(PardelMpi, replaces_and_hides_no_other_file) {
  EXPECT_EQ(on_ranks(2, {"mesh", "pipe.poly", "-o", "pipe.node"}).exit_code, 2);
  write("out.msh", "a mesh of the user");
  const Ran ran = on_ranks(2, {"mesh", "pipe.poly", "-o", "out.msh"});
  EXPECT_EQ(ran.exit_code, 2);
  EXPECT_TRUE(holds(ran.err, {"out.msh: this file exists, and would hide the pieces out_1.msh, ..."})) << ran;
  EXPECT_EQ(files(), (Files{"pipe.poly", "out.msh"}));
}

TEST_F(PardelMpi, never_replaces_the_field_of_sizes_by_a_piece) {
  ASSERT_EQ(on_ranks(2, {"mesh", "pipe.poly", "-o", "sizes.pvtu", "--max-area", "1e-2"}).exit_code, 0);
  write("index.pvtu", read("sizes.pvtu"));  // another name for the same pieces
  const std::string before = read("sizes_0001.vtu");
  for (const char* sizes : {"sizes_0001.vtu", "sizes.pvtu", "index.pvtu"}) {
    const Ran ran = on_ranks(2, {"mesh", "pipe.poly", "-o", "./sizes.pvtu", "--sizes", sizes});
    EXPECT_EQ(ran.exit_code, 2) << ran;
    EXPECT_TRUE(holds(ran.err, {"would replace files of the input"})) << ran;
    EXPECT_TRUE(read("sizes_0001.vtu") == before);
  }
}

TEST_F(PardelMpi, puts_pieces_beside_the_file_that_a_link_leads_to) {
  fs::create_directories(folder_ / "work" / "real");
  write("real/out.pvtu", "an earlier file\n");
  fs::create_symlink("real/out.pvtu", folder_ / "work" / "link.pvtu");
  const Ran ran = on_ranks(2, {"mesh", "pipe.poly", "-o", "link.pvtu", "--max-area", "1e-3"});
  ASSERT_EQ(ran.exit_code, 0) << ran;
  EXPECT_TRUE(fs::is_symlink(folder_ / "work" / "link.pvtu"));
  EXPECT_TRUE(exists("real/out_0000.vtu"));
  EXPECT_TRUE(exists("real/out_0001.vtu"));
  const Result<Mesh> whole = read_mesh(folder_ / "work" / "real" / "out.pvtu");
  ASSERT_TRUE(whole) << whole.error().message;
  EXPECT_EQ(to_string(digest(*whole)), to_string(digest(mesh(domains::pipe(), Goal{.max_area = 1e-3})->mesh)));
}

TEST_F(PardelMpi, writes_regular_files_only) {
  const fs::path work = folder_ / "work";
  fs::create_symlink("/dev/null", work / "null.pvtu");
  fs::create_symlink("/dev/null", work / "out_0001.vtu");
  fs::create_symlink("/dev/null", work / "out_2.msh");
  fs::create_symlink("/dev/null", work / "out.ele");
  fs::create_symlink("a&b.pvtu", work / "and.pvtu");
  const Files before = files();
  for (const auto& [output, message] : {std::pair{"null.pvtu", "null.pvtu: this is not a regular file"},
                                        {"out.pvtu", "out_0001.vtu: this is not a regular file"},
                                        {"out.msh", "out_2.msh: this is not a regular file"},
                                        {"out.node", "out.ele: this is not a regular file"},
                                        {"and.pvtu", "must not contain <, >, & or"}}) {
    const Ran ran = on_ranks(2, {"mesh", "pipe.poly", "-o", output, "--max-area", "1e-3"});
    EXPECT_EQ(ran.exit_code, 2) << ran;
    EXPECT_TRUE(holds(ran.err, {message})) << ran;
    EXPECT_EQ(files(), before);
  }
  EXPECT_FALSE(fs::exists("/dev/null_0000.vtu"));
}

TEST_F(PardelMpi, makes_the_file_that_a_link_leads_to) {
  const fs::path work = folder_ / "work";
  fs::create_directories(work / "real");
  fs::create_symlink("real/new.pvtu", work / "link.pvtu");
  const Ran ran = on_ranks(2, {"mesh", "pipe.poly", "-o", "link.pvtu", "--max-area", "1e-3"});
  EXPECT_EQ(ran.exit_code, 0) << ran;
  EXPECT_TRUE(fs::is_symlink(work / "link.pvtu"));
  EXPECT_TRUE(read_mesh(work / "real" / "new.pvtu"));
}

/// Ranks with different working folders stand for machines that have no folder in common.
TEST_F(PardelMpi, says_that_the_folder_of_the_output_is_not_the_same_on_all_machines) {
  const fs::path work = folder_ / "work";
  const auto on_two_machines = [&](const std::string& output) {
    std::vector<std::string> arguments{"--oversubscribe", "--bind-to", "none"};
    for (const char* machine : {"one", "two"}) {
      fs::create_directories(work / machine);
      if (arguments.size() > 3) arguments.emplace_back(":");
      arguments.insert(arguments.end(), {"-n", "1", "-wdir", work / machine, PARDEL_MPI_PROGRAM, "mesh",
                                         work / "pipe.poly", "-o", output, "--max-area", "0.01", "--threads", "1"});
    }
    return run(PARDEL_MPIRUN, arguments);
  };
  for (const std::string output : {"out.pvtu", "out.msh", "out.node"}) {
    const Ran ran = on_two_machines(output);
    EXPECT_EQ(ran.exit_code, 5) << ran;
    EXPECT_TRUE(holds(ran.err, {"pardel-mpi: rank 1: " + output + ": rank 0 has made the file out",
                                "the folder of the output must be the same on all machines"}))
        << ran;
    EXPECT_TRUE(fs::is_empty(work / "one")) << output;
    EXPECT_TRUE(fs::is_empty(work / "two")) << output;
  }
}

TEST_F(PardelMpi, has_one_message_for_an_error_of_all_ranks) {
  const std::vector<std::pair<std::vector<std::string>, std::string>> cases = {
      {{"--pieces", "1"}, "pardel-mpi: --pieces 1: there are 2 ranks, and each makes at least one piece\n"},
      {{"--pieces", "5"}, "pardel-mpi: --pieces 5: more pieces than ranks need --interior fill, and"},
      {{"--pieces", "5", "--interior", "fill"}, "pardel-mpi: --pieces 5: more pieces than ranks need"},
      {{"--pieces", "5", "--interior", "fill", "--max-area", "0.1", "--grading", "0.2"},
       "pardel-mpi: --pieces 5: more pieces than ranks need"}};
  for (const auto& [more, message] : cases) {
    std::vector<std::string> arguments{"mesh", "pipe.poly", "-o", "out.pvtu"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Ran ran = on_ranks(2, arguments);
    EXPECT_EQ(ran.exit_code, 2) << ran;
    const std::size_t first = ran.err.find(message);
    EXPECT_NE(first, std::string::npos) << ran;
    EXPECT_EQ(ran.err.find("pardel", first + message.size()), std::string::npos) << ran;
    EXPECT_EQ(ran.err.find("MPI_ABORT"), std::string::npos) << ran;
    EXPECT_EQ(ran.err.find("interrupted"), std::string::npos) << ran;
  }
  EXPECT_EQ(files(), Files{"pipe.poly"});
}

TEST_F(PardelMpi, writes_the_same_arrays_for_a_rank_without_triangles) {
  EXPECT_TRUE(write_poly(domains::regions(), folder_ / "work" / "regions.poly"));
  const Ran ran = on_ranks(3, {"mesh", "regions.poly", "-o", "out.pvtu"});
  ASSERT_EQ(ran.exit_code, 0) << ran;
  EXPECT_TRUE(holds(read("out.pvtu"), {"Name=\"region\"", "Name=\"GlobalNodeId\""}));
  for (const char* piece : {"out_0000.vtu", "out_0001.vtu", "out_0002.vtu"})
    EXPECT_TRUE(holds(read(piece), {"Name=\"region\"", "Name=\"marker\"", "Name=\"GlobalNodeId\""})) << piece;
  const Result<Mesh> whole = read_mesh(folder_ / "work" / "out.pvtu");
  ASSERT_TRUE(whole) << whole.error().message;
  EXPECT_EQ(to_string(digest(*whole)), to_string(digest(mesh(domains::regions(), Goal{})->mesh)));
}

TEST_F(PardelMpi, says_once_that_a_file_cannot_be_read) {
  const Ran ran = on_ranks(3, {"mesh", "missing.poly", "-o", "out.pvtu"});
  EXPECT_EQ(ran.exit_code, 5) << ran;
  const std::string message = "pardel-mpi: missing.poly: cannot be opened: No such file or directory\n";
  const std::size_t at = ran.err.find(message);
  ASSERT_NE(at, std::string::npos) << ran;
  EXPECT_EQ(ran.err.find(message, at + 1), std::string::npos) << ran;
  EXPECT_EQ(files(), Files{"pipe.poly"});
}

TEST_F(PardelMpi, refuses_an_invalid_domain) {
  write("bow.poly", "4 2 0 0\n0 0 0\n1 1 1\n2 0 1\n3 1 0\n2 0\n0 0 1\n1 2 3\n0\n");
  const Ran ran = on_ranks(2, {"mesh", "bow.poly", "-o", "out.pvtu"});
  EXPECT_EQ(ran.exit_code, 3) << ran;
  EXPECT_TRUE(holds(ran.err, {"cross"}));
  EXPECT_EQ(files(), (Files{"bow.poly", "pipe.poly"}));
}

TEST_F(PardelMpi, refuses_wrong_arguments) {
  EXPECT_EQ(on_ranks(2, {"mesh", "pipe.poly"}).exit_code, 2);
  EXPECT_EQ(on_ranks(2, {"mesh", "pipe.poly", "-o", "out.vtu"}).exit_code, 2);
  EXPECT_EQ(on_ranks(2, {"mesh", "pipe.poly", "-o", "out.pvtu", "--max-area", "-1"}).exit_code, 2);
  EXPECT_EQ(on_ranks(2, {}).exit_code, 2);
  EXPECT_EQ(files(), Files{"pipe.poly"});
}

TEST_F(PardelMpi, writes_no_piece_if_one_cannot_be_written) {
  fs::create_directories(folder_ / "work" / "out_0001.vtu" / "full");
  const Ran ran = on_ranks(3, {"mesh", "pipe.poly", "-o", "out.pvtu", "--max-area", "1e-3"});
  EXPECT_EQ(ran.exit_code, 5) << ran;
  EXPECT_TRUE(holds(ran.err, {"rank 1: ", "out_0001.vtu"}));
  EXPECT_EQ(files(), (Files{"pipe.poly", "out_0001.vtu"}));
}

TEST_F(PardelMpi, has_a_help) {
  const Ran ran = on_ranks(2, {"--help"});
  EXPECT_EQ(ran.exit_code, 0) << ran;
  const std::size_t at = ran.out.find("pardel-mpi: guaranteed-quality");
  ASSERT_NE(at, std::string::npos) << ran;
  EXPECT_EQ(ran.out.find("pardel-mpi: guaranteed-quality", at + 1), std::string::npos);
  EXPECT_EQ(on_ranks(1, {"mesh", "--help"}).exit_code, 0);
  EXPECT_EQ(on_ranks(1, {"help", "mesh"}).out, on_ranks(1, {"mesh", "--help"}).out);
}

}  // namespace
}  // namespace pardel
