// pardel check: valid meshes pass. For an invalid mesh, every violation is reported with its place.
#include <nlohmann/json.hpp>
#include <string>

#include "program.hpp"

namespace pardel::testing {
namespace {

using nlohmann::json;

/// The mesh of the square with two triangles, cut along one diagonal.
class CheckCommand : public Workshop {
 protected:
  CheckCommand() {
    write("square.poly", square_poly);
    write("m.node", "4 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n");
    write("m.ele", "2 3 0\n1 1 2 3\n2 1 3 4\n");
  }
};

TEST_F(CheckCommand, a_valid_mesh_of_another_program_is_certified) {
  const Ran ran = pardel({"check", "square.poly", "m.ele"});
  EXPECT_EQ(ran.exit_code, 0) << ran;
  EXPECT_TRUE(holds(ran.out, {"valid"}));
  EXPECT_EQ(ran.err, "");
}

TEST_F(CheckCommand, the_certificate_is_written_as_json) {
  const Ran ran = pardel({"check", "square.poly", "m.ele", "--json", "-"});
  const json certificate = json::parse(ran.out, nullptr, false);
  ASSERT_TRUE(certificate.is_object()) << ran;
  EXPECT_EQ(certificate["schema"], "pardel.certificate/1");
  EXPECT_TRUE(certificate["valid"]);
  EXPECT_EQ(pardel({"check", "square.poly", "m.ele", "-q", "--json", "c.json"}).out, "");
  EXPECT_EQ(json::parse(read("c.json")), certificate);
}

TEST_F(CheckCommand, the_number_of_threads_changes_nothing) {
  const auto certificate = [&](const char* threads) {
    return pardel({"check", "square.poly", "m.ele", "--threads", threads, "--json", "-"}).out;
  };
  const std::string one = certificate("1");
  EXPECT_EQ(json::parse(one)["decided_exactly"], 1) << "the four corners lie on one circle";
  EXPECT_EQ(certificate("2"), one);
  EXPECT_EQ(certificate("all"), one);
  EXPECT_EQ(pardel({"check", "square.poly", "m.ele", "--threads", "none"}).exit_code, 2);
}

TEST_F(CheckCommand, a_missing_triangle_is_a_violation) {
  write("m.ele", "1 3 0\n1 1 2 3\n");
  const Ran ran = pardel({"check", "square.poly", "m.ele"});
  EXPECT_EQ(ran.exit_code, 1) << ran;
  EXPECT_TRUE(holds(ran.out, {"uncovered"}));
}

TEST_F(CheckCommand, a_triangle_the_wrong_way_round_is_a_violation) {
  write("m.ele", "2 3 0\n1 1 3 2\n2 1 3 4\n");
  EXPECT_EQ(pardel({"check", "square.poly", "m.ele"}).exit_code, 1);
}

TEST_F(CheckCommand, a_moved_vertex_is_a_violation) {
  write("m.node", "4 2 0 0\n1 0 0\n2 1 0\n3 1 1.0000000000000002\n4 0 1\n");
  EXPECT_EQ(pardel({"check", "square.poly", "m.ele"}).exit_code, 1);
}

TEST_F(CheckCommand, each_bound_of_the_goal_is_checked) {
  EXPECT_EQ(pardel({"check", "square.poly", "m.ele", "--max-area", "0.5"}).exit_code, 0);
  EXPECT_EQ(pardel({"check", "square.poly", "m.ele", "--max-area", "0.4999999"}).exit_code, 1);
  EXPECT_EQ(pardel({"check", "square.poly", "m.ele", "--min-angle", "44.9"}).exit_code, 0);
  EXPECT_EQ(pardel({"check", "square.poly", "m.ele", "--min-angle", "45.1"}).exit_code, 1);
  EXPECT_EQ(pardel({"check", "square.poly", "m.ele", "--max-edge", "1.42"}).exit_code, 0);
  EXPECT_EQ(pardel({"check", "square.poly", "m.ele", "--max-edge", "1.41"}).exit_code, 1);
  EXPECT_EQ(pardel({"check", "square.poly", "m.ele", "--max-circumradius", "0.7072"}).exit_code, 0);
  EXPECT_EQ(pardel({"check", "square.poly", "m.ele", "--max-circumradius", "0.7071"}).exit_code, 1);
}

TEST_F(CheckCommand, bounds_that_are_missed_are_reported_in_words) {
  const auto words = [this](const std::string& option, const std::string& value) {
    return pardel({"check", "square.poly", "m.ele", option, value}).out;
  };
  EXPECT_TRUE(holds(words("--min-angle", "50"), {"small angle: 2\n  triangle 0: angle 45° is below 50°, at (0, 0)\n"}));
  EXPECT_TRUE(holds(words("--max-area", "0.3"), {"large area: 2\n  triangle 0: area 0.5 is above 0.3, at (0, 0)\n"}));
  EXPECT_TRUE(holds(words("--max-edge", "1.3"), {"edge 2-0 of triangle 0: length 1.41 is above 1.3"}));
  EXPECT_TRUE(holds(words("--max-circumradius", "0.7"), {"triangle 0: circumradius 0.707 is above 0.7"}));
  // More digits are shown where three would not tell the value from the bound.
  EXPECT_TRUE(holds(words("--max-edge", "1.41421"), {"length 1.414214 is above 1.41421"}));
}

TEST_F(CheckCommand, ten_findings_per_kind_are_printed_and_all_are_in_the_json) {
  ASSERT_EQ(pardel({"mesh", "square.poly", "-o", "fine.vtu", "--max-area", "0.0004", "-q"}).exit_code, 0);
  const Ran ran = pardel({"check", "square.poly", "fine.vtu", "--max-edge", "0.0001", "--max-area", "1e-9"});
  EXPECT_EQ(ran.exit_code, 1);
  EXPECT_EQ(pardel({"check", "square.poly", "fine.vtu", "--max-area", "1e-9", "--json", "all.json", "-q"}).exit_code,
            1);
  const json certificate = json::parse(read("all.json"));
  const std::size_t triangles = certificate["mesh"]["triangles"];
  ASSERT_GT(triangles, 1010U);
  EXPECT_EQ(certificate["violations"].size(), triangles);
  std::size_t lines = 0;
  for (std::size_t at = 0; (at = ran.out.find(": area ", at)) != std::string::npos; ++at) ++lines;
  EXPECT_EQ(lines, 10U);
  EXPECT_TRUE(holds(ran.out, {"... and " + std::to_string(triangles - 10) + " more (all in the file of --json)"}));
}

TEST_F(CheckCommand, an_invalid_domain_is_refused) {
  write("bad.poly", "4 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n2 0\n1 1 3\n2 2 4\n0\n");
  const Ran ran = pardel({"check", "bad.poly", "m.ele"});
  EXPECT_EQ(ran.exit_code, 3) << ran;
  EXPECT_TRUE(holds(ran.err, {"bad.poly", "cross"}));
}

TEST_F(CheckCommand, a_mesh_that_cannot_be_read_is_refused_with_its_line) {
  write("m.ele", "2 3 0\n1 1 2 3\n2 1 3 9\n");
  const Ran ran = pardel({"check", "square.poly", "m.ele"});
  EXPECT_EQ(ran.exit_code, 3) << ran;
  EXPECT_TRUE(holds(ran.err, {"m.ele:3:", "9"}));
}

TEST_F(CheckCommand, vertices_that_differ_from_input_points_by_rounding_get_a_hint) {
  write("third.poly", "3 2 0 0\n1 0 0\n2 0.30000000000000004 0\n3 0 1\n3 0\n1 1 2\n2 2 3\n3 3 1\n0\n");
  for (const auto& [x, is_rounded] : {std::pair("0.3", true), std::pair("0.3001", false)}) {
    write("m.off", std::string("OFF\n3 1 0\n0 0 0\n") + x + " 0 0\n0 1 0\n3 0 1 2\n");
    const Ran ran = pardel({"check", "third.poly", "m.off", "--min-angle", "0"});
    EXPECT_EQ(ran.exit_code, 1) << ran;
    EXPECT_EQ(bool(holds(ran.out, {"hint", "rounding", "-bin -format msh41"})), is_rounded) << ran;
  }
}

}  // namespace
}  // namespace pardel::testing
