#include "chains.hpp"

#include <algorithm>

namespace pardel::files {
namespace {

/// Walks along edges that have not been passed.
class Walk {
 public:
  explicit Walk(std::span<const EdgeEnds> edges) : edges_(edges), is_passed_(edges.size(), 0) {
    for (Index e = 0; e < edges.size(); ++e)
      for (const Index end : edges[e]) at_vertex_.push_back({end, e});
    std::ranges::sort(at_vertex_);
  }

  [[nodiscard]] bool is_passed(Index e) const { return is_passed_[e] != 0; }
  /// True if chains end at the vertex.
  [[nodiscard]] bool is_end(Index vertex) const { return edges_at(vertex).size() != 2; }

  /// The chain that begins with edge e at one of its ends.
  [[nodiscard]] Chain from(Index vertex, Index e) {
    Chain chain{vertex};
    for (;;) {
      is_passed_[e] = 1;
      vertex = edges_[e][0] == vertex ? edges_[e][1] : edges_[e][0];
      chain.push_back(vertex);
      if (is_end(vertex)) return chain;
      const auto edges = edges_at(vertex);
      const auto next = std::ranges::find_if(edges, [&](const Incidence& i) { return !is_passed(i.edge); });
      if (next == edges.end()) return chain;
      e = next->edge;
    }
  }

 private:
  struct Incidence {
    Index vertex, edge;
    friend auto operator<=>(const Incidence&, const Incidence&) = default;
  };
  [[nodiscard]] std::span<const Incidence> edges_at(Index vertex) const {
    const auto first = std::lower_bound(at_vertex_.begin(), at_vertex_.end(), Incidence{vertex, 0});
    return {first, std::upper_bound(first, at_vertex_.end(), Incidence{vertex, no_index})};
  }

  std::span<const EdgeEnds> edges_;
  std::vector<Incidence> at_vertex_;
  std::vector<char> is_passed_;
};

}  // namespace

std::vector<Chain> chains_of(std::span<const EdgeEnds> edges) {
  Walk walk(edges);
  std::vector<Chain> chains;
  // First the chains that begin at the first end of an edge, so that they keep its direction; then those whose edges
  // have different directions; then what remains, which is closed.
  for (const std::size_t end : {0, 1})
    for (Index e = 0; e < edges.size(); ++e)
      if (!walk.is_passed(e) && walk.is_end(edges[e][end])) chains.push_back(walk.from(edges[e][end], e));
  for (Index e = 0; e < edges.size(); ++e)
    if (!walk.is_passed(e)) chains.push_back(walk.from(edges[e][0], e));
  return chains;
}

}  // namespace pardel::files
