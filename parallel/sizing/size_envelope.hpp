// The least of many lengths that grow with the distance from their sources.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "../../core/size_source.hpp"
#include "../arithmetic/box.hpp"
#include "../threads/threads.hpp"
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
  [[nodiscard]] double at(Point p) const {
    const double dx = p.x - a_.x, dy = p.y - a_.y;
    const double along = dx * ux_ + dy * uy_;
    // From the ends of the source, no difference of large numbers is formed: a point has u = 0, so `beside` is not
    // used.
    const double beside = std::abs(dy * ux_ - dx * uy_);
    const double best = std::clamp(along - offset_ * beside, 0.0, extent_);
    const double x = dx - best * ux_, y = dy - best * uy_;
    return length_ + change_ * best + slope_ * std::sqrt(x * x + y * y);
  }

 private:
  Point a_;
  double ux_ = 0, uy_ = 0;  ///< the unit vector from a to b
  double extent_ = 0;       ///< the distance of a and b; 0 for a point
  double length_ = 0;       ///< the wanted length at a
  double change_ = 0;       ///< of the wanted length per unit along the source
  double offset_ = 0;       ///< the best y lies so much beside the foot of p, per unit of p's distance from the line
  double slope_;
};

/// The lower envelope of many sources. A binary tree over the sources, ordered along a curve, knows of each of its
/// parts a box that contains it and the least length in it; so the search for the least length at a point skips most
/// parts. The value at a point depends on the point and the set of sources only. Immutable, so several threads may use
/// it. Memory: about 130 bytes per source.
class SizeEnvelope {
 public:
  /// The box contains all points at which at() will be called. O(n) on typical input.
  SizeEnvelope(std::span<const GrowingSize> sources, const Box& box, const Threads& threads = {});

  /// The least length of all sources at p; infinity if there is no source. The search begins at the hint, which becomes
  /// the source of the result. O(log n) on typical input.
  [[nodiscard]] double at(Point p, Index& hint) const;
  [[nodiscard]] double at(Point p) const {
    Index none = 0;
    return at(p, none);
  }

  [[nodiscard]] bool empty() const { return sources_.empty(); }
  /// How fast the value changes inside the box.
  [[nodiscard]] const Steepness& steepness() const { return steepness_; }

 private:
  /// Lengths are compared with this factor, so that rounding leaves no source out.
  static constexpr double margin = 1 + 0x1p-40;

  /// A part of the sources.
  struct Node {
    Box box = empty_box;
    double least = INFINITY, slope = INFINITY;  ///< of its sources

    void cover(const Node& other);
    [[nodiscard]] double squared_distance(Point p) const {
      const double x = std::max({box.min_x - p.x, 0.0, p.x - box.max_x});
      const double y = std::max({box.min_y - p.y, 0.0, p.y - box.max_y});
      return x * x + y * y;
    }
    /// False only if no length of the part, at this distance, is less than this.
    [[nodiscard]] bool may_be_less(double squared_distance, double length) const {
      const double to_spare = length * margin - least;
      return to_spare > 0 && slope * slope * squared_distance < to_spare * to_spare * margin;
    }
    [[nodiscard]] bool may_be_less(Point p, double length) const { return may_be_less(squared_distance(p), length); }
  };
  static constexpr std::size_t sources_per_leaf = 2;

  void search_leaf(std::size_t leaf, Point p, double& best, Index& found) const;
  void search(std::size_t node, Point p, double& best, Index& found) const;

  std::vector<PreparedSize> sources_;  ///< in the order of the leaves
  std::vector<Node> nodes_;            ///< the root at 1, the children of node i at 2 i and 2 i + 1
  std::size_t leaves_ = 1;
  Steepness steepness_{0, 0};
};

}  // namespace pardel::engine
