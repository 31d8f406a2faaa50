// Allocation of indices to concurrent tasks. Vertices and triangles are elements of arrays. Before a phase starts, each
// task of the phase gets its own ranges of indices for the elements that it may create. The tasks therefore share no
// counter, and the index of a vertex does not depend on the speed of the threads.
#pragma once

#include <algorithm>
#include <vector>

#include "../../core/pslg.hpp"

namespace pardel::engine {

/// The indices in [begin, end).
struct IndexRange {
  Index begin = 0, end = 0;
  [[nodiscard]] Index size() const { return end - begin; }
};

/// The indices that one task may use, in the order in which it uses them.
class IndexPool {
 public:
  IndexPool() = default;
  explicit IndexPool(std::vector<IndexRange> ranges) : ranges_(std::move(ranges)) {
    for (const IndexRange r : ranges_) left_ += r.size();
  }
  /// The number of unused indices.
  [[nodiscard]] std::size_t left() const { return left_; }
  /// The next unused index. Precondition: left() > 0.
  Index take() {
    while (ranges_[current_].begin == ranges_[current_].end) ++current_;
    --left_;
    return ranges_[current_].begin++;
  }
  /// The unused indices; some ranges may be empty.
  [[nodiscard]] const std::vector<IndexRange>& rest() const { return ranges_; }

 private:
  std::vector<IndexRange> ranges_;
  std::size_t current_ = 0;
  std::size_t left_ = 0;
};

/// Allocates the indices in [0, limit), lowest first, and takes unused ones back. Every index below end() is either in
/// use or free.
class IndexAllocator {
 public:
  /// The indices below `used` are in use.
  IndexAllocator(Index used, Index limit) : end_(used), limit_(limit) {}

  [[nodiscard]] Index end() const { return end_; }
  /// The number of indices in use.
  [[nodiscard]] Index in_use() const { return end_ - static_cast<Index>(free_count_); }
  [[nodiscard]] std::size_t available() const { return limit_ - in_use(); }

  /// Appends ranges with `count` indices to `ranges`. If fewer indices are available, appends all of them.
  void allocate(std::size_t count, std::vector<IndexRange>& ranges);
  /// Frees the unused indices of a pool. Call settle() after the last pool of a phase.
  void release(const IndexPool& pool);
  /// Sorts and joins the free ranges. Free indices at the end are no longer below end().
  void settle();
  /// The free ranges below end(), in ascending order. Precondition: settled.
  [[nodiscard]] const std::vector<IndexRange>& holes() const { return free_; }

 private:
  std::vector<IndexRange> free_;
  std::size_t first_free_ = 0;  ///< the ranges before this one are used up
  std::size_t free_count_ = 0;
  Index end_, limit_;
};

/// Moves the element with index `from` to the free index `to`.
struct IndexMove {
  Index from, to;
};

/// The moves after which the elements in use have the indices [0, in_use()): every free index in this range (hole) gets
/// an element from above the range. Both `from` and `to` ascend. Precondition: the allocator is settled.
[[nodiscard]] std::vector<IndexMove> moves_into_holes(const IndexAllocator& allocator);

}  // namespace pardel::engine
