// Checks that the triangles are counter-clockwise and joined edge to edge. These checks do not use the domain.
#include <algorithm>
#include <numeric>

#include "../arithmetic/exact.hpp"
#include "../arithmetic/text.hpp"
#include "stages.hpp"

namespace pardel::checker {
namespace {

void check_orientation(const Subject& subject, const Scan& scan, Findings& found) {
  const std::vector<Index> open = scan.open_for(Test::orientation);
  check_each(open.size(), found, [&](std::size_t i, Findings& mine) {
    const Index t = open[i];
    const Triangle& triangle = subject.mesh.triangles[t];
    const Point a = subject.corner(triangle, 0), b = subject.corner(triangle, 1), c = subject.corner(triangle, 2);
    if (exactly::orientation(a, b, c) > 0) return;
    if (mine.admit(ViolationKind::degenerate_triangle))
      mine.keep({ViolationKind::degenerate_triangle,
                 {t, triangle.v[0], triangle.v[1], triangle.v[2]},
                 {a, b, c},
                 "triangle " + to_text(t) + " is not counter-clockwise: twice its signed area is " +
                     exactly::orientation_text(a, b, c)});
  });
}

/// True if `other` has an edge from `to` to `from` and its neighbour there is t.
bool is_reciprocal(const Triangle& other, Index t, Index from, Index to) {
  for (int j = 0; j < 3; ++j)
    if (other.v[next(j)] == to && other.v[previous(j)] == from) return other.n[j] == t;
  return false;
}

void check_reciprocity(const Mesh& mesh, Findings& found) {
  check_each(mesh.triangles.size(), found, [&](std::size_t t, Findings& mine) {
    const Triangle& triangle = mesh.triangles[t];
    for (int i = 0; i < 3; ++i) {
      const Index from = triangle.v[next(i)];
      const Index to = triangle.v[previous(i)];
      if (triangle.n[i] == no_index || is_reciprocal(mesh.triangles[triangle.n[i]], static_cast<Index>(t), from, to))
        continue;
      if (mine.admit(ViolationKind::wrong_neighbour))
        mine.keep({ViolationKind::wrong_neighbour,
                   {static_cast<Index>(t), triangle.n[i]},
                   {mesh.points[from], mesh.points[to]},
                   "triangle " + to_text(t) + " lists " + to_text(triangle.n[i]) + " as its neighbour across edge " +
                       edge_text(from, to) + ", but that triangle does not list it there"});
    }
  });
}

/// Reports edges that have a triangle on both sides although neither triangle lists a neighbour there.
void check_lost_neighbours(const Mesh& mesh, const Adjacency& adjacency, Findings& found) {
  const auto boundary = adjacency.boundary();
  SparseAsk ask(found.stop());
  for (const BoundaryEdge& edge : boundary) {
    ask();
    if (edge.from > edge.to) continue;
    const auto back = std::lower_bound(boundary.begin(), boundary.end(), edge, [](const auto& x, const auto& y) {
      return std::pair(x.from, x.to) < std::pair(y.to, y.from);
    });
    if (back == boundary.end() || back->from != edge.to || back->to != edge.from) continue;
    found.add(ViolationKind::wrong_neighbour, {edge.left.triangle, back->left.triangle},
              {mesh.points[edge.from], mesh.points[edge.to]},
              "triangles " + to_text(edge.left.triangle) + " and " + to_text(back->left.triangle) + " share edge " +
                  edge_text(edge.from, edge.to) + " but are not neighbours");
  }
}

/// Reports a vertex if an edge at it has two triangles on one side. This is possible only at vertices with several
/// fans.
void check_fans(Index vertex, const Mesh& mesh, const Adjacency& adjacency, Findings& found) {
  std::vector<Index> ahead;
  const int fans = adjacency.visit_fans(
      vertex, [&](Index t, int corner) { ahead.push_back(adjacency.triangles()[t].v[next(corner)]); });
  if (fans <= 1) return;
  std::sort(ahead.begin(), ahead.end());
  const auto twice = std::adjacent_find(ahead.begin(), ahead.end());
  if (twice != ahead.end())
    found.add(ViolationKind::non_manifold_vertex, {vertex, *twice}, {mesh.points[vertex]},
              "vertex " + to_text(vertex) + " has two triangles on the left of its edge to vertex " + to_text(*twice));
}

/// Reports a vertex if a walk around it does not reach all its triangles, or if check_fans() does. Visits all vertices.
void walk_around_vertices(const Mesh& mesh, Adjacency& adjacency, Findings& found) {
  adjacency.count_corners(found.stop());
  check_each(mesh.points.size(), found, [&](std::size_t v, Findings& mine) {
    const auto vertex = static_cast<Index>(v);
    Index reached = 0;
    adjacency.visit_fans(vertex, [&](Index, int) { ++reached; });
    if (reached == adjacency.corners(vertex)) return check_fans(vertex, mesh, adjacency, mine);
    mine.add(ViolationKind::non_manifold_vertex, {vertex}, {mesh.points[v]},
             "vertex " + to_text(v) + " has " + to_text(adjacency.corners(vertex)) +
                 " triangles, but a walk around it from its boundary edges reaches " + to_text(reached));
  });
}

/// The vertices with boundary edges, ascending.
std::vector<Index> boundary_vertices(const Adjacency& adjacency) {
  std::vector<Index> vertices;
  for (const BoundaryEdge& edge : adjacency.boundary())
    if (vertices.empty() || vertices.back() != edge.from) vertices.push_back(edge.from);
  return vertices;
}

std::uint64_t count_used_vertices(const Adjacency& adjacency, std::size_t vertices, StopSignal* stop) {
  std::vector<std::uint64_t> counts(static_cast<std::size_t>(omp_get_max_threads()), 0);
  for_each_run(vertices, stop, [&](std::size_t first, std::size_t last, std::size_t thread) {
    std::uint64_t used = 0;
    for (std::size_t v = first; v < last; ++v) used += adjacency.has_triangle(static_cast<Index>(v)) ? 1 : 0;
    counts[thread] += used;
  });
  return std::accumulate(counts.begin(), counts.end(), std::uint64_t{0});
}

/// True if it is certain that each vertex without boundary edges has one fan, and that all fans of the others end at
/// boundary edges. Then a walk around each vertex reaches all its triangles. Precondition: all triangles are
/// counter-clockwise.
///
/// Around a vertex, a closed fan of counter-clockwise triangles turns by 360 degrees or a multiple of it. So the ray
/// from the vertex to the right begins in one triangle of the fan or in several. The scan has counted these triangles
/// at all vertices. Without those of the open fans, at least one remains for each inner vertex. If no more remain, then
/// each inner vertex has one closed fan, and no boundary vertex has any.
bool has_only_single_fans(const Mesh& mesh, const Adjacency& adjacency, const Scan& scan, StopSignal* stop) {
  std::uint64_t rays = scan.rays;
  const std::vector<Index> outer = boundary_vertices(adjacency);
  SparseAsk ask(stop);
  for (const Index vertex : outer) {
    adjacency.visit_fans(vertex, [&](Index t, int corner) {
      ask();
      const auto& v = adjacency.triangles()[t].v;
      if (has_ray_at(mesh.points[vertex], mesh.points[v[next(corner)]], mesh.points[v[previous(corner)]])) --rays;
    });
  }
  return rays + outer.size() == count_used_vertices(adjacency, mesh.points.size(), stop);
}

/// Reports vertices with triangles that do not form a fan or several open fans. True if has_only_single_fans().
bool check_vertices(const Mesh& mesh, Adjacency& adjacency, const Scan& scan, Findings& found) {
  if (!scan.neighbours_reciprocal || found.count(ViolationKind::degenerate_triangle) > 0 ||
      !has_only_single_fans(mesh, adjacency, scan, found.stop())) {
    walk_around_vertices(mesh, adjacency, found);
    return false;
  }
  const std::vector<Index> outer = boundary_vertices(adjacency);
  check_each(outer.size(), found, [&](std::size_t i, Findings& mine) { check_fans(outer[i], mesh, adjacency, mine); });
  return true;
}

void report_non_manifold(const Mesh& mesh, const std::vector<NonManifoldEdge>& edges, Findings& found) {
  std::vector<std::pair<Index, Index>> duplicates;
  SparseAsk ask(found.stop());
  for (const NonManifoldEdge& edge : edges) {
    ask();
    std::vector<Index> ids = edge.triangles;
    found.add(
        ViolationKind::non_manifold_edge, ids, {mesh.points[edge.a], mesh.points[edge.b]},
        "edge " + edge_text(edge.a, edge.b) + " has " + to_text(ids.size()) + " triangles, more than one on a side");
    // Equal triangles share their edges, so they meet here.
    const auto corners = [&](Index t) {
      std::array<Index, 3> sorted = mesh.triangles[t].v;
      std::sort(sorted.begin(), sorted.end());
      return sorted;
    };
    std::sort(ids.begin(), ids.end(),
              [&](Index s, Index t) { return std::pair(corners(s), s) < std::pair(corners(t), t); });
    for (std::size_t i = 1; i < ids.size(); ++i)
      if (corners(ids[i - 1]) == corners(ids[i])) duplicates.emplace_back(ids[i - 1], ids[i]);
  }
  std::sort(duplicates.begin(), duplicates.end());
  duplicates.erase(std::unique(duplicates.begin(), duplicates.end()), duplicates.end());
  for (const auto& [s, t] : duplicates)
    found.add(ViolationKind::duplicate_triangle, {s, t}, {mesh.points[mesh.triangles[s].v[0]]},
              "triangles " + to_text(s) + " and " + to_text(t) + " have the same corners");
}

/// The boundary edge that follows another on its loop: turns clockwise through the triangles at the end of the edge.
TriangleEdge next_on_loop(std::span<const Triangle> triangles, TriangleEdge edge) {
  const Index pivot = triangles[edge.triangle].v[previous(edge.edge)];
  for (edge.edge = next(edge.edge); triangles[edge.triangle].n[edge.edge] != no_index;) {
    edge.triangle = triangles[edge.triangle].n[edge.edge];
    edge.edge = next(next(corner_at(triangles[edge.triangle], pivot)));  // past the edge that arrives at the pivot
  }
  return edge;
}

/// The position in Adjacency::boundary() of an edge without a neighbour.
std::size_t position_of(TriangleEdge edge, const Adjacency& adjacency) {
  const Triangle& triangle = adjacency.triangles()[edge.triangle];
  const Index from = triangle.v[next(edge.edge)], to = triangle.v[previous(edge.edge)];
  const auto boundary = adjacency.boundary();
  auto at = std::lower_bound(boundary.begin(), boundary.end(), std::pair(from, to),
                             [](const BoundaryEdge& e, const auto& key) { return std::pair(e.from, e.to) < key; });
  while (at->left.triangle != edge.triangle) ++at;
  return static_cast<std::size_t>(at - boundary.begin());
}

/// Visits the triangles component by component. Memory: one byte per triangle, and the list of triangles to visit next.
class Surface {
 public:
  Surface(const Adjacency& adjacency, StopSignal* stop)
      : adjacency_(adjacency),
        triangles_(adjacency.triangles()),
        passed_(triangles_.size(), 0),
        on_loop_(adjacency.boundary().size(), 0),
        ask_(stop) {}

  [[nodiscard]] bool reached(Index t) const { return (passed_[t] & reached_bit) != 0; }

  struct Component {
    std::int64_t characteristic = 0;  ///< V - E + F, where a vertex counts once for each of its fans
    std::int64_t loops = 0;           ///< the number of boundary loops
  };

  /// Visits the component of a triangle that was not reached before. Afterwards the whole component is reached.
  Component component_of(Index start) {
    std::int64_t faces = 0, sides = 0, fans = 0;
    std::vector<TriangleEdge> open;
    std::vector<Index> front{start}, ahead;
    passed_[start] |= reached_bit;
    for (; !front.empty(); std::swap(front, ahead)) {
      ahead.clear();
      for (const Index t : front) {
        ask_();
        ++faces;
        for (int i = 0; i < 3; ++i) {
          ++sides;
          const Index n = triangles_[t].n[i];
          if (n == no_index) {
            open.push_back({t, i});
          } else if (!reached(n)) {
            passed_[n] |= reached_bit;
            ahead.push_back(n);
          }
          if (!passed_corner(t, i)) {
            ++fans;
            pass_fan(t, i);
          }
        }
      }
    }
    Component component{fans - (sides + static_cast<std::int64_t>(open.size())) / 2 + faces, 0};
    for (const TriangleEdge edge : open) component.loops += pass_loop(edge) ? 1 : 0;
    return component;
  }

 private:
  static constexpr std::uint8_t reached_bit = 8;  // bits 0 to 2 mark the corners

  [[nodiscard]] bool passed_corner(Index t, int corner) const { return (passed_[t] >> corner & 1) != 0; }

  /// Marks the corners of the fan that contains this corner. In this way every fan is found, even if a vertex has more
  /// fans than a valid mesh allows.
  void pass_fan(Index t, int corner) {
    if (closes(t, corner, /*counter_clockwise=*/true)) return;
    const Index before = triangles_[t].n[previous(corner)];
    if (before != no_index) closes(before, corner_at(triangles_[before], triangles_[t].v[corner]), false);
  }

  /// Marks the corners around the vertex in one direction. True if this leads back to a marked corner, false if
  /// the fan ends at a boundary edge.
  bool closes(Index t, int corner, bool counter_clockwise) {
    const Index vertex = triangles_[t].v[corner];
    for (;;) {
      passed_[t] = static_cast<std::uint8_t>(passed_[t] | 1 << corner);
      t = triangles_[t].n[counter_clockwise ? next(corner) : previous(corner)];
      if (t == no_index) return false;
      corner = corner_at(triangles_[t], vertex);
      if (passed_corner(t, corner)) return true;
    }
  }

  /// Walks the boundary loop of an edge without a neighbour. False if the loop was walked before.
  bool pass_loop(TriangleEdge edge) {
    if (on_loop_[position(edge)] != 0) return false;
    for (std::size_t at = position(edge); on_loop_[at] == 0; at = position(edge)) {
      ask_();
      on_loop_[at] = 1;
      edge = next_on_loop(triangles_, edge);
    }
    return true;
  }

  [[nodiscard]] std::size_t position(TriangleEdge edge) const { return position_of(edge, adjacency_); }

  const Adjacency& adjacency_;
  std::span<const Triangle> triangles_;
  Array<std::uint8_t> passed_;
  std::vector<char> on_loop_;
  SparseAsk ask_;
};

/// Joins the boundary loops that lie in one component of the mesh, as far as walks straight down from holes find them.
class Loops {
 public:
  Loops(const Mesh& mesh, const Adjacency& adjacency, StopSignal* stop)
      : mesh_(mesh), adjacency_(adjacency), loop_of_(adjacency.boundary().size(), no_index), ask_(stop) {
    for (std::size_t e = 0; e < loop_of_.size(); ++e)
      if (loop_of_[e] == no_index) add_loop(adjacency.boundary()[e].left, e);
    classes_ = lowest_.size();
    representative_.resize(lowest_.size());
    std::iota(representative_.begin(), representative_.end(), Index{0});
    for (std::size_t loop = 0; loop < lowest_.size(); ++loop) walk_down(static_cast<Index>(loop));
  }

  [[nodiscard]] std::size_t count() const { return lowest_.size(); }
  /// The number of classes of joined loops. Each component has at least one loop, because its triangles have a positive
  /// area. So there are at most as many components.
  [[nodiscard]] std::size_t classes() const { return classes_; }

 private:
  /// Two successive edges of a loop, at its lowest vertex.
  struct Lowest {
    TriangleEdge before, after;
  };

  [[nodiscard]] Point from(TriangleEdge e) const {
    return mesh_.points[adjacency_.triangles()[e.triangle].v[next(e.edge)]];
  }
  [[nodiscard]] Point to(TriangleEdge e) const {
    return mesh_.points[adjacency_.triangles()[e.triangle].v[previous(e.edge)]];
  }

  void add_loop(TriangleEdge edge, std::size_t at) {
    Lowest lowest{edge, edge};
    bool any = false;
    for (; loop_of_[at] == no_index; at = position_of(edge, adjacency_)) {
      ask_();
      loop_of_[at] = static_cast<Index>(lowest_.size());
      const TriangleEdge after = next_on_loop(adjacency_.triangles(), edge);
      if (!any || is_lower(from(after), from(lowest.after))) lowest = {edge, after};
      any = true;
      edge = after;
    }
    lowest_.push_back(lowest);
  }

  /// Follows a vertical line from the lowest vertex of a hole, beside the vertex, to the next edge of the boundary.
  /// Only sides of vertices decide which way the line takes through the triangles.
  void walk_down(Index loop) {
    const auto [before, after] = lowest_[loop];
    const Point bottom = from(after);
    const bool is_steep = to(after).x == bottom.x;
    TriangleEdge at = is_steep ? before : after;
    const double other = is_steep ? from(before).x : to(after).x;
    const bool domain_is_below = is_steep ? other > bottom.x : other < bottom.x;
    if (!domain_is_below) return;
    const bool line_is_right = other > bottom.x;
    const auto is_right = [&](Index v) {
      return line_is_right ? mesh_.points[v].x > bottom.x : mesh_.points[v].x >= bottom.x;
    };
    for (;;) {
      if (++steps_ > adjacency_.triangles().size()) return;
      ask_();
      const Triangle& triangle = adjacency_.triangles()[at.triangle];
      // The line enters across this edge and leaves across one of the two others.
      const bool apex = is_right(triangle.v[at.edge]);
      const int exit = apex == is_right(triangle.v[next(at.edge)]) ? next(at.edge) : previous(at.edge);
      const Index beyond = triangle.n[exit];
      if (beyond == no_index) return join(loop, loop_of_[position_of({at.triangle, exit}, adjacency_)]);
      const int corner = corner_at(adjacency_.triangles()[beyond], triangle.v[next(exit)]);
      at = {beyond, next(corner)};
    }
  }

  [[nodiscard]] Index find(Index loop) {
    while (representative_[loop] != loop) loop = representative_[loop] = representative_[representative_[loop]];
    return loop;
  }
  void join(Index a, Index b) {
    a = find(a);
    b = find(b);
    if (a == b) return;
    representative_[a] = b;
    --classes_;
  }

  const Mesh& mesh_;
  const Adjacency& adjacency_;
  std::vector<Index> loop_of_;  ///< by position in the boundary
  std::vector<Lowest> lowest_;  ///< by loop
  std::vector<Index> representative_;
  std::size_t classes_ = 0, steps_ = 0;
  SparseAsk ask_;
};

/// True if it is certain that each component has V - E + F = 2 - L. Preconditions: all triangles are counter-clockwise,
/// and has_only_single_fans().
///
/// Let g be the genus of a component: V - E + F = 2 - 2g - L for a connected oriented surface with L boundary loops. So
/// half the sum of V - E + F + L over all components is the sum of 1 - g, which is at most the number of components,
/// and equal to it only if every g is 0. The number of components is at most the number of classes of loops.
bool has_only_disks_with_holes(const Mesh& mesh, const Adjacency& adjacency, StopSignal* stop) {
  const auto faces = static_cast<std::int64_t>(adjacency.triangles().size());
  const auto sides = static_cast<std::int64_t>(adjacency.boundary().size());
  const std::size_t outer = boundary_vertices(adjacency).size();
  // Each inner vertex has one fan. Each other fan begins at one edge of the boundary.
  const auto fans = static_cast<std::int64_t>(count_used_vertices(adjacency, mesh.points.size(), stop) - outer) + sides;
  const std::int64_t characteristic = fans - (3 * faces + sides) / 2 + faces;
  const Loops loops(mesh, adjacency, stop);
  return characteristic + static_cast<std::int64_t>(loops.count()) == 2 * static_cast<std::int64_t>(loops.classes());
}

/// A connected oriented surface with L boundary loops is a disk with holes if and only if V - E + F = 2 - L,
/// where a vertex counts once for each of its fans (that is, a surface is cut where it touches itself in a vertex).
void check_euler(const Subject& subject, const Adjacency& adjacency, Findings& found) {
  Surface surface(adjacency, found.stop());
  for (std::size_t i = 0; i < adjacency.triangles().size(); ++i) {
    const auto t = static_cast<Index>(i);
    if (surface.reached(t)) continue;
    const auto [characteristic, loops] = surface.component_of(t);
    if (characteristic == 2 - loops) continue;
    found.add(ViolationKind::euler_characteristic, {t}, {subject.corner(adjacency.triangles()[t], 0)},
              "the component of triangle " + to_text(t) + " has V - E + F = " + to_text(characteristic) + " and " +
                  to_text(loops) + " boundary loops, which do not sum to 2");
  }
}

}  // namespace

bool lacks_neighbours(const Subject& subject) {
  const auto& triangles = subject.mesh.triangles;
  return subject.options.foreign && std::all_of(triangles.begin(), triangles.end(), [](const Triangle& t) {
           return t.n == std::array<Index, 3>{no_index, no_index, no_index};
         });
}

Adjacency check_topology(const Subject& subject, bool neighbours_usable, Scan& scan, Findings& found) {
  const Mesh& mesh = subject.mesh;
  check_orientation(subject, scan, found);
  const auto check_rest = [&](Adjacency& adjacency, bool has_single_fans) {
    if (!has_single_fans || !has_only_disks_with_holes(mesh, adjacency, found.stop()))
      check_euler(subject, adjacency, found);
  };

  const bool absent = lacks_neighbours(subject);
  if (neighbours_usable && !absent) {
    if (!scan.neighbours_reciprocal) check_reciprocity(mesh, found);
    if (found.count(ViolationKind::wrong_neighbour) == 0) {
      Adjacency given(mesh.triangles.span(), std::move(scan.start), std::move(scan.boundary));
      check_lost_neighbours(mesh, given, found);
      const bool single_fans = check_vertices(mesh, given, scan, found);
      if (found.count(ViolationKind::wrong_neighbour) == 0 && found.count(ViolationKind::non_manifold_vertex) == 0) {
        check_rest(given, single_fans);
        return given;
      }
    }
  }

  // The neighbours are wrong or absent. Rebuild them, and find the edges with too many triangles.
  Array<Triangle> rebuilt = mesh.triangles;
  std::vector<NonManifoldEdge> non_manifold;
  rebuild_neighbours(rebuilt.span(), non_manifold, found.stop());
  report_non_manifold(mesh, non_manifold, found);
  scan = checker::scan(mesh.points.span(), std::as_const(rebuilt).span(), bounds_of(subject), found.stop());
  Adjacency adjacency(std::move(rebuilt), std::move(scan.start), std::move(scan.boundary));
  const bool single_fans =
      found.count(ViolationKind::non_manifold_vertex) == 0 && check_vertices(mesh, adjacency, scan, found);
  check_rest(adjacency, single_fans);
  if (!single_fans) {
    adjacency.count_corners(found.stop());
    adjacency.index_irregular_vertices(found.stop());
  }
  return adjacency;
}

}  // namespace pardel::checker
