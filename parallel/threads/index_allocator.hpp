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
    if (!ranges_.empty()) next_ = ranges_.front().begin;
  }
  /// The number of unused indices.
  [[nodiscard]] std::size_t left() const { return left_; }
  /// The next unused index. Precondition: left() > 0.
  Index take() {
    while (next_ == ranges_[current_].end) next_ = ranges_[++current_].begin;
    --left_;
    return next_++;
  }
  /// Calls visit(range) for the indices that were taken, in the order in which they were taken.
  template <class Visit>
  void for_each_taken(const Visit& visit) const {
    for (std::size_t i = 0; i < current_; ++i) visit(ranges_[i]);
    if (current_ < ranges_.size()) visit(IndexRange{ranges_[current_].begin, next_});
  }
  /// The same for the unused indices; some ranges may be empty.
  template <class Visit>
  void for_each_left(const Visit& visit) const {
    if (current_ < ranges_.size()) visit(IndexRange{next_, ranges_[current_].end});
    for (std::size_t i = current_ + 1; i < ranges_.size(); ++i) visit(ranges_[i]);
  }

 private:
  std::vector<IndexRange> ranges_;
  std::size_t current_ = 0, left_ = 0;
  Index next_ = 0;  ///< in the current range
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
  /// True if the index is in use. Logarithmic time. Precondition: settled.
  [[nodiscard]] bool uses(Index index) const {
    const auto hole = std::partition_point(free_.begin(), free_.end(), [&](IndexRange h) { return h.end <= index; });
    return index < end_ && (hole == free_.end() || index < hole->begin);
  }
  /// Calls visit(range) for the ranges in use among the indices from `first` to `last` - 1, in ascending order.
  /// Precondition: settled.
  template <class Visit>
  void for_each_used(Index first, Index last, const Visit& visit) const {
    Index begin = first;
    auto hole = std::partition_point(free_.begin(), free_.end(), [&](IndexRange h) { return h.end <= first; });
    for (; hole != free_.end() && hole->begin < last; ++hole) {
      if (begin < hole->begin) visit(IndexRange{begin, hole->begin});
      begin = hole->end;
    }
    if (begin < std::min(last, end_)) visit(IndexRange{begin, std::min(last, end_)});
  }

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

/// The moves after which the elements in use have the indices [0, in_use()): every free index in this range (hole) gets
/// an element from above the range. The order of the elements that move does not change.
class IndexMoves {
 public:
  /// Precondition: the allocator is settled.
  explicit IndexMoves(const IndexAllocator& allocator);

  [[nodiscard]] bool empty() const { return to_.empty(); }
  [[nodiscard]] Index in_use() const { return in_use_; }
  [[nodiscard]] bool has_moved(Index before) const { return before >= in_use_; }
  /// No element at or above this index was in use.
  [[nodiscard]] Index end() const { return in_use_ + static_cast<Index>(to_.size()); }
  /// The new index of an element in use; no_index for an index from in_use() to end() - 1 that was free.
  [[nodiscard]] Index now(Index before) const { return has_moved(before) ? to_[before - in_use_] : before; }

 private:
  Index in_use_;
  std::vector<Index> to_;  ///< per index from in_use_ on: its new index; no_index if it is free
};

}  // namespace pardel::engine
