// An output that cannot be written gives a message, exit code 5, and no partial file under the final name.
#include <csignal>
#include <filesystem>
#include <string>

#include "program.hpp"

namespace pardel::testing {
namespace {

class BadOutput : public Workshop {
 protected:
  BadOutput() { write("square.poly", square_poly); }
};

constexpr const char* fine = "0.0001";  // this area bound gives files of several 100 kB

TEST_F(BadOutput, a_folder_that_does_not_exist_is_reported_before_meshing) {
  const Ran ran = pardel({"mesh", "square.poly", "-o", "nowhere/out.vtu"});
  EXPECT_EQ(ran.exit_code, 5) << ran;
  EXPECT_TRUE(holds(ran.err, {"nowhere/out.vtu", "No such file or directory (the folder nowhere)"}));
}

TEST_F(BadOutput, a_folder_in_place_of_a_file_is_refused) {
  std::filesystem::create_directory(folder_ / "work" / "out.vtu");
  const Ran ran = pardel({"mesh", "square.poly", "-o", "out.vtu"});
  EXPECT_EQ(ran.exit_code, 5) << ran;
  EXPECT_TRUE(holds(ran.err, {"out.vtu", "directory"}));
}

TEST_F(BadOutput, a_file_in_place_of_a_folder_is_refused) {
  const Ran ran = pardel({"mesh", "square.poly", "-o", "square.poly/out.vtu"});
  EXPECT_EQ(ran.exit_code, 5) << ran;
  EXPECT_TRUE(holds(ran.err, {"square.poly/out.vtu", "Not a directory"}));
}

TEST_F(BadOutput, a_link_into_a_missing_folder_is_refused_before_the_mesh_is_made) {
  std::filesystem::create_symlink("missing/out.vtu", folder_ / "work" / "link.vtu");
  const Ran ran = pardel({"mesh", "square.poly", "-o", "link.vtu"});
  EXPECT_EQ(ran.exit_code, 5) << ran;
  EXPECT_TRUE(holds(ran.err, {"link.vtu", "No such file or directory", "the folder missing"}));
  EXPECT_EQ(ran.out, "");
}

TEST_F(BadOutput, replaces_no_other_file_of_its_command) {
  std::filesystem::create_symlink("n.vtu", folder_ / "work" / "link.vtu");
  write("n.vtu", "");
  std::filesystem::create_symlink("new.vtu", folder_ / "work" / "to_new.msh");
  write("s.wld", "1\n0\n0\n-1\n0\n0\n");
  ASSERT_EQ(pardel({"mesh", "square.poly", "-o", "m.ele"}).exit_code, 0);
  const std::vector<std::vector<std::string>> commands = {
      {"mesh", "square.poly", "-o", "n.vtu", "--json", "square.poly"},
      {"mesh", "square.poly", "-o", "n.vtu", "--json", "n.vtu"},
      {"mesh", "square.poly", "-o", "n.node", "--json", "n.poly"},
      {"check", "square.poly", "m.ele", "--json", "m.node"},
      {"check", "square.poly", "m.ele", "--json", "./square.poly"},
      {"doctor", "square.poly", "--json", "square.poly"},
      {"doctor", "square.poly", "--repair", "square.poly"},
      {"convert", "square.poly", "./square.poly"},
      {"draw", "m.ele", "p.svg", "--by", "tile", "--report", "p.svg"},
      {"mesh", "square.poly", "--sizes", "s.off", "-o", "s.off"},
      {"mesh", "square.poly", "-o", "n.vtu", "-o", "n.vtu"},
      {"mesh", "square.poly", "-o", "n.vtu", "-o", "./n.vtu"},
      {"mesh", "square.poly", "-o", "n.vtu", "-o", "link.vtu"},
      {"mesh", "square.poly", "-o", "new.vtu", "-o", "to_new.msh"},
      {"mesh", "square.poly", "--sizes", "s.npy", "-o", "n.vtu", "--json", "s.wld"},
      {"check", "square.poly", "m.ele", "--sizes", "s.npy", "--json", "s.wld"},
      {"mesh", "square.poly", "-o", "n.node", "-o", "n.ele"},
      {"mesh", "square.poly", "-o", "n.svg", "--json", "n.svg"},
      {"doctor", "square.poly", "--repair", "f.poly", "--json", "f.poly"}};
  const std::string square = read("square.poly");
  for (const std::vector<std::string>& command : commands) {
    const Ran ran = pardel(command);
    EXPECT_EQ(ran.exit_code, 2) << ran;
    EXPECT_TRUE(holds(ran.err, {"this output would replace files of "}));
    EXPECT_EQ(read("square.poly"), square);
    EXPECT_EQ(read("n.vtu"), "");
  }
}

TEST_F(BadOutput, that_two_options_name_is_an_error_that_names_both) {
  const Ran ran = pardel({"mesh", "square.poly", "-o", "m.vtu", "-o", "n.vtu", "--json", "./m.vtu"});
  EXPECT_EQ(ran.exit_code, 2) << ran;
  EXPECT_TRUE(holds(ran.err, {"--json ./m.vtu: ", "of -o m.vtu; choose another name"}));
}

TEST_F(BadOutput, may_be_a_domain_beside_the_points_that_it_is_made_of) {
  ASSERT_EQ(pardel({"mesh", "square.poly", "-o", "m.node"}).exit_code, 0);
  std::filesystem::copy(folder_ / "work" / "m.node", folder_ / "work" / "p.node");
  EXPECT_EQ(pardel({"convert", "p.node", "p.poly"}).exit_code, 0);
  EXPECT_EQ(pardel({"doctor", "square.poly", "--repair", "/dev/null", "--json", "/dev/null"}).exit_code, 0);
}

TEST_F(BadOutput, with_a_name_that_is_not_UTF_8_is_written_with_its_report) {
  const std::string name = "caf\xE9.poly", mesh = "caf\xE9.vtu";
  write(name, square_poly);
  const Ran ran = pardel({"mesh", name, "-o", mesh, "--json", "r.json"});
  EXPECT_EQ(ran.exit_code, 0) << ran;
  EXPECT_TRUE(exists(mesh));
  EXPECT_TRUE(holds(read("r.json"), {"caf\xEF\xBF\xBD.poly"}));
  EXPECT_EQ(pardel({"doctor", name, "--json", "r.json"}).exit_code, 0);
  EXPECT_EQ(pardel({"draw", name, "p.svg"}).exit_code, 0);
  EXPECT_EQ(pardel({"draw", name, "p.png"}).exit_code, 0);
  write(name, "wrong");
  EXPECT_EQ(pardel({"mesh", name, "-o", mesh, "--json", "r.json"}).exit_code, 3);
  EXPECT_TRUE(holds(read("r.json"), {"caf\xEF\xBF\xBD.poly:1"}));
}

TEST_F(BadOutput, a_suffix_that_names_no_format_is_a_usage_error) {
  const Ran ran = pardel({"mesh", "square.poly", "-o", "out.docx"});
  EXPECT_EQ(ran.exit_code, 2) << ran;
  EXPECT_TRUE(holds(ran.err, {"out.docx", ".vtu"}));
}

TEST_F(BadOutput, that_another_program_writes_is_refused_with_the_name_of_this_program) {
  const Ran picture = pardel({"mesh", "square.poly", "-o", "out.png"});
  EXPECT_EQ(picture.exit_code, 2) << picture;
  EXPECT_TRUE(holds(picture.err, {"out.png: '.png' is not a known format", "'pardel draw' draws a mesh as .png"}));
  const Ran index = pardel({"mesh", "square.poly", "-o", "out.pvtu"});
  EXPECT_EQ(index.exit_code, 2) << index;
  EXPECT_TRUE(holds(index.err, {"out.pvtu: '.pvtu' is not a known format", "'pardel-mpi mesh' writes .pvtu"}));
}

TEST_F(BadOutput, never_replaces_a_piece_of_a_mesh_that_is_read) {
  const auto mesh = [&](const char* file) { return pardel({"mesh", "square.poly", "-o", file, "-q"}).exit_code; };
  ASSERT_EQ(mesh("piece.vtu"), 0);
  write("all.pvtu", "<VTKFile><Piece Source=\"piece.vtu\"/></VTKFile>\n");
  ASSERT_EQ(mesh("msh_1.msh"), 0);  // msh.msh stands for it
  const std::string vtu = read("piece.vtu"), msh = read("msh_1.msh");
  for (const std::vector<std::string>& arguments :
       std::vector<std::vector<std::string>>{{"check", "square.poly", "all.pvtu", "--json", "piece.vtu"},
                                             {"mesh", "square.poly", "--sizes", "all.pvtu", "-o", "piece.vtu"},
                                             {"check", "square.poly", "msh.msh", "--json", "msh_1.msh"},
                                             {"convert", "msh.msh", "msh_1.msh"}}) {
    const Ran ran = pardel(arguments);
    EXPECT_EQ(ran.exit_code, 2) << ran;
    EXPECT_TRUE(holds(ran.err, {"this output would replace files of the input"})) << ran;
    EXPECT_EQ(read("piece.vtu"), vtu);
    EXPECT_EQ(read("msh_1.msh"), msh);
  }
}

TEST_F(BadOutput, the_input_is_never_replaced) {
  const Ran ran = pardel({"mesh", "square.poly", "-o", "square.node"});
  EXPECT_EQ(ran.exit_code, 2) << ran;
  EXPECT_TRUE(holds(ran.err, {"square.node", "square.poly"}));
  EXPECT_EQ(read("square.poly"), square_poly);
}

TEST_F(BadOutput, a_full_disk_is_an_io_error_in_every_format) {
  for (const std::string suffix : {"vtu", "msh", "off", "svg", "node"}) {
    std::filesystem::create_symlink("/dev/full", folder_ / "work" / ("full." + suffix));
    const Ran ran = pardel({"mesh", "square.poly", "-o", "full." + suffix, "--max-area", fine});
    EXPECT_EQ(ran.exit_code, 5) << suffix << ": " << ran;
    EXPECT_TRUE(holds(ran.err, {"full." + suffix, "No space left"}));
    EXPECT_FALSE(exists("full.ele"));
    EXPECT_FALSE(exists("full.poly"));
  }
}

TEST_F(BadOutput, a_disk_that_fills_up_leaves_no_file_under_any_name) {
  for (const std::string suffix : {"vtu", "msh", "off", "svg", "node"}) {
    const Ran ran =
        pardel({"mesh", "square.poly", "-o", "out." + suffix, "--max-area", fine}, {.file_size_limit = 40'000});
    EXPECT_EQ(ran.exit_code, 5) << suffix << ": " << ran;
    EXPECT_TRUE(holds(ran.err, {"File too large"}));
    EXPECT_EQ(files(), Files{"square.poly"}) << suffix;
  }
}

TEST_F(BadOutput, an_older_file_survives_a_disk_that_fills_up) {
  write("out.vtu", "older");
  EXPECT_EQ(pardel({"mesh", "square.poly", "-o", "out.vtu", "--max-area", fine}, {.file_size_limit = 40'000}).exit_code,
            5);
  EXPECT_EQ(read("out.vtu"), "older");
}

TEST_F(BadOutput, a_report_on_a_full_disk_is_an_io_error) {
  const Ran ran = pardel({"mesh", "square.poly", "-o", "out.vtu", "--json", "/dev/full"});
  EXPECT_EQ(ran.exit_code, 5) << ran;
  EXPECT_TRUE(holds(ran.err, {"/dev/full", "No space left"}));
}

TEST_F(BadOutput, a_mesh_goes_to_standard_output_in_the_format_that_is_named) {
  for (const std::string format : {"vtu", "msh", "off", "svg"}) {
    ASSERT_EQ(pardel({"mesh", "square.poly", "-o", "m." + format}).exit_code, 0);
    const Ran ran = pardel({"mesh", "square.poly", "-o", "-", "--format", format});
    EXPECT_EQ(ran.exit_code, 0) << ran;
    EXPECT_EQ(ran.out, read("m." + format));
    EXPECT_FALSE(exists("-"));
  }
  const Ran without = pardel({"mesh", "square.poly", "-o", "-"});
  EXPECT_EQ(without.exit_code, 2) << without;
  EXPECT_TRUE(holds(without.err, {"--format", "vtu"}));
  EXPECT_TRUE(holds(pardel({"mesh", "square.poly", "-o", "/dev/stdout"}).err, {"/dev/stdout", "'-o - --format"}));
  EXPECT_EQ(pardel({"mesh", "square.poly", "-o", "m.vtu", "--format", "vtu"}).exit_code, 2);
  EXPECT_EQ(pardel({"mesh", "square.poly", "-o", "-", "--format", "vtu", "--json", "-"}).exit_code, 2);
  const Ran full = pardel({"mesh", "square.poly", "-o", "-", "--format", "vtu"}, {.out_file = "/dev/full"});
  EXPECT_EQ(full.exit_code, 5) << full;
  EXPECT_TRUE(holds(full.err, {"standard output", "No space left"}));
}

TEST_F(BadOutput, standard_output_on_a_full_disk_is_an_io_error) {
  const Ran ran = pardel({"mesh", "square.poly", "-o", "out.vtu", "--json", "-"}, {.out_file = "/dev/full"});
  EXPECT_EQ(ran.exit_code, 5) << ran;
  EXPECT_TRUE(holds(ran.err, {"standard output", "No space left"}));
}

TEST_F(BadOutput, the_other_commands_report_a_full_disk_too) {
  std::filesystem::create_symlink("/dev/full", folder_ / "work" / "full.svg");
  std::filesystem::create_symlink("/dev/full", folder_ / "work" / "full.poly");
  EXPECT_EQ(pardel({"draw", "square.poly", "-o", "full.svg"}).exit_code, 5);
  EXPECT_EQ(pardel({"generate", "square", "-o", "full.poly"}).exit_code, 5);
  EXPECT_EQ(pardel({"doctor", "square.poly", "--repair", "full.poly"}).exit_code, 5);
  EXPECT_EQ(pardel({"doctor", "square.poly", "--json", "/dev/full"}).exit_code, 5);
}

TEST_F(BadOutput, triangle_leaves_no_file_when_the_disk_fills_up) {
  const Ran ran = pardel({"triangle", "-pqa0.0001", "square"}, {.file_size_limit = 40'000});
  EXPECT_EQ(ran.exit_code, 5) << ran;
  EXPECT_EQ(files(), Files{"square.poly"});
}

TEST_F(BadOutput, too_little_memory_is_a_message_and_code_5) {
  if (sanitized) GTEST_SKIP() << "a sanitizer's shadow memory alone is larger than the limit";
  const Ran ran =
      pardel({"generate", "points", "-n", "50000000", "-o", "many.poly"}, {.address_space = std::uint64_t{256} << 20});
  EXPECT_EQ(ran.exit_code, 5) << ran;
  EXPECT_TRUE(holds(ran.err, {"memory"}));
  EXPECT_FALSE(exists("many.poly"));
}

}  // namespace
}  // namespace pardel::testing
