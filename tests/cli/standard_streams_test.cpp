// `-` stands for standard input and standard output, each for one file at most.
#include <string>
#include <vector>

#include "program.hpp"

namespace pardel::testing {
namespace {

class StandardStreams : public Workshop {
 protected:
  StandardStreams() {
    write("square.poly", square_poly);
    EXPECT_EQ(
        pardel({"mesh", "square.poly", "-o", "m.vtu", "-o", "m.msh", "-o", "m.off", "-o", "m.node", "-q"}).exit_code,
        0);
  }
  [[nodiscard]] Ran with_input(const std::string& file, const std::vector<std::string>& arguments) const {
    return pardel(arguments, {.in_file = file});
  }
  void refuses_two_outputs(const std::vector<std::string>& arguments) const {
    const Files before = files();
    const Ran ran = pardel(arguments);
    EXPECT_EQ(ran.exit_code, 2) << ran;
    EXPECT_EQ(ran.out, "");
    EXPECT_TRUE(holds(ran.err, {"-: only one output can go to standard output"}));
    EXPECT_EQ(files(), before);
  }
};

TEST_F(StandardStreams, a_mesh_in_one_file_is_checked_from_standard_input) {
  for (const std::string mesh : {"m.vtu", "m.msh", "m.off"}) {
    const Ran ran = with_input(mesh, {"check", "square.poly", "-"});
    EXPECT_EQ(ran.exit_code, 0) << mesh << ": " << ran;
    EXPECT_EQ(ran.out, pardel({"check", "square.poly", mesh}).out) << mesh;
  }
  const Ran domain = with_input("square.poly", {"check", "-", "m.vtu"});
  EXPECT_EQ(domain.exit_code, 0) << domain;
}

TEST_F(StandardStreams, a_comment_or_a_blank_line_may_come_before_a_mesh) {
  write("c.off", "# made by hand\n\n" + read("m.off"));
  EXPECT_EQ(with_input("c.off", {"check", "square.poly", "-"}).exit_code, 0);
}

TEST_F(StandardStreams, a_mesh_in_two_files_cannot_come_from_standard_input) {
  for (const std::string file : {"m.node", "m.ele", "square.poly"}) {
    const Ran ran = with_input(file, {"check", "square.poly", "-"});
    EXPECT_EQ(ran.exit_code, 3) << ran;
    EXPECT_TRUE(
        holds(ran.err, {"pardel: -: ", ".msh, .vtu, .off, .vtk or .2dm", ".node and .ele consists of two files"}));
  }
  EXPECT_TRUE(holds(with_input("/dev/null", {"check", "square.poly", "-"}).err, {".msh, .vtu, .off, .vtk or .2dm"}));
}

TEST_F(StandardStreams, a_domain_or_a_mesh_is_drawn_from_standard_input) {
  for (const std::string input : {"m.vtu", "m.msh", "m.off", "square.poly"}) {
    ASSERT_EQ(pardel({"draw", input, "named.svg", "--no-legend"}).exit_code, 0);
    const Ran ran = with_input(input, {"draw", "-", "out.svg", "--no-legend"});
    EXPECT_EQ(ran.exit_code, 0) << input << ": " << ran;
    EXPECT_EQ(read("out.svg"), read("named.svg")) << input;
  }
  const Ran by = with_input("square.poly", {"draw", "-", "by.svg", "--by", "quality"});
  EXPECT_EQ(by.exit_code, 2) << by;
  EXPECT_TRUE(holds(by.err, {"-: --by needs a mesh"}));
}

TEST_F(StandardStreams, a_domain_or_a_mesh_is_converted_from_standard_input_to_standard_output) {
  for (const std::string input : {"m.vtu", "m.msh"}) {
    ASSERT_EQ(pardel({"convert", input, "named.vtu"}).exit_code, 0);
    const Ran ran = with_input(input, {"convert", "-", "-", "--format", "vtu"});
    EXPECT_EQ(ran.exit_code, 0) << ran;
    EXPECT_EQ(ran.out, read("named.vtu")) << input;
  }
  const Ran domain = with_input("square.poly", {"convert", "-", "-"});
  EXPECT_EQ(domain.exit_code, 0) << domain;
  ASSERT_EQ(pardel({"convert", "square.poly", "out.poly"}).exit_code, 0);
  EXPECT_EQ(domain.out, read("out.poly"));
  const Ran format = with_input("square.poly", {"convert", "-", "-", "--format", "vtu"});
  EXPECT_EQ(format.exit_code, 2) << format;
  EXPECT_TRUE(holds(format.err, {"--format is for meshes; - is a domain"}));
}

TEST_F(StandardStreams, a_mesh_from_standard_input_is_refined) {
  const Ran ran = with_input("m.vtu", {"mesh", "-", "--refine", "--max-area", "0.01", "-o", "finer.off", "--check"});
  EXPECT_EQ(ran.exit_code, 0) << ran;
}

TEST_F(StandardStreams, a_mesh_in_place_of_a_domain_is_a_usage_error_that_names_the_option) {
  const Ran ran = with_input("m.vtu", {"mesh", "-", "-o", "finer.off"});
  EXPECT_EQ(ran.exit_code, 2) << ran;
  EXPECT_TRUE(holds(ran.err, {"pardel: -: expected a domain", "--refine"}));
}

TEST_F(StandardStreams, points_of_a_domain_from_standard_input_cannot_be_in_another_file) {
  write("empty.poly", "0 2 0 0\n1 0\n1 1 2\n0\n");
  const Ran ran = with_input("empty.poly", {"mesh", "-", "-o", "out.vtu"});
  EXPECT_EQ(ran.exit_code, 3) << ran;
  EXPECT_TRUE(holds(ran.err, {"-:1: expected points here"}));
}

TEST_F(StandardStreams, two_inputs_cannot_both_come_from_standard_input) {
  for (const std::vector<std::string>& arguments : {std::vector<std::string>{"check", "-", "-"},
                                                    {"check", "-", "m.vtu", "--sizes", "-"},
                                                    {"mesh", "-", "--sizes", "-", "-o", "out.vtu"},
                                                    {"check", "-", "/dev/stdin"},
                                                    {"check", "/dev/fd/0", "/proc/self/fd/0"},
                                                    {"mesh", "/dev/stdin", "--sizes", "-", "-o", "out.vtu"}}) {
    const Ran ran = with_input("square.poly", arguments);
    EXPECT_EQ(ran.exit_code, 2) << ran;
    EXPECT_TRUE(holds(ran.err, {"-: only one input can come from standard input"}));
  }
}

TEST_F(StandardStreams, standard_input_is_read_from_where_it_is_under_all_its_names) {
  write("late.poly", "one line that another program has read\n" + read("square.poly"));
  for (const std::string name : {"-", "/dev/stdin", "/dev/fd/0", "/proc/self/fd/0"}) {
    const Ran ran = run("/bin/sh", {"-c", "{ read line; " PARDEL_PROGRAM " check " + name + " m.vtu; } < late.poly"});
    EXPECT_EQ(ran.exit_code, 0) << name << ": " << ran;
  }
}

TEST_F(StandardStreams, a_picture_goes_to_standard_output_in_the_format_that_is_named) {
  for (const std::string format : {"svg", "png"}) {
    ASSERT_EQ(pardel({"draw", "m.vtu", "m." + format}).exit_code, 0);
    const Ran ran = pardel({"draw", "m.vtu", "-", "--format", format});
    EXPECT_EQ(ran.exit_code, 0) << ran;
    EXPECT_EQ(ran.out, read("m." + format));
  }
  const Ran without = pardel({"draw", "m.vtu", "-"});
  EXPECT_EQ(without.exit_code, 2) << without;
  EXPECT_TRUE(holds(without.err, {"-: standard output has no suffix; set --format png or svg"}));
  EXPECT_EQ(pardel({"draw", "m.vtu", "m.svg", "--format", "svg"}).exit_code, 2);
}

TEST_F(StandardStreams, two_outputs_cannot_both_go_to_standard_output) {
  refuses_two_outputs({"mesh", "square.poly", "-o", "-", "--format", "vtu", "--json", "-"});
  refuses_two_outputs({"mesh", "square.poly", "-o", "-", "-o", "-", "--format", "vtu"});
  refuses_two_outputs({"mesh", "square.poly", "-o", "-", "--format", "vtu", "--json", "/dev/stdout"});
  refuses_two_outputs({"doctor", "square.poly", "--repair", "-", "--json", "-"});
  refuses_two_outputs({"doctor", "square.poly", "--repair", "/dev/stdout", "--json"});
}

TEST_F(StandardStreams, one_output_on_standard_output_is_all_that_is_printed) {
  ASSERT_EQ(pardel({"check", "square.poly", "m.vtu", "--json", "c.json"}).exit_code, 0);
  for (const std::string name : {"-", "/dev/stdout"}) {
    EXPECT_EQ(pardel({"check", "square.poly", "m.vtu", "--json", name}).out, read("c.json"));
    ASSERT_EQ(pardel({"doctor", "square.poly", "--repair", "fixed.poly"}).exit_code, 0);
    EXPECT_EQ(pardel({"doctor", "square.poly", "--repair", name}).out, read("fixed.poly"));
    ASSERT_EQ(pardel({"generate", "square", "-o", "generated.poly"}).exit_code, 0);
    EXPECT_EQ(pardel({"generate", "square", "-o", name}).out, read("generated.poly"));
    EXPECT_EQ(pardel({"mesh", "square.poly", "-o", "n.vtu", "--json", name}).out.substr(0, 1), "{");
  }
}

}  // namespace
}  // namespace pardel::testing
