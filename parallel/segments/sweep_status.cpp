#include "sweep_status.hpp"

#include "../../core/support/hash.hpp"

namespace pardel::engine {

Index SweepStatus::new_node(Index edge) {
  Index node = static_cast<Index>(nodes_.size());
  if (free_.empty()) {
    nodes_.emplace_back();
    nodes_[node].priority = static_cast<std::uint32_t>(mixed(node + 1));
  } else {
    node = free_.back();
    free_.pop_back();
    nodes_[node].child = {no_index, no_index};
  }
  assign(node, edge);
  return node;
}

void SweepStatus::link(Index node, Index previous, Index next) {
  nodes_[node].previous = previous;
  nodes_[node].next = next;
  if (previous != no_index) nodes_[previous].next = node;
  (next != no_index ? nodes_[next].previous : last_) = node;
}

void SweepStatus::attach(Index node, Index parent, std::size_t side) {
  if (node != no_index) nodes_[node].parent = parent;
  (parent != no_index ? nodes_[parent].child[side] : root_) = node;
}

/// Exchanges the places of a node and its parent. The sequence stays the same.
void SweepStatus::rotate_up(Index node) {
  const Index parent = nodes_[node].parent, above = nodes_[parent].parent;
  const std::size_t side = nodes_[parent].child[1] == node ? 1 : 0;
  const std::size_t side_above = above != no_index && nodes_[above].child[1] == parent ? 1 : 0;
  attach(nodes_[node].child[1 - side], parent, side);
  attach(parent, node, 1 - side);
  attach(node, above, side_above);
}

void SweepStatus::insert_before(Index where, Index edge) {
  const Index node = new_node(edge);
  const Index previous = where != no_index ? nodes_[where].previous : last_;
  // If `where` has a child before it, the previous node is in that subtree and has no child after it.
  const bool is_first_child = where != no_index && nodes_[where].child[0] == no_index;
  link(node, previous, where);
  attach(node, is_first_child ? where : previous, is_first_child ? 0 : 1);
  while (nodes_[node].parent != no_index && nodes_[nodes_[node].parent].priority < nodes_[node].priority)
    rotate_up(node);
}

void SweepStatus::erase(Index node) {
  for (;;) {
    const auto [before, after] = nodes_[node].child;
    if (before == no_index && after == no_index) break;
    const bool take_before =
        after == no_index || (before != no_index && nodes_[before].priority > nodes_[after].priority);
    rotate_up(take_before ? before : after);
  }
  const Index parent = nodes_[node].parent;
  attach(no_index, parent, parent != no_index && nodes_[parent].child[1] == node ? 1 : 0);
  const Index previous = nodes_[node].previous, next = nodes_[node].next;
  if (previous != no_index) nodes_[previous].next = next;
  (next != no_index ? nodes_[next].previous : last_) = previous;
  free_.push_back(node);
}

}  // namespace pardel::engine
