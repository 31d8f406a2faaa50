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

/// A block of $Elements, of one type. row(i) is an array: the tag of the element of a thing, and the tags of its nodes.
template <class Row>
void write_element_block(MshRows& out, int dimension, int entity, int type, std::span<const Index> things,
                         const Row& row) {
  if (things.empty()) return;
  out.row(dimension, entity, type, things.size());
  out.rows(things.size(), [&](std::size_t i) { return row(things[i]); });
}
/// Blocks of first order. `tags`: tags.node(v), tags.line(i) and tags.triangle(t) are the tags of things of the mesh.
template <class Tags>
void write_line_block(MshRows& out, int entity, std::span<const Index> lines, const Mesh& mesh, const Tags& tags) {
  write_element_block(out, 1, entity, msh_line, lines, [&](Index line) {
    const ConstrainedEdge& e = mesh.constrained_edges[line];
    return std::array<std::size_t, 3>{tags.line(line), tags.node(e.a), tags.node(e.b)};
  });
}
template <class Tags>
void write_triangle_block(MshRows& out, int entity, std::span<const Index> triangles, const Mesh& mesh,
                          const Tags& tags) {
  write_element_block(out, 2, entity, msh_triangle, triangles, [&](Index t) {
    const auto& v = mesh.triangles[t].v;
    return std::array<std::size_t, 4>{tags.triangle(t), tags.node(v[0]), tags.node(v[1]), tags.node(v[2])};
  });
}
/// A block of $Nodes. tag(i) and point(i) are those of a node.
template <class Tag, class PointOf>
void write_node_block(MshRows& out, int dimension, int entity, std::span<const Index> nodes, const Tag& tag,
                      const PointOf& point) {
  if (nodes.empty()) return;
  out.row(dimension, entity, 0, nodes.size());
  out.rows(nodes.size(), [&](std::size_t i) { return std::array<std::size_t, 1>{tag(nodes[i])}; });
  out.rows(nodes.size(), [&](std::size_t i) {
    const Point p = point(nodes[i]);
    return std::array{p.x, p.y, 0.0};
  });
}
/// The same for vertices.
template <class Tags>
void write_node_block(MshRows& out, int dimension, int entity, std::span<const Index> points, const Mesh& mesh,
                      const Tags& tags) {
  write_node_block(
      out, dimension, entity, points, [&](Index v) { return tags.node(v); }, [&](Index v) { return mesh.points[v]; });
}

/// The section $PhysicalNames, which is text in ASCII and in binary files.
void write_names(MshRows& out, const MshModel& model);
/// The section $Entities.
void write_entities(MshRows& out, const MshModel& model);

}  // namespace pardel::files
