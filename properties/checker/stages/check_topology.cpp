// Checks that the triangles are counter-clockwise and joined edge to edge. These checks do not use the domain.
#include <algorithm>

#include "../arithmetic/exact.hpp"
#include "../arithmetic/text.hpp"
#include "stages.hpp"

namespace pardel::checker {
namespace {

void check_orientation(const Subject& subject, Findings& found) {
  check_each(subject.mesh.triangles.size(), found, [&](std::size_t t, Findings& mine) {
    const Triangle& triangle = subject.mesh.triangles[t];
    const Point a = subject.corner(triangle, 0), b = subject.corner(triangle, 1), c = subject.corner(triangle, 2);
    if (exactly::orientation(a, b, c) > 0) return;
    if (mine.admit(ViolationKind::degenerate_triangle))
      mine.keep({ViolationKind::degenerate_triangle,
                 {static_cast<Index>(t), triangle.v[0], triangle.v[1], triangle.v[2]},
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

bool names_no_neighbour_at_all(const Mesh& mesh) {
  return std::all_of(mesh.triangles.begin(), mesh.triangles.end(), [](const Triangle& t) {
    return t.n == std::array<Index, 3>{no_index, no_index, no_index};
  });
}

/// Reports a vertex if a walk around it does not reach all its triangles, or if an edge at it has two triangles on one
/// side. The second case is possible only at vertices with several fans.
void check_vertices(const Subject& subject, const Adjacency& adjacency, Findings& found) {
  const Mesh& mesh = subject.mesh;
  check_each(mesh.points.size(), found, [&](std::size_t v, Findings& mine) {
    const auto vertex = static_cast<Index>(v);
    Index reached = 0;
    const int fans = adjacency.visit_fans(vertex, [&](Index, int) { ++reached; });
    if (reached != adjacency.corners(vertex)) {
      mine.add(ViolationKind::non_manifold_vertex, {vertex}, {mesh.points[v]},
               "vertex " + to_text(v) + " has " + to_text(adjacency.corners(vertex)) +
                   " triangles, but a walk around it from its boundary edges reaches " + to_text(reached));
    } else if (fans > 1) {
      std::vector<Index> ahead;
      adjacency.visit_fans(vertex,
                           [&](Index t, int corner) { ahead.push_back(adjacency.triangles()[t].v[next(corner)]); });
      std::sort(ahead.begin(), ahead.end());
      const auto twice = std::adjacent_find(ahead.begin(), ahead.end());
      if (twice != ahead.end())
        mine.add(ViolationKind::non_manifold_vertex, {vertex, *twice}, {mesh.points[v]},
                 "vertex " + to_text(v) + " has two triangles on the left of its edge to vertex " + to_text(*twice));
    }
  });
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

/// Visits the triangles component by component. Memory: one byte per triangle, and the list of triangles to visit next.
class Surface {
 public:
  Surface(const Adjacency& adjacency, StopSignal* stop)
      : triangles_(adjacency.triangles()),
        boundary_(adjacency.boundary()),
        passed_(triangles_.size(), 0),
        on_loop_(boundary_.size(), 0),
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
      // Find the next boundary edge of the same fan at the pivot: turn clockwise through the triangles there.
      const Index pivot = boundary_[at].to;
      for (edge.edge = next(edge.edge); triangles_[edge.triangle].n[edge.edge] != no_index;) {
        edge.triangle = triangles_[edge.triangle].n[edge.edge];
        edge.edge = next(next(corner_at(triangles_[edge.triangle], pivot)));  // past the edge that arrives at the pivot
      }
    }
    return true;
  }

  [[nodiscard]] std::size_t position(TriangleEdge edge) const {
    const Index from = triangles_[edge.triangle].v[next(edge.edge)];
    const Index to = triangles_[edge.triangle].v[previous(edge.edge)];
    auto at = std::lower_bound(boundary_.begin(), boundary_.end(), std::pair(from, to),
                               [](const BoundaryEdge& e, const auto& key) { return std::pair(e.from, e.to) < key; });
    while (at->left.triangle != edge.triangle) ++at;
    return static_cast<std::size_t>(at - boundary_.begin());
  }

  std::span<const Triangle> triangles_;
  std::span<const BoundaryEdge> boundary_;
  Array<std::uint8_t> passed_;
  std::vector<char> on_loop_;
  SparseAsk ask_;
};

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

Adjacency check_topology(const Subject& subject, bool neighbours_usable, Findings& found) {
  const Mesh& mesh = subject.mesh;
  check_orientation(subject, found);

  const bool absent = subject.options.foreign && names_no_neighbour_at_all(mesh);
  if (neighbours_usable && !absent) {
    check_reciprocity(mesh, found);
    if (found.count(ViolationKind::wrong_neighbour) == 0) {
      Adjacency given({}, mesh, found.stop());
      check_lost_neighbours(mesh, given, found);
      check_vertices(subject, given, found);
      if (found.count(ViolationKind::wrong_neighbour) == 0 && found.count(ViolationKind::non_manifold_vertex) == 0) {
        check_euler(subject, given, found);
        return given;
      }
    }
  }

  // The neighbours are wrong or absent. Rebuild them, and find the edges with too many triangles.
  Array<Triangle> rebuilt = mesh.triangles;
  std::vector<NonManifoldEdge> non_manifold;
  rebuild_neighbours(rebuilt.span(), non_manifold, found.stop());
  report_non_manifold(mesh, non_manifold, found);
  Adjacency adjacency(std::move(rebuilt), mesh, found.stop());
  if (found.count(ViolationKind::non_manifold_vertex) == 0) check_vertices(subject, adjacency, found);
  check_euler(subject, adjacency, found);
  adjacency.index_irregular_vertices(found.stop());
  return adjacency;
}

}  // namespace pardel::checker
