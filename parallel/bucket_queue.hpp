// A priority queue of triangles by the length of their shortest side, shortest first, to within a quarter
// of an octave of squared length. Push and pop take constant time; within a bucket, last in, first out.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <vector>

#include "../core/mutants.hpp"
#include "triangulation.hpp"

namespace pardel {

/// A triangle as it was when it was queued. Slots are reused at once, so the slot may hold another one by the
/// time its turn comes; the first corner then differs, since every insertion makes one triangle per slot with
/// the new vertex first.
struct Queued {
  TriangleId id;
  VertexId first_corner;
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

  [[nodiscard]] bool empty() const { return size_ == 0; }

  void push(Queued triangle, unsigned key) {
    if (mutated("queue_rounds_keys")) key &= ~1U;
    Index node = free_;
    if (node == no_index) {
      node = static_cast<Index>(nodes_.size());
      nodes_.push_back({});
    } else {
      free_ = nodes_[node].next;
    }
    nodes_[node] = {triangle, head_[key]};
    head_[key] = node;
    words_[key / 64] |= std::uint64_t{1} << (key % 64);
    summary_[key / 4096] |= std::uint64_t{1} << (key / 64 % 64);
    ++size_;
  }

  /// Precondition: not empty.
  Queued pop() {
    unsigned s = 0;
    while (summary_[s] == 0) ++s;
    const unsigned word = s * 64 + static_cast<unsigned>(std::countr_zero(summary_[s]));
    const unsigned key = word * 64 + static_cast<unsigned>(std::countr_zero(words_[word]));
    const Index node = head_[key];
    head_[key] = nodes_[node].next;
    if (head_[key] == no_index) {
      words_[word] &= words_[word] - 1;
      if (words_[word] == 0) summary_[s] &= summary_[s] - 1;
    }
    nodes_[node].next = free_;
    free_ = node;
    --size_;
    return nodes_[node].triangle;
  }

 private:
  struct Node {
    Queued triangle;
    Index next;
  };
  static constexpr unsigned buckets = last + 1;
  std::array<Index, buckets> head_;
  std::array<std::uint64_t, buckets / 64> words_{};
  std::array<std::uint64_t, buckets / 4096> summary_{};
  std::vector<Node> nodes_;
  Index free_ = no_index;
  std::size_t size_ = 0;
};

}  // namespace pardel
