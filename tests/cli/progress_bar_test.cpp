// The text of the progress bar.
#include "../../cli/progress_bar.hpp"

#include <gtest/gtest.h>

namespace pardel::cli {
namespace {

TEST(ProgressLine, shows_the_triangles_and_the_estimate) {
  EXPECT_EQ(progress_line(3'210'000, 10.01e6, 4.2),
            "[##########----------------------]  32 %  3.21 of about 10.01 million triangles  4 s");
  EXPECT_EQ(progress_line(500, 2000, 0), "[########------------------------]  25 %  500 of about 2000 triangles  0 s");
}

TEST(ProgressLine, stays_at_99_percent_and_omits_the_estimate_where_that_was_too_low) {
  EXPECT_EQ(progress_line(2'500'000, 2e6, 61),
            "[###############################-]  99 %  2.50 million triangles  61 s");
}

TEST(ProgressLine, shows_no_bar_without_an_estimate) { EXPECT_EQ(progress_line(123, 0, 1), "123 triangles  1 s"); }

TEST(ProgressLine, fits_the_width_with_a_shorter_bar_then_without_a_bar_then_cut) {
  const auto line = [](std::size_t width) { return progress_line(3'210'000, 10.01e6, 4.2, width); };
  EXPECT_EQ(line(60), "[##------]  32 %  3.21 of about 10.01 million triangles  4 s");
  EXPECT_EQ(line(50), " 32 %  3.21 of about 10.01 million triangles  4 s");
  EXPECT_EQ(line(20), " 32 %  3.21 of about");
  for (std::size_t width = 0; width < 100; ++width) EXPECT_LE(line(width).size(), width);
}

TEST(StepLine, names_the_step_and_shortens_a_long_name) {
  EXPECT_EQ(step_line("reading key.poly", 4.2), "reading key.poly  4 s");
  EXPECT_EQ(step_line("reading key.poly", 4.2, 17), "reading k...  4 s");
  EXPECT_EQ(step_line("reading key.poly", 4.2, 21), "reading key.poly  4 s");
  for (std::size_t width = 0; width < 30; ++width) EXPECT_LE(step_line("reading key.poly", 4, width).size(), width);
}

TEST(StepLine, does_not_cut_a_character_of_several_bytes) {
  EXPECT_EQ(step_line("reading \u00e9\u00e9\u00e9\u00e9\u00e9\u00e9", 4, 18), "reading \u00e9...  4 s");
}

}  // namespace
}  // namespace pardel::cli
