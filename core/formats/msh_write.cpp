// Writes Gmsh's MSH 4.1, ASCII and binary (gmsh.info, "MSH file format"). Regions and markers are physical groups, each
// with one entity: surfaces `region ATTRIBUTE` (`domain` for triangles without a region), curves `marker NUMBER`. The
// tag of a group is the attribute or marker itself if that is a positive int, else the smallest free number. A marker
// or a region with a name of its own has the group of this name. Fields are $NodeData and $ElementData.
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

void write_nodes(MshRows& out, const MshModel& model, const Mesh& mesh, const Tags& tags) {
  const std::size_t n = mesh.points.size(), curves = model.curves.size(), entities = curves + model.surfaces.size();
  const Gathered points = gather(n, entities, [&](std::size_t i) { return model.entity_of_point[i]; });
  out.open("Nodes");
  out.row(points.groups_in_use(), n, std::size_t{n > 0}, n);
  for (std::size_t c = 0; c < curves; ++c) write_node_block(out, 1, model.curves[c].tag, points[c], mesh, tags);
  for (std::size_t s = 0; s < model.surfaces.size(); ++s)
    write_node_block(out, 2, model.surfaces[s].tag, points[curves + s], mesh, tags);
  out.close("Nodes");
}

void write_elements(MshRows& out, const MshModel& model, const Mesh& mesh, const Tags& tags) {
  const std::size_t n = tags.lines + mesh.triangles.size();
  out.open("Elements");
  out.row(model.lines.groups_in_use() + model.triangles.groups_in_use(), n, std::size_t{n > 0}, n);
  for (std::size_t c = 0; c < model.curves.size(); ++c)
    write_line_block(out, model.curves[c].tag, model.lines[c], mesh, tags);
  for (std::size_t s = 0; s < model.surfaces.size(); ++s)
    write_triangle_block(out, model.surfaces[s].tag, model.triangles[s], mesh, tags);
  out.close("Elements");
}

}  // namespace

Status write_msh(const Mesh& mesh, const std::filesystem::path& file, MshEncoding encoding) {
  OutputFile out(file);
  MshRows rows(out, encoding);
  const MshModel model = msh_model(mesh, values_of(mesh));
  const Tags tags{mesh.constrained_edges.size()};
  rows.format();
  write_names(rows, model);
  write_entities(rows, model);
  write_nodes(rows, model, mesh, tags);
  write_elements(rows, model, mesh, tags);
  write_fields(
      rows, mesh, [&](Index v) { return tags.node(v); }, [&](Index t) { return tags.triangle(t); });
  return out.commit();
}

}  // namespace pardel
