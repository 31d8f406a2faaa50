// WantedSize: the edge lengths that Goal::grading and Goal::feature_edges allow, computed from the domain alone.
#pragma once

#include <algorithm>
#include <limits>
#include <vector>

#include "../../../core/goal.hpp"
#include "../../../core/pslg.hpp"
#include "stoppable.hpp"

namespace pardel::checker {

/// Lengths that grow away from straight pieces. Finds the least of them at a point.
class GrowingLengths {
 public:
  struct Piece {
    Point a, b;
    double at_a, at_b;  ///< the length at the ends, linear in between
    double slope;       ///< the growth per unit of distance, > 0
  };

  explicit GrowingLengths(std::vector<Piece> pieces);

  /// The least length at p of all pieces for which skip(piece number) is false; infinity if there is none.
  template <class Skip>
  [[nodiscard]] double least(Point p, const Skip& skip) const {
    double best = infinity;
    if (!nodes_.empty()) descend(0, p, skip, best);
    return best;
  }
  [[nodiscard]] double least(Point p) const {
    return least(p, [](Index) { return false; });
  }

 private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  struct Node {
    double min_x, min_y, max_x, max_y;
    double length, slope;             ///< the least of all pieces
    std::size_t first, last;          ///< a range of order_
    std::size_t left = 0, right = 0;  ///< children; 0 in a leaf
  };

  std::size_t build(std::size_t first, std::size_t last);
  [[nodiscard]] static double length_at(const Piece& piece, Point p);
  [[nodiscard]] static double bound(const Node& node, Point p);

  template <class Skip>
  void descend(std::size_t at, Point p, const Skip& skip, double& best) const {
    const Node& node = nodes_[at];
    if (node.left == 0) {
      for (std::size_t i = node.first; i < node.last; ++i)
        if (!skip(order_[i])) best = std::min(best, length_at(pieces_[order_[i]], p));
      return;
    }
    const double left = bound(nodes_[node.left], p), right = bound(nodes_[node.right], p);
    const bool right_first = right < left;
    if (std::min(left, right) < best) descend(right_first ? node.right : node.left, p, skip, best);
    if (std::max(left, right) < best) descend(right_first ? node.left : node.right, p, skip, best);
  }

  std::vector<Piece> pieces_;
  std::vector<Index> order_;
  std::vector<Node> nodes_;
};

/// The definition in docs/sizes.md. The distances of features are computed at many points of each segment. In between
/// they are unknown, so lengths can be greater than those of the definition, but hardly ever by more than an eighth.
class WantedSize {
 public:
  WantedSize(const Pslg& pslg, const Goal& goal, StopSignal* stop = nullptr);

  /// True if the goal has none of the two bounds.
  [[nodiscard]] bool empty() const { return !graded_; }
  /// The longest edge allowed at p; infinity: no bound. Rounded, with an error far below size_tolerance.
  [[nodiscard]] double at(Point p) const { return lengths_.least(p); }

 private:
  bool graded_;
  GrowingLengths lengths_;
};

}  // namespace pardel::checker
