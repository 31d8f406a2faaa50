// Who may use which numbers. Vertices and triangles are numbers into arrays; tasks that run at the same
// time get disjoint ranges of numbers before they start, so that they share no counter, and so that which
// number a vertex gets does not depend on which thread was faster.
#pragma once

#include <algorithm>
#include <vector>

#include "../../core/pslg.hpp"

namespace pardel::engine {

struct NumberRange {
  Index begin = 0, end = 0;
  [[nodiscard]] Index size() const { return end - begin; }
};

/// The numbers of one task, used in order.
class Numbers {
 public:
  Numbers() = default;
  explicit Numbers(std::vector<NumberRange> ranges) : ranges_(std::move(ranges)) {
    for (const NumberRange r : ranges_) left_ += r.size();
  }
  [[nodiscard]] std::size_t left() const { return left_; }
  /// Precondition: left() > 0.
  Index take() {
    while (ranges_[current_].begin == ranges_[current_].end) ++current_;
    --left_;
    return ranges_[current_].begin++;
  }
  /// What was not used.
  [[nodiscard]] const std::vector<NumberRange>& rest() const { return ranges_; }

 private:
  std::vector<NumberRange> ranges_;
  std::size_t current_ = 0;
  std::size_t left_ = 0;
};

/// Hands out ranges of numbers from 0 to `limit`, lowest first, and takes back what was not used. Every number
/// below end() is in use or free.
class NumberLedger {
 public:
  NumberLedger(Index used, Index limit) : end_(used), limit_(limit) {}

  [[nodiscard]] Index end() const { return end_; }
  [[nodiscard]] Index in_use() const { return end_ - static_cast<Index>(free_count_); }
  [[nodiscard]] std::size_t available() const { return limit_ - in_use(); }

  /// Appends `count` numbers, or as many as there are, to `ranges`.
  void assign(std::size_t count, std::vector<NumberRange>& ranges);
  /// To be followed by settle(), once all of a phase are back.
  void take_back(const Numbers& numbers);
  void settle();
  /// The free ranges, ascending. Precondition: settled.
  [[nodiscard]] const std::vector<NumberRange>& holes() const { return free_; }

 private:
  std::vector<NumberRange> free_;
  std::size_t first_free_ = 0;  ///< ranges before it are used up
  std::size_t free_count_ = 0;
  Index end_, limit_;
};

/// A move of what has number `from` to the hole `to`.
struct NumberMove {
  Index from, to;
};

/// The moves that fill the holes below the number of things in use with what lies above, in ascending order of
/// both. Afterwards the numbers in use are 0 to ledger.end() minus the holes.
[[nodiscard]] std::vector<NumberMove> moves_into_holes(const NumberLedger& ledger);

}  // namespace pardel::engine
