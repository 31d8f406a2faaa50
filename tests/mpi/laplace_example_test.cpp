// The finite-element example: the error falls as theory says, and does not depend on the number of ranks.
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include "mpi_workshop.hpp"

namespace pardel {
namespace {

using testing::Ran;

struct Row {
  double longest_edge = 0, vertices = 0, steps = 0, l2_error = 0, largest_error = 0;
};

class LaplaceExample : public testing::MpiWorkshop {
 protected:
  std::vector<Row> rows_on(int ranks) const {
    const Ran ran = on_ranks(ranks, PARDEL_LAPLACE, {});
    EXPECT_EQ(ran.exit_code, 0) << ran;
    std::istringstream out(ran.out);
    std::string heading;
    std::getline(out, heading);
    std::vector<Row> rows;
    for (Row r; out >> r.longest_edge >> r.vertices >> r.steps >> r.l2_error >> r.largest_error;) rows.push_back(r);
    return rows;
  }
};

TEST_F(LaplaceExample, has_a_quarter_of_the_error_on_edges_of_half_the_length) {
  const std::vector<Row> rows = rows_on(3);
  ASSERT_EQ(rows.size(), 3u);
  for (std::size_t i = 1; i < rows.size(); ++i) {
    EXPECT_EQ(rows[i - 1].longest_edge, 2 * rows[i].longest_edge);
    EXPECT_NEAR(rows[i - 1].l2_error / rows[i].l2_error, 4, 0.5);
  }
  // The largest error at a vertex varies more, because the triangles of two meshes are not similar.
  EXPECT_GT(rows.front().largest_error / rows.back().largest_error, 3.3 * 3.3);
  EXPECT_LT(rows.back().l2_error, 1e-4);
}

TEST_F(LaplaceExample, gives_the_same_on_one_rank_and_on_three) {
  const std::vector<Row> one = rows_on(1), three = rows_on(3);
  ASSERT_EQ(one.size(), 3u);
  ASSERT_EQ(three.size(), 3u);
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one[i].vertices, three[i].vertices);
    EXPECT_NEAR(one[i].steps, three[i].steps, 1);
    EXPECT_NEAR(one[i].l2_error, three[i].l2_error, 1e-8 * one[i].l2_error);
    EXPECT_NEAR(one[i].largest_error, three[i].largest_error, 1e-8 * one[i].largest_error);
  }
}

}  // namespace
}  // namespace pardel
