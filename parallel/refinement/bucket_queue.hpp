// A priority queue of triangles, ordered by the length of their shortest side.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <vector>

#include "queued_triangle.hpp"

namespace pardel::engine {

/// A priority queue with one bucket per key. The least key comes first; within a bucket, the last entry pushed comes
/// first. Push and pop take constant time.
class BucketQueue {
 public:
  BucketQueue() { head_.fill(no_index); }

  /// The key of a squared length: its exponent and the two leading bits of its mantissa. Two squared lengths with the
  /// same key differ by less than a quarter of a power of two.
  [[nodiscard]] static unsigned key(double squared_length) {
    return static_cast<unsigned>(std::bit_cast<std::uint64_t>(squared_length) >> 50U) & last;
  }
  /// The key that comes before every length.
  static constexpr unsigned urgent = 0;
  /// The key that comes after every length.
  static constexpr unsigned last = 8191;

  [[nodiscard]] bool empty() const { return lowest_ == none; }

  void push(QueuedTriangle triangle, unsigned key) {
    Index node = free_;
    if (node == no_index) {
      node = static_cast<Index>(nodes_.size());
      nodes_.push_back({});
    } else {
      free_ = nodes_[node].next;
    }
    nodes_[node] = {triangle, head_[key]};
    if (head_[key] == no_index) {
      words_[key / 64] |= std::uint64_t{1} << (key % 64);
      summary_[key / 4096] |= std::uint64_t{1} << (key / 64 % 64);
    }
    head_[key] = node;
    lowest_ = std::min(lowest_, key);
  }

  /// Precondition: not empty.
  QueuedTriangle pop() {
    const Index node = head_[lowest_];
    // Copy field by field: a load of the whole entry would wait if its fields have just been stored one by one.
    const QueuedTriangle triangle{nodes_[node].triangle.side, nodes_[node].triangle.first_corner};
    const Index next = nodes_[node].next;
    head_[lowest_] = next;
    nodes_[node].next = free_;
    free_ = node;
    if (next == no_index) remove_lowest_bucket();
    return triangle;
  }

 private:
  struct Node {
    QueuedTriangle triangle;
    Index next;
  };
  void remove_lowest_bucket() {
    std::uint64_t &word = words_[lowest_ / 64], &words = summary_[lowest_ / 4096];
    word &= word - 1;
    if (word == 0) words &= words - 1;
    lowest_ = none;
    for (unsigned s = 0; s < summary_.size() && lowest_ == none; ++s)
      if (summary_[s] != 0) {
        const unsigned w = s * 64 + static_cast<unsigned>(std::countr_zero(summary_[s]));
        lowest_ = w * 64 + static_cast<unsigned>(std::countr_zero(words_[w]));
      }
    // The list of free nodes has the order of the pops, which uses the cache badly. Therefore an empty queue starts
    // again with consecutive nodes.
    if (lowest_ == none) {
      nodes_.clear();
      free_ = no_index;
    }
  }

  static constexpr unsigned buckets = last + 1;
  static constexpr unsigned none = buckets;
  std::array<Index, buckets> head_;                      ///< the first node of each bucket, or no_index
  std::array<std::uint64_t, buckets / 64> words_{};      ///< one bit per bucket, 1 if it is not empty
  std::array<std::uint64_t, buckets / 4096> summary_{};  ///< one bit per word, 1 if it is not zero
  std::vector<Node> nodes_;
  Index free_ = no_index;   ///< the first free node, or no_index
  unsigned lowest_ = none;  ///< the key of the next entry, or none
};

}  // namespace pardel::engine
