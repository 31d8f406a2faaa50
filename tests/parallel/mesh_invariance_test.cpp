// Metamorphic tests: the mesh of a changed input, compared with the mesh of the input.
//
// Two changes have an exact effect. Scaling by a power of two scales every coordinate and every intermediate result
// without rounding. Another order of points and segments in the input changes nothing, because the engine orders
// everything by coordinates. Other changes have no exact effect. A translation changes the rounding of circumcentres,
// so the mesh has the same guarantees and about the same size, but other points. A reflection or a quarter turn also
// changes the space-filling curve and with it the order of insertions.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "../../core/digest.hpp"
#include "../../parallel/mesher.hpp"
#include "../../properties/checker/check.hpp"
#include "../../properties/domains/domains.hpp"
#include "samples.hpp"
#include "test_name.hpp"

namespace pardel::engine {
namespace {

const std::vector<Goal>& goals() {
  static const std::vector<Goal> all{
      {.region_caps = false}, {.min_angle_deg = 30, .max_area = 0.01, .region_caps = false}, {.conforming = true}};
  return all;
}

Mesh mesh_of(const Pslg& pslg, const Goal& goal) {
  Result<Meshed> meshed = mesh(pslg, goal);
  EXPECT_TRUE(meshed) << meshed.error().message;
  return meshed ? std::move(meshed->mesh) : Mesh{};
}

Mesh scaled(Mesh m, double scale) {
  for (Point& p : m.points) p = {p.x * scale, p.y * scale};
  return m;
}

class Law : public testing::TestWithParam<std::string> {
 protected:
  /// Does not test the wedge. If one of its segments is split, all are split, at the same distances from the apex; and
  /// at 20.7 degrees rounding decides whether a segment is split.
  void expect_like_sizes(const Mesh& here, const Mesh& there) const {
    if (GetParam() == "wedge") return;
    const auto ratio = static_cast<double>(there.triangles.size()) / static_cast<double>(here.triangles.size());
    EXPECT_NEAR(ratio, 1, 0.15);
  }

  Pslg pslg_ = *domains::generate(GetParam(), 0, 1);
};

TEST_P(Law, scaling_by_a_power_of_two_scales_the_mesh) {
  for (Region& region : pslg_.regions) region.max_area = std::numeric_limits<double>::infinity();
  for (const Goal& goal : goals()) {
    const Mesh expected = mesh_of(pslg_, goal);
    for (const double scale : {2.0, 0x1p60, 0x1p-60}) {
      Goal scaled_goal = goal;
      scaled_goal.max_area *= scale * scale;
      const Mesh found = mesh_of(domains::moved(pslg_, 0, 0, scale), scaled_goal);
      EXPECT_EQ(digest(found), digest(scaled(expected, scale))) << std::log2(scale) << " octaves";
    }
  }
}

TEST_P(Law, the_order_of_points_and_segments_has_no_effect) {
  samples::Random random(7);
  std::vector<Index> new_place(pslg_.points.size());
  for (std::size_t i = 0; i < new_place.size(); ++i) new_place[i] = static_cast<Index>(i);
  random.shuffle(new_place);
  Pslg shuffled = pslg_;
  for (std::size_t i = 0; i < new_place.size(); ++i) shuffled.points[new_place[i]] = pslg_.points[i];
  if (!shuffled.point_markers.empty())
    for (std::size_t i = 0; i < new_place.size(); ++i) shuffled.point_markers[new_place[i]] = pslg_.point_markers[i];
  for (Segment& s : shuffled.segments) s = {new_place[s.a], new_place[s.b], s.marker};
  for (const Goal& goal : goals()) EXPECT_EQ(digest(mesh_of(shuffled, goal)), digest(mesh_of(pslg_, goal)));
  random.shuffle(shuffled.segments);
  for (const Goal& goal : goals()) {
    const Mesh first = mesh_of(pslg_, goal), second = mesh_of(shuffled, goal);
    EXPECT_TRUE(check(shuffled, second, goal).valid);
    EXPECT_EQ(digest(second), digest(first));
  }
}

TEST_P(Law, reversing_segments_has_no_effect) {
  Pslg turned = pslg_;
  for (Segment& s : turned.segments) std::swap(s.a, s.b);
  for (const Goal& goal : goals()) EXPECT_EQ(digest(mesh_of(turned, goal)), digest(mesh_of(pslg_, goal)));
}

TEST_P(Law, moving_the_lattice_keeps_the_guarantees_and_about_the_size) {
  for (const Goal& goal : goals()) {
    const Mesh here = mesh_of(pslg_, goal);
    for (const Point by : {Point{3, -5}, Point{4096, 65536}}) {
      const Pslg moved = domains::moved(pslg_, by.x, by.y);
      const Mesh there = mesh_of(moved, goal);
      EXPECT_TRUE(check(moved, there, goal).valid);
      expect_like_sizes(here, there);
    }
  }
}

TEST_P(Law, a_quarter_turn_and_a_reflection_keep_the_guarantees_and_about_the_size) {
  const auto turned = [&](auto map) {
    Pslg result = pslg_;
    for (Point& p : result.points) p = map(p);
    for (Point& p : result.holes) p = map(p);
    for (Region& r : result.regions) r.seed = map(r.seed);
    return result;
  };
  const Pslg quarter = turned([](Point p) { return Point{-p.y, p.x}; });
  const Pslg mirrored = turned([](Point p) { return Point{p.y, p.x}; });
  for (const Goal& goal : goals()) {
    const Mesh here = mesh_of(pslg_, goal);
    for (const Pslg& pslg : {quarter, mirrored}) {
      const Mesh there = mesh_of(pslg, goal);
      EXPECT_TRUE(check(pslg, there, goal).valid);
      expect_like_sizes(here, there);
    }
  }
}

TEST_P(Law, a_stricter_goal_does_not_make_a_much_smaller_mesh) {
  std::size_t before = 0;
  for (const double angle : {0.0, 10.0, 20.7, 25.0, 30.0, 33.0}) {
    const std::size_t size = mesh_of(pslg_, {.min_angle_deg = angle}).triangles.size();
    EXPECT_GE(static_cast<double>(size), 0.95 * static_cast<double>(before)) << angle;
    before = size;
  }
}

INSTANTIATE_TEST_SUITE_P(Every, Law, testing::ValuesIn(domains::even_names()), test_name);

}  // namespace
}  // namespace pardel::engine
