#include "chains.hpp"

#include <algorithm>
#include <cmath>
#include <queue>
#include <unordered_map>

#include "../arithmetic/exact.hpp"
#include "../tolerances.hpp"

namespace pardel::checker {
namespace {

/// Finds the cheapest path of mesh edges from one end of a segment to the other (Dijkstra's algorithm). Equal costs are
/// decided by the numbers of vertices, so the path depends neither on the order of triangles nor on that of edges.
class ChainSearch {
 public:
  ChainSearch(Index segment, const Domain& domain, const MeshEdges& mesh, const InputVertices& inputs,
              Strictness strictness, StopSignal* stop, std::span<const Index> others)
      : segment_(segment),
        on_boundary_(domain.on_boundary(segment)),
        tolerance_(domain.tolerance(segment)),
        mesh_(mesh),
        inputs_(inputs),
        strictness_(strictness),
        stop_(stop),
        others_(others),
        first_(inputs.vertex(domain.segments()[segment].a)),
        last_(inputs.vertex(domain.segments()[segment].b)) {}

  std::vector<ChainEdge> run() {
    if (first_ == no_index || last_ == no_index || first_ == last_) return {};
    // Start at the end with fewer triangles. If many segments meet in one point, no search visits the triangles there.
    const bool backward = mesh_.adjacency.has_fewer_triangles(last_, first_);
    if (backward) std::swap(first_, last_);
    a_ = mesh_.points[first_];
    b_ = mesh_.points[last_];
    length_ = std::hypot(b_.x - a_.x, b_.y - a_.y);
    if (!search()) return {};
    std::vector<ChainEdge> chain;
    for (Index at = last_; at != first_; at = reached_.at(at).from) chain.push_back(edge(reached_.at(at).from, at));
    if (!backward) std::reverse(chain.begin(), chain.end());
    for (ChainEdge& edge : chain)
      if (backward) edge = {edge.to, edge.from, edge.segment, edge.right, edge.left};
    return chain;
  }

 private:
  struct Reached {
    double cost;  ///< of the cheapest path that is known
    Index from;   ///< the vertex before this one on that path
    bool settled = false;
  };

  /// True if last_ was reached. Afterwards reached_ contains the cheapest path to it.
  bool search() {
    using Entry = std::pair<double, Index>;  // (cost, vertex)
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    reached_[first_] = {0, no_index};
    SparseAsk ask(stop_);
    for (queue.emplace(0, first_); !queue.empty();) {
      ask();
      const auto [cost, at] = queue.top();
      queue.pop();
      if (at == last_) return true;
      if (std::exchange(reached_.at(at).settled, true)) continue;
      visit_edges(at, [&, cost = cost, at = at](Index to, bool one_sided) {
        if (!is_allowed(at, to)) return;
        const double there = cost + cost_of(at, to, one_sided);
        const auto [known, is_new] = reached_.try_emplace(to, Reached{there, at});
        if (!is_new && !(there < known->second.cost)) return;
        known->second = {there, at};
        queue.emplace(there, to);
      });
    }
    return false;
  }

  /// Calls visit(to, one_sided) once for each mesh edge at the vertex `at`.
  template <class Visit>
  void visit_edges(Index at, const Visit& visit) const {
    mesh_.adjacency.visit_fans(at, [&](Index t, int corner) {
      const Triangle& triangle = mesh_.adjacency.triangles()[t];
      visit(triangle.v[next(corner)], triangle.n[previous(corner)] == no_index);
      if (triangle.n[next(corner)] == no_index) visit(triangle.v[previous(corner)], true);
    });
  }

  /// A marked edge costs nothing, and every other edge its squared length. So the search follows the marked edges.
  /// Where there are none it takes short steps: rounding makes slivers along a segment, and the long side of a sliver
  /// skips a vertex of the chain. An edge of the boundary costs as much as the whole segment if the segment is not
  /// there.
  double cost_of(Index at, Index to, bool one_sided) const {
    const double misplaced = one_sided == on_boundary_ ? 0 : 1;
    if (mesh_.marked.contains(at, to)) return misplaced;
    const Point p = mesh_.points[at], q = mesh_.points[to];
    const double share = std::hypot(q.x - p.x, q.y - p.y) / length_;
    return misplaced + std::min(1.0, share * share);
  }

  /// True if the chain may go from `at` to `to`.
  bool is_allowed(Index at, Index to) const {
    if (to != last_ && (inputs_.input(to) != no_index || is_taken(to))) return false;
    const bool far = !is_near(mesh_.points[to]) || !is_near(mesh_.points[at]);
    if (far && (strictness_ == Strictness::exact || !mesh_.marked.contains(at, to))) return false;
    const Point p = mesh_.points[to];
    return exactly::progress(mesh_.points[at], p, a_, b_) > 0 && (to == last_ || exactly::progress(p, b_, a_, b_) > 0);
  }

  /// True if the chain of another segment passes this vertex.
  bool is_taken(Index vertex) const {
    return !others_.empty() && others_[vertex] != no_index && others_[vertex] != segment_;
  }

  bool is_near(Point p) const {
    if (p == a_ || p == b_) return true;
    const double dx = b_.x - a_.x, dy = b_.y - a_.y, left = dx * (p.y - a_.y), right = dy * (p.x - a_.x);
    const double cross = std::abs(left - right);
    if (strictness_ == Strictness::loose) return cross / length_ <= meant_chain_share * length_;
    // The rounding error of `cross` is less than the second term. (Without an underflow: products of usable coordinates
    // do not come near 1e-290.)
    const double allowed = tolerance_.x * std::abs(dy) + tolerance_.y * std::abs(dx);
    const bool is_certainly_off = cross > 2 * allowed + 0x1p-50 * (std::abs(left) + std::abs(right)) && cross > 1e-290;
    return !is_certainly_off && !exactly::line_offset_exceeds(p, a_, b_, tolerance_);
  }

  ChainEdge edge(Index from, Index to) const {
    ChainEdge edge{from, to, segment_, {}, {}};
    mesh_.adjacency.visit_fans(from, [&](Index t, int corner) {
      const Triangle& triangle = mesh_.adjacency.triangles()[t];
      if (triangle.v[next(corner)] == to) edge.left = {t, previous(corner)};
      if (triangle.v[previous(corner)] == to) edge.right = {t, next(corner)};
    });
    return edge;
  }

  Index segment_;
  bool on_boundary_;
  Units tolerance_;
  const MeshEdges& mesh_;
  const InputVertices& inputs_;
  Strictness strictness_;
  StopSignal* stop_;
  std::span<const Index> others_;
  Index first_, last_;
  Point a_, b_;
  double length_ = 0;
  std::unordered_map<Index, Reached> reached_;
};

}  // namespace

std::vector<ChainEdge> find_chain(Index segment, const Domain& domain, const MeshEdges& mesh,
                                  const InputVertices& inputs, Strictness strictness, StopSignal* stop,
                                  std::span<const Index> others) {
  return ChainSearch(segment, domain, mesh, inputs, strictness, stop, others).run();
}

}  // namespace pardel::checker
