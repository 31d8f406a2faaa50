// Arithmetic with pairs of doubles gives the same results as arithmetic with single doubles.
#include "../../../parallel/arithmetic/pair.hpp"

#include <gtest/gtest.h>

#include "../../../parallel/arithmetic/predicates.hpp"
#include "../samples.hpp"

namespace pardel::engine {
namespace {

using samples::Random;

TEST(Pair, rounds_each_half_like_a_single_double) {
  Random random(1);
  for (int round = 0; round < 1000; ++round) {
    const std::array<double, 2> a{random.uniform(-1, 1), random.uniform(-1e9, 1e9)};
    const std::array<double, 2> b{random.uniform(-1e-9, 1e-9), random.uniform(-1, 1)};
    const Pair p{a[0], a[1]}, q{b[0], b[1]};
    for (const int half : {0, 1}) {
      EXPECT_EQ((p * q + p - q)[half], a[half] * b[half] + a[half] - b[half]);
      EXPECT_EQ(magnitude(p)[half], magnitude(a[half]));
      EXPECT_EQ(least(p, q)[half], least(a[half], b[half]));
      EXPECT_EQ(greatest(p, q)[half], greatest(a[half], b[half]));
    }
  }
}

TEST(Pair, reports_comparisons_of_each_half_separately) {
  const Pair low{1, 2}, high{3, 2};
  EXPECT_EQ(bits(low < high), 1U);
  EXPECT_EQ(bits(low == high), 2U);
  EXPECT_EQ(bits(low > high), 0U);
  EXPECT_EQ(bits(low <= high), 3U);
  EXPECT_TRUE(all(low <= high));
  EXPECT_FALSE(all(low < high));
  EXPECT_EQ(firsts(low, high)[0], 1);
  EXPECT_EQ(firsts(low, high)[1], 3);
  EXPECT_EQ(seconds(low, high)[0], 2);
  const Point p{5, -7};
  EXPECT_EQ(as_point(as_pair(p)), p);
}

TEST(Pair, evaluates_the_filters_of_both_halves) {
  Random random(2);
  const auto number = [&] { return random.uniform(-1, 1); };
  for (int round = 0; round < 1000; ++round) {
    std::array<std::array<double, 8>, 2> x{};
    for (auto& half : x)
      for (double& value : half) value = number();
    const auto pair = [&](std::size_t i) { return Pair{x[0][i], x[1][i]}; };
    const InCircle<Pair> disks(pair(0), pair(1), pair(2), pair(3), pair(4), pair(5), pair(6), pair(7));
    const Orientation<Pair> turns(pair(0), pair(1), pair(2), pair(3));
    for (const std::size_t half : {0U, 1U}) {
      const auto& h = x[half];
      const InCircle<double> disk(h[0], h[1], h[2], h[3], h[4], h[5], h[6], h[7]);
      EXPECT_EQ(disks.determinant[half], disk.determinant);
      EXPECT_EQ(disks.error[half], disk.error);
      EXPECT_EQ(disks.square[half], disk.square);
      const Orientation<double> turn(h[0], h[1], h[2], h[3]);
      EXPECT_EQ(turns.determinant[half], turn.determinant);
      EXPECT_EQ(turns.error[half], turn.error);
    }
  }
}

TEST(Pair, is_certain_if_and_only_if_both_halves_are) {
  const auto disks = [](double first,
                        double second) {  // for the unit circle and points at these distances from its centre
    const Pair x{first, second}, zero{0, 0}, one{1, 1};
    // Corners (1, 0), (0, 1), (-1, 0) relative to (x, 0): v, u, w are counter-clockwise.
    const Pair vx = one - x, ux = -x, wx = -one - x;
    return InCircle<Pair>(ux, one, vx, zero, wx, zero, ux * ux + one, vx * vx);
  };
  EXPECT_TRUE(disks(0.5, 2).is_certain());
  EXPECT_EQ(bits(disks(0.5, 2).determinant > 0), 1U);
  EXPECT_FALSE(disks(1, 2).is_certain());
  EXPECT_FALSE(disks(0.5, 1).is_certain());
}

}  // namespace
}  // namespace pardel::engine
