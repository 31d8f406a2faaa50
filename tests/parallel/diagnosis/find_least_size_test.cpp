// least_size(): the triangles that the narrow parts of a domain require.
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <string>

#include "../../../parallel/least_size.hpp"
#include "../../../parallel/mesher.hpp"
#include "../../../properties/domains/domains.hpp"
#include "../shapes.hpp"

namespace pardel {
namespace {

using testing::add_polygon;
using testing::add_square;
using testing::square;

constexpr double bound = 20.7;

LeastSize least_of(const Pslg& pslg, double min_angle_deg = bound, int threads = 0) {
  Result<LeastSize> least = least_size(*validate(pslg), min_angle_deg, 0, threads);
  EXPECT_TRUE(least) << least.error().message;
  return *least;
}

Pslg polygon(const std::vector<Point>& corners) {
  Pslg pslg;
  add_polygon(pslg, corners);
  return pslg;
}

Pslg plate(double width) { return polygon({{0, 0}, {1, 0}, {1, width}, {0, width}}); }

TEST(LeastSize, of_a_thin_plate_is_just_below_the_size_of_its_mesh) {
  for (const double width : {3e-4, 1e-4, 2e-5}) {
    for (const double angle : {5.0, 20.7, 30.0}) {
      const LeastSize least = least_of(plate(width), angle);
      const double made = static_cast<double>(mesh(plate(width), {.min_angle_deg = angle})->mesh.triangles.size());
      EXPECT_LE(least.triangles, made);
      EXPECT_GE(least.triangles, made / 4);
    }
  }
}

TEST(LeastSize, of_a_plate_of_a_billionth_is_hundreds_of_millions_and_names_the_place) {
  const LeastSize least = least_of(plate(1e-9));
  EXPECT_NEAR(least.triangles, std::tan(bound * std::acos(-1.0) / 180) / 1e-9, 1e3);
  EXPECT_EQ(least.width, 1e-9);
  EXPECT_EQ(least.message(),
            "The domain is only 1e-09 wide at (0.125, 0). With such narrow parts and this smallest angle, the mesh "
            "needs at least 377.9 million triangles, and usually has about 831.3 million.");
}

TEST(LeastSize, names_no_number_that_is_too_large_to_be_estimated) {
  LeastSize size;
  size.expected = 4e12;
  EXPECT_EQ(size.message(), "With these bounds on sizes, the mesh will have more than a million million triangles.");
  size.expected = 4e9;
  EXPECT_EQ(size.message(), "With these bounds on sizes, the mesh will have about 4000 million triangles.");
}

TEST(LeastSize, counts_only_the_part_where_segments_face_each_other) {
  // A short tooth comes close to the lower side: its tip is 1e-4 wide.
  const Pslg tooth = polygon({{0, 0}, {1, 0}, {1, 1}, {0.50005, 1e-8}, {0.49995, 1e-8}, {0, 1}});
  EXPECT_LE(least_of(tooth).triangles, 1e-4 * std::tan(0.3613) / 1e-8);
  EXPECT_LE(least_of(tooth).triangles,
            static_cast<double>(mesh(tooth, {.min_angle_deg = bound})->mesh.triangles.size()));
}

TEST(LeastSize, is_negligible_for_small_input_angles_and_for_points_that_come_close) {
  EXPECT_LT(least_of(polygon({{0, 0}, {1, 0}, {1, 1e-9}})).triangles, 1);                    // a needle
  EXPECT_LT(least_of(polygon({{0, 0}, {0.5, -1e-9}, {1, 0}, {0.5, 1}})).triangles, 1);       // nearly straight
  EXPECT_LT(least_of(polygon({{0, 0}, {1, 0}, {1, 1}, {0.5, 1e-9}, {0, 1}})).triangles, 1);  // a peak over a side
  Pslg close = square(1);
  close.points.push_back({0.5, 1e-9});
  EXPECT_LT(least_of(close).triangles, 1);
}

TEST(LeastSize, is_negligible_without_a_bound_on_angles_and_for_parts_too_narrow_to_be_refined) {
  EXPECT_EQ(least_of(plate(1e-9), 0).triangles, 0);
  EXPECT_LT(least_of(plate(1e-14)).triangles, 1);
  EXPECT_LT(mesh(plate(1e-14), {.min_angle_deg = bound})->mesh.triangles.size(), 100);
  EXPECT_LT(least_size(*validate(plate(1e-9)), bound, 1e-8)->triangles, 1);
}

TEST(LeastSize, counts_a_narrow_hole_from_outside_only_and_a_slot_between_holes) {
  Pslg slot = square(1);
  add_polygon(slot, {{0.1, 0.1}, {0.9, 0.1}, {0.9, 0.5}, {0.1, 0.5}});
  add_polygon(slot, {{0.1, 0.5 + 1e-8}, {0.9, 0.5 + 1e-8}, {0.9, 0.9}, {0.1, 0.9}});
  slot.holes = {{0.2, 0.2}, {0.2, 0.8}};
  EXPECT_NEAR(least_of(slot).triangles, 0.8 * std::tan(0.3613) / 1e-8, 1e5);
  Pslg slit = square(1);
  add_polygon(slit, {{0.1, 0.1}, {0.9, 0.1}, {0.9, 0.1 + 1e-8}, {0.1, 0.1 + 1e-8}});
  slit.holes = {{0.5, 0.1 + 5e-9}};
  EXPECT_LT(least_of(slit).triangles, 10);
}

TEST(LeastSize, is_small_for_ordinary_domains) {
  for (const std::string& name : domains::names())
    EXPECT_LT(least_of(*domains::generate(name, 0, 1)).triangles, 1e5) << name;
}

TEST(LeastSize, does_not_depend_on_the_number_of_threads) {
  const Pslg comb = *domains::generate("comb", 0, 1);
  EXPECT_EQ(least_of(comb, bound, 1).triangles, least_of(comb, bound, 3).triangles);
  EXPECT_EQ(least_of(plate(1e-9), bound, 1).triangles, least_of(plate(1e-9), bound, 3).triangles);
}

TEST(LeastSize, is_announced_before_the_refinement_which_an_error_prevents) {
  Options options;
  double announced = 0;
  options.before_refinement = [&](const LeastSize& least) -> Status {
    announced = least.triangles;
    return Error{ErrorKind::usage, "too many"};
  };
  const Result<Meshed> none = mesh(plate(1e-9), {.min_angle_deg = bound}, options);
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().message, "too many");
  EXPECT_EQ(announced, least_of(plate(1e-9)).triangles);
  options.before_refinement = [](const LeastSize&) -> Status { throw std::runtime_error("no"); };
  EXPECT_EQ(mesh(plate(0.1), {.min_angle_deg = bound}, options).error().message,
            "Options::before_refinement threw an exception: no");
}

/// Then the bound on angles does not hold in narrow parts, so that no triangles are required there.
TEST(LeastSize, is_announced_as_negligible_if_segments_may_not_be_split) {
  const auto announced = [](Options options) {
    double triangles = -1;
    options.before_refinement = [&](const LeastSize& least) -> Status {
      triangles = least.triangles;
      return Error{ErrorKind::usage, "enough"};
    };
    EXPECT_FALSE(mesh(plate(1e-9), {.min_angle_deg = bound}, options));
    return triangles;
  };
  EXPECT_GT(announced({}), 1e8);
  EXPECT_EQ(announced({.no_boundary_splits = true}), 0);
  EXPECT_EQ(announced({.no_segment_splits = true}), 0);
  EXPECT_EQ(announced({.no_boundary_splits = true, .no_segment_splits = true}), 0);
}

TEST(LeastSize, counts_the_parts_that_are_as_wide_as_the_shortest_edge_and_none_that_are_narrower) {
  constexpr double width = 0x1p-20;
  EXPECT_GT(least_size(*validate(plate(width)), bound, width)->triangles, 100'000);
  EXPECT_LT(least_size(*validate(plate(width)), bound, std::nextafter(width, 1.0))->triangles, 10);
}

TEST(LeastSize, counts_parts_that_are_narrower_than_a_thousandth_of_their_length) {
  const auto strip = [](double width) { return polygon({{0, 0}, {1000, 0}, {1000, width}, {0, width}}); };
  EXPECT_EQ(least_of(strip(1)).triangles, 0);
  EXPECT_GT(least_of(strip(std::nextafter(1.0, 0.0))).triangles, 300);
}

}  // namespace
}  // namespace pardel
