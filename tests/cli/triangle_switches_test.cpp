// The parser of Triangle's switches.
#include <string>
#include <vector>

#include "program.hpp"

namespace pardel::testing {
namespace {

class TriangleSwitches : public Workshop {
 protected:
  TriangleSwitches() { write("a.poly", square_poly); }

  void is_usage_error(const std::vector<std::string>& arguments, const std::vector<std::string>& words) const {
    std::vector<std::string> all = {"triangle"};
    all.insert(all.end(), arguments.begin(), arguments.end());
    const Ran ran = pardel(all);
    EXPECT_EQ(ran.exit_code, 2) << ran;
    EXPECT_TRUE(holds(ran.err, words));
    EXPECT_EQ(ran.out, "");
    EXPECT_EQ(files(), Files{"a.poly"});
  }
};

TEST_F(TriangleSwitches, the_help_names_every_switch_of_triangle) {
  for (const std::string argument : {"-h", "-H", "-?", "-ph", "--help"}) {
    const Ran ran = pardel({"triangle", argument});
    EXPECT_EQ(ran.exit_code, 0) << argument;
    EXPECT_TRUE(holds(ran.out, {"smallest angle", "largest area", "Voronoi", "refused"}));
  }
}

TEST_F(TriangleSwitches, a_switch_that_is_not_supported_is_refused_by_name) {
  is_usage_error({"-pqv", "a"}, {"switch v", "Voronoi"});
  is_usage_error({"-pqu", "a"}, {"switch u", "user"});
  is_usage_error({"-pw", "a"}, {"switch w", "weighted"});
  is_usage_error({"-pW", "a"}, {"switch W", "weighted"});
}

TEST_F(TriangleSwitches, a_letter_that_is_not_a_switch_is_refused_by_name) { is_usage_error({"-pk", "a"}, {"'k'"}); }

TEST_F(TriangleSwitches, no_file_and_two_files_are_usage_errors) {
  is_usage_error({"-pq"}, {"file"});
  is_usage_error({"-pq", "a", "b"}, {"'a'", "'b'"});
}

TEST_F(TriangleSwitches, an_area_of_zero_and_a_broken_number_are_usage_errors) {
  is_usage_error({"-pa0", "a"}, {"switch a"});
  is_usage_error({"-pa1.2.3", "a"}, {"switch a"});
  is_usage_error({"-pq3.4.5", "a"}, {"switch q"});
}

TEST_F(TriangleSwitches, an_angle_that_is_too_large_is_a_usage_error) {
  const Ran ran = pardel({"triangle", "-Qpq60", "a"});
  EXPECT_EQ(ran.exit_code, 2) << ran;
  EXPECT_TRUE(holds(ran.err, {"between 0 and 45 degrees, not 60\n"}));
}

TEST_F(TriangleSwitches, refining_without_a_number_in_the_name_is_refused) {
  is_usage_error({"-rI", "a"}, {"switch I", "switch r"});
}

TEST_F(TriangleSwitches, switches_may_be_spread_over_arguments_and_follow_the_file) {
  EXPECT_EQ(pardel({"triangle", "-p", "a", "-q", "-a0.1", "-Q"}).exit_code, 0);
  EXPECT_EQ(files(), (Files{"a.poly", "a.1.node", "a.1.ele", "a.1.poly"}));
}

TEST_F(TriangleSwitches, numbers_end_where_the_next_letter_begins) {
  // 30 degrees and area 0.1. The e after 0.1 is the switch for edges, not an exponent.
  EXPECT_EQ(pardel({"triangle", "-Qpq30a0.1e", "a"}).exit_code, 0);
  EXPECT_TRUE(exists("a.1.edge"));
  EXPECT_EQ(pardel({"check", "a.poly", "a.1.ele", "--min-angle", "30", "--max-area", "0.1"}).exit_code, 0);
}

TEST_F(TriangleSwitches, algorithm_switches_are_accepted_and_reported_to_have_no_effect) {
  const Ran plain = pardel({"triangle", "-pq", "a"});
  const auto triangles = table("a.1.ele");
  EXPECT_EQ(plain.out.find("no effect"), std::string::npos);
  const Ran ran = pardel({"triangle", "-pqiFlsXV", "a"});
  EXPECT_EQ(ran.exit_code, 0);
  EXPECT_TRUE(
      holds(ran.out, {"Switch i has no effect", "Switch F has", "Switch l has", "Switch s has", "Switch X has"}));
  EXPECT_EQ(table("a.1.ele"), triangles);
}

TEST_F(TriangleSwitches, quiet_prints_nothing_and_verbose_prints_more) {
  EXPECT_EQ(pardel({"triangle", "-pqQ", "a"}).out, "");
  const Ran plain = pardel({"triangle", "-pq", "a"});
  const Ran verbose = pardel({"triangle", "-pqV", "a"});
  EXPECT_TRUE(holds(plain.out,
                    {"Opening a.poly", "Writing a.1.node", "Writing a.1.ele", "Writing a.1.poly", "Smallest angle"}));
  EXPECT_GT(verbose.out.size(), plain.out.size());
}

}  // namespace
}  // namespace pardel::testing
