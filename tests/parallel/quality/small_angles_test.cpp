#include "../../../parallel/quality/small_angles.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "../../../parallel/arithmetic/floor.hpp"
#include "../../../properties/checker/arithmetic/exact.hpp"
#include "../../../properties/checker/check.hpp"
#include "../on_segment.hpp"
#include "../samples.hpp"

namespace pardel::engine {
namespace {

double distance(Point a, Point b) { return std::hypot(a.x - b.x, a.y - b.y); }
bool is_power_of_two(double x, double tolerance) {
  const double nearest = std::exp2(std::round(std::log2(x)));
  return std::abs(x - nearest) <= tolerance;
}

/// Three segments: from vertex 0 to 1, from 0 to 2, and from 1 to 3.
struct InputAngle {
  Triangulation t;
  DomainSegments segments;

  InputAngle(Point apex, Point first, Point second, Point on) {
    for (const Point p : {apex, first, second, on}) t.points.push_back(p);
    t.origin.resize(4, input_vertex);
    const std::vector<Constraint> constraints{{0, 1}, {0, 2}, {1, 3}};
    segments = DomainSegments(t.points, constraints);
  }
  /// Splits the piece u-v of a segment, and adds the point.
  VertexId split(Index line, VertexId u, VertexId v) {
    const Point p = edge_split_point(t, segments, line, u, v);
    t.points.push_back(p);
    t.origin.push_back(origin_on_segment(line));
    return static_cast<VertexId>(t.points.size() - 1);
  }
};

TEST(EdgeSplitPoint, of_a_segment_with_a_small_angle_at_one_end_lies_on_a_shell_between_a_third_and_two_thirds) {
  for (double length = 0.01; length < 100; length *= 1.07) {
    InputAngle corner({0, 0}, {length, 0}, {1, 0.5}, {length, length});
    const Point p = edge_split_point(corner.t, corner.segments, 0, 0, 1);
    EXPECT_TRUE(is_power_of_two(p.x, 1e-15 * p.x)) << p.x;
    EXPECT_GE(p.x, length / 3 * (1 - 1e-15));
    EXPECT_LE(p.x, 2 * length / 3 * (1 + 1e-15));
    const Point reversed = edge_split_point(corner.t, corner.segments, 0, 1, 0);
    EXPECT_NEAR(reversed.x, p.x, 1e-15 * length) << "the direction of the piece has no influence";
  }
}

TEST(EdgeSplitPoint, of_a_segment_without_an_angle_below_60_degrees_is_its_midpoint) {
  InputAngle blunt({0, 0}, {5, 0}, {-1, 3}, {7, 3});
  EXPECT_EQ(edge_split_point(blunt.t, blunt.segments, 0, 0, 1), (Point{2.5, 0}));
  InputAngle sixty_one({0, 0}, {5, 0}, {1, 1.81}, {4, 1.81});
  EXPECT_EQ(edge_split_point(sixty_one.t, sixty_one.segments, 0, 0, 1), (Point{2.5, 0}));
}

/// Segment 0-1 of length 5 and segment 0-2, whose end is at a distance of 3.1 from vertex 0 and of 3.1e-6 from the
/// other segment.
TEST(EdgeSplitPoint, of_an_edge_that_passes_the_end_of_a_segment_at_less_than_one_degree_lies_beside_this_end) {
  InputAngle corner({0, 0}, {5, 0}, {3.1, 3.1e-6}, {5, 5});
  EXPECT_NEAR(edge_split_point(corner.t, corner.segments, 0, 0, 1).x, 3.1, 1e-11);
  EXPECT_NEAR(edge_split_point(corner.t, corner.segments, 0, 1, 0).x, 3.1, 1e-11);
  EXPECT_NEAR(edge_split_point(corner.t, corner.segments, 1, 0, 2).x, 2, 1e-11) << "the shorter segment passes no end";
  const VertexId beside = corner.split(0, 0, 1);
  EXPECT_NEAR(edge_split_point(corner.t, corner.segments, 0, 0, beside).x, 2, 1e-11) << "as the shorter segment";
}

TEST(EdgeSplitPoint, does_not_lie_beside_an_end_that_is_as_near_to_an_end_of_the_edge_as_to_the_segment) {
  const auto split_at = [](double length, double gap) {
    InputAngle corner({0, 0}, {4, 0}, {length, gap}, {4, 4});
    return edge_split_point(corner.t, corner.segments, 0, 0, 1).x;
  };
  EXPECT_NEAR(split_at(3.98, 0.01), 3.98, 1e-4);
  EXPECT_EQ(split_at(3.98, 0.03), 2);
}

TEST(EdgeSplitPoint, does_not_lie_beside_an_end_if_an_edge_shorter_than_the_floor_would_result) {
  const auto split_at = [](double length, double gap, double floor) {
    InputAngle corner({0, 0}, {4, 0}, {length, gap}, {4, 4});
    return edge_split_point(corner.t, corner.segments, 0, 0, 1, floor).x;
  };
  EXPECT_NEAR(split_at(3.1, 1e-3, 9e-4), 3.1, 1e-6);
  EXPECT_EQ(split_at(3.1, 1e-3, 1.1e-3), 2) << "the gap";
  EXPECT_NEAR(split_at(3.9, 1e-2, 9e-3), 3.9, 1e-4);
  EXPECT_EQ(split_at(3.99, 1e-6, 0.02), 2) << "the rest of the segment";
}

TEST(EdgeSplitPoint, divides_a_segment_beside_a_patch_into_whole_pieces) {
  InputAngle blunt({0, 0}, {5, 0}, {-1, 3}, {7, 3});
  const auto split_at = [&](double pieces) {
    const double x = edge_split_point(blunt.t, blunt.segments, 0, 0, 1, 0, pieces).x;
    EXPECT_EQ(edge_split_point(blunt.t, blunt.segments, 0, 1, 0, 0, pieces).x, x) << "the direction has no influence";
    return x;
  };
  EXPECT_EQ(split_at(1), 2) << "two of five pieces";
  EXPECT_EQ(split_at(1.05), 2);
  EXPECT_EQ(split_at(1.25), 2.5) << "two of four pieces";
  EXPECT_EQ(split_at(3.3), 2.5) << "two pieces";
  EXPECT_EQ(split_at(4), 2.5) << "a short segment is halved";
  EXPECT_EQ(split_at(INFINITY), 2.5) << "there is no patch";
  InputAngle apex({0, 0}, {5, 0}, {1, 0.5}, {5, 5});
  EXPECT_EQ(edge_split_point(apex.t, apex.segments, 0, 0, 1, 0, 1), edge_split_point(apex.t, apex.segments, 0, 0, 1))
      << "a small angle decides alone";
}

TEST(EdgeSplitPoint, of_a_short_piece_at_a_right_angle_lies_on_a_shell) {
  InputAngle right({0, 0}, {5, 0}, {0, 3}, {9, 1});
  right.t.points.push_back({5.0 / 32, 0});
  right.t.points.push_back({0.15, 0});
  EXPECT_EQ(edge_split_point(right.t, right.segments, 0, 0, 4), (Point{2.5 / 32, 0})) << "not short";
  EXPECT_NEAR(edge_split_point(right.t, right.segments, 0, 0, 5).x, 0.0625, 1e-16);
  EXPECT_NEAR(edge_split_point(right.t, right.segments, 0, 5, 0).x, 0.0625, 1e-16);
}

TEST(EdgeSplitPoint, of_a_short_piece_at_an_angle_above_104_degrees_is_its_midpoint) {
  InputAngle wide({0, 0}, {5, 0}, {-1, 3}, {9, 1});
  wide.t.points.push_back({0.15, 0});
  EXPECT_EQ(edge_split_point(wide.t, wide.segments, 0, 0, 4), (Point{0.075, 0}));
}

/// Splits the piece u-v of a segment until no part is longer than 0.7. Returns the distances of all new vertices from
/// vertex 0, ascending.
std::vector<double> distances_of_splits(InputAngle& corner, Index line, VertexId u, VertexId v) {
  if (distance(corner.t.points[u], corner.t.points[v]) <= 0.7) return {};
  const VertexId w = corner.split(line, u, v);
  std::vector<double> all = distances_of_splits(corner, line, u, w);
  all.push_back(distance(corner.t.points[0], corner.t.points[w]));
  std::ranges::copy(distances_of_splits(corner, line, w, v), std::back_inserter(all));
  return all;
}

TEST(EdgeSplitPoint, of_both_sides_of_a_narrow_wedge_have_the_same_distances_from_the_apex) {
  InputAngle wedge({0, 0}, {100, 0}, {70, 1e-5}, {200, 50});
  const std::vector<double> first = distances_of_splits(wedge, 0, 0, 1), second = distances_of_splits(wedge, 1, 0, 2);
  ASSERT_GT(second.size(), 64u);
  for (std::size_t i = 0; i < 64; ++i) EXPECT_NEAR(first[i], second[i], 1e-13);
}

TEST(EdgeSplitPoint, of_a_chain_of_narrow_wedges_is_the_midpoint) {
  InputAngle chain({0, 0}, {100, 0}, {140, 2}, {0, 1.3});
  EXPECT_NEAR(edge_split_point(chain.t, chain.segments, 0, 0, 1).x, 50, 1e-12);
  for (const Point p : {Point{40, 0}, Point{70, 0}}) {
    chain.t.points.push_back(p);
    chain.t.origin.push_back(origin_on_segment(0));
  }
  EXPECT_NEAR(edge_split_point(chain.t, chain.segments, 0, 4, 5).x, 55, 1e-12);
}

TEST(EdgeSplitPoint, of_a_side_of_a_narrow_wedge_lies_between_a_third_and_two_thirds) {
  InputAngle wedge({0, 0}, {100, 0}, {100.001, 1e-5}, {200, 1});
  for (double start = 0.01; start < 99; start *= 1.3) {
    wedge.t.points.push_back({start, 0});
    const VertexId from = static_cast<VertexId>(wedge.t.points.size() - 1);
    const double fraction = (edge_split_point(wedge.t, wedge.segments, 0, from, 1).x - start) / (100 - start);
    EXPECT_GE(fraction, 1 / 3.0 - 1e-12);
    EXPECT_LE(fraction, 2 / 3.0 + 1e-12);
  }
}

TEST(EdgeSplitPoint, of_a_segment_with_two_different_small_angles_lies_on_a_shell_around_the_smaller_one) {
  InputAngle at_first({0, 0}, {5, 0}, {3, 0.5}, {2, 1});
  EXPECT_NEAR(edge_split_point(at_first.t, at_first.segments, 0, 0, 1).x, 2, 1e-15);
  EXPECT_NEAR(edge_split_point(at_first.t, at_first.segments, 0, 1, 0).x, 2, 1e-15);
  InputAngle at_second({0, 0}, {5, 0}, {3, 1}, {2, 0.5});
  EXPECT_NEAR(edge_split_point(at_second.t, at_second.segments, 0, 0, 1).x, 3, 1e-15);
}

TEST(EdgeSplitPoint, of_a_segment_with_two_similar_small_angles_is_its_midpoint) {
  InputAngle equal({0, 0}, {5, 0}, {3, 1}, {2, 1});
  EXPECT_EQ(edge_split_point(equal.t, equal.segments, 0, 0, 1), (Point{2.5, 0}));
  InputAngle similar({0, 0}, {5, 0}, {3, 1}, {2, 1.2});
  EXPECT_EQ(edge_split_point(similar.t, similar.segments, 0, 0, 1), (Point{2.5, 0}));
}

TEST(EdgeSplitPoint, of_a_segment_with_one_small_angle_ignores_the_larger_angle_at_its_other_end) {
  InputAngle corner({0, 0}, {5, 0}, {1.2, 2}, {4.9, 2});  // 59 and 87 degrees
  EXPECT_NEAR(edge_split_point(corner.t, corner.segments, 0, 0, 1).x, 2, 1e-15);
}

TEST(EdgeSplitPoint, of_a_right_angle_is_the_midpoint) {
  InputAngle right({0, 0}, {5, 0}, {0, 3}, {5, 3});
  EXPECT_EQ(edge_split_point(right.t, right.segments, 0, 0, 1), (Point{2.5, 0}));
}

TEST(EdgeSplitPoint, puts_the_pieces_at_one_apex_on_shared_shells) {
  InputAngle corner({0, 0}, {3, 1}, {1.7, 0.9}, {3, 9});
  VertexId u = 1, v = 2;
  for (int i = 0; i < 12; ++i) {
    u = corner.split(0, 0, u);
    EXPECT_TRUE(is_power_of_two(distance(corner.t.points[0], corner.t.points[u]), 1e-14));
    v = corner.split(1, 0, v);
    EXPECT_TRUE(is_power_of_two(distance(corner.t.points[0], corner.t.points[v]), 1e-14));
  }
}

/// The tolerance is that of the checker: units of the segment.
void expect_on_line(const InputAngle& corner, const std::string& what) {
  const Point a = corner.t.points[0], b = corner.t.points[1];
  const auto [x, y] = checker::units_of_segment(a, b);
  for (std::size_t v = 4; v < corner.t.points.size(); ++v)
    EXPECT_FALSE(checker::exactly::line_offset_exceeds(corner.t.points[v], a, b, {chain_units * x, chain_units * y}))
        << what << ", after split " << v - 3;
}

/// Where coordinates have different signs, their differences are rounded too.
TEST(EdgeSplitPoint, is_rounded_once_across_the_origin_too) {
  for (std::uint64_t seed = 1; seed <= 3000; ++seed) {
    samples::Random random(seed);
    const auto near = [&] { return Point{random.uniform(-0.499, 0.499), random.uniform(-0.499, 0.499)}; };
    InputAngle corner(near(), near(), near(), near());
    VertexId u = 0, v = 1;
    for (int i = 0; i < 20; ++i) (random.below(2) == 0 ? u : v) = corner.split(0, u, v);
    expect_on_line(corner, "seed " + std::to_string(seed));
  }
}

TEST(EdgeSplitPoint, stays_on_its_line_however_often_the_line_is_split) {
  for (const Point offset : {Point{0, 0}, Point{654321, 4987654}, Point{-1e-3, 1e9}})
    for (std::uint64_t seed = 1; seed <= 50; ++seed) {
      samples::Random random(seed);
      const auto near = [&] { return Point{offset.x + random.uniform(-9, 9), offset.y + random.uniform(-9, 9)}; };
      InputAngle towards_apex(near(), near(), near(), near());
      VertexId v = 1;
      for (int i = 0; i < 40 && distance(towards_apex.t.points[0], towards_apex.t.points[v]) > 1e-6; ++i)
        v = towards_apex.split(0, 0, v);
      expect_on_line(towards_apex, "towards the apex");

      InputAngle inwards(near(), near(), near(), near());
      VertexId u = 0;
      v = 1;
      for (int i = 0; i < 40 && distance(inwards.t.points[u], inwards.t.points[v]) > 1e-6; ++i)
        (random.below(2) == 0 ? u : v) = inwards.split(0, u, v);
      expect_on_line(inwards, "towards a point inside");
    }
}

/// A coordinate of any size. Two of them are often equal, or far from the origin for their difference.
class Coordinates {
 public:
  Coordinates(samples::Random& random, int least, int most)
      : random_(random), size_(random.between(least, most)), offset_(random.below(3) == 0 ? near(0, size_) : 0) {
    if (offset_ != 0) size_ -= random.between(0, 50);
  }
  [[nodiscard]] double next() {
    if (random_.below(8) == 0) return offset_;
    for (;;)
      if (const double x = near(offset_, random_.below(8) == 0 ? size_ - random_.between(0, 60) : size_); is_usable(x))
        return x;
  }

 private:
  [[nodiscard]] double near(double centre, int size) {
    return centre + std::ldexp(random_.uniform(1, 2) * (random_.below(2) == 0 ? 1 : -1), size);
  }
  samples::Random& random_;
  int size_;
  double offset_ = 0;
};

/// Splits a segment of random size and place again and again, as long as the engine would. Returns how many points were
/// put on it.
int split_at_random(samples::Random& random, int least, int most, const std::string& what) {
  Coordinates x(random, least, most), y(random, least, most);
  const auto point = [&] { return Point{x.next(), y.next()}; };
  const Point a = point(), b = point(), c = point(), d = point();
  if (a == b || a == c || b == d || c == d || a == d || b == c) return 0;
  InputAngle corner(a, b, c, d);
  VertexId u = 0, v = 1;
  int points = 0;
  for (int i = 0; i < 60; ++i) {
    const Point from = corner.t.points[u], to = corner.t.points[v];
    if (distance(from, to) < 2 * Floor(0).along(from, to)) break;
    const VertexId middle = corner.split(0, u, v);
    const Point p = corner.t.points[middle];
    if (p == from) break;
    ++points;
    EXPECT_TRUE(is_usable(p)) << what;
    EXPECT_FALSE(p == to) << what;
    EXPECT_TRUE(samples::is_on_line(p, a, b)) << what << ", after split " << i;
    (random.below(2) == 0 ? u : v) = middle;
  }
  return points;
}

TEST(EdgeSplitPoint, lies_within_two_units_of_its_segment_at_any_scale) {
  int points = 0;
  for (std::uint64_t seed = 1; seed <= 20'000; ++seed) {
    samples::Random random(seed);
    points += split_at_random(random, -130, 190, "seed " + std::to_string(seed));
  }
  EXPECT_GT(points, 200'000);
}

TEST(EdgeSplitPoint, lies_within_two_units_of_its_segment_where_coordinates_are_hardly_usable) {
  int points = 0;
  for (std::uint64_t seed = 1; seed <= 20'000; ++seed) {
    samples::Random random(seed);
    points += split_at_random(random, -139, -120, "seed " + std::to_string(seed));
  }
  EXPECT_GT(points, 20'000);
}

TEST(EdgeSplitPoint, with_a_coordinate_that_is_too_small_is_moved_along_the_segment) {
  const auto split = [](Point a, Point b) {
    InputAngle corner(a, b, {a.x, a.y + 0x1p-100}, {b.x, b.y + 0x1p-100});
    return edge_split_point(corner.t, corner.segments, 0, 0, 1);
  };
  constexpr double least = smallest_coordinate;
  EXPECT_EQ(split({-4 * least, -0x1p-120}, {4.5 * least, 0x1p-120}), (Point{0, -0x1p-120 / 17})) << "to an axis";
  EXPECT_EQ(split({0, -0x1p-120}, {1.5 * least, 0x1p-120}), (Point{least, 0x1p-120 / 3})) << "away from an axis";
  EXPECT_EQ(split({0, -0x1p-120}, {least, 0x1p-120}), (Point{0, -0x1p-120})) << "nowhere: to its end";
}

/// One triangle with the given corners, some of whose sides are constrained.
struct OneTriangle {
  Triangulation t;
  Slot slot;

  OneTriangle(const Triangulation& from, std::array<VertexId, 3> v, std::array<bool, 3> constrained) : t(from) {
    slot.v = v;
    for (unsigned side = 0; side < 3; ++side) slot.n[side] = constrained[side] ? EdgeRef() : EdgeRef(0, 0);
  }
  [[nodiscard]] std::optional<SmallAngle> exemption(const DomainSegments& segments) const {
    return small_angle(t, segments, Criteria({.min_angle_deg = 33}, Placement::off_centre, {}), slot, Shape(t, slot));
  }
};

TEST(SmallAngle, between_two_segments_makes_a_triangle_nestled) {
  InputAngle corner({0, 0}, {4, 0}, {4, 1}, {9, 9});
  const auto found = OneTriangle(corner.t, {0, 1, 2}, {false, true, true}).exemption(corner.segments);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->reason, ExemptReason::nestled);
  EXPECT_EQ(found->apex, 0U);
  EXPECT_NEAR(found->angle_deg, std::atan2(1, 4) * 180 / std::acos(-1.0), 1e-9);
}

TEST(SmallAngle, between_a_segment_and_an_edge_exempts_nothing) {
  InputAngle corner({0, 0}, {4, 0}, {4, 1}, {9, 9});
  EXPECT_FALSE(OneTriangle(corner.t, {0, 1, 2}, {false, true, false}).exemption(corner.segments));
  EXPECT_FALSE(OneTriangle(corner.t, {0, 1, 2}, {false, false, false}).exemption(corner.segments));
}

TEST(SmallAngle, at_another_corner_than_the_smallest_exempts_nothing) {
  // The segments meet at vertex 0 at 76 degrees. The smallest angle is at vertex 1.
  InputAngle corner({0, 0}, {4, 0}, {0.25, 1}, {9, 9});
  EXPECT_FALSE(OneTriangle(corner.t, {0, 1, 2}, {false, true, true}).exemption(corner.segments));
}

TEST(SmallAngle, across_one_shell_makes_a_triangle_seditious) {
  InputAngle corner({0, 0}, {4, 0}, {4, 1}, {9, 9});
  const VertexId u = corner.split(0, 0, 1), v = corner.split(1, 0, 2);
  const auto found = OneTriangle(corner.t, {1, v, u}, {false, true, false}).exemption(corner.segments);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->reason, ExemptReason::seditious);
  EXPECT_EQ(found->apex, 0U);
}

TEST(SmallAngle, needs_a_cause_for_each_angle_below_the_bound) {
  // The segments meet at 14 degrees. The angle at vertex 1 is 16 degrees, and nothing lies behind the edge from 0 to 2.
  InputAngle corner({0, 0}, {4, 0}, {2.1, 0.525}, {9, 9});
  EXPECT_FALSE(OneTriangle(corner.t, {0, 1, 2}, {false, true, true}).exemption(corner.segments));
  // Here it is 37 degrees.
  InputAngle wide({0, 0}, {4, 0}, {3.3, 0.525}, {9, 9});
  EXPECT_TRUE(OneTriangle(wide.t, {0, 1, 2}, {false, true, true}).exemption(wide.segments));
}

TEST(SmallAngle, across_a_shell_is_not_smaller_than_the_next_shell_explains) {
  for (const double length : {4.0, 4.5, 40.0}) {
    InputAngle corner({0, 0}, {4, 0}, {4, 1}, {9, 9});
    const VertexId u = corner.split(0, 0, 1), v = corner.split(1, 0, 2);
    const auto far = static_cast<VertexId>(corner.t.points.size());
    corner.t.points.push_back({length, 0});
    corner.t.origin.push_back(interior_vertex);
    EXPECT_EQ(OneTriangle(corner.t, {far, v, u}, {false, false, false}).exemption(corner.segments).has_value(),
              length == 4)
        << length;
  }
}

TEST(SmallAngle, across_the_shell_of_an_end_makes_a_triangle_seditious) {
  InputAngle corner({0, 0}, {5, 0}, {3.1, 3.1e-6}, {9, 9});
  const VertexId beside = corner.split(0, 0, 1);
  for (const auto& [first, second] : {std::pair(beside, VertexId{2}), std::pair(VertexId{2}, beside)}) {
    const auto found = OneTriangle(corner.t, {1, first, second}, {false, true, false}).exemption(corner.segments);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->reason, ExemptReason::seditious);
    EXPECT_EQ(found->apex, 0U);
  }
}

TEST(SmallAngle, between_the_ends_of_two_segments_of_one_length_exempts_nothing) {
  for (const double height : {1e-6, 1.0}) {
    InputAngle corner({0, 0}, {4, 0}, {std::sqrt(16 - height * height), height}, {9, 9});
    EXPECT_FALSE(OneTriangle(corner.t, {3, 2, 1}, {false, false, false}).exemption(corner.segments));
  }
}

TEST(SmallAngle, between_two_shells_exempts_nothing) {
  InputAngle corner({0, 0}, {4, 0}, {4, 1}, {9, 9});
  const VertexId outer = corner.split(0, 0, 1), first = corner.split(1, 0, 2), inner = corner.split(1, 0, first);
  ASSERT_LT(distance(corner.t.points[0], corner.t.points[inner]), distance(corner.t.points[0], corner.t.points[outer]));
  corner.t.points.push_back({40, 4});
  corner.t.origin.push_back(interior_vertex);
  const auto far = static_cast<VertexId>(corner.t.points.size() - 1);
  EXPECT_FALSE(OneTriangle(corner.t, {inner, outer, far}, {false, false, false}).exemption(corner.segments));
}

TEST(SmallAngle, of_sixty_degrees_is_none) {
  // The points have the same distance from the apex, but the angle there exceeds 60 degrees. Splitting ends.
  InputAngle corner({0, 0}, {4, 0}, {2, 3.5}, {9, 9});
  const VertexId u = corner.split(0, 0, 1), v = corner.split(1, 0, 2);
  EXPECT_FALSE(OneTriangle(corner.t, {3, v, u}, {false, false, false}).exemption(corner.segments));
}

TEST(SmallAngle, needs_an_apex_that_the_segments_share) {
  // Segments 0-1 and 1-3 share the apex 1. Segments 0-2 and 1-3 share no apex.
  InputAngle corner({0, 0}, {4, 0}, {4, 1}, {0, 1});
  const VertexId u = corner.split(1, 0, 2), v = corner.split(2, 1, 3);
  EXPECT_FALSE(OneTriangle(corner.t, {3, v, u}, {false, false, false}).exemption(corner.segments));
}

}  // namespace
}  // namespace pardel::engine
