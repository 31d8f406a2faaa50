#include "duplicates.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>
#include <utility>

#include "../../core/array.hpp"
#include "../../core/support/hash.hpp"
#include "../arithmetic/box.hpp"
#include "../arithmetic/distance.hpp"
#include "../threads/parallel_arrays.hpp"

namespace pardel::engine {
namespace {

std::uint64_t hash_of(Point p) {
  // Adding zero turns -0 into 0.
  return mixed(mixed(std::bit_cast<std::uint64_t>(p.x + 0.0)) + std::bit_cast<std::uint64_t>(p.y + 0.0));
}

/// A point with the low half of its hash.
struct Entry {
  std::uint32_t hash;
  Index index;
};

/// A hash table over the entries of one part.
class Table {
 public:
  explicit Table(std::size_t entries) : slots_(std::bit_ceil(2 * entries + 1), nullptr), mask_(slots_.size() - 1) {}

  /// Returns the entry with an equal point if there is one. Otherwise inserts the entry and returns null.
  const Entry* find_or_insert(const Entry& entry, std::span<const Point> points) {
    for (std::size_t slot = entry.hash & mask_;; slot = (slot + 1) & mask_) {
      if (slots_[slot] == nullptr) {
        slots_[slot] = &entry;
        return nullptr;
      }
      if (slots_[slot]->hash == entry.hash && points[slots_[slot]->index] == points[entry.index]) return slots_[slot];
    }
  }

 private:
  std::vector<const Entry*> slots_;
  std::size_t mask_;
};

}  // namespace

std::vector<Duplicate> find_duplicates(std::span<const Point> points, const Threads& threads) {
  // Parts of about a thousand points: their tables stay in the first-level cache.
  const std::size_t parts = std::bit_ceil(std::clamp<std::size_t>(points.size() / 1024, 1, 4096));
  const Array<Index> part_of = make_array(threads, points.size(), [&](std::size_t i) {
    return static_cast<Index>((hash_of(points[i]) >> 32U) & (parts - 1));
  });

  std::vector<std::size_t> end(parts + 1);
  visit_by_cell(threads, part_of.span(), parts, [&](Index part, std::size_t) { ++end[part + 1]; });
  std::partial_sum(end.begin(), end.end(), end.begin());
  const std::vector<std::size_t> begin = end;
  Array<Entry> entries;
  entries.resize_uninitialised(points.size());
  visit_by_cell(threads, part_of.span(), parts, [&](Index part, std::size_t i) {
    entries[end[part]++] = {static_cast<std::uint32_t>(hash_of(points[i])), static_cast<Index>(i)};
  });

  std::vector<std::vector<Duplicate>> found(parts);
  parallel_for(threads, parts, [&](std::size_t part, int) {
    Table table(end[part] - begin[part]);
    for (std::size_t i = begin[part]; i < end[part]; ++i)
      if (const Entry* first = table.find_or_insert(entries[i], points))
        found[part].push_back({first->index, entries[i].index});
  });
  std::vector<Duplicate> duplicates;
  for (const std::vector<Duplicate>& of_part : found)
    duplicates.insert(duplicates.end(), of_part.begin(), of_part.end());
  std::ranges::sort(duplicates, {}, &Duplicate::again);
  return duplicates;
}

namespace {

/// Points of one level, which have similar reaches, in square cells. Points of several cells can share a list, so the
/// distance must be tested.
class CellLists {
 public:
  /// Announces a point that may be inserted.
  void expect(Point p, double reach) {
    ++points_;
    reach_ = std::max(reach_, reach);
    largest_ = std::max(largest_, Box::around(p).largest_magnitude());
  }
  /// The width of cells ensures that a coordinate divided by it has an integer part of fewer than 53 bits. Cells are
  /// wider than the reach, so that most points have their whole neighbourhood in one cell.
  void allocate(std::vector<Index>& next) {
    next_ = next;
    width_ = std::max(8 * reach_, 0x1p-50 * largest_);
    first_.assign(std::bit_ceil(2 * points_ + 1), no_index);
  }

  void insert(Index i, Point p) { next_[i] = std::exchange(first_[list_of(cell(p.x), cell(p.y))], i); }

  /// Calls visit(i) at least for the inserted points in reach of p, which is at most `reach`.
  template <class Visit>
  void for_each_near(Point p, double reach, const Visit& visit) const {
    const double distance = std::min(reach, reach_);
    if (Box::around(p).largest_magnitude() > 2 * (largest_ + distance)) return;
    // Cells are whole numbers, small enough that adding 1 is exact.
    for (double x = cell(p.x - distance); x <= cell(p.x + distance); ++x)    // NOLINT(*-FloatLoopCounter)
      for (double y = cell(p.y - distance); y <= cell(p.y + distance); ++y)  // NOLINT(*-FloatLoopCounter)
        for (Index i = first_[list_of(x, y)]; i != no_index; i = next_[i]) visit(i);
  }

 private:
  [[nodiscard]] double cell(double coordinate) const { return width_ > 0 ? std::floor(coordinate / width_) : 0; }
  [[nodiscard]] std::size_t list_of(double x, double y) const { return hash_of(Point{x, y}) & (first_.size() - 1); }

  std::size_t points_ = 0;
  double reach_ = 0, largest_ = 0, width_ = 0;
  std::vector<Index> first_;
  std::span<Index> next_;
};

/// Scales that differ by less than a factor of 256 are on one level: then cells are small enough for all its points.
int level_of(double scale) {
  constexpr int powers_per_level = 8;
  return static_cast<int>(std::floor(std::ilogb(scale) / static_cast<double>(powers_per_level)));
}

}  // namespace

std::vector<Duplicate> find_close(std::span<const Point> points, const Reach& reach, StopSignal* stop) {
  SparseAsk ask(stop);
  std::map<int, CellLists> levels;
  for (Index i = 0; i < points.size(); ++i)
    levels[level_of(reach.scale_of_point(i))].expect(points[i], reach.farthest(reach.scale_of_point(i)));
  std::vector<Index> next(points.size());
  for (auto& [level, kept] : levels) kept.allocate(next);
  std::vector<Duplicate> duplicates;
  for (Index i = 0; i < points.size(); ++i) {
    ask();
    const Point p = points[i];
    const double scale = reach.scale_of_point(i), farthest = reach.farthest(scale);
    Index first = no_index;
    for (const auto& [level, kept] : levels)
      kept.for_each_near(p, farthest, [&](Index j) {
        if (points[j] == p || distance(points[j], p) < reach.between_points(i, j)) first = std::min(first, j);
      });
    if (first == no_index)
      levels[level_of(scale)].insert(i, p);
    else
      duplicates.push_back({first, i});
  }
  return duplicates;
}

std::vector<Ends> sorted_ends(std::span<const Segment> segments, std::size_t points, StopSignal* stop) {
  SparseAsk ask(stop);
  std::vector<Index> place(points + 1);  // of the next segment with this low end
  for (const Segment& s : segments) ++place[std::min(s.a, s.b) + 1];
  std::partial_sum(place.begin(), place.end(), place.begin());
  std::vector<Ends> all(segments.size());
  for (Index s = 0; s < segments.size(); ++s) {
    ask();
    const auto [low, high] = std::minmax(segments[s].a, segments[s].b);
    all[place[low]++] = {low, high, s};
  }
  for (std::size_t begin = 0, p = 0; p < points; begin = place[p++]) {
    ask();
    std::sort(all.begin() + static_cast<std::ptrdiff_t>(begin), all.begin() + static_cast<std::ptrdiff_t>(place[p]));
  }
  return all;
}

}  // namespace pardel::engine
