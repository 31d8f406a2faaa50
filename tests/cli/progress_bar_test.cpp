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

}  // namespace
}  // namespace pardel::cli
