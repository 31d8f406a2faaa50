// Faces of plane graphs, and the domains that consist of these faces.
#include "../../../properties/checker/model/planar_faces.hpp"

#include <gtest/gtest.h>

#include <set>

#include "../../../properties/checker/domain_faces.hpp"
#include "../../../properties/checker/model/domain.hpp"
#include "../../../properties/domains/domains.hpp"

namespace pardel::checker {
namespace {

/// Adds an axis-parallel square as a closed outline of four segments.
void add_square(Pslg& pslg, Point centre, double half_side) {
  const auto first = static_cast<Index>(pslg.points.size());
  for (const Point corner : {Point{-1, -1}, Point{1, -1}, Point{1, 1}, Point{-1, 1}})
    pslg.points.push_back({centre.x + half_side * corner.x, centre.y + half_side * corner.y});
  for (Index i = 0; i < 4; ++i) pslg.segments.push_back({first + i, first + (i + 1) % 4, 0});
}

TEST(PlanarFaces, of_an_empty_graph_are_the_exterior_alone) {
  const PlanarFaces faces({}, {});
  EXPECT_EQ(faces.count(), 1u);
  EXPECT_EQ(faces.face_at({1, 2}), PlanarFaces::exterior());
}

TEST(PlanarFaces, of_an_open_polyline_are_the_exterior_alone) {
  const std::vector<Point> points{{0, 0}, {1, 0}, {1, 1}};
  const std::vector<Segment> segments{{0, 1, 0}, {1, 2, 0}};
  const PlanarFaces faces(points, segments);
  EXPECT_EQ(faces.count(), 1u);
  EXPECT_EQ(faces.face(0, Side::left), faces.face(0, Side::right));
}

TEST(PlanarFaces, nest_rings_in_rings_and_keep_neighbours_apart) {
  Pslg pslg;
  for (int ring = 1; ring <= 6; ++ring) add_square(pslg, {0, 0}, ring);
  add_square(pslg, {20, 0}, 2);
  add_square(pslg, {20, 0}, 1);
  add_square(pslg, {0, 1.5}, 0.25);  // an island between the first and the second ring
  const PlanarFaces faces(pslg.points, pslg.segments);
  EXPECT_EQ(faces.count(), 10u);
  std::set<Index> met;
  for (const Point p :
       {Point{0, 0}, {1.5, 0}, {2.5, 0}, {3.5, 0}, {4.5, 0}, {5.5, 0}, {10, 0}, {20, 0}, {21.5, 0}, {0, 1.5}})
    met.insert(faces.face_at(p));
  EXPECT_EQ(met.size(), 10u);
  EXPECT_EQ(faces.face_at({10, 0}), PlanarFaces::exterior());
  EXPECT_EQ(faces.face_at({0, 1.1}), faces.face_at({0, -1.5})) << "the ring around the first square is one face";
  EXPECT_EQ(faces.face_at({1, 0.5}), no_index) << "a point on a segment lies in no face";
}

TEST(PlanarFaces, on_the_two_sides_of_a_dangling_segment_are_one) {
  Pslg pslg;
  add_square(pslg, {0, 0}, 1);
  pslg.points.push_back({0, 0});
  pslg.segments.push_back({0, 4, 0});
  const PlanarFaces faces(pslg.points, pslg.segments);
  EXPECT_EQ(faces.count(), 2u);
  EXPECT_EQ(faces.face(4, Side::left), faces.face(4, Side::right));
  EXPECT_EQ(faces.face(4, Side::left), faces.face_at({0.5, 0.5}));
}

TEST(PlanarFaces, of_squares_that_touch_at_a_corner_are_apart) {
  Pslg pslg;
  add_square(pslg, {0, 0}, 1);
  add_square(pslg, {2, 2}, 1);
  pslg.segments[4].a = 2;  // corner (1, 1) is shared
  pslg.segments[7].b = 2;
  const PlanarFaces faces(pslg.points, pslg.segments);
  EXPECT_EQ(faces.count(), 3u);
  EXPECT_NE(faces.face_at({0, 0}), faces.face_at({2, 2}));
  EXPECT_EQ(faces.face_at({2, 0}), PlanarFaces::exterior());
}

TEST(Domain, is_every_face_except_the_exterior_and_the_holes) {
  Pslg pslg;
  for (int ring = 1; ring <= 4; ++ring) add_square(pslg, {0, 0}, ring);
  pslg.points.push_back({0, 0.5});  // inside the first square: a hole
  pslg.points.push_back({0, 1.5});  // inside the first ring
  pslg.points.push_back({10, 10});  // outside
  pslg.holes = {{0, 0}, {0, 2.5}};
  const Domain domain(pslg, false);
  EXPECT_EQ(domain.segments().size(), 16u);
  const auto in_domain = [&](Point p) { return domain.inside(domain.faces().face_at(p)); };
  EXPECT_FALSE(in_domain({0, 0}));
  EXPECT_TRUE(in_domain({0, 1.5}));
  EXPECT_FALSE(in_domain({0, 2.5}));
  EXPECT_TRUE(in_domain({0, 3.5}));
  EXPECT_FALSE(in_domain({0, 4.5}));
  EXPECT_FALSE(domain.has_point(16));
  EXPECT_TRUE(domain.has_point(17));
  EXPECT_FALSE(domain.has_point(18));
  EXPECT_TRUE(domain.on_boundary(0));
}

TEST(Domain, has_faces_on_the_sides_of_segments_and_around_isolated_points) {
  Pslg pslg;
  add_square(pslg, {0, 0}, 2);
  add_square(pslg, {0, 0}, 1);
  pslg.points.push_back({0, 1.5});  // between the squares
  pslg.points.push_back({0, 0.5});  // in the hole
  pslg.points.push_back({-1.5, 0});
  pslg.holes = {{0, 0}};
  const DomainFaces faces = faces_of_domain(pslg, false);
  ASSERT_EQ(faces.segments.size(), 8u);
  ASSERT_EQ(faces.sides.size(), 8u);
  const Index ring = faces.sides[0].left;
  EXPECT_NE(ring, no_index);
  for (Index s = 0; s < 8; ++s) {
    EXPECT_EQ(faces.sides[s].left, s < 4 ? ring : no_index);
    EXPECT_EQ(faces.sides[s].right, s < 4 ? no_index : ring);
  }
  ASSERT_EQ(faces.isolated_points.size(), 2u);
  EXPECT_EQ(faces.isolated_points[0].point, 8u);
  EXPECT_EQ(faces.isolated_points[1].point, 10u);
  for (const auto& isolated : faces.isolated_points) EXPECT_EQ(isolated.face, ring);
}

TEST(Domain, without_segments_is_the_convex_hull_through_all_points_on_it) {
  const Pslg pslg = domains::grid_points(3);
  const Domain domain(pslg, false);
  EXPECT_EQ(domain.segments().size(), 12u);
  for (Index s = 0; s < 12; ++s) {
    EXPECT_TRUE(domain.is_hull_piece(s));
    EXPECT_TRUE(domain.on_boundary(s));
    EXPECT_TRUE(domain.inside(s, Side::left));
  }
  for (Index p = 0; p < pslg.points.size(); ++p) EXPECT_TRUE(domain.has_point(p));
}

TEST(Domain, of_points_that_stand_twice_has_no_edge_of_length_0) {
  Pslg pslg;
  pslg.points = {{0, 0}, {1, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}};
  const Domain domain(pslg, true);
  EXPECT_EQ(domain.segments().size(), 4u);
  for (const Segment& s : domain.segments()) EXPECT_FALSE(pslg.points[s.a] == pslg.points[s.b]);
}

TEST(Domain, completes_the_hull_around_segments_when_asked) {
  Pslg pslg;
  pslg.points = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  pslg.segments = {{1, 0, 7}, {0, 2, 0}};
  EXPECT_EQ(Domain(pslg, false).faces().count(), 1u) << "open: nothing but the exterior";
  const Domain domain(pslg, true);
  EXPECT_EQ(domain.segments().size(), 5u);
  EXPECT_FALSE(domain.is_hull_piece(0));
  EXPECT_TRUE(domain.on_boundary(0));
  EXPECT_FALSE(domain.on_boundary(1));
  EXPECT_TRUE(domain.has(1));
}

TEST(Domain, of_collinear_points_is_empty) {
  Pslg pslg;
  pslg.points = {{0, 0}, {1, 1}, {2, 2}};
  const Domain domain(pslg, true);
  EXPECT_TRUE(domain.segments().empty());
  EXPECT_FALSE(domain.has_point(1));
}

}  // namespace
}  // namespace pardel::checker
