// Faces on small inputs.
#include "../../../parallel/segments/faces.hpp"

#include <gtest/gtest.h>

#include <set>

#include "../../../parallel/segments/plane_sweep.hpp"
#include "../shapes.hpp"

namespace pardel::engine {
namespace {

using testing::add_square;
using testing::square;

/// The faces between segments, and the faces that contain places.
class Located {
 public:
  Located(const Pslg& pslg, const std::vector<Point>& places)
      : swept_(sweep_plane({.points = pslg.points, .segments = pslg.segments, .queries = places})),
        faces(pslg.points, pslg.segments, swept_.below) {
    for (std::size_t i = 0; i < places.size(); ++i)
      containing.push_back(faces.above(swept_.below[pslg.points.size() + i]));
  }

 private:
  Swept swept_;

 public:
  Faces faces;
  std::vector<Index> containing;  ///< for each place
};

TEST(Faces, of_a_square_are_its_inside_and_the_exterior) {
  const Pslg pslg = square(2);
  const std::vector<Point> outside = {{3, 1}, {-1, 1}, {1, 3}, {1, -1}, {2, 3}, {0, 3}, {0, -1}, {-1, 0}, {3, 2}};
  const Index inside = Located(pslg, {{1, 1}}).containing[0];
  const Located located(pslg, outside);
  const Faces& faces = located.faces;
  EXPECT_EQ(faces.count(), 2);
  for (Index s = 0; s < 4; ++s) {
    EXPECT_EQ(faces.left_of(s), 1);
    EXPECT_EQ(faces.right_of(s), Faces::exterior);
  }
  EXPECT_EQ(inside, 1);
  EXPECT_EQ(located.containing, std::vector<Index>(outside.size(), Faces::exterior));
}

TEST(Faces, reach_around_islands_and_dangling_ends) {
  Pslg pslg = square(8);
  add_square(pslg, 2, {2, 3});
  add_square(pslg, 1, {5, 3});
  pslg.points.insert(pslg.points.end(), {{4.5, 2.5}, {4, 7}, {7, 7}});
  pslg.segments.push_back({5, 12});   // from a corner of the first island outwards
  pslg.segments.push_back({13, 14});  // both ends are free
  const Located located(pslg, {{1, 1}, {4.5, 3.5}, {3, 4}, {5.5, 3.5}});
  const Faces& faces = located.faces;
  EXPECT_EQ(faces.count(), 4);
  const Index around = located.containing[0];
  EXPECT_EQ(around, faces.left_of(0));
  EXPECT_EQ(located.containing[1], around);
  for (const Index s : {4, 5, 6, 7, 8, 9, 10, 11}) EXPECT_EQ(faces.right_of(s), around);
  for (const Index s : {12, 13}) {
    EXPECT_EQ(faces.left_of(s), around);
    EXPECT_EQ(faces.right_of(s), around);
  }
  EXPECT_NE(located.containing[2], around);
  EXPECT_NE(located.containing[2], located.containing[3]);
}

TEST(Faces, on_both_sides_of_a_touching_point_are_distinguished) {
  Pslg pslg = square(4);  // a bow tie inside: two triangles that share point 4
  pslg.points.insert(pslg.points.end(), {{2, 2}, {1, 1}, {1, 3}, {3, 1}, {3, 3}});
  pslg.segments.insert(pslg.segments.end(), {{4, 5}, {5, 6}, {6, 4}, {4, 7}, {7, 8}, {8, 4}});
  const Located located(pslg, {{1.25, 2}, {2.75, 2}, {2, 1}, {2, 3}});
  EXPECT_EQ(located.faces.count(), 4);
  const std::set<Index> distinct(located.containing.begin(), located.containing.end());
  EXPECT_EQ(distinct.size(), 3);
  EXPECT_EQ(located.containing[2], located.containing[3]);
}

TEST(Faces, without_segments_is_the_exterior_alone) {
  Pslg pslg;
  pslg.points = {{0, 0}, {1, 1}};
  const Located located(pslg, {{0.5, 0.5}});
  EXPECT_EQ(located.faces.count(), 1);
  EXPECT_EQ(located.containing[0], Faces::exterior);
}

TEST(Faces, of_thousands_of_islands_and_nested_squares_are_all_found) {
  Pslg pslg = square(1000);
  constexpr int n = 60;
  for (int i = 0; i < n * n; ++i) add_square(pslg, 1, {10.0 + 10 * (i % n), 10.0 + 10 * (i / n)});
  for (int i = 0; i < 100; ++i) add_square(pslg, 300 - 2 * i, {650.0 + i, 650.0 + i});
  const Located located(pslg, {});
  const Faces& faces = located.faces;
  EXPECT_EQ(faces.count(), 2 + n * n + 100);
  const Index around = faces.left_of(0);
  for (Index s = 4; s < 4 + 4 * n * n; ++s) EXPECT_EQ(faces.right_of(s), around);
  for (int i = 1; i < 100; ++i) {
    const Index outer = 4 + 4 * n * n + 4 * (i - 1);
    EXPECT_EQ(faces.right_of(outer + 4), faces.left_of(outer));
  }
}

}  // namespace
}  // namespace pardel::engine
