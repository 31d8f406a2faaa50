// Tests scripts/real-inputs, the program that meshes all files of a folder: it must report what goes wrong.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "../cli/program.hpp"

namespace pardel::testing {
namespace {

constexpr const char* square = "4 2 0 0\n0 0 0\n1 1 0\n2 1 1\n3 0 1\n4 0\n0 0 1\n1 1 2\n2 2 3\n3 3 0\n0\n";

class RealInputs : public Workshop {
 protected:
  /// Runs the script on the folder of the test, with a shell script in place of pardel. `before_mesh` are commands that
  /// this shell script runs in place of `pardel mesh`, which they may call as "$pardel" "$@".
  Ran run_with(const std::string& before_mesh) const {
    write("pardel", "#!/bin/sh\npardel=" PARDEL_PROGRAM "\nif [ \"$1\" = mesh ]; then\n" + before_mesh +
                        "\nfi\nexec \"$pardel\" \"$@\"\n");
    std::filesystem::permissions(folder_ / "work" / "pardel", std::filesystem::perms::owner_all);
    return run(PARDEL_RUNNER, {".", "--pardel", "./pardel", "--without-triangle", "--goals", "20.7", "--time-limit",
                               "5", "--csv", "runs.csv"});
  }
  /// With these commands in place of `pardel mesh`, the script reports the square `a.poly` and gives code 1.
  void expect_report(const std::string& report, const std::string& before_mesh) const {
    write("a.poly", square);
    const Ran ran = run_with(before_mesh);
    EXPECT_EQ(ran.exit_code, 1);
    EXPECT_NE(ran.out.find(report + ": a.poly at 20.7"), std::string::npos) << ran;
  }
};

TEST_F(RealInputs, that_are_meshed_give_code_0_and_one_line_each) {
  write("a.poly", square);
  write("b.poly", square);
  const Ran ran = run_with(":");
  EXPECT_EQ(ran.exit_code, 0) << ran;
  EXPECT_NE(read("runs.csv").find("a.poly,20.7,valid,0"), std::string::npos);
  EXPECT_NE(read("runs.csv").find("b.poly,20.7,valid,0"), std::string::npos);
}

TEST_F(RealInputs, have_their_lines_in_the_table_before_the_next_input_is_meshed) {
  write("a.poly", square);
  write("b.poly", square);
  const std::string folder = folder_ / "work";
  const Ran ran = run_with("cat " + folder + "/runs.csv >> " + folder + "/seen.csv");
  EXPECT_EQ(ran.exit_code, 0) << ran;
  EXPECT_NE(read("seen.csv").find("a.poly,20.7,valid,0"), std::string::npos);
}

TEST_F(RealInputs, that_cannot_be_repaired_are_refused_and_give_code_0) {
  write("a.poly", "3 2 0 0\n0 0 0\n1 1 0\n2 1 1\n2 0\n0 0 1\n1 1 2\n0\n");
  const Ran ran = run_with(":");
  EXPECT_EQ(ran.exit_code, 0) << ran;
  EXPECT_NE(read("runs.csv").find("a.poly,repair,refused,3"), std::string::npos);
}

TEST_F(RealInputs, whose_mesh_fails_a_check_are_reported) { expect_report("failed", "exit 1"); }

TEST_F(RealInputs, whose_run_does_not_end_are_reported) { expect_report("time-out", "exec sleep 1000"); }

TEST_F(RealInputs, that_miss_a_bound_without_a_narrow_gap_are_reported) {
  expect_report("missed", "exec \"$pardel\" \"$@\" --max-area 0.01 --max-vertices 9");
}

TEST_F(RealInputs, that_miss_a_bound_near_a_narrow_gap_are_explained) {
  // A point is 1e-11 above a side of the convex hull. Repair cannot close this gap.
  write("a.poly", "5 2 0 0\n0 0 0\n1 1 0\n2 1 1\n3 0 1\n4 0.5 1e-11\n0 0\n0\n");
  const Ran ran = run_with("exec \"$pardel\" \"$@\" --min-edge 1e-9");
  EXPECT_EQ(ran.exit_code, 0) << ran;
  EXPECT_NE(read("runs.csv").find("a.poly,20.7,explained,4"), std::string::npos) << read("runs.csv");
}

}  // namespace
}  // namespace pardel::testing
