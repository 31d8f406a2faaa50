// The command line of pardel-harness: its answers, and its messages about errors.
#include "harness_fixture.hpp"

namespace pardel::testing {
namespace {

class HarnessOptions : public HarnessFixture {
 protected:
  void refuses(const std::vector<std::string>& arguments, int exit_code, const std::vector<std::string>& words) const {
    const Ran ran = harness(arguments);
    EXPECT_EQ(ran.exit_code, exit_code) << ran;
    EXPECT_TRUE(holds(ran.err, words));
    EXPECT_EQ(ran.out, "");
  }
};

TEST_F(HarnessOptions, help_shows_options_examples_and_exit_codes) {
  const Ran ran = harness({"--help"});
  EXPECT_EQ(ran.exit_code, 0);
  EXPECT_TRUE(holds(ran.out, {"--mesher COMMAND", "{poly}", "{out}", "Examples:", "Exit status:", "gmsh", "triangle"}));
}

TEST_F(HarnessOptions, list_families_prints_all_families) {
  const Ran ran = harness({"--list-families"});
  EXPECT_EQ(ran.exit_code, 0);
  EXPECT_TRUE(holds(ran.out, {"cracks\n", "far_offset\n"}));
}

TEST_F(HarnessOptions, a_mesher_is_required) { refuses({}, 2, {"--mesher", "--help"}); }

TEST_F(HarnessOptions, a_command_without_an_argument_for_the_input_is_an_error) {
  refuses({"--mesher", "mesher in {out}"}, 2, {"{poly}"});
}

TEST_F(HarnessOptions, the_message_names_a_missing_program) {
  refuses({"--mesher", "no-such-mesher {poly} {out}"}, 5, {"no program 'no-such-mesher' on the PATH"});
  refuses({"--mesher", "./no-such-mesher {poly} {out}"}, 5, {"no-such-mesher is no program"});
}

TEST_F(HarnessOptions, the_report_and_the_json_cannot_both_go_to_standard_output) {
  refuses({"--mesher", "pardel", "--cases", "1", "--json", "-"}, 2, {"only one output can go to standard output"});
}

TEST_F(HarnessOptions, unknown_families_and_malformed_cases_are_errors) {
  refuses({"--mesher", "pardel", "--families", "cracks,tracks"}, 2, {"no family 'tracks'", "--list-families"});
  refuses({"--mesher", "pardel", "--replay", "1:cracks"}, 2, {"'1:cracks' is no case", "SEED:FAMILY:INDEX"});
  refuses({"--mesher", "pardel", "--cases", "0"}, 2, {"--cases"});
}

TEST_F(HarnessOptions, folders_that_cannot_be_created_are_errors) {
  write("file", "");
  refuses({"--mesher", "pardel", "--failures", "file/folder"}, 5, {"file/folder"});
  refuses({"--mesher", "pardel", "--keep", "/proc/no-such"}, 5, {"/proc/no-such"});
  refuses({"--mesher", "pardel", "--report", "no-such/card.md"}, 5, {"no-such/card.md"});
}

TEST_F(HarnessOptions, report_writes_the_card_to_a_file) {
  const Ran ran = harness({"--mesher", "pardel", "--cases", "11", "--report", "card.md"});
  EXPECT_EQ(ran.exit_code, 0) << ran;
  EXPECT_EQ(ran.out + ran.err, "");
  EXPECT_TRUE(holds(read("card.md"), {"# 11 of 11 valid", "| **all** | 11 | 11 | 0 | 0 | 0 | 0 | 0 |"}));
}

TEST_F(HarnessOptions, progress_is_shown_on_a_terminal_only) {
  if (!terminals_exist()) GTEST_SKIP() << "no terminals here";
  const Ran ran = harness({"--mesher", "pardel", "--cases", "11"}, {.terminal = true});
  EXPECT_TRUE(holds(ran.err, {"11 of 11 cases"}));
}

TEST_F(HarnessOptions, an_interrupt_stops_the_run) {
  if (!terminals_exist()) GTEST_SKIP() << "no terminals here";
  const Ran ran = harness({"--mesher", "sh -c 'test -e once && sleep 600; touch once' {poly}"},
                          {.interrupt_when = "1 of", .terminal = true});
  EXPECT_EQ(ran.exit_code, 130) << ran;
}

}  // namespace
}  // namespace pardel::testing
