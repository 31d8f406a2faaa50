#include "euler_characteristic.hpp"

#include <algorithm>
#include <numeric>

#include "../arithmetic/text.hpp"

namespace pardel::checker {
namespace {

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

}  // namespace

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

void check_euler(const Subject& subject, const Adjacency& adjacency, Findings& found) {
  Surface surface(adjacency, found.stop());
  for (std::size_t i = 0; i < adjacency.triangles().size(); ++i) {
    const auto t = static_cast<Index>(i);
    if (surface.reached(t)) continue;
    const auto [characteristic, loops] = surface.component_of(t);
    if (characteristic == 2 - loops) continue;
    found.add(ViolationKind::euler_characteristic, {t}, {subject.corner(adjacency.triangles()[t], 0)},
              "the component of triangle " + triangle_number(t) + " has V - E + F = " + to_text(characteristic) +
                  " and " + to_text(loops) + " boundary loops, which do not sum to 2");
  }
}

}  // namespace pardel::checker
