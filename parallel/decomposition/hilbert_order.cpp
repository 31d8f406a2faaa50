#include "hilbert_order.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <utility>

#include "../../core/support/point_order.hpp"
#include "../threads/parallel_arrays.hpp"
#include "bounding_box.hpp"

namespace pardel::engine {
namespace {

// One level of the curve. The state is one of the four orientations of the curve's U shape. For each state and quadrant
// (x bit, y bit), the table has the position of the quadrant along the curve and the state inside the quadrant.
struct Step {
  std::uint8_t position, state;
};
constexpr std::array<std::array<Step, 4>, 4> one_level{{
    // quadrants (0,0) (0,1) (1,0) (1,1)
    {{{0, 1}, {1, 0}, {3, 2}, {2, 0}}},
    {{{0, 0}, {3, 3}, {1, 1}, {2, 1}}},
    {{{2, 2}, {1, 2}, {3, 0}, {0, 3}}},
    {{{2, 3}, {3, 1}, {1, 3}, {0, 2}}},
}};

/// Four levels in one step. The first index is the state; the second has four bits of x above four bits of y.
constexpr auto four_levels = [] {
  std::array<std::array<Step, 256>, 4> table{};
  for (std::uint8_t start = 0; start < 4; ++start)
    for (unsigned bits = 0; bits < 256; ++bits) {
      Step whole{0, start};
      for (int bit = 3; bit >= 0; --bit) {
        const Step step = one_level[whole.state][(bits >> (bit + 4) & 1U) << 1U | (bits >> bit & 1U)];
        whole = {static_cast<std::uint8_t>(whole.position << 2U | step.position), step.state};
      }
      table[start][bits] = whole;
    }
  return table;
}();

std::uint32_t hilbert_key(std::uint32_t x, std::uint32_t y) {
  std::uint32_t key = 0;
  unsigned state = 0;
  for (int bit = static_cast<int>(CurveGrid::levels) - 4; bit >= 0; bit -= 4) {
    const Step step = four_levels[state][(x >> bit & 15U) << 4U | (y >> bit & 15U)];
    key = key << 8U | step.position;
    state = step.state;
  }
  return key;
}

/// So few words are sorted by comparisons.
constexpr std::size_t few_words = 1024;

/// Sorts words by their upper halves. Precondition: equal upper halves are in the order of the lower halves. Radix sort
/// with digits of 11 bits, least significant digit first. It is stable, so the number of parts does not change the
/// result.
void sort_by_key(Array<std::uint64_t>& words, const Threads& threads) {
  if (words.size() <= few_words) return std::sort(words.begin(), words.end());
  Array<std::uint64_t> sorted;
  sorted.resize_uninitialised(words.size());
  const std::size_t parts = std::min(block_count(words.size()), static_cast<std::size_t>(threads.count));
  std::vector<std::array<std::size_t, 2048>> next(parts);
  for (unsigned shift = 32; shift < 64; shift += 11) {
    const auto in_parts = [&](const auto& visit) {
      parallel_for(threads, parts, [&](std::size_t part, int) {
        SparseAsk ask(threads.stop);
        const std::size_t last = words.size() * (part + 1) / parts;
        for (std::size_t i = words.size() * part / parts; i < last; ++i) {
          ask();
          visit(words[i], next[part][words[i] >> shift & 2047U]);
        }
      });
    };
    for (auto& counts : next) counts.fill(0);
    in_parts([](std::uint64_t, std::size_t& count) { ++count; });
    std::size_t place = 0;
    for (unsigned digit = 0; digit < 2048; ++digit)
      for (auto& counts : next) place += std::exchange(counts[digit], place);
    in_parts([&](std::uint64_t word, std::size_t& to) { sorted[to++] = word; });
    words.swap(sorted);
  }
}

void order_by_coordinates(std::span<const Point> points, std::span<Index> ids) {
  std::sort(ids.begin(), ids.end(), [&](Index a, Index b) { return lexicographically_less(points[a], points[b]); });
}

void order_in_cells(std::span<const Point> points, std::span<Index> ids, const CurveGrid& grid, const Threads& threads);

void order_along_curve(std::span<const Point> points, std::span<Index> ids, const Threads& threads) {
  if (ids.size() <= few_points) return order_by_coordinates(points, ids);
  const Box box = bounding_box(threads, ids.size(), [&](std::size_t k) { return points[ids[k]]; });
  if (!(box.extent() > 0)) return order_by_coordinates(points, ids);
  order_in_cells(points, ids, CurveGrid(box), threads);
}

/// Orders the points by their cells, and those of each cell along a curve through the cell.
void order_in_cells(std::span<const Point> points, std::span<Index> ids, const CurveGrid& grid,
                    const Threads& threads) {
  Array<std::uint64_t> words = make_array(threads, ids.size(), [&](std::size_t k) {
    const Point p = points[ids[k]];
    return static_cast<std::uint64_t>(hilbert_key(grid.column(p), grid.row(p))) << 32U | ids[k];
  });
  sort_by_key(words, threads);
  parallel_blocks(threads, ids.size(), [&](std::size_t first, std::size_t last, std::size_t) {
    for (std::size_t k = first; k < last; ++k) ids[k] = static_cast<Index>(words[k]);
  });
  // Find the runs of equal keys: `continued` lists the positions with the same key as the position before.
  const Array<Index> continued = indices_where(
      threads, words.size(), [&](std::size_t k) { return k > 0 && words[k] >> 32U == words[k - 1] >> 32U; });
  for (std::size_t i = 0; i < continued.size();) {
    const std::size_t start = continued[i] - 1;
    std::size_t stop = start + 1;
    for (; i < continued.size() && continued[i] == stop; ++i) ++stop;
    threads.ask();
    order_along_curve(points, ids.subspan(start, stop - start), threads);
  }
}

}  // namespace

CurveGrid::CurveGrid(const Box& bounds)
    : min_x_(bounds.min_x),
      min_y_(bounds.min_y),
      scale_(bounds.extent() > 0 ? last_cell / bounds.extent() : 0),
      margin_(0x1p-45 * bounds.largest_magnitude()) {}

std::uint32_t CurveGrid::key(Point p) const { return hilbert_key(column(p), row(p)); }

std::uint32_t CurveGrid::first_key(const Quadrant& quadrant) {
  const unsigned below = levels - quadrant.level;
  const std::uint64_t keys = std::uint64_t{1} << 2 * below;
  return static_cast<std::uint32_t>(hilbert_key(quadrant.x << below, quadrant.y << below) & ~(keys - 1));
}

Box CurveGrid::square(const Quadrant& quadrant) const {
  const double side = scale_ == 0 ? 0 : std::ldexp(1 / scale_, static_cast<int>(levels - quadrant.level));
  const double left = min_x_ + quadrant.x * side, low = min_y_ + quadrant.y * side;
  return {left - margin_, low - margin_, left + side + margin_, low + side + margin_};
}

CurveGrid::Quadrant CurveGrid::around(const Box& box) const {
  const std::uint32_t x = cell(box.min_x - margin_ - min_x_), y = cell(box.min_y - margin_ - min_y_);
  const std::uint32_t differing = (x ^ cell(box.max_x + margin_ - min_x_)) | (y ^ cell(box.max_y + margin_ - min_y_));
  const auto below = static_cast<unsigned>(std::bit_width(differing));
  return {x >> below, y >> below, levels - below};
}

Array<Index> hilbert_order(std::span<const Point> points, const CurveGrid& grid, const Threads& threads) {
  Array<Index> ids = make_array(threads, points.size(), [](std::size_t i) { return static_cast<Index>(i); });
  if (!ids.empty()) order_in_cells(points, ids.span(), grid, threads);
  return ids;
}

Array<Index> hilbert_order(std::span<const Point> points, const Threads& threads) {
  Array<Index> ids = make_array(threads, points.size(), [](std::size_t i) { return static_cast<Index>(i); });
  order_along_curve(points, ids.span(), threads);
  return ids;
}

}  // namespace pardel::engine
