#include "chain_graph.hpp"

#include <algorithm>
#include <functional>
#include <map>
#include <utility>

namespace pardel::checker {
namespace {

/// The position of the boundary edge that runs from `from` to `to`, or no_index.
Index boundary_edge(const Adjacency& adjacency, Index from, Index to) {
  const auto boundary = adjacency.boundary();
  const auto at = std::lower_bound(
      boundary.begin(), boundary.end(), std::pair(from, to),
      [](const BoundaryEdge& e, const std::pair<Index, Index>& ends) { return std::pair(e.from, e.to) < ends; });
  const bool found = at != boundary.end() && at->from == from && at->to == to;
  return found ? static_cast<Index>(at - boundary.begin()) : no_index;
}

}  // namespace

ChainGraph::ChainGraph(std::span<const Point> points, const Adjacency& adjacency, const Chains& chains,
                       StopSignal* stop)
    : edges_(edges_of(points, adjacency, chains, stop)), faces_(points_, edges_, stop) {}

std::vector<Segment> ChainGraph::edges_of(std::span<const Point> points, const Adjacency& adjacency,
                                          const Chains& chains, StopSignal* stop) {
  std::vector<Segment> edges;
  SparseAsk ask(stop);
  for (const BoundaryEdge& edge : adjacency.boundary()) edges.push_back({edge.from, edge.to, 0});
  boundary_ = edges.size();
  std::map<std::pair<Index, Index>, Index> inner;  // chains that share an edge share it here, too
  place_.reserve(chains.edges.size());
  for (const ChainEdge& edge : chains.edges) {
    ask();
    if (edge.left.exists() && edge.right.exists()) {
      const auto [at, is_new] = inner.try_emplace(std::minmax(edge.from, edge.to), static_cast<Index>(edges.size()));
      if (is_new) edges.push_back({edge.from, edge.to, 0});
      place_.push_back({at->second, edges[at->second].a != edge.from});
    } else if (edge.left.exists()) {
      place_.push_back({boundary_edge(adjacency, edge.from, edge.to), false});
    } else {
      place_.push_back({boundary_edge(adjacency, edge.to, edge.from), true});
    }
  }
  vertices_.reserve(2 * edges.size());
  for (const Segment& edge : edges) vertices_.insert(vertices_.end(), {edge.a, edge.b});
  stoppable_sort(vertices_.begin(), vertices_.end(), std::less<>(), stop);
  vertices_.erase(std::unique(vertices_.begin(), vertices_.end()), vertices_.end());
  points_.reserve(vertices_.size());
  for (const Index v : vertices_) points_.push_back(points[v]);
  const auto position = [&](Index v) {
    return static_cast<Index>(std::lower_bound(vertices_.begin(), vertices_.end(), v) - vertices_.begin());
  };
  for (Segment& edge : edges) {
    ask();
    edge = {position(edge.a), position(edge.b), 0};
  }
  return edges;
}

Index ChainGraph::face(std::size_t position, Side side) const {
  const auto [edge, reversed] = place_[position];
  if (edge == no_index) return no_index;
  const bool is_left = (side == Side::left) != reversed;
  return faces_.face(edge, is_left ? Side::left : Side::right);
}

}  // namespace pardel::checker
