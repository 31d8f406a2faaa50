// A folder with two domains, for tests of pardel triangle.
#pragma once

#include <string>
#include <vector>

#include "program.hpp"

namespace pardel::testing {

/// The lines of a text file, as Workshop::table() returns them.
using Rows = std::vector<std::vector<double>>;

class TriangleCommand : public Workshop {
 protected:
  TriangleCommand() {
    write("a.poly", square_poly);
    // A square with a square hole; regions left and right of a wall, the right one with an area cap. Counted from 0.
    write("b.poly", R"(11 2 1 1
0 0 0 10 3
1 2 0 20 0
2 4 0 30 0
3 4 2 40 0
4 2 2 50 0
5 0 2 60 0
6 0.5 0.5 1 0
7 1.5 0.5 2 0
8 1.5 1.5 3 0
9 0.5 1.5 4 0
10 9 9 5 0
11 1
0 0 1 7
1 1 2 0
2 2 3 0
3 3 4 0
4 4 5 0
5 5 0 0
6 1 4 9
7 6 7 0
8 7 8 0
9 8 9 0
10 9 6 0
1
0 1 1
2
0 0.2 1 5 -1
1 3 1 8 0.05
)");
  }

  void ends_well(const std::string& switches, const std::string& file) const {
    const Ran ran = pardel({"triangle", "-Q" + switches, file});
    EXPECT_EQ(ran.exit_code, 0) << ran;
    EXPECT_EQ(ran.out, "");
  }
};

}  // namespace pardel::testing
