// pardel mesh --paranoid checks the mesh after every sweep (one pass of the refinement over all cells of a lattice).
#include <nlohmann/json.hpp>

#include "program.hpp"

namespace pardel::testing {
namespace {

using nlohmann::json;

class Paranoid : public Workshop {
 protected:
  json report(std::vector<std::string> arguments) const {
    arguments.insert(arguments.end(), {"-o", "m.ele"});
    return Workshop::report(arguments);
  }
};

TEST_F(Paranoid, finds_no_violation_with_many_tiles_on_any_number_of_threads_and_gives_the_same_mesh) {
  const std::vector<std::vector<std::string>> runs = {{"square", "--max-area", "0.001"},
                                                      {"pipe", "--min-angle", "30"},
                                                      {"key", "--max-area", "0.003", "--conforming"},
                                                      {"cracks", "--decomposition", "paper", "--max-area", "0.003"},
                                                      {"regions", "--regions", "--max-area", "0.0003"}};
  for (const auto& run : runs) {
    ASSERT_EQ(pardel({"generate", run[0], "-o", "d.poly"}).exit_code, 0) << run[0];
    std::vector<std::string> arguments = run;
    arguments[0] = "d.poly";
    arguments.insert(arguments.end(), {"--cells", "4,4"});
    const json plain = report(arguments);
    EXPECT_TRUE(plain["refine"]["sweeps_checked"].is_null()) << run[0];
    for (const std::string threads : {"1", "2"}) {
      std::vector<std::string> paranoid = arguments;
      paranoid.insert(paranoid.end(), {"--paranoid", "--threads", threads});
      const json r = report(paranoid);
      EXPECT_EQ(r["digest"], plain["digest"]) << run[0];
      // Where few equilateral triangles fit, the mesh is made with and without them. The report is about one of both.
      EXPECT_GE(r["refine"]["sweeps_checked"], r["refine"]["sweeps"].size()) << run[0];
      EXPECT_GE(r["refine"]["sweeps_checked"], 3) << run[0];
    }
  }
}

TEST_F(Paranoid, reports_the_number_of_sweeps_checked) {
  write("square.poly", square_poly);
  const Ran ran = pardel({"mesh", "square.poly", "-o", "m.ele", "--max-area", "0.01", "--paranoid"});
  EXPECT_EQ(ran.exit_code, 0) << ran;
  EXPECT_TRUE(holds(ran.out, {"sweeps  ", ", the mesh was checked after each"}));
}

TEST_F(Paranoid, checks_the_refinement_of_a_mesh_too) {
  write("square.poly", square_poly);
  for (const std::string coarse : {"c.ele", "c.vtu", "c.msh"}) {
    ASSERT_EQ(pardel({"mesh", "square.poly", "-o", coarse}).exit_code, 0);
    const json r = report({coarse, "--refine", "--max-area", "0.001", "--cells", "3,3", "--paranoid"});
    EXPECT_GE(r["refine"]["sweeps_checked"], 3) << coarse;
  }
}

}  // namespace
}  // namespace pardel::testing
