// The lower envelope of growing lengths is the least of them, wherever the search begins.
#include "../../../parallel/sizing/size_envelope.hpp"

#include <gtest/gtest.h>

#include "../samples.hpp"

namespace pardel::engine {
namespace {

constexpr Box unit_box{0, 0, 1, 1};

GrowingSize at_point(Point p, double length, double slope) { return {{p, p, length, length}, slope}; }

TEST(SizeEnvelope, of_a_point_is_a_cone) {
  const std::vector<GrowingSize> one{at_point({0.25, 0.5}, 0.1, 0.5)};
  const SizeEnvelope envelope(one, unit_box);
  EXPECT_EQ(envelope.at({0.25, 0.5}), 0.1);
  EXPECT_DOUBLE_EQ(envelope.at({0.25, 1}), 0.35);
  EXPECT_DOUBLE_EQ(envelope.at({3.25, 4.5}), 2.6) << "outside the box";
}

TEST(SizeEnvelope, of_a_segment_grows_with_the_distance_from_its_nearest_point) {
  const std::vector<GrowingSize> one{{{{0.2, 0.5}, {0.8, 0.5}, 0.1, 0.1}, 1}};
  const SizeEnvelope envelope(one, unit_box);
  EXPECT_NEAR(envelope.at({0.4, 0.7}), 0.3, 1e-15);
  EXPECT_NEAR(envelope.at({0.9, 0.5}), 0.2, 1e-15);
}

TEST(SizeEnvelope, of_a_segment_with_two_lengths_is_the_least_over_all_its_points) {
  const GrowingSize source{{{0, 0}, {1, 0}, 0.1, 0.7}, 1};
  const PreparedSize prepared(source);
  for (const Point p : {Point{0.5, 0.25}, Point{0.9, 1}, Point{-1, 0.5}, Point{1.5, -0.1}}) {
    double least = INFINITY;
    for (int i = 0; i <= 100000; ++i) {
      const double x = i / 100000.0, dx = p.x - x;
      least = std::min(least, 0.1 + 0.6 * x + std::sqrt(dx * dx + p.y * p.y));
    }
    EXPECT_NEAR(prepared.at(p), least, 1e-9);
    EXPECT_LE(prepared.at(p), least + 1e-15);
  }
}

TEST(SizeEnvelope, of_a_segment_that_is_steeper_than_the_limit_is_that_of_its_shorter_end) {
  for (const bool turned : {false, true}) {
    const Point a{0, 0}, b{1, 0};
    const GrowingSize source = turned ? GrowingSize{{b, a, 5, 0.1}, 0.5} : GrowingSize{{a, b, 0.1, 5}, 0.5};
    EXPECT_DOUBLE_EQ(PreparedSize(source).at({1, 0}), 0.6);
    EXPECT_DOUBLE_EQ(PreparedSize(source).at({0, 0}), 0.1);
  }
}

/// The length grows along the source by 1. All values are numbers that doubles can represent.
TEST(SizeEnvelope, of_a_segment_that_is_as_steep_as_the_limit_is_that_of_its_shorter_end) {
  for (const bool turned : {false, true}) {
    const Point a{0, 0}, b{2, 0};
    const PreparedSize prepared(turned ? GrowingSize{{b, a, 3, 1}, 1} : GrowingSize{{a, b, 1, 3}, 1});
    for (const double x : {-2.0, 0.0, 0.5, 1.0, 2.0, 5.0}) EXPECT_EQ(prepared.at({x, 0}), 1 + std::abs(x)) << x;
    EXPECT_EQ(prepared.at({3, 4}), 6);
    EXPECT_EQ(prepared.at({-3, -4}), 6);
    EXPECT_EQ(prepared.at({0, 2}), 3);
  }
}

TEST(SizeEnvelope, of_a_segment_hardly_depends_on_whether_it_is_steeper_than_the_limit) {
  for (const double slope : {1 - 0x1p-40, 1.0, 1 + 0x1p-40}) {
    const PreparedSize prepared(GrowingSize{{{0, 0}, {2, 0}, 1, 3}, slope});
    for (const Point p : {Point{-2, 0}, {0, 0}, {1, 0}, {2, 0}, {5, 0}, {3, 4}, {1, -1}, {0, 2}})
      EXPECT_NEAR(prepared.at(p), 1 + std::hypot(p.x, p.y), 1e-5) << slope << ": " << p.x << ' ' << p.y;
  }
}

TEST(SizeEnvelope, without_sources_is_infinite) {
  EXPECT_EQ(SizeEnvelope({}, unit_box).at({0.5, 0.5}), INFINITY);
  EXPECT_TRUE(SizeEnvelope({}, unit_box).empty());
}

TEST(SizeEnvelope, is_the_least_of_thousands_of_sources) {
  samples::Random random(5);
  std::vector<GrowingSize> sources;
  for (int i = 0; i < 3000; ++i) {
    const double slope = i % 3 == 0 ? 0.2 : 1;
    const Point a{random.uniform(), random.uniform()};
    const Point b = i % 2 == 0 ? a : Point{a.x + random.uniform(-0.1, 0.1), a.y + random.uniform(-0.1, 0.1)};
    const double length = i % 7 == 0 ? 1e-6 * random.uniform(1, 1000) : random.uniform(0.01, 1);
    sources.push_back({{a, b, length, i % 2 == 0 ? length : random.uniform(0.01, 1)}, slope});
  }
  const SizeEnvelope envelope(sources, unit_box);
  for (int i = 0; i < 2000; ++i) {
    const Point p =
        i % 4 == 0 ? sources[random.below(sources.size())].source.a : Point{random.uniform(), random.uniform()};
    double least = INFINITY;
    for (const GrowingSize& source : sources) least = std::min(least, PreparedSize(source).at(p));
    EXPECT_EQ(envelope.at(p), least);
    Index hint = static_cast<Index>(random.below(4000));  // also beyond the sources
    EXPECT_EQ(envelope.at(p, hint), least);
    EXPECT_EQ(envelope.at(p, hint), least) << "from the source that was found";
  }
}

TEST(SizeEnvelope, is_the_least_of_any_number_of_sources) {
  samples::Random random(6);
  std::vector<GrowingSize> sources;
  for (int n = 1; n <= 40; ++n) {
    sources.push_back(at_point({random.uniform(), random.uniform()}, random.uniform(0.01, 0.2), 0.5));
    const SizeEnvelope envelope(sources, unit_box);
    for (int i = 0; i < 50; ++i) {
      const Point p{random.uniform(-1, 2), random.uniform(-1, 2)};
      double least = INFINITY;
      for (const GrowingSize& source : sources) least = std::min(least, PreparedSize(source).at(p));
      EXPECT_EQ(envelope.at(p), least) << n << " sources";
    }
  }
}

TEST(SizeEnvelope, is_the_least_at_the_centre_of_a_circle_of_equal_sources) {
  std::vector<GrowingSize> sources;
  for (int i = 0; i < 1000; ++i)
    sources.push_back(at_point({0.5 + 0.4 * std::cos(0.00628 * i), 0.5 + 0.4 * std::sin(0.00628 * i)}, 0.01, 0.25));
  const SizeEnvelope envelope(sources, unit_box);
  EXPECT_NEAR(envelope.at({0.5, 0.5}), 0.11, 1e-12);
}

TEST(SizeEnvelope, does_not_need_a_hint_that_is_a_source) {
  const std::vector<GrowingSize> two{at_point({0.25, 0.5}, 0.1, 0.5), at_point({0.75, 0.5}, 0.1, 0.5)};
  const SizeEnvelope envelope(two, unit_box);
  for (Index hint : {Index{0}, Index{1}, Index{2}, Index{1} << 30U, no_index}) {
    EXPECT_EQ(envelope.at({0.75, 0.5}, hint), 0.1);
    EXPECT_LT(hint, 2U);
  }
}

}  // namespace
}  // namespace pardel::engine
