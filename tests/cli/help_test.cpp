// --help and --version; and wrong command lines, which give a message on stderr and exit code 2.
#include <sstream>
#include <string>
#include <vector>

#include "program.hpp"

namespace pardel::testing {
namespace {

using Help = Workshop;

TEST_F(Help, help_lists_the_commands_examples_and_exit_codes) {
  const Ran ran = pardel({"--help"});
  EXPECT_EQ(ran.exit_code, 0);
  EXPECT_TRUE(
      holds(ran.out, {"mesh", "check", "doctor", "draw", "generate", "triangle", "Examples:", "Exit status:", "130"}));
  EXPECT_EQ(ran.err, "");
}

TEST_F(Help, every_command_has_a_help_with_an_example) {
  for (const std::string command : {"mesh", "check", "doctor", "draw", "generate"}) {
    const Ran ran = pardel({command, "--help"});
    EXPECT_EQ(ran.exit_code, 0) << command;
    EXPECT_TRUE(holds(ran.out, {"Example", "pardel " + command}));
  }
}

TEST_F(Help, no_line_of_help_is_wider_than_a_page) {
  for (const std::vector<std::string>& arguments : std::vector<std::vector<std::string>>{
           {"--help"}, {"mesh", "--help"}, {"check", "--help"}, {"doctor", "--help"}, {"triangle", "-h"}}) {
    std::istringstream lines(pardel(arguments).out);
    for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 132U) << line;
  }
}

TEST_F(Help, the_version_is_printed) {
  for (const char* option : {"--version", "-V"}) {
    const Ran ran = pardel({option});
    EXPECT_EQ(ran.exit_code, 0);
    EXPECT_TRUE(holds(ran.out, {"pardel "}));
  }
}

TEST_F(Help, the_command_help_prints_what_the_option_prints) {
  EXPECT_EQ(pardel({"help"}).out, pardel({"--help"}).out);
  for (const std::string command : {"mesh", "check", "doctor", "draw", "generate", "triangle"}) {
    const Ran ran = pardel({"help", command});
    EXPECT_EQ(ran.exit_code, 0) << command;
    EXPECT_EQ(ran.out, pardel({command, "--help"}).out) << command;
  }
  EXPECT_EQ(pardel({"help", "fly"}).exit_code, 2);
}

TEST_F(Help, a_mistyped_command_or_option_gets_a_suggestion) {
  EXPECT_TRUE(holds(pardel({"chekc"}).err, {"there is no command 'chekc'; did you mean 'check'?"}));
  EXPECT_TRUE(holds(pardel({"mesh", "a.poly", "-o", "b.vtu", "--min-agle=30"}).err,
                    {"pardel mesh: there is no option '--min-agle'; did you mean '--min-angle'?"}));
  // The mistyped option is named, not the required option that is missing because of it.
  EXPECT_TRUE(holds(pardel({"mesh", "a.poly", "--ouput", "b.vtu"}).err, {"did you mean '--output'?"}));
  const std::string far = pardel({"mesh", "a.poly", "-o", "b.vtu", "--zzzzzz"}).err;
  EXPECT_TRUE(holds(far, {"there is no option '--zzzzzz' (see"})) << far;
  EXPECT_TRUE(holds(pardel({"doctor", "a.poly", "b.poly"}).err, {"unexpected argument 'b.poly'"}));
}

TEST_F(Help, a_missing_or_unknown_command_and_an_unknown_option_are_usage_errors) {
  for (const std::vector<std::string>& arguments :
       std::vector<std::vector<std::string>>{{},
                                             {"fly"},
                                             {"mesh"},
                                             {"mesh", "a.poly"},
                                             {"mesh", "a.poly", "-o", "b.vtu", "--fast"},
                                             {"check", "a.poly"}}) {
    const Ran ran = pardel(arguments);
    EXPECT_EQ(ran.exit_code, 2) << ran;
    EXPECT_EQ(ran.out, "");
    EXPECT_TRUE(ran.err.starts_with("pardel")) << ran;
  }
}

TEST_F(Help, a_usage_error_names_the_command_the_option_and_its_help) {
  EXPECT_EQ(pardel({"mesh", "a.poly", "-o", "b.vtu", "--threads", "-1"}).exit_code, 2);
  EXPECT_TRUE(holds(pardel({"mesh", "a.poly", "-o", "b.vtu", "--threads", "many"}).err,
                    {"pardel mesh: ", "--threads", "many", "pardel mesh --help"}));
  EXPECT_TRUE(holds(pardel({"fly"}).err, {"there is no command 'fly'", "pardel --help"}));
}

TEST_F(Help, a_wrong_choice_gives_a_message_with_the_right_ones) {
  const auto message = [this](const std::string& option) {
    return pardel({"mesh", "a.poly", "-o", "b.vtu", option, "foo"}).err;
  };
  EXPECT_TRUE(holds(message("--placement"), {"'foo' is not one of auto, circumcentre, off-centre, search (see"}));
  EXPECT_TRUE(holds(message("--decomposition"),
                    {"'foo' is not one of auto, lattice, none, paper, paper-quadtree, quadtree (see"}));
  EXPECT_TRUE(holds(message("--progress"), {"'foo' is not one of always, auto, never (see"}));
  EXPECT_TRUE(holds(pardel({"draw", "a.node", "-o", "a.svg", "--report", "r.json", "--by", "foo"}).err,
                    {"'foo' is not one of phase, quality, region, size, thread, tile (see"}));
}

}  // namespace
}  // namespace pardel::testing
