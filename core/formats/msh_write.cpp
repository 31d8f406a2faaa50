// Writes Gmsh's MSH 4.1, ASCII and binary (gmsh.info, "MSH file format"). Regions and markers are physical groups, each
// with one entity: surfaces `region ATTRIBUTE` (`domain` for triangles without a region), curves `marker NUMBER`. The
// tag of a group is the attribute or marker itself if that is a positive int, else the smallest free number. A marker
// or a region with a name of its own has the group of this name. Fields are $NodeData and $ElementData.
#include <optional>

#include "middles.hpp"
#include "msh_fields.hpp"
#include "msh_model.hpp"

namespace pardel {
using namespace files;
namespace {

/// Vertices, lines and then triangles have tags in the order of the mesh.
struct Tags {
  std::size_t lines;
  [[nodiscard]] std::size_t node(Index v) const { return std::size_t{v} + 1; }
  [[nodiscard]] std::size_t line(Index i) const { return std::size_t{i} + 1; }
  [[nodiscard]] std::size_t triangle(Index t) const { return lines + t + 1; }
};

/// What write_msh() writes of second order: the middles of edges, whose tags follow those of the vertices.
struct SecondOrder {
  Middles middles;
  Gathered by_entity;  ///< the middles, as MshModel::entity_of_point
};
[[nodiscard]] std::size_t tag_of_middle(const Mesh& mesh, Index middle) { return mesh.points.size() + middle + 1; }

SecondOrder second_order(const Mesh& mesh, const MshModel& model) {
  const std::size_t curves = model.curves.size();
  SecondOrder second{middles_of(mesh), {}};
  Array<Index> entity(second.middles.edges.size(), static_cast<Index>(curves));
  for (std::size_t s = model.surfaces.size(); s-- > 0;)
    for (const Index t : model.triangles[s])
      for (const Index middle : second.middles.of_triangle(t)) entity[middle] = static_cast<Index>(curves + s);
  for (std::size_t c = curves; c-- > 0;)
    for (const Index line : model.lines[c]) entity[second.middles.of_line[line]] = static_cast<Index>(c);
  second.by_entity =
      gather(entity.size(), curves + model.surfaces.size(), [&](std::size_t middle) { return entity[middle]; });
  return second;
}

/// `second`: null for elements of first order.
void write_nodes(MshRows& out, const MshModel& model, const Mesh& mesh, const Tags& tags, const SecondOrder* second) {
  const std::size_t points = mesh.points.size(), curves = model.curves.size(),
                    entities = curves + model.surfaces.size();
  const std::size_t n = points + (second == nullptr ? 0 : second->middles.edges.size());
  const Gathered by_entity = gather(points, entities, [&](std::size_t i) { return model.entity_of_point[i]; });
  const std::size_t blocks_of_middles = second == nullptr ? 0 : second->by_entity.groups_in_use();
  out.open("Nodes");
  out.row(by_entity.groups_in_use() + blocks_of_middles, n, std::size_t{n > 0}, n);
  for (std::size_t e = 0; e < entities; ++e) {
    const int dimension = e < curves ? 1 : 2, tag = e < curves ? model.curves[e].tag : model.surfaces[e - curves].tag;
    write_node_block(out, dimension, tag, by_entity[e], mesh, tags);
    if (second != nullptr)
      write_node_block(
          out, dimension, tag, second->by_entity[e], [&](Index middle) { return tag_of_middle(mesh, middle); },
          [&](Index middle) { return second->middles.point(mesh, middle); });
  }
  out.close("Nodes");
}

void write_lines_of_3(MshRows& out, int entity, std::span<const Index> lines, const Mesh& mesh, const Tags& tags,
                      const Middles& middles) {
  write_element_block(out, 1, entity, msh_line_of_3, lines, [&](Index line) {
    const ConstrainedEdge& e = mesh.constrained_edges[line];
    return std::array<std::size_t, 4>{tags.line(line), tags.node(e.a), tags.node(e.b),
                                      tag_of_middle(mesh, middles.of_line[line])};
  });
}

void write_triangles_of_6(MshRows& out, int entity, std::span<const Index> triangles, const Mesh& mesh,
                          const Tags& tags, const Middles& middles) {
  write_element_block(out, 2, entity, msh_triangle_of_6, triangles, [&](Index t) {
    const auto& v = mesh.triangles[t].v;
    const auto m = middles.of_triangle(t);
    return std::array<std::size_t, 7>{tags.triangle(t),         tags.node(v[0]),           tags.node(v[1]),
                                      tags.node(v[2]),          tag_of_middle(mesh, m[0]), tag_of_middle(mesh, m[1]),
                                      tag_of_middle(mesh, m[2])};
  });
}

void write_elements(MshRows& out, const MshModel& model, const Mesh& mesh, const Tags& tags,
                    const SecondOrder* second) {
  const std::size_t n = tags.lines + mesh.triangles.size();
  out.open("Elements");
  out.row(model.lines.groups_in_use() + model.triangles.groups_in_use(), n, std::size_t{n > 0}, n);
  for (std::size_t c = 0; c < model.curves.size(); ++c) {
    if (second == nullptr)
      write_line_block(out, model.curves[c].tag, model.lines[c], mesh, tags);
    else
      write_lines_of_3(out, model.curves[c].tag, model.lines[c], mesh, tags, second->middles);
  }
  for (std::size_t s = 0; s < model.surfaces.size(); ++s) {
    if (second == nullptr)
      write_triangle_block(out, model.surfaces[s].tag, model.triangles[s], mesh, tags);
    else
      write_triangles_of_6(out, model.surfaces[s].tag, model.triangles[s], mesh, tags, second->middles);
  }
  out.close("Elements");
}

}  // namespace

Status write_msh(const Mesh& mesh, const std::filesystem::path& file, MshEncoding encoding, ElementOrder elements,
                 const GoOn& go_on) {
  OutputFile out(file, go_on);
  MshRows rows(out, encoding);
  const MshModel model = msh_model(mesh, values_of(mesh));
  const Tags tags{mesh.constrained_edges.size()};
  std::optional<SecondOrder> second;
  if (elements == ElementOrder::second) second = second_order(mesh, model);
  const SecondOrder* const order = second ? &*second : nullptr;
  rows.format();
  write_names(rows, model);
  write_entities(rows, model);
  write_nodes(rows, model, mesh, tags, order);
  write_elements(rows, model, mesh, tags, order);
  const std::vector<Field> extended = second ? with_middles(mesh.fields, second->middles) : std::vector<Field>{};
  write_fields(
      rows, second ? extended : mesh.fields, [&](Index v) { return tags.node(v); },
      [&](Index t) { return tags.triangle(t); });
  return out.commit();
}

}  // namespace pardel
