// The command line: what it answers, and what it says of a mistake.
#include "harness_workshop.hpp"

namespace pardel::testing {
namespace {

class TheHarness : public HarnessWorkshop {
 protected:
  void refuses(const std::vector<std::string>& arguments, int exit_code, const std::vector<std::string>& words) const {
    const Ran ran = harness(arguments);
    EXPECT_EQ(ran.exit_code, exit_code) << ran;
    EXPECT_TRUE(holds(ran.err, words));
    EXPECT_EQ(ran.out, "");
  }
};

TEST_F(TheHarness, ExplainsItself) {
  const Ran ran = harness({"--help"});
  EXPECT_EQ(ran.exit_code, 0);
  EXPECT_TRUE(holds(ran.out, {"--mesher COMMAND", "{poly}", "{out}", "Examples:", "Exit status:", "gmsh", "triangle"}));
}

TEST_F(TheHarness, ListsTheFamilies) {
  const Ran ran = harness({"--list-families"});
  EXPECT_EQ(ran.exit_code, 0);
  EXPECT_TRUE(holds(ran.out, {"cracks\n", "far_offset\n"}));
}

TEST_F(TheHarness, WantsAMesher) { refuses({}, 2, {"--mesher", "--help"}); }

TEST_F(TheHarness, WantsToKnowWhereTheInputGoes) { refuses({"--mesher", "mesher in {out}"}, 2, {"{poly}"}); }

TEST_F(TheHarness, SaysWhichProgramIsNotThere) {
  refuses({"--mesher", "no-such-mesher {poly} {out}"}, 5, {"no program 'no-such-mesher' on the PATH"});
  refuses({"--mesher", "./no-such-mesher {poly} {out}"}, 5, {"no-such-mesher is no program"});
}

TEST_F(TheHarness, RefusesCasesWithoutMeaning) {
  refuses({"--mesher", "pardel", "--families", "cracks,tracks"}, 2, {"no family 'tracks'", "--list-families"});
  refuses({"--mesher", "pardel", "--replay", "1:cracks"}, 2, {"'1:cracks' is no case", "SEED:FAMILY:INDEX"});
  refuses({"--mesher", "pardel", "--cases", "0"}, 2, {"--cases"});
}

TEST_F(TheHarness, RefusesFoldersThatCannotBe) {
  write("file", "");
  refuses({"--mesher", "pardel", "--failures", "file/folder"}, 5, {"file/folder"});
  refuses({"--mesher", "pardel", "--keep", "/proc/no-such"}, 5, {"/proc/no-such"});
  refuses({"--mesher", "pardel", "--report", "no-such/card.md"}, 5, {"no-such/card.md"});
}

TEST_F(TheHarness, WritesTheReportToAFile) {
  const Ran ran = harness({"--mesher", "pardel", "--cases", "11", "--report", "card.md"});
  EXPECT_EQ(ran.exit_code, 0) << ran;
  EXPECT_EQ(ran.out + ran.err, "");
  EXPECT_TRUE(holds(read("card.md"), {"# 11 of 11 valid", "| **all** | 11 | 11 | 0 | 0 | 0 | 0 | 0 |"}));
}

TEST_F(TheHarness, ShowsHowFarItIsOnATerminalOnly) {
  if (!terminals_exist()) GTEST_SKIP() << "no terminals here";
  const Ran ran = harness({"--mesher", "pardel", "--cases", "11"}, {.terminal = true});
  EXPECT_TRUE(holds(ran.err, {"11 of 11 cases"}));
}

TEST_F(TheHarness, StopsAtAnInterrupt) {
  if (!terminals_exist()) GTEST_SKIP() << "no terminals here";
  const Ran ran = harness({"--mesher", "sh -c 'test -e once && sleep 600; touch once' {poly}"},
                          {.interrupt_when = "1 of", .terminal = true});
  EXPECT_EQ(ran.exit_code, 130) << ran;
}

}  // namespace
}  // namespace pardel::testing
