#include "duplicates.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <utility>

#include "../../core/array.hpp"
#include "../../core/support/hash.hpp"
#include "../arithmetic/distance.hpp"
#include "../concurrency/parallel_arrays.hpp"

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

/// Points in square cells. Points of several cells can share a list, so the distance must be tested.
class CellLists {
 public:
  /// Coordinates divided by the width must be smaller than 2^51.
  CellLists(std::size_t points, double width)
      : width_(width), first_(std::bit_ceil(2 * points + 1), no_index), next_(points) {}

  void insert(Index i, Point p) { next_[i] = std::exchange(first_[list_of(cell(p.x), cell(p.y))], i); }

  /// Calls visit(i) at least for the inserted points closer to p than `distance`, which must be at most the width.
  template <class Visit>
  void for_each_near(Point p, double distance, const Visit& visit) const {
    // Cells are whole numbers, small enough that adding 1 is exact.
    for (double x = cell(p.x - distance); x <= cell(p.x + distance); ++x)    // NOLINT(*-FloatLoopCounter)
      for (double y = cell(p.y - distance); y <= cell(p.y + distance); ++y)  // NOLINT(*-FloatLoopCounter)
        for (Index i = first_[list_of(x, y)]; i != no_index; i = next_[i]) visit(i);
  }

 private:
  [[nodiscard]] double cell(double coordinate) const { return std::floor(coordinate / width_); }
  [[nodiscard]] std::size_t list_of(double x, double y) const { return hash_of(Point{x, y}) & (first_.size() - 1); }

  double width_;
  std::vector<Index> first_, next_;
};

}  // namespace

std::vector<Duplicate> find_close(std::span<const Point> points, double distance, StopSignal* stop) {
  SparseAsk ask(stop);
  // The width ensures that a coordinate divided by it has an integer part of fewer than 53 bits. Cells are wider than
  // the distance, so that most points have their whole neighbourhood in one cell.
  double width = 8 * distance;
  for (const Point& p : points) width = std::max(width, 0x1p-50 * std::max(std::abs(p.x), std::abs(p.y)));
  CellLists kept(points.size(), width);
  std::vector<Duplicate> duplicates;
  for (Index i = 0; i < points.size(); ++i) {
    ask();
    const Point p = points[i];
    Index first = no_index;
    kept.for_each_near(p, distance, [&](Index j) {
      if (points[j] == p || engine::distance(points[j], p) < distance) first = std::min(first, j);
    });
    if (first == no_index)
      kept.insert(i, p);
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
