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

}  // namespace
}  // namespace pardel::testing
