#include "insert_constraints.hpp"

#include <algorithm>
#include <deque>
#include <string>

#include "../../core/support/shortest.hpp"
#include "../arithmetic/predicates.hpp"
#include "../triangulation/flips.hpp"

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
    Result<EdgeRef> first = first_crossing(c);
    if (!first) return first.error();
    if (first->none()) return Done{};  // the edge exists already
    crossing_.clear();
    if (Status walked = collect_crossings(c, *first); !walked) return walked;
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

  /// Calls visit(triangle, corner) for the triangles around v, counter-clockwise, until it returns true.
  template <class Visit>
  void around(VertexId v, const Visit& visit) const {
    const TriangleId start = triangle_of_[v];
    TriangleId id = start;
    do {
      const unsigned corner = t_.slots[id].corner_of(v);
      if (visit(id, corner)) return;
      id = t_.slots[id].n[next_corner[corner]].triangle();
    } while (id != start);
  }

  /// The edge from u to v as a side of the triangle on its left; none() if there is no such edge.
  EdgeRef edge(VertexId u, VertexId v) const {
    EdgeRef found;
    around(u, [&](TriangleId id, unsigned corner) {
      if (t_.slots[id].from(corner) != v) return false;
      found = EdgeRef(id, previous_corner[corner]);
      return true;
    });
    return found;
  }

  /// The side opposite c.a that the constraint crosses first. If the constraint is an edge already, marks this edge as
  /// constrained and returns none().
  Result<EdgeRef> first_crossing(Constraint c) {
    EdgeRef out;
    VertexId passed = no_index;
    bool present = false;
    const Point a = t_.points[c.a], b = t_.points[c.b];
    around(c.a, [&](TriangleId id, unsigned corner) {
      const Slot& slot = t_.slots[id];
      const VertexId x = slot.from(corner), y = slot.to(corner);
      if (x == c.b) {
        t_.constrain(EdgeRef(id, previous_corner[corner]));
        return present = true;
      }
      if (x == ghost) return false;
      const double right = orient2d(a, t_.points[x], b);
      const bool ahead = (t_.points[x].x - a.x) * (b.x - a.x) + (t_.points[x].y - a.y) * (b.y - a.y) > 0;
      if (right == 0 && ahead) {
        passed = x;
        return true;
      }
      if (y != ghost && right > 0 && orient2d(a, t_.points[y], b) < 0) {
        out = EdgeRef(id, corner);
        return true;
      }
      return false;
    });
    if (passed != no_index) return through_vertex(c, passed);
    if (out.none() && !present)
      return Error{ErrorKind::invalid_input,
                   "the triangulation has no triangle in the direction of the segment from " + shortest(a)};
    return out;
  }

  Error through_vertex(Constraint c, VertexId v) const {
    return {ErrorKind::invalid_input, "the segment from " + shortest(t_.points[c.a]) + " to " +
                                          shortest(t_.points[c.b]) + " passes through the point " +
                                          shortest(t_.points[v])};
  }

  /// Lists the edges that the constraint crosses, in the order along the constraint. e is the first of them.
  Status collect_crossings(Constraint c, EdgeRef e) {
    const Point a = t_.points[c.a], b = t_.points[c.b];
    for (;;) {
      ask_();
      const Slot& slot = t_.slot(e);
      const EdgeRef across = slot.n[e.side()];
      if (across.constrained())
        return Error{ErrorKind::invalid_input,
                     "the segment from " + shortest(a) + " to " + shortest(b) + " crosses the segment from " +
                         shortest(t_.points[slot.from(e.side())]) + " to " + shortest(t_.points[slot.to(e.side())])};
      crossing_.push_back({slot.from(e.side()), slot.to(e.side())});
      const VertexId q = t_.slot(across).apex(across.side());
      if (q == c.b) return Done{};
      const double side = orient2d(a, b, t_.points[q]);
      if (side == 0) return through_vertex(c, q);
      // Seen from the far triangle, `from` lies to the left of the constraint and `to` to its right.
      e = EdgeRef(across.triangle(), side > 0 ? next_corner[across.side()] : previous_corner[across.side()]);
    }
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
  std::deque<VertexPair> crossing_;      ///< the edges that cross the constraint
  std::vector<VertexPair> fresh_;        ///< edges that flips made and that do not cross the constraint
  std::vector<EdgeRef> suspects_;
  std::vector<TriangleId> changed_;
};

}  // namespace

Status insert_constraints(Triangulation& t, std::span<const Constraint> constraints, const Threads& threads) {
  if (constraints.empty()) return Done{};
  // Sort by vertices, which are numbered by coordinates. The result then does not depend on the order of the input.
  std::vector<std::pair<VertexId, VertexId>> ordered;
  ordered.reserve(constraints.size());
  for (const Constraint c : constraints) ordered.push_back(std::minmax(c.a, c.b));
  SparseAsk ask(threads.stop);
  std::sort(ordered.begin(), ordered.end(), [&](const auto& c, const auto& d) {
    ask();
    return c < d;
  });
  ConstraintInserter inserter(t, threads);
  for (const auto& [a, b] : ordered)
    if (Status inserted = inserter.insert({a, b}); !inserted) return inserted;
  return Done{};
}

}  // namespace pardel::engine
