// Checks that the triangles are counter-clockwise and joined edge to edge. These checks do not use the domain.
#include <algorithm>
#include <numeric>

#include "../arithmetic/exact.hpp"
#include "../arithmetic/text.hpp"
#include "euler_characteristic.hpp"
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
                 subject.names.triangle_and_corners(t, triangle),
                 {a, b, c},
                 "triangle " + triangle_number(subject.names.triangle(t)) +
                     " is not counter-clockwise: twice its signed area is " + exactly::orientation_text(a, b, c)});
  });
}

/// True if `other` has an edge from `to` to `from` and its neighbour there is t.
bool is_reciprocal(const Triangle& other, Index t, Index from, Index to) {
  for (int j = 0; j < 3; ++j)
    if (other.v[next(j)] == to && other.v[previous(j)] == from) return other.n[j] == t;
  return false;
}

void check_reciprocity(const Subject& subject, Findings& found) {
  const Mesh& mesh = subject.mesh;
  const Numbering& names = subject.names;
  check_each(mesh.triangles.size(), found, [&](std::size_t t, Findings& mine) {
    const Triangle& triangle = mesh.triangles[t];
    for (int i = 0; i < 3; ++i) {
      const Index from = triangle.v[next(i)];
      const Index to = triangle.v[previous(i)];
      if (triangle.n[i] == no_index || is_reciprocal(mesh.triangles[triangle.n[i]], static_cast<Index>(t), from, to))
        continue;
      if (mine.admit(ViolationKind::wrong_neighbour))
        mine.keep({ViolationKind::wrong_neighbour,
                   {names.triangle(static_cast<Index>(t)), names.triangle(triangle.n[i])},
                   {mesh.points[from], mesh.points[to]},
                   "triangle " + triangle_number(names.triangle(static_cast<Index>(t))) + " lists " +
                       triangle_number(names.triangle(triangle.n[i])) + " as its neighbour across edge " +
                       names.edge_text(from, to) + ", but that triangle does not list it there"});
    }
  });
}

/// Reports edges that have a triangle on both sides although neither triangle lists a neighbour there.
void check_lost_neighbours(const Subject& subject, const Adjacency& adjacency, Findings& found) {
  const Mesh& mesh = subject.mesh;
  const Numbering& names = subject.names;
  const auto boundary = adjacency.boundary();
  SparseAsk ask(found.stop());
  for (const BoundaryEdge& edge : boundary) {
    ask();
    if (edge.from > edge.to) continue;
    const auto back = std::lower_bound(boundary.begin(), boundary.end(), edge, [](const auto& x, const auto& y) {
      return std::pair(x.from, x.to) < std::pair(y.to, y.from);
    });
    if (back == boundary.end() || back->from != edge.to || back->to != edge.from) continue;
    const Index left = names.triangle(edge.left.triangle), right = names.triangle(back->left.triangle);
    found.add(ViolationKind::wrong_neighbour, {left, right}, {mesh.points[edge.from], mesh.points[edge.to]},
              "triangles " + triangle_number(left) + " and " + triangle_number(right) + " share edge " +
                  names.edge_text(edge.from, edge.to) + " but are not neighbours");
  }
}

/// Reports a vertex if an edge at it has two triangles on one side. This is possible at vertices with several fans, and
/// in a fan that turns by more than 360 degrees.
void check_fans(Index vertex, const Subject& subject, const Adjacency& adjacency, Findings& found) {
  std::vector<Index> ahead;
  adjacency.visit_fans(vertex, [&](Index t, int corner) { ahead.push_back(adjacency.triangles()[t].v[next(corner)]); });
  std::sort(ahead.begin(), ahead.end());
  const auto twice = std::adjacent_find(ahead.begin(), ahead.end());
  if (twice != ahead.end())
    found.add(ViolationKind::non_manifold_vertex, {subject.names.vertex(vertex), subject.names.vertex(*twice)},
              {subject.mesh.points[vertex]},
              "vertex " + vertex_number(subject.names.vertex(vertex)) +
                  " has two triangles on the left of its edge to vertex " +
                  vertex_number(subject.names.vertex(*twice)));
}

/// Reports a vertex if a walk around it does not reach all its triangles, or if check_fans() does. Precondition:
/// count_corners() was called.
void walk_around_vertex(Index vertex, const Subject& subject, const Adjacency& adjacency, Findings& found) {
  Index reached = 0;
  adjacency.visit_fans(vertex, [&](Index, int) { ++reached; });
  if (reached == adjacency.corners(vertex)) return check_fans(vertex, subject, adjacency, found);
  const Index name = subject.names.vertex(vertex);
  found.add(ViolationKind::non_manifold_vertex, {name}, {subject.mesh.points[vertex]},
            "vertex " + vertex_number(name) + " has " + to_text(adjacency.corners(vertex)) +
                " triangles, but a walk around it from its boundary edges reaches " + to_text(reached));
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
bool check_vertices(const Subject& subject, Adjacency& adjacency, const Scan& scan, Findings& found) {
  const Mesh& mesh = subject.mesh;
  if (!scan.neighbours_reciprocal || found.count(ViolationKind::degenerate_triangle) > 0 ||
      !has_only_single_fans(mesh, adjacency, scan, found.stop())) {
    adjacency.count_corners(found.stop());
    check_each(mesh.points.size(), found, [&](std::size_t v, Findings& mine) {
      walk_around_vertex(static_cast<Index>(v), subject, adjacency, mine);
    });
    return false;
  }
  const std::vector<Index> outer = boundary_vertices(adjacency);
  check_each(outer.size(), found,
             [&](std::size_t i, Findings& mine) { check_fans(outer[i], subject, adjacency, mine); });
  return true;
}

}  // namespace

void report_non_manifold(const Subject& subject, std::span<const NonManifoldEdge> edges, Findings& found) {
  const Mesh& mesh = subject.mesh;
  const Numbering& names = subject.names;
  std::vector<std::pair<Index, Index>> duplicates;
  SparseAsk ask(found.stop());
  for (const NonManifoldEdge& edge : edges) {
    ask();
    std::vector<Index> ids = edge.triangles, in_names;
    for (const Index t : ids) in_names.push_back(names.triangle(t));
    found.add(ViolationKind::non_manifold_edge, in_names, {mesh.points[edge.a], mesh.points[edge.b]},
              "edge " + names.edge_text(edge.a, edge.b) + " has " + to_text(ids.size()) +
                  " triangles, more than one on a side");
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
    found.add(ViolationKind::duplicate_triangle, {names.triangle(s), names.triangle(t)},
              {mesh.points[mesh.triangles[s].v[0]]},
              "triangles " + triangle_number(names.triangle(s)) + " and " + triangle_number(names.triangle(t)) +
                  " have the same corners");
}

bool lacks_neighbours(const Subject& subject) {
  const auto& triangles = subject.mesh.triangles;
  return subject.options.foreign && std::all_of(triangles.begin(), triangles.end(), [](const Triangle& t) {
           return t.n == std::array<Index, 3>{no_index, no_index, no_index};
         });
}

namespace {

/// Computes the neighbours anew, because they are wrong or absent. Appends the edges with too many triangles.
Adjacency with_new_neighbours(const Subject& subject, Scan& scan, std::vector<NonManifoldEdge>& non_manifold,
                              StopSignal* stop) {
  Array<Triangle> rebuilt = subject.mesh.triangles;
  rebuild_neighbours(rebuilt.span(), non_manifold, stop);
  scan = checker::scan(subject.mesh.points.span(), std::as_const(rebuilt).span(), bounds_of(subject), stop);
  return {std::move(rebuilt), std::move(scan.start), std::move(scan.boundary)};
}

}  // namespace

Adjacency check_topology(const Subject& subject, bool neighbours_usable, Scan& scan, Findings& found) {
  const Mesh& mesh = subject.mesh;
  check_orientation(subject, scan, found);
  const auto check_rest = [&](Adjacency& adjacency, bool has_single_fans) {
    if (!has_single_fans || !has_only_disks_with_holes(mesh, adjacency, found.stop()))
      check_euler(subject, adjacency, found);
  };

  const bool absent = lacks_neighbours(subject);
  if (neighbours_usable && !absent) {
    if (!scan.neighbours_reciprocal) check_reciprocity(subject, found);
    if (found.count(ViolationKind::wrong_neighbour) == 0) {
      Adjacency given(mesh.triangles.span(), std::move(scan.start), std::move(scan.boundary));
      check_lost_neighbours(subject, given, found);
      const bool single_fans = check_vertices(subject, given, scan, found);
      if (found.count(ViolationKind::wrong_neighbour) == 0 && found.count(ViolationKind::non_manifold_vertex) == 0) {
        check_rest(given, single_fans);
        return given;
      }
    }
  }

  std::vector<NonManifoldEdge> non_manifold;
  Adjacency adjacency = with_new_neighbours(subject, scan, non_manifold, found.stop());
  report_non_manifold(subject, non_manifold, found);
  const bool single_fans =
      found.count(ViolationKind::non_manifold_vertex) == 0 && check_vertices(subject, adjacency, scan, found);
  check_rest(adjacency, single_fans);
  if (!single_fans) {
    adjacency.count_corners(found.stop());
    adjacency.index_irregular_vertices(found.stop());
  }
  return adjacency;
}

Adjacency check_topology_of_piece(const Subject& subject, bool neighbours_usable, Scan& scan, Findings& found) {
  check_orientation(subject, scan, found);
  if (neighbours_usable && !lacks_neighbours(subject)) {
    if (!scan.neighbours_reciprocal) check_reciprocity(subject, found);
    if (found.count(ViolationKind::wrong_neighbour) == 0) {
      Adjacency given(subject.mesh.triangles.span(), std::move(scan.start), std::move(scan.boundary));
      check_lost_neighbours(subject, given, found);
      if (found.count(ViolationKind::wrong_neighbour) == 0) return given;
    }
  }
  std::vector<NonManifoldEdge> non_manifold;
  return with_new_neighbours(subject, scan, non_manifold, found.stop());
}

void check_boundary_vertices(const Subject& subject, Adjacency& adjacency, Findings& found) {
  const std::uint64_t before = found.count(ViolationKind::non_manifold_vertex);
  adjacency.count_corners(found.stop());
  for (const Index vertex : boundary_vertices(adjacency)) walk_around_vertex(vertex, subject, adjacency, found);
  if (found.count(ViolationKind::non_manifold_vertex) > before) adjacency.index_irregular_vertices(found.stop());
}

}  // namespace pardel::checker
