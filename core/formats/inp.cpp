// Writes Abaqus' input file, which CalculiX reads, too. A line with a star is a keyword, one with two stars a comment.
#include <algorithm>
#include <array>

#include "../formats.hpp"
#include "../support/mesh_edges.hpp"
#include "../support/without_repetitions.hpp"
#include "msh_model.hpp"
#include "records.hpp"

namespace pardel {
using namespace files;
namespace {

/// A comment with the name of the group, then a keyword with the name of its set.
void write_set(OutputFile& out, std::string_view keyword, std::string_view prefix, const MshGroup& group) {
  Bytes to;
  to << "** " << group.name << '\n' << keyword << prefix << group.tag << '\n';
  out.write(to.view());
}

void write_elements(OutputFile& out, const Mesh& mesh, const MshGroup& group, std::span<const Index> triangles) {
  if (triangles.empty()) return;
  write_set(out, "*ELEMENT, TYPE=CPS3, ELSET=", "REGION_", group);
  write_records(out, triangles.size(), [&](Bytes& to, std::size_t i) {
    const auto& v = mesh.triangles[triangles[i]].v;
    to << std::uint64_t{triangles[i]} + 1;
    for (const Index corner : v) to << ", " << std::uint64_t{corner} + 1;
    to << '\n';
  });
}

/// The nodes of the constrained edges of a group, each once, in ascending order, 16 per line.
void write_node_set(OutputFile& out, const Mesh& mesh, const MshGroup& group, std::span<const Index> lines) {
  constexpr std::size_t per_line = 16;
  std::vector<Index> nodes;
  for (const Index i : lines) nodes.insert(nodes.end(), {mesh.constrained_edges[i].a, mesh.constrained_edges[i].b});
  sort_without_repetitions(nodes);
  write_set(out, "*NSET, NSET=", "MARKER_", group);
  write_records(out, nodes.size(), [&](Bytes& to, std::size_t i) {
    to << std::uint64_t{nodes[i]} + 1 << ((i + 1) % per_line == 0 || i + 1 == nodes.size() ? "\n" : ", ");
  });
}

/// A side of a triangle at the boundary. Side S1 joins the first two nodes of an element, S2 the next two.
struct Side {
  Index triangle;
  int number;
};

/// The sides at the boundary by the group of their constrained edge; the others are left out.
std::vector<std::vector<Side>> sides_of(const Mesh& mesh, const MshModel& model) {
  std::vector<std::size_t> group_of_line(mesh.constrained_edges.size());
  for (std::size_t c = 0; c < model.curves.size(); ++c)
    for (const Index i : model.lines[c]) group_of_line[i] = c;
  std::vector<std::vector<Side>> sides(model.curves.size());
  const ConstrainedEdgeIndex constrained(mesh);
  for (Index t = 0; t < mesh.triangles.size(); ++t) {
    const Triangle& triangle = mesh.triangles[t];
    for (std::size_t i = 0; i < 3; ++i) {
      if (triangle.n[(i + 2) % 3] != no_index) continue;
      const ConstrainedEdge* edge = constrained.find(triangle.v[i], triangle.v[(i + 1) % 3]);
      if (edge == nullptr) continue;
      const auto line = static_cast<std::size_t>(edge - mesh.constrained_edges.data());
      sides[group_of_line[line]].push_back({t, static_cast<int>(i) + 1});
    }
  }
  return sides;
}

void write_surface(OutputFile& out, const MshGroup& group, const std::vector<Side>& sides) {
  if (sides.empty()) return;
  write_set(out, "*SURFACE, TYPE=ELEMENT, NAME=", "SIDES_", group);
  write_records(out, sides.size(), [&](Bytes& to, std::size_t i) {
    to << std::uint64_t{sides[i].triangle} + 1 << ", S" << sides[i].number << '\n';
  });
}

}  // namespace

Status write_inp(const Mesh& mesh, const std::filesystem::path& file, const GoOn& go_on) {
  const MshModel model = msh_model(mesh, values_of(mesh));
  const std::vector<std::vector<Side>> sides = sides_of(mesh, model);
  OutputFile out(file, go_on);
  out.write("*HEADING\npardel\n*NODE, NSET=ALL\n");
  write_records(out, mesh.points.size(), [&](Bytes& to, std::size_t i) {
    to << i + 1 << ", " << mesh.points[i].x << ", " << mesh.points[i].y << ", 0\n";
  });
  for (std::size_t s = 0; s < model.surfaces.size(); ++s)
    write_elements(out, mesh, model.surfaces[s], model.triangles[s]);
  for (std::size_t c = 0; c < model.curves.size(); ++c) {
    if (model.lines[c].empty()) continue;
    write_node_set(out, mesh, model.curves[c], model.lines[c]);
    write_surface(out, model.curves[c], sides[c]);
  }
  return out.commit();
}

}  // namespace pardel
