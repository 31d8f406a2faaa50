// A priority queue of triangles by the length of their shortest side, shortest first, to within a quarter
// of an octave of squared length. Push and pop take constant time; within a bucket, last in, first out.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <vector>

#include "../triangulation/triangulation.hpp"

namespace pardel::engine {

/// A triangle as it was when it was queued. Slots are reused at once, so the slot may hold another one by the
/// time its turn comes; the first corner then differs, since every insertion makes one triangle per slot with
/// the new vertex first.
struct Queued {
  /// Which of its sides the triangle was queued for: the one to split, or its shortest. A task goes by it for what is
  /// in its own queue; elsewhere triangles are assessed anew.
  EdgeRef side;
  VertexId first_corner;

  [[nodiscard]] TriangleId id() const { return side.triangle(); }
};

class BucketQueue {
 public:
  BucketQueue() { head_.fill(no_index); }

  /// The key of a squared length: its exponent and the two leading bits of its mantissa.
  [[nodiscard]] static unsigned key(double squared_length) {
    return static_cast<unsigned>(std::bit_cast<std::uint64_t>(squared_length) >> 50U) & last;
  }
  /// Comes before every length.
  static constexpr unsigned urgent = 0;
  /// Comes after every length.
  static constexpr unsigned last = 8191;

  [[nodiscard]] bool empty() const { return lowest_ == none; }

  void push(Queued triangle, unsigned key) {
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
  Queued pop() {
    const Index node = head_[lowest_];
    // Field by field: a processor waits where it loads as a whole what it has just stored in pieces.
    const Queued triangle{nodes_[node].triangle.side, nodes_[node].triangle.first_corner};
    const Index next = nodes_[node].next;
    head_[lowest_] = next;
    nodes_[node].next = free_;
    free_ = node;
    if (next == no_index) remove_lowest_bucket();
    return triangle;
  }

 private:
  struct Node {
    Queued triangle;
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
    // What is free by now is strewn over memory in the order of pops; what comes next had better lie in a row.
    if (lowest_ == none) {
      nodes_.clear();
      free_ = no_index;
    }
  }

  static constexpr unsigned buckets = last + 1;
  static constexpr unsigned none = buckets;
  std::array<Index, buckets> head_;
  std::array<std::uint64_t, buckets / 64> words_{};
  std::array<std::uint64_t, buckets / 4096> summary_{};
  std::vector<Node> nodes_;
  Index free_ = no_index;
  unsigned lowest_ = none;  ///< key of what comes next
};

}  // namespace pardel::engine
