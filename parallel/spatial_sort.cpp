#include "spatial_sort.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "../core/mutants.hpp"
#include "parallel_for.hpp"

namespace pardel {
namespace {

constexpr int levels = 16;  // bits per coordinate of a key

// One level of the curve: a state is one of four orientations of the U; per quadrant (x bit, y bit), its
// position along the curve and the orientation inside it.
struct Step {
  std::uint8_t position, state;
};
constexpr std::array<std::array<Step, 4>, 4> steps{{
    // quadrants (0,0) (0,1) (1,0) (1,1)
    {{{0, 1}, {1, 0}, {3, 2}, {2, 0}}},
    {{{0, 0}, {3, 3}, {1, 1}, {2, 1}}},
    {{{2, 2}, {1, 2}, {3, 0}, {0, 3}}},
    {{{2, 3}, {3, 1}, {1, 3}, {0, 2}}},
}};

std::uint32_t hilbert_key(std::uint32_t x, std::uint32_t y) {
  std::uint32_t key = 0;
  unsigned state = 0;
  for (int bit = levels - 1; bit >= 0; --bit) {
    const unsigned quadrant = (x >> bit & 1U) << 1U | (y >> bit & 1U);
    const Step step = steps[state][quadrant];
    key = key << 2U | step.position;
    state = step.state;
  }
  return key;
}

struct Box {
  double min_x, min_y, side;
};

Box bounding_square(std::span<const Point> points, std::span<const Index> ids) {
  double min_x = INFINITY, min_y = INFINITY, max_x = -INFINITY, max_y = -INFINITY;
  for (const Index i : ids) {
    min_x = std::min(min_x, points[i].x);
    max_x = std::max(max_x, points[i].x);
    min_y = std::min(min_y, points[i].y);
    max_y = std::max(max_y, points[i].y);
  }
  return {min_x, min_y, std::max(max_x - min_x, max_y - min_y)};
}

/// Least significant digit first, 11 bits at a time, on the upper half of each word.
void radix_sort_by_key(std::vector<std::uint64_t>& words) {
  std::vector<std::uint64_t> other(words.size());
  for (unsigned shift = 32; shift < 64; shift += 11) {
    std::array<std::size_t, 2049> start{};
    for (const std::uint64_t w : words) ++start[(w >> shift & 2047U) + 1];
    for (std::size_t d = 1; d < start.size(); ++d) start[d] += start[d - 1];
    for (const std::uint64_t w : words) other[start[w >> shift & 2047U]++] = w;
    words.swap(other);
  }
}

void order_along_curve(std::span<const Point> points, std::span<Index> ids, int threads) {
  const Box box = bounding_square(points, ids);
  if (ids.size() <= 16 || !(box.side > 0)) {
    if (mutated("order_of_the_input_decides")) return;
    std::sort(ids.begin(), ids.end(), [&](Index a, Index b) {
      return points[a].x < points[b].x || (points[a].x == points[b].x && points[a].y < points[b].y);
    });
    return;
  }
  constexpr double top = (1U << levels) - 1;
  const double scale = top / box.side;
  std::vector<std::uint64_t> words(ids.size());
  parallel_blocks(threads, ids.size(), [&](std::size_t first, std::size_t last, std::size_t) {
    for (std::size_t k = first; k < last; ++k) {
      const Point p = points[ids[k]];
      const auto x = static_cast<std::uint32_t>(std::min(top, (p.x - box.min_x) * scale));
      const auto y = static_cast<std::uint32_t>(std::min(top, (p.y - box.min_y) * scale));
      words[k] = static_cast<std::uint64_t>(hilbert_key(x, y)) << 32U | ids[k];
    }
  });
  radix_sort_by_key(words);
  for (std::size_t k = 0; k < ids.size(); ++k) ids[k] = static_cast<Index>(words[k]);
  for (std::size_t k = 0; k < words.size();) {
    std::size_t stop = k + 1;
    while (stop < words.size() && words[stop] >> 32U == words[k] >> 32U) ++stop;
    if (stop - k > 1) order_along_curve(points, ids.subspan(k, stop - k), threads);
    k = stop;
  }
}

}  // namespace

std::vector<Index> hilbert_order(std::span<const Point> points, int threads) {
  std::vector<Index> ids(points.size());
  for (std::size_t i = 0; i < ids.size(); ++i) ids[i] = static_cast<Index>(i);
  order_along_curve(points, ids, threads);
  return ids;
}

}  // namespace pardel
