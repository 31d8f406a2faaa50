// A mesh in Gmsh's terms: physical groups, and the entities to which vertices, lines and triangles belong.
#pragma once

#include <array>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "../array.hpp"
#include "../mesh.hpp"
#include "msh_rows.hpp"

namespace pardel::files {

/// A box around points; empty at first.
struct MshBox {
  Point low{std::numeric_limits<double>::max(), std::numeric_limits<double>::max()};
  Point high{std::numeric_limits<double>::lowest(), std::numeric_limits<double>::lowest()};

  void cover(const Point& p);
  void cover(const MshBox& other);
  /// The same, or the origin if it is empty.
  [[nodiscard]] MshBox finite() const { return low.x > high.x ? MshBox{{}, {}} : *this; }
};

/// A physical group and its only entity, which has the same tag.
struct MshGroup {
  std::string name;
  int tag = 0;
  MshBox box;  ///< around the vertices that belong to the entity
};

/// The numbers 0 .. n-1 by group. Group g has members[start[g]] .. members[start[g + 1] - 1], in ascending order.
struct Gathered {
  std::vector<std::size_t> start;
  Array<Index> members;
  [[nodiscard]] std::span<const Index> operator[](std::size_t g) const {
    return members.span().subspan(start[g], start[g + 1] - start[g]);
  }
  [[nodiscard]] std::size_t groups_in_use() const;
};

/// The distinct markers of constrained edges, and the distinct attributes of triangles, in ascending order. A NaN at
/// the end stands for triangles without a region.
struct MshValues {
  std::vector<double> markers, attributes;
};
[[nodiscard]] MshValues values_of(const Mesh& mesh);
/// Sorts values, removes repeated ones, and keeps one NaN at the end, if there are any.
[[nodiscard]] std::vector<double> distinct(std::vector<double> values);

/// The numbers of curves come before those of surfaces.
struct MshModel {
  std::vector<MshGroup> curves;
  std::vector<MshGroup> surfaces;
  std::vector<GroupName> empty_groups;  ///< names of markers and regions that nothing has
  Gathered lines;                       ///< the constrained edges, grouped by curve
  Gathered triangles;                   ///< grouped by surface
  /// Per point: the number of its curve or, beyond the curves, of its surface. A point belongs to the first curve
  /// through it, else to a surface around it, else to the first surface.
  Array<Index> entity_of_point;
};
/// `values`: those of the mesh, and possibly more.
[[nodiscard]] MshModel msh_model(const Mesh& mesh, MshValues values);

/// The numbers 0 .. n-1 by group: group_of(i) is the group of i.
template <class GroupOf>
[[nodiscard]] Gathered gather(std::size_t n, std::size_t groups, const GroupOf& group_of) {
  Gathered gathered{std::vector<std::size_t>(groups + 1, 0), Array<Index>(n)};
  for (std::size_t i = 0; i < n; ++i) ++gathered.start[group_of(i) + 1];
  for (std::size_t g = 0; g < groups; ++g) gathered.start[g + 1] += gathered.start[g];
  std::vector<std::size_t> next = gathered.start;
  for (std::size_t i = 0; i < n; ++i) gathered.members[next[group_of(i)]++] = static_cast<Index>(i);
  return gathered;
}

/// Blocks of $Elements. `tags`: tags.node(v), tags.line(i) and tags.triangle(t) are the tags of things of the mesh.
template <class Tags>
void write_line_block(MshRows& out, int entity, std::span<const Index> lines, const Mesh& mesh, const Tags& tags) {
  if (lines.empty()) return;
  out.row(1, entity, msh_line, lines.size());
  out.rows(lines.size(), [&](std::size_t i) {
    const ConstrainedEdge& e = mesh.constrained_edges[lines[i]];
    return std::array<std::size_t, 3>{tags.line(lines[i]), tags.node(e.a), tags.node(e.b)};
  });
}
template <class Tags>
void write_triangle_block(MshRows& out, int entity, std::span<const Index> triangles, const Mesh& mesh,
                          const Tags& tags) {
  if (triangles.empty()) return;
  out.row(2, entity, msh_triangle, triangles.size());
  out.rows(triangles.size(), [&](std::size_t i) {
    const auto& v = mesh.triangles[triangles[i]].v;
    return std::array<std::size_t, 4>{tags.triangle(triangles[i]), tags.node(v[0]), tags.node(v[1]), tags.node(v[2])};
  });
}
/// A block of $Nodes.
template <class Tags>
void write_node_block(MshRows& out, int dimension, int entity, std::span<const Index> points, const Mesh& mesh,
                      const Tags& tags) {
  if (points.empty()) return;
  out.row(dimension, entity, 0, points.size());
  out.rows(points.size(), [&](std::size_t i) { return std::array<std::size_t, 1>{tags.node(points[i])}; });
  out.rows(points.size(), [&](std::size_t i) {
    const Point& p = mesh.points[points[i]];
    return std::array{p.x, p.y, 0.0};
  });
}

/// The section $PhysicalNames, which is text in ASCII and in binary files.
void write_names(MshRows& out, const MshModel& model);
/// The section $Entities.
void write_entities(MshRows& out, const MshModel& model);

}  // namespace pardel::files
