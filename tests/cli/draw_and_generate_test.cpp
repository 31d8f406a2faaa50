// pardel draw and pardel generate.
#include <sstream>
#include <string>

#include "program.hpp"

namespace pardel::testing {
namespace {

using DrawAndGenerate = Workshop;

TEST_F(DrawAndGenerate, every_domain_named_in_the_help_is_written_and_valid) {
  const std::string help = pardel({"generate", "--help"}).out;
  std::size_t at = help.find("Names:");
  ASSERT_NE(at, std::string::npos);
  std::istringstream names(help.substr(at + 6, help.find('\n', at) - at - 6));
  int count = 0;
  for (std::string name; names >> name; ++count) {
    const Ran ran = pardel({"generate", name, "-o", name + ".poly"});
    EXPECT_EQ(ran.exit_code, 0) << name << ": " << ran;
    EXPECT_EQ(pardel({"doctor", name + ".poly"}).exit_code, 0) << name;
  }
  EXPECT_GE(count, 8);
}

TEST_F(DrawAndGenerate, equal_seeds_give_equal_files_and_different_seeds_different_files) {
  for (const std::string name : {"a 7", "b 7", "c 8"}) {
    ASSERT_EQ(pardel({"generate", "points", "-n", "1000", "--seed", name.substr(2), "-o", name.substr(0, 1) + ".poly"})
                  .exit_code,
              0);
  }
  EXPECT_EQ(table("a.poly")[0][0], 1000);
  EXPECT_EQ(read("a.poly"), read("b.poly"));
  EXPECT_NE(read("a.poly"), read("c.poly"));
}

TEST_F(DrawAndGenerate, an_unknown_name_is_a_usage_error_that_lists_the_names) {
  const Ran ran = pardel({"generate", "dragon", "-o", "x.poly"});
  EXPECT_EQ(ran.exit_code, 2) << ran;
  EXPECT_TRUE(holds(ran.err, {"dragon", "square", "pipe", "key"}));
  EXPECT_EQ(files(), Files{});
}

TEST_F(DrawAndGenerate, useless_options_of_generate_are_refused_before_a_file_is_written) {
  for (const auto& [more, message] : std::vector<std::pair<std::vector<std::string>, std::string>>{
           {{"-o", "r.poly", "--sizes", "r.poly"}, "would replace files of -o r.poly"},
           {{"-o", "-", "--sizes", "-"}, "only one output can go to standard output"},
           {{"-o", "r.poly", "--ratio", "0.1"}, "--ratio needs --sizes"},
           {{"-o", "r.poly", "--sizes", "r.area", "--ratio", "nan"}, "'nan' is not a ratio"},
           {{"-o", "r.poly", "--sizes", "r.area", "--ratio", "0"}, "'0' is not a ratio"},
           {{"-o", "r.poly", "--seed", "-1"}, "'-1' is not a whole number"},
           {{"-o", "r.poly", "--seed", "18446744073709551616"}, "is not a whole number"},
           {{"-o", "r.poly", "-n", "7"}, "must be from 1 to 6"}}) {
    std::vector<std::string> arguments = {"generate", "radial"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Ran ran = pardel(arguments);
    EXPECT_EQ(ran.exit_code, 2) << ran;
    EXPECT_TRUE(holds(ran.err, {message}));
    EXPECT_EQ(ran.out, "");
    EXPECT_EQ(files(), Files{});
  }
  EXPECT_EQ(pardel({"generate", "radial", "-n", "1", "-o", "r.poly", "--sizes", "r.area"}).exit_code, 0);
  EXPECT_EQ(files(), (Files{"r.area", "r.poly"}));
}

TEST_F(DrawAndGenerate, the_help_lists_the_numbers_that_n_takes) {
  EXPECT_TRUE(holds(pardel({"generate", "--help"}).out, {"radial       1 to 6 (2)", "comb         1 to 100000 (16)"}));
}

TEST_F(DrawAndGenerate, domains_are_written_as_poly_only) {
  EXPECT_EQ(pardel({"generate", "square", "-o", "x.node"}).exit_code, 2);
  const Ran ran = pardel({"generate", "square", "-o", "/dev/stdout"});
  EXPECT_EQ(ran.exit_code, 0);
  EXPECT_EQ(ran.out.substr(0, 2), "4 ");
}

TEST_F(DrawAndGenerate, domains_points_and_meshes_are_drawn) {
  write("square.poly", square_poly);
  ASSERT_EQ(pardel({"mesh", "square.poly", "-o", "m.node", "-o", "m.vtu", "-o", "m.msh"}).exit_code, 0);
  write("points.node", "3 2 0 0\n1 0 0\n2 1 0\n3 0 1\n");
  for (const std::string input : {"square.poly", "points.node", "m.node", "m.ele", "m.vtu", "m.msh"}) {
    const Ran ran = pardel({"draw", input, "-o", input + ".svg", "--no-legend"});
    EXPECT_EQ(ran.exit_code, 0) << input << ": " << ran;
    EXPECT_TRUE(holds(read(input + ".svg"), {"<svg", "</svg>"})) << input;
  }
  EXPECT_EQ(read("m.node.svg"), read("m.ele.svg"));
}

}  // namespace
}  // namespace pardel::testing
