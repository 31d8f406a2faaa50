#include "duplicates.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <unordered_map>

#include "../../core/array.hpp"
#include "../../core/support/hash.hpp"
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

std::vector<Duplicate> find_duplicates(std::span<const Point> points, int threads) {
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

std::vector<Duplicate> find_close(std::span<const Point> points, double distance) {
  // The width ensures that a coordinate divided by it has an integer part of fewer than 53 bits.
  double width = distance;
  for (const Point& p : points) width = std::max(width, 0x1p-50 * std::max(std::abs(p.x), std::abs(p.y)));
  const auto cell_of = [&](Point p) { return Point{std::floor(p.x / width), std::floor(p.y / width)}; };

  struct Hash {
    std::size_t operator()(Point cell) const { return hash_of(cell); }
  };
  std::unordered_map<Point, std::vector<Index>, Hash> kept;
  std::vector<Duplicate> duplicates;
  for (Index i = 0; i < points.size(); ++i) {
    const Point p = points[i], cell = cell_of(p);
    Index first = no_index;
    for (const double dx : {-1.0, 0.0, 1.0}) {
      for (const double dy : {-1.0, 0.0, 1.0}) {
        const auto near = kept.find({cell.x + dx, cell.y + dy});
        if (near == kept.end()) continue;
        for (const Index j : near->second)
          if (points[j] == p || std::hypot(points[j].x - p.x, points[j].y - p.y) < distance) first = std::min(first, j);
      }
    }
    if (first == no_index)
      kept[cell].push_back(i);
    else
      duplicates.push_back({first, i});
  }
  return duplicates;
}

}  // namespace pardel::engine
