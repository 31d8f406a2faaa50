#include "../../../properties/domains/domains.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "../../../core/formats.hpp"
#include "../../../parallel/validate.hpp"

namespace pardel {
namespace {

double angle_deg(Point at, Point p, Point q) {
  const double ux = p.x - at.x, uy = p.y - at.y, vx = q.x - at.x, vy = q.y - at.y;
  return std::abs(std::atan2(ux * vy - uy * vx, ux * vx + uy * vy)) * 180 / std::numbers::pi;
}

/// The smallest angle between two segments that share a point.
double smallest_input_angle_deg(const Pslg& pslg) {
  double smallest = 180;
  for (const Segment& s : pslg.segments)
    for (const Segment& t : pslg.segments)
      for (const auto& [a, p] : {std::pair{s.a, s.b}, std::pair{s.b, s.a}})
        for (const auto& [b, q] : {std::pair{t.a, t.b}, std::pair{t.b, t.a}})
          if (a == b && p != q)
            smallest = std::min(smallest, angle_deg(pslg.points[a], pslg.points[p], pslg.points[q]));
  return smallest;
}

bool on_lattice(double x, double pieces) { return std::floor(x * pieces) == x * pieces; }

TEST(Domains, are_all_valid) {
  for (const std::string& name : domains::names()) {
    const auto pslg = domains::generate(name, 0, 1);
    ASSERT_TRUE(pslg.ok()) << name;
    const auto problems = find_problems(*pslg);
    EXPECT_TRUE(problems.empty()) << name << ": " << problems.front().message();
  }
}

TEST(Domains, stay_valid_when_moved_far_from_the_origin) {
  for (const std::string& name : domains::names()) {
    const Pslg pslg = domains::moved(*domains::generate(name, 0, 1), 654321, 4987654, 16);
    const auto problems = find_problems(pslg);
    EXPECT_TRUE(problems.empty()) << name << ": " << problems.front().message();
  }
}

TEST(Domains, have_coordinates_on_a_dyadic_lattice) {
  for (const std::string& name : domains::names()) {
    const Pslg pslg = *domains::generate(name, 0, 1);
    for (const Point& p : pslg.points) EXPECT_TRUE(on_lattice(p.x, 0x1p40) && on_lattice(p.y, 0x1p40)) << name;
  }
}

TEST(Domains, radial_has_rings_whose_radii_grow_by_one_factor_and_sizes_that_grow_with_them) {
  const Pslg pslg = domains::radial(3);
  ASSERT_EQ(pslg.points.size(), 5U + 24 * 72);
  const std::vector<double> sizes = domains::radial_sizes(pslg, 0.5);
  ASSERT_EQ(sizes.size(), pslg.points.size());
  const auto radius = [&](std::size_t i) { return std::hypot(pslg.points[i].x, pslg.points[i].y); };
  EXPECT_NEAR(radius(5), 0.95e-3, 1e-8);
  EXPECT_NEAR(radius(pslg.points.size() - 1), 0.95, 1e-8);
  for (std::size_t i = 5; i < sizes.size(); ++i) EXPECT_NEAR(sizes[i], 0.5 * radius(i), 1e-12);
  EXPECT_NEAR(sizes[4], 0.5 * 0.95e-3, 1e-8) << "the centre";
}

TEST(Domains, the_key_and_pipe_in_examples_are_what_the_functions_return) {
  for (const auto& [file, pslg] : {std::pair{"key.poly", domains::key()}, std::pair{"pipe.poly", domains::pipe()}}) {
    const auto shipped = read_pslg(std::filesystem::path(PARDEL_EXAMPLES) / file);
    ASSERT_TRUE(shipped.ok()) << shipped.error().message;
    EXPECT_EQ(*shipped, pslg) << file;
  }
}

TEST(Domains, the_key_has_at_least_150_segments_a_ring_and_a_hole_in_its_bit) {
  const Pslg key = domains::key();
  EXPECT_GE(key.segments.size(), 150u);
  EXPECT_EQ(key.holes.size(), 2u);
}

TEST(Domains, the_pipe_has_the_cross_section_of_the_paper) {
  const Pslg pipe = domains::pipe();
  EXPECT_EQ(pipe.segments.size(), 200u + 7 * 60);
  EXPECT_EQ(pipe.holes.size(), 7u);
  double furthest = 0;
  for (const Point& p : pipe.points) furthest = std::max(furthest, std::hypot(p.x, p.y));
  EXPECT_NEAR(furthest, 1, 0x1p-29);
}

TEST(Domains, spikes_of_a_star_have_the_requested_angle) {
  for (const double degrees : {1.0, 5.0, 30.0})
    EXPECT_NEAR(smallest_input_angle_deg(domains::star(12, degrees)), degrees, 1e-6);
}

TEST(Domains, segments_of_a_wedge_have_the_requested_angle) {
  const Pslg wedge = domains::wedge(50, 1.8);
  EXPECT_NEAR(smallest_input_angle_deg(wedge), 1.8, 1e-6);
  EXPECT_EQ(std::ranges::count_if(wedge.segments, [](const Segment& s) { return s.a == 4; }), 50);
}

TEST(Domains, touching_holes_make_no_small_angle) {
  EXPECT_NEAR(smallest_input_angle_deg(domains::touching_holes()), 90, 1e-9);
}

TEST(Domains, random_points_depend_only_on_their_number_and_the_seed) {
  EXPECT_EQ(domains::random_points(100, 7), domains::random_points(100, 7));
  EXPECT_NE(domains::random_points(100, 7), domains::random_points(100, 8));
  // The first draw of SplitMix64 with seed 0 is e220a8397b1dcdaf, as its authors publish it.
  EXPECT_EQ(domains::random_points(1, 0).points[0].x, static_cast<double>(0xe220a8397b1dcdafu >> 24) * 0x1p-40);
}

TEST(Domains, grids_have_the_requested_size) {
  EXPECT_EQ(domains::grid(7).points.size(), 64u);
  EXPECT_EQ(domains::grid(7).segments.size(), 2u * 7 * 8 + 49);
  EXPECT_EQ(domains::generate("grid-points", 7, 0)->points.size(), 64u);
}

TEST(Domains, an_unknown_name_or_a_size_out_of_range_is_an_error_of_usage) {
  for (const auto& wrong : {domains::generate("keys", 0, 0), domains::generate("square", 4, 0),
                            domains::generate("star", 2, 0), domains::generate("grid", 1'000'000, 0)}) {
    ASSERT_FALSE(wrong.ok());
    EXPECT_EQ(wrong.error().kind, ErrorKind::usage);
  }
}

}  // namespace
}  // namespace pardel
