// Numbers in the whole mesh.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "../../parallel/threads/index_allocator.hpp"

namespace pardel::engine {

/// Vertices that were inserted one after the other have consecutive indices, and consecutive numbers in the whole mesh.
/// So the numbers are kept as ranges, which take little memory.
class VertexNumbers {
 public:
  /// The vertices of a range have the numbers from `first` on.
  void add(IndexRange vertices, std::uint64_t first) {
    if (vertices.size() > 0) ranges_.push_back({vertices, first});
  }
  /// To be called after add(), before a number is asked for. No two ranges overlap.
  void settle() {
    std::ranges::sort(ranges_, {}, [](const Range& r) { return r.vertices.begin; });
  }
  [[nodiscard]] bool has(Index vertex) const {
    const auto range = range_of(vertex);
    return range != ranges_.end() && range->vertices.begin <= vertex;
  }
  /// Precondition: has(vertex). Logarithmic time.
  [[nodiscard]] std::uint64_t of(Index vertex) const { return range_of(vertex)->number_of(vertex); }
  /// Calls visit(vertex, number) for all vertices from `first` to `last` - 1 with numbers, in ascending order.
  template <class Visit>
  void for_each(Index first, Index last, const Visit& visit) const {
    for (auto range = range_of(first); range != ranges_.end() && range->vertices.begin < last; ++range)
      for (Index v = std::max(first, range->vertices.begin); v < std::min(last, range->vertices.end); ++v)
        visit(v, range->number_of(v));
  }

 private:
  struct Range {
    IndexRange vertices;
    std::uint64_t first;
    [[nodiscard]] std::uint64_t number_of(Index vertex) const { return first + (vertex - vertices.begin); }
  };
  /// The first range that does not end before the vertex.
  [[nodiscard]] std::vector<Range>::const_iterator range_of(Index vertex) const {
    return std::ranges::partition_point(ranges_, [&](const Range& r) { return r.vertices.end <= vertex; });
  }

  std::vector<Range> ranges_;
};

}  // namespace pardel::engine
