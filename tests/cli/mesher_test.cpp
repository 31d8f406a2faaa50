// pardel mesh --mesher: a sequential mesher does the work, in parts.
#include <nlohmann/json.hpp>

#include "program.hpp"

namespace pardel::testing {
namespace {

using nlohmann::json;

class Mesher : public Workshop {
 protected:
  void SetUp() override { ASSERT_EQ(pardel({"generate", "pipe", "-o", "pipe.poly"}).exit_code, 0); }
  /// The report of a mesh of the pipe that is checked, too.
  json report(std::vector<std::string> options) const {
    options.insert(options.begin(), "pipe.poly");
    options.insert(options.end(), {"-o", "m.ele", "--min-angle", "25", "--check"});
    return Workshop::report(options);
  }
  void expect_usage_error(std::vector<std::string> options, const std::string& message) const {
    options.insert(options.begin(), {"mesh", "pipe.poly", "-o", "m.ele"});
    const Ran ran = pardel(options);
    EXPECT_EQ(ran.exit_code, 2) << ran;
    EXPECT_TRUE(holds(ran.err, {message})) << ran;
  }
};

TEST_F(Mesher, makes_the_same_certified_mesh_on_any_number_of_threads_in_each_scheme) {
  for (const std::string scheme : {"frozen", "cells", "decoupled"}) {
    const auto made = [&](const std::string& threads) {
      return report({"--mesher", "own", "--scheme", scheme, "--max-area", "2e-4", "--triangles-per-task", "2000",
                     "--threads", threads});
    };
    const json one = made("1"), two = made("2");
    EXPECT_EQ(one["digest"], two["digest"]) << scheme;
    EXPECT_TRUE(one["certificate"]["valid"]) << scheme;
    EXPECT_EQ(one["mesher"]["scheme"], scheme);
    EXPECT_GT(one["mesher"]["tasks"], 4) << scheme;
    EXPECT_TRUE(one["mesher"]["breaches"].empty()) << scheme;
  }
}

TEST_F(Mesher, can_be_pardel_triangle_which_speaks_as_triangle_does) {
  const json r = report({"--mesher", "pardel-triangle", "--max-area", "5e-4", "--triangles-per-task", "2000"});
  EXPECT_TRUE(r["certificate"]["valid"]);
  EXPECT_TRUE(r["mesher"]["breaches"].empty()) << r["mesher"]["breaches"];
  EXPECT_GT(r["mesher"]["vertices"]["by_mesher"], r["mesher"]["vertices"]["after"]);
}

TEST_F(Mesher, that_fails_is_named_and_replaced) {
  const Ran ran = pardel({"mesh", "pipe.poly", "-o", "m.ele", "--mesher", "false {mesh}", "--max-area", "5e-4",
                          "--triangles-per-task", "5000", "--check"});
  EXPECT_EQ(ran.exit_code, 0) << ran;
  EXPECT_TRUE(
      holds(ran.out, {"mesher  false {mesh}, frozen: ", "breach  crashed in ", ": exit code 1\n", "check   valid"}))
      << ran;
}

TEST_F(Mesher, can_be_watched_after_each_sweep) {
  const json r = report({"--mesher", "own", "--max-area", "1e-3", "--triangles-per-task", "500", "--paranoid"});
  EXPECT_GE(r["refine"]["sweeps_checked"], r["mesher"]["sweeps"]);
}

TEST_F(Mesher, that_does_not_exist_is_a_usage_error) {
  expect_usage_error({"--mesher", "nosuch"}, "--mesher: 'nosuch' is no command with the argument {mesh} or {poly}");
}

TEST_F(Mesher, excludes_what_it_has_no_use_for) {
  for (const auto& [option, value] : std::vector<std::pair<std::string, std::string>>{
           {"--interior", "fill"}, {"--decomposition", "lattice"}, {"--cells", "2,2"}, {"--placement", "search"}}) {
    const std::string name = option == "--interior" ? "--interior fill" : option;
    expect_usage_error({"--max-area", "1e-3", "--mesher", "own", option, value},
                       "--mesher cannot be used with " + name);
  }
  expect_usage_error({"--mesher", ""}, "--mesher: it is empty");
  expect_usage_error({"--mesher", "own", "--refine"}, "--mesher cannot be used with --refine");
  expect_usage_error({"--scheme", "cells"}, "--scheme requires --mesher");
  expect_usage_error({"--mesher", "pardel-triangle", "--scheme", "cells"},
                     "the scheme 'cells' needs a mesher that inserts points in a given cell only");
}

}  // namespace
}  // namespace pardel::testing
