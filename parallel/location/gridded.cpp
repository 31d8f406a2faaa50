#include "gridded.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numeric>
#include <vector>

#include "../threads/parallel_for.hpp"

namespace pardel::engine {
namespace {

/// What a sample of the triangles says in one direction: where nearly all of their boxes have their middle, and how
/// wide a typical box is.
struct Spread {
  double from, to, width;

  Spread(std::vector<double>& middles, std::vector<double>& widths) {
    const auto share = [](std::vector<double>& values, std::size_t parts) {
      const auto place = values.begin() + static_cast<std::ptrdiff_t>((values.size() - 1) * parts / 20);
      std::ranges::nth_element(values, place);
      return *place;
    };
    const double low = share(middles, 1), high = share(middles, 19);
    const double beyond = (high - low) / 18;  // if they are spread evenly, to the first and the last one
    from = low - beyond;
    to = high + beyond;
    width = share(widths, 10);
  }
  /// How many typical boxes lie side by side.
  [[nodiscard]] double boxes() const { return width > 0 ? std::clamp((to - from) / width, 1.0, 1e9) : 1.0; }
};

/// A grid with about `cells` cells over most of the triangles.
LocationGrid grid_over(const LocatedTriangles& all, std::span<const Index> list, double cells) {
  constexpr std::size_t largest_sample = 4096;
  const std::size_t sample = std::min(list.size(), largest_sample);
  std::vector<double> x, y, width, height;
  for (std::size_t i = 0; i < sample; ++i) {
    const Box box = all.box(list[list.size() * i / sample]);
    x.push_back(box.min_x / 2 + box.max_x / 2);
    y.push_back(box.min_y / 2 + box.max_y / 2);
    width.push_back(box.max_x - box.min_x);
    height.push_back(box.max_y - box.min_y);
  }
  const Spread over_x(x, width), over_y(y, height);
  const double shape = over_x.boxes() / over_y.boxes();
  const double columns = std::clamp(std::round(std::sqrt(cells * shape)), 1.0, std::max(1.0, cells));
  const double rows = std::max(1.0, std::round(cells / columns));
  return {.x = {over_x.from, over_x.to, static_cast<std::size_t>(columns)},
          .y = {over_y.from, over_y.to, static_cast<std::size_t>(rows)}};
}

/// The number of pairs of a triangle and a cell that touches its box.
std::size_t pairs_by_boxes(const LocatedTriangles& all, std::span<const Index> list, const LocationGrid& grid,
                           const Threads& threads) {
  std::vector<std::size_t> of_block(block_count(list.size()));
  parallel_blocks(threads, list.size(), [&](std::size_t first, std::size_t last, std::size_t block) {
    for (std::size_t i = first; i < last; ++i) of_block[block] += grid.cells_of(all.box(list[i]));
  });
  return std::accumulate(of_block.begin(), of_block.end(), std::size_t{0});
}

/// Calls visit(triangle, cell) for all triangles of the list and their cells, on all threads.
template <class Visit>
void for_each_pair(const LocatedTriangles& all, std::span<const Index> list, const LocationGrid& grid,
                   const Threads& threads, const Visit& visit) {
  parallel_blocks(threads, list.size(), [&](std::size_t first, std::size_t last, std::size_t) {
    for (std::size_t i = first; i < last; ++i) {
      const Index t = list[i];
      grid.for_each_cell(all.corners(t), all.box(t), [&](std::size_t cell) { visit(t, cell); });
    }
  });
}

/// Adds one, also if several threads do so; returns the number before.
Index count_up(Index& number) { return std::atomic_ref<Index>(number).fetch_add(1, std::memory_order_relaxed); }

}  // namespace

std::optional<GriddedTriangles> gridded(const LocatedTriangles& all, std::span<const Index> list,
                                        const Threads& threads) {
  constexpr double fewest_cells = 16;
  constexpr std::size_t most_pairs = 12;  // per triangle
  GriddedTriangles result;
  double cells = static_cast<double>(list.size()) / 2;
  for (;; cells /= 4) {
    if (cells < fewest_cells) return {};
    result.grid = grid_over(all, list, cells);
    const std::size_t pairs = pairs_by_boxes(all, list, result.grid, threads);
    if (pairs <= most_pairs * list.size() && pairs < no_index) break;
  }

  const std::size_t count = result.grid.cells();
  Array<Index>& start = result.start;
  start.resize(count + 1);
  for_each_pair(all, list, result.grid, threads, [&](Index, std::size_t cell) { count_up(start[cell + 1]); });
  if (*std::ranges::max_element(start) > list.size() * 3 / 4) return {};
  SparseAsk ask(threads.stop);
  for (std::size_t cell = 0; cell < count; ++cell) {
    ask();
    start[cell + 1] += start[cell];
  }
  result.triangles.resize_uninitialised(start[count]);
  Array<Index> next(start.span().first(count));
  for_each_pair(all, list, result.grid, threads,
                [&](Index t, std::size_t cell) { result.triangles[count_up(next[cell])] = t; });
  parallel_blocks(threads, count, [&](std::size_t first, std::size_t last, std::size_t) {
    for (std::size_t cell = first; cell < last; ++cell)
      std::sort(result.triangles.begin() + start[cell], result.triangles.begin() + start[cell + 1]);
  });
  return result;
}

}  // namespace pardel::engine
