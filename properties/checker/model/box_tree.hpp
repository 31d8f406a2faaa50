// BoxTree: a static tree of bounding boxes. It finds the items near a given place.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

#include "../../../core/pslg.hpp"
#include "stoppable.hpp"

namespace pardel::checker {

struct BoundingBox {
  double min_x = std::numeric_limits<double>::infinity();
  double min_y = std::numeric_limits<double>::infinity();
  double max_x = -std::numeric_limits<double>::infinity();
  double max_y = -std::numeric_limits<double>::infinity();

  void include(Point p) {
    min_x = std::min(min_x, p.x);
    min_y = std::min(min_y, p.y);
    max_x = std::max(max_x, p.x);
    max_y = std::max(max_y, p.y);
  }
  void include(const BoundingBox& other) {
    include(Point{other.min_x, other.min_y});
    include(Point{other.max_x, other.max_y});
  }
  [[nodiscard]] bool meets(const BoundingBox& other) const {
    return min_x <= other.max_x && other.min_x <= max_x && min_y <= other.max_y && other.min_y <= max_y;
  }
};

class BoxTree {
 public:
  /// boxes[i] is the bounding box of item i. O(n log n).
  explicit BoxTree(std::vector<BoundingBox> boxes, StopSignal* stop = nullptr);

  /// Calls visit_item(item) for every item whose box passes filter(BoundingBox). Precondition: if a box passes, every
  /// box that contains it passes as well.
  template <class Filter, class Visit>
  void visit(const Filter& filter, const Visit& visit_item) const {
    if (!nodes_.empty()) descend(0, filter, visit_item);
  }

  [[nodiscard]] const BoundingBox& box(Index item) const { return boxes_[item]; }

 private:
  static constexpr std::uint32_t leaf_size = 4;

  struct Node {
    BoundingBox box;
    std::uint32_t first, last;  ///< a range of order_
    std::uint32_t left, right;  ///< children; left == 0 in a leaf
  };

  std::uint32_t build(std::uint32_t first, std::uint32_t last, SparseAsk& ask);

  template <class Filter, class Visit>
  void descend(std::uint32_t at, const Filter& filter, const Visit& visit_item) const {
    const Node& node = nodes_[at];
    if (!filter(node.box)) return;
    if (node.left == 0) {
      for (std::uint32_t i = node.first; i < node.last; ++i)
        if (filter(boxes_[order_[i]])) visit_item(order_[i]);
      return;
    }
    descend(node.left, filter, visit_item);
    descend(node.right, filter, visit_item);
  }

  std::vector<BoundingBox> boxes_;
  std::vector<Index> order_;
  std::vector<Node> nodes_;
};

}  // namespace pardel::checker
