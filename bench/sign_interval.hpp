// An interval for the median of a distribution from which some values are known.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace pardel::bench {

struct Interval {
  double low = 0, high = std::numeric_limits<double>::infinity();
};

/// The narrowest interval from the k-th least to the k-th greatest value that contains the median with at least this
/// confidence, whatever the distribution: at most k - 1 of n values lie on one side of the median with the probability
/// of at most k - 1 heads in n throws of a coin. From 0 to infinity if there are too few values: for 95 %, five.
/// Precondition: fewer than 1000 values, not negative; 0 < confidence < 1. The same as sign_interval() of
/// measuring/ratios.py, for programs that run as ranks. (The sign test: Gibbons and Chakraborti, "Nonparametric
/// Statistical Inference", section 5.4.)
[[nodiscard]] inline Interval sign_interval(std::vector<double> values, double confidence) {
  std::ranges::sort(values);
  const std::size_t n = values.size();
  double heads = std::pow(0.5, static_cast<double>(n));  // the probability of exactly k heads
  double at_most = 0;                                    // and of at most k - 1
  std::size_t k = 0;
  while (2 * (at_most + heads) <= 1 - confidence) {
    at_most += heads;
    heads *= static_cast<double>(n - k) / static_cast<double>(k + 1);
    ++k;
  }
  if (k == 0) return {};
  return {values[k - 1], values[n - k]};
}

}  // namespace pardel::bench
