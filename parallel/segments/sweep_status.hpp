// The order of the segments along the sweep line: a balanced tree whose positions are kept by their neighbours, so that
// no comparison is needed to insert, erase or exchange segments at a known position.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "../../core/pslg.hpp"

namespace pardel::engine {

/// A sequence of edges, named by indices below `edges`, each at most once. An edge stays in its node until the edge is
/// erased, replaced or exchanged. The tree is a treap (Seidel and Aragon, "Randomized search trees", 1996) with fixed
/// pseudo-random priorities: operations take expected O(log n), and the walk to a neighbour takes constant time.
class SweepStatus {
 public:
  explicit SweepStatus(std::size_t edges) : node_of_(edges, no_index) {}

  [[nodiscard]] Index last() const { return last_; }
  /// Neighbours in the sequence; no_index if there is none.
  [[nodiscard]] Index next(Index node) const { return nodes_[node].next; }
  [[nodiscard]] Index previous(Index node) const { return nodes_[node].previous; }
  [[nodiscard]] Index edge(Index node) const { return nodes_[node].edge; }
  /// The node of an edge; no_index if the sequence does not contain the edge.
  [[nodiscard]] Index node_of(Index edge) const { return node_of_[edge]; }

  /// The first node with an edge that is not below; no_index if there is none. Precondition: all edges for which
  /// is_below(edge) is true come before the others.
  template <class IsBelow>
  [[nodiscard]] Index first_not_below(const IsBelow& is_below) const {
    Index found = no_index;
    for (Index node = root_; node != no_index;) {
      const bool below = is_below(nodes_[node].edge);
      if (!below) found = node;
      node = nodes_[node].child[below ? 1 : 0];
    }
    return found;
  }

  /// Inserts an edge before a node; at the end for no_index.
  void insert_before(Index where, Index edge);
  void erase(Index node);
  /// Replaces the edge of a node.
  void assign(Index node, Index edge) {
    nodes_[node].edge = edge;
    node_of_[edge] = node;
  }
  /// Records that the sequence no longer contains the edge, whose node is then assigned or erased.
  void forget(Index edge) { node_of_[edge] = no_index; }
  /// Exchanges the edges of two nodes.
  void exchange(Index node, Index other) {
    const Index edge = nodes_[node].edge;
    assign(node, nodes_[other].edge);
    assign(other, edge);
  }

 private:
  struct Node {
    Index parent = no_index;
    std::array<Index, 2> child{no_index, no_index};
    Index previous = no_index, next = no_index;
    Index edge = no_index;
    std::uint32_t priority = 0;
  };

  Index new_node(Index edge);
  void link(Index node, Index previous, Index next);
  void attach(Index node, Index parent, std::size_t side);
  void rotate_up(Index node);

  std::vector<Node> nodes_;
  std::vector<Index> free_;
  std::vector<Index> node_of_;
  Index root_ = no_index;
  Index last_ = no_index;
};

}  // namespace pardel::engine
