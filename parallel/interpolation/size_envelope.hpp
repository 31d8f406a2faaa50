// The least of many lengths that grow with the distance from their sources.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "../../core/size_source.hpp"
#include "../arithmetic/box.hpp"
#include "../concurrency/threads.hpp"
#include "background.hpp"

namespace pardel::engine {

/// A source whose length grows by `slope` per unit of distance. Precondition: slope is finite and > 0.
struct GrowingSize {
  SizeSource source;
  double slope = 1;
};

/// A source, prepared for evaluation at many points.
class PreparedSize {
 public:
  explicit PreparedSize(const GrowingSize& growing);

  /// The least length at p: min over all points y of the source of (the length at y + slope * |p - y|).
  [[nodiscard]] double at(Point p) const;
  [[nodiscard]] double slope() const { return slope_; }

 private:
  Point a_;
  double ux_ = 0, uy_ = 0;  ///< the unit vector from a to b
  double extent_ = 0;       ///< the distance of a and b; 0 for a point
  double length_ = 0;       ///< the wanted length at a
  double change_ = 0;       ///< of the wanted length per unit along the source
  double offset_ = 0;       ///< the best y lies so much beside the foot of p, per unit of p's distance from the line
  double slope_;
};

/// The lower envelope of many sources, with a quadtree whose leaves list the sources that can be the least in them. The
/// value at a point depends on the point and the set of sources only. Immutable, so several threads may use it.
class SizeEnvelope {
 public:
  /// The quadtree covers the box. Time: O(n log n) on typical input.
  SizeEnvelope(std::span<const GrowingSize> sources, const Box& box, const Threads& threads = {});

  /// The least length of all sources at p; infinity if there is no source. Slow outside the box.
  [[nodiscard]] double at(Point p) const;

  [[nodiscard]] bool empty() const { return sources_.empty(); }
  /// How fast the value changes inside the box.
  [[nodiscard]] const Steepness& steepness() const { return steepness_; }

 private:
  struct Node {
    std::uint32_t first;  ///< the first of four children, or the first candidate
    std::uint32_t count;  ///< of candidates; inner: this node has children
  };
  static constexpr std::uint32_t inner = UINT32_MAX;
  /// A source that can be the least in a leaf.
  struct Candidate {
    double least;  ///< no value in the leaf is less
    std::uint32_t source;
  };

  void build(std::uint32_t node, Point centre, double half, std::span<const Candidate> from, int depth, SparseAsk& ask);

  std::vector<PreparedSize> sources_;
  Steepness steepness_{0, 0};
  Point low_;
  double side_ = 0;
  std::vector<Node> nodes_;
  std::vector<Candidate> candidates_;
};

}  // namespace pardel::engine
