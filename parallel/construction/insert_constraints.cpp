#include "insert_constraints.hpp"

#include <algorithm>
#include <deque>
#include <string>

#include "../../core/support/shortest.hpp"
#include "../arithmetic/predicates.hpp"
#include "../triangulation/flips.hpp"
#include "crossed_edges.hpp"

namespace pardel::engine {
namespace {

class ConstraintInserter {
 public:
  ConstraintInserter(Triangulation& t, const Threads& threads)
      : t_(t), threads_(threads), ask_(threads.stop), triangle_of_(t.points.size(), no_index) {
    for (TriangleId id = 0; id < t.slots.size(); ++id) {
      ask_();
      remember(id);
    }
  }

  Status insert(Constraint c) {
    ask_();
    find_crossed_edges(t_, c, triangle_of_[c.a], ask_, crossed_);
    if (!crossed_.present.none()) {
      t_.constrain(crossed_.present);
      return Done{};
    }
    if (Status possible = check_crossed(c); !possible) return possible;
    crossing_.clear();
    for (const EdgeRef e : crossed_.edges) crossing_.push_back({t_.slot(e).from(e.side()), t_.slot(e).to(e.side())});
    remove_crossings(c);
    t_.constrain(edge(c.a, c.b));
    suspects_.clear();
    for (const auto& [u, v] : fresh_)
      if (const EdgeRef e = edge(u, v); !e.none()) suspects_.push_back(e);
    changed_.clear();
    restore_delaunay(t_, suspects_, changed_, threads_);
    for (const TriangleId id : changed_) remember(id);
    return Done{};
  }

 private:
  using VertexPair = std::pair<VertexId, VertexId>;

  /// Records the triangle in triangle_of_ for each of its corners.
  void remember(TriangleId id) {
    for (const VertexId v : t_.slots[id].v)
      if (v != ghost) triangle_of_[v] = id;
  }

  /// The edge from u to v as a side of the triangle on its left; none() if there is no such edge.
  EdgeRef edge(VertexId u, VertexId v) const {
    EdgeRef found;
    for_each_around(t_, u, triangle_of_[u], [&](TriangleId id, unsigned corner) {
      if (t_.slots[id].from(corner) != v) return false;
      found = EdgeRef(id, previous_corner[corner]);
      return true;
    });
    return found;
  }

  /// Done if the edges that the constraint crosses can be flipped.
  [[nodiscard]] Status check_crossed(Constraint c) const {
    const auto at = [&](VertexId v) { return shortest(t_.points[v]); };
    const auto invalid = [&](const std::string& what) {
      return Error{ErrorKind::invalid_input, "the segment from " + at(c.a) + " to " + at(c.b) + what};
    };
    if (crossed_.passed != no_index) return invalid(" passes through the point " + at(crossed_.passed));
    if (const EdgeRef e = crossed_.constrained; !e.none()) {
      const Slot& slot = t_.slot(e);
      return invalid(" crosses the segment from " + at(slot.from(e.side())) + " to " + at(slot.to(e.side())));
    }
    if (crossed_.edges.empty()) return invalid(" begins where the triangulation has no triangle");
    return Done{};
  }

  /// Flips edges until none crosses the constraint. An edge whose quadrilateral is not strictly convex goes to the end
  /// of the queue.
  void remove_crossings(Constraint c) {
    fresh_.clear();
    const Point a = t_.points[c.a], b = t_.points[c.b];
    while (!crossing_.empty()) {
      ask_();
      const auto [u, v] = crossing_.front();
      crossing_.pop_front();
      const EdgeRef e = edge(u, v);
      const EdgeRef across = t_.slot(e).n[e.side()];
      const VertexId p = t_.slot(e).apex(e.side()), q = t_.slot(across).apex(across.side());
      const Point pp = t_.points[p], qq = t_.points[q], uu = t_.points[u], vv = t_.points[v];
      const double side_u = orient2d(pp, qq, uu), side_v = orient2d(pp, qq, vv);
      if (!(side_u < 0 && side_v > 0)) {
        crossing_.push_back({u, v});
        continue;
      }
      flip(t_, e);
      remember(e.triangle());
      remember(across.triangle());
      const bool ends_here = p == c.a || p == c.b || q == c.a || q == c.b;
      const double side_p = orient2d(a, b, pp), side_q = orient2d(a, b, qq);
      if (!ends_here && ((side_p > 0 && side_q < 0) || (side_p < 0 && side_q > 0)))
        crossing_.push_back({p, q});
      else
        fresh_.push_back({p, q});
    }
  }

  Triangulation& t_;
  Threads threads_;
  SparseAsk ask_;
  std::vector<TriangleId> triangle_of_;  ///< for each vertex, one of its triangles
  CrossedEdges crossed_;
  std::deque<VertexPair> crossing_;  ///< the edges that cross the constraint
  std::vector<VertexPair> fresh_;    ///< edges that flips made and that do not cross the constraint
  std::vector<EdgeRef> suspects_;
  std::vector<TriangleId> changed_;
};

}  // namespace

Status insert_constraints(Triangulation& t, std::span<const Constraint> constraints, const Threads& threads) {
  // Sort by vertices, which are numbered by coordinates. The result then does not depend on the order of the input.
  std::vector<Constraint> ordered;
  ordered.reserve(constraints.size());
  for (const Constraint c : constraints) ordered.push_back({std::min(c.a, c.b), std::max(c.a, c.b)});
  SparseAsk ask(threads.stop);
  std::sort(ordered.begin(), ordered.end(), [&](const Constraint& c, const Constraint& d) {
    ask();
    return std::pair(c.a, c.b) < std::pair(d.a, d.b);
  });
  return insert_in_order(t, ordered, threads);
}

Status insert_in_order(Triangulation& t, std::span<const Constraint> constraints, const Threads& threads) {
  if (constraints.empty()) return Done{};
  ConstraintInserter inserter(t, threads);
  for (const Constraint c : constraints)
    if (Status inserted = inserter.insert(c); !inserted) return inserted;
  return Done{};
}

}  // namespace pardel::engine
