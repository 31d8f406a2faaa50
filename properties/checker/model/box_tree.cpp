#include "box_tree.hpp"

#include <numeric>

namespace pardel::checker {

BoxTree::BoxTree(std::vector<BoundingBox> boxes, StopSignal* stop) : boxes_(std::move(boxes)), order_(boxes_.size()) {
  std::iota(order_.begin(), order_.end(), Index{0});
  SparseAsk ask(stop);
  if (!boxes_.empty()) build(0, static_cast<std::uint32_t>(boxes_.size()), ask);
}

std::uint32_t BoxTree::build(std::uint32_t first, std::uint32_t last, SparseAsk& ask) {
  const auto at = static_cast<std::uint32_t>(nodes_.size());
  BoundingBox box;
  for (std::uint32_t i = first; i < last; ++i) {
    ask();
    box.include(boxes_[order_[i]]);
  }
  nodes_.push_back({box, first, last, 0, 0});
  if (last - first <= leaf_size) return at;

  // Split at the median of the centres along the longer side.
  const bool wide = box.max_x - box.min_x >= box.max_y - box.min_y;
  const auto centre = [&](Index item) {
    const BoundingBox& b = boxes_[item];
    return wide ? b.min_x / 2 + b.max_x / 2 : b.min_y / 2 + b.max_y / 2;
  };
  const std::uint32_t middle = first + (last - first) / 2;
  std::nth_element(order_.begin() + first, order_.begin() + middle, order_.begin() + last,
                   [&](Index a, Index b) { return centre(a) < centre(b); });
  const std::uint32_t left = build(first, middle, ask);
  const std::uint32_t right = build(middle, last, ask);
  nodes_[at].left = left;
  nodes_[at].right = right;
  return at;
}

}  // namespace pardel::checker
