// --max-memory limits the memory of the whole process, in every step.
#include "program.hpp"

namespace pardel::testing {
namespace {

class MemoryLimit : public Workshop {
 protected:
  MemoryLimit() { write("square.poly", square_poly); }

  /// Expects that the limit, in GiB, ends the run with code 5, no output file and not much more memory.
  void expect_end(const std::vector<std::string>& arguments, double limit) {
    if (sanitized) GTEST_SKIP() << "a sanitizer needs much memory of its own";
    const Files before = files();
    const Ran ran = pardel(arguments);
    EXPECT_EQ(ran.exit_code, 5) << ran;
    EXPECT_TRUE(holds(ran.err, {"memory"}));
    EXPECT_EQ(files(), before);
    // On an idle machine the excess is below 5 %. Other processes can delay the look at the memory.
    EXPECT_LT(static_cast<double>(ran.peak_memory), 1.5 * limit * 0x1p30);
  }
};

TEST_F(MemoryLimit, refuses_at_once_a_mesh_that_cannot_fit) {
  if (sanitized) GTEST_SKIP() << "a sanitizer needs much memory of its own";
  const Ran ran = pardel({"mesh", "square.poly", "-o", "out.vtu", "--max-area", "1e-8", "--max-memory", "0.5"});
  EXPECT_EQ(ran.exit_code, 5) << ran;
  EXPECT_TRUE(holds(ran.err, {"million triangles", "GiB", "512 MiB"}));
  EXPECT_FALSE(files().contains("out.vtu"));
}

TEST_F(MemoryLimit, ends_the_refinement) {
  expect_end(
      {"mesh", "square.poly", "-o", "out.vtu", "--min-angle", "30", "--max-edge", "0.0008", "--max-memory", "0.125"},
      0.125);
}

TEST_F(MemoryLimit, counts_the_memory_of_reading) {
  pardel({"generate", "points", "-n", "1000000", "-o", "points.poly"});
  expect_end({"mesh", "points.poly", "-o", "out.vtu", "--max-memory", "0.0625"}, 0.0625);
}

TEST_F(MemoryLimit, that_is_wide_enough_changes_nothing) {
  EXPECT_EQ(pardel({"mesh", "square.poly", "-o", "free.off", "--max-area", "1e-4"}).exit_code, 0);
  EXPECT_EQ(pardel({"mesh", "square.poly", "-o", "out.off", "--max-area", "1e-4", "--max-memory", "16"}).exit_code, 0);
  EXPECT_EQ(read("free.off"), read("out.off"));
}

}  // namespace
}  // namespace pardel::testing
