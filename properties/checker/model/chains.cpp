#include "chains.hpp"

#include <algorithm>
#include <cmath>

#include "../arithmetic/exact.hpp"

namespace pardel::checker {
namespace {

/// The distance of p from line ab in floating point. It ranks allowed edges; it does not allow or forbid one.
double rough_distance(Point p, Point a, Point b) {
  const double dx = b.x - a.x;
  const double dy = b.y - a.y;
  return std::abs(dx * (p.y - a.y) - dy * (p.x - a.x)) / std::hypot(dx, dy);
}

class Walk {
 public:
  Walk(Index segment, const Domain& domain, const Mesh& mesh, const Adjacency& adjacency, const InputVertices& inputs,
       Strictness strictness)
      : segment_(segment),
        tolerance_(domain.tolerance()),
        mesh_(mesh),
        adjacency_(adjacency),
        inputs_(inputs),
        strictness_(strictness),
        first_(inputs.vertex(domain.segments()[segment].a)),
        last_(inputs.vertex(domain.segments()[segment].b)) {}

  std::vector<ChainEdge> run() {
    if (first_ == no_index || last_ == no_index || first_ == last_) return {};
    // Start at the end with fewer triangles. If many segments meet in one point, no walk searches the triangles there.
    const bool backward = adjacency_.corners(last_) < adjacency_.corners(first_);
    if (backward) std::swap(first_, last_);
    a_ = mesh_.points[first_];
    b_ = mesh_.points[last_];
    std::vector<ChainEdge> chain;
    for (Index at = first_; at != last_;) {
      const ChainEdge edge = next_edge(at);
      if (edge.to == no_index) return {};
      chain.push_back(edge);
      at = edge.to;
    }
    if (backward) {
      std::reverse(chain.begin(), chain.end());
      for (ChainEdge& edge : chain) edge = {edge.to, edge.from, edge.segment, edge.right, edge.left};
    }
    return chain;
  }

 private:
  bool has_this_origin(Index vertex) const { return vertex < mesh_.origin.size() && mesh_.origin[vertex] == segment_; }

  /// True if the chain may go from `at` to `to`.
  bool is_allowed(Index at, Index to) const {
    const Point from = mesh_.points[at];
    const Point p = mesh_.points[to];
    if (to == last_) return exactly::progress(from, p, a_, b_) > 0;
    if (inputs_.input(to) != no_index) return false;
    const double distance = rough_distance(p, a_, b_);
    const double length = std::hypot(b_.x - a_.x, b_.y - a_.y);
    if (strictness_ == Strictness::loose) {
      if (!has_this_origin(to) && !(distance <= 1e-6 * length)) return false;
    } else {
      // The rounding error of `distance` is a few units in the last place, and the tolerance is two such units. So a
      // distance above 64 tolerances needs no exact comparison.
      if (distance > 64 * tolerance_ || exactly::line_distance_exceeds(p, a_, b_, tolerance_)) return false;
    }
    return exactly::progress(from, p, a_, b_) > 0 && exactly::progress(p, b_, a_, b_) > 0;
  }

  /// True if the edge to `to` is preferred to the edge to `than`. Rounding makes slivers along a segment, and the long
  /// side of a sliver skips a vertex of the chain. A vertex whose origin is this segment is preferred; if both have
  /// this origin, the nearer vertex is preferred, so that no vertex is skipped.
  bool is_better(Index at, Index to, Index than) const {
    if (than == no_index) return true;
    if (strictness_ == Strictness::exact && (has_this_origin(to) || has_this_origin(than))) {
      if (has_this_origin(to) != has_this_origin(than)) return has_this_origin(to);
      return exactly::compare_lengths(mesh_.points[at], mesh_.points[to], mesh_.points[at], mesh_.points[than]) < 0;
    }
    if (to == last_) return true;
    if (than == last_) return false;
    if (has_this_origin(to) != has_this_origin(than)) return has_this_origin(to);
    return rough_distance(mesh_.points[to], a_, b_) < rough_distance(mesh_.points[than], a_, b_);
  }

  ChainEdge next_edge(Index at) const {
    ChainEdge best{at, no_index, segment_, {}, {}};
    adjacency_.visit_fans(at, [&](Index t, int corner) {
      const Triangle& triangle = adjacency_.triangles()[t];
      const Index right = triangle.v[next(corner)];     // t lies on the left of the edge to `right`,
      const Index left = triangle.v[previous(corner)];  // and on the right of the edge to `left`
      for (const Index to : {right, left}) {
        if (to == best.to || !is_better(at, to, best.to) || !is_allowed(at, to)) continue;
        best = {at, to, segment_, {}, {}};
      }
    });
    if (best.to == no_index) return best;
    adjacency_.visit_fans(at, [&](Index t, int corner) {
      const Triangle& triangle = adjacency_.triangles()[t];
      if (triangle.v[next(corner)] == best.to) best.left = {t, previous(corner)};
      if (triangle.v[previous(corner)] == best.to) best.right = {t, next(corner)};
    });
    return best;
  }

  Index segment_;
  double tolerance_;
  const Mesh& mesh_;
  const Adjacency& adjacency_;
  const InputVertices& inputs_;
  Strictness strictness_;
  Index first_, last_;
  Point a_, b_;
};

}  // namespace

std::vector<ChainEdge> walk_chain(Index segment, const Domain& domain, const Mesh& mesh, const Adjacency& adjacency,
                                  const InputVertices& inputs, Strictness strictness) {
  return Walk(segment, domain, mesh, adjacency, inputs, strictness).run();
}

}  // namespace pardel::checker
