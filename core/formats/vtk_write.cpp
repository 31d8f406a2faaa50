// Writes legacy files of VTK as text: the cells are the triangles, then the constrained edges as lines.
#include <algorithm>
#include <string>
#include <vector>

#include "../formats.hpp"
#include "records.hpp"
#include "vtk_names.hpp"
#include "vtu_names.hpp"

namespace pardel {
using namespace files;
namespace {

/// One row per cell: put_triangle(to, t), then put_line(to, i).
template <class PutTriangle, class PutLine>
void write_cells(OutputFile& out, const Mesh& mesh, const PutTriangle& put_triangle, const PutLine& put_line) {
  write_records(out, mesh.triangles.size(), [&](Bytes& to, std::size_t t) {
    put_triangle(to, t);
    to << '\n';
  });
  write_records(out, mesh.constrained_edges.size(), [&](Bytes& to, std::size_t i) {
    put_line(to, mesh.constrained_edges[i]);
    to << '\n';
  });
}

void write_geometry(OutputFile& out, const Mesh& mesh) {
  const std::size_t triangles = mesh.triangles.size(), lines = mesh.constrained_edges.size();
  out.write((Bytes() << "POINTS " << mesh.points.size() << " double\n").view());
  write_records(out, mesh.points.size(),
                [&](Bytes& to, std::size_t i) { to.numbers(mesh.points[i].x, mesh.points[i].y) << " 0\n"; });
  out.write((Bytes() << "CELLS " << triangles + lines << ' ' << 4 * triangles + 3 * lines << '\n').view());
  write_cells(
      out, mesh,
      [&](Bytes& to, std::size_t t) {
        const auto& v = mesh.triangles[t].v;
        to.numbers(3, v[0], v[1], v[2]);
      },
      [](Bytes& to, const ConstrainedEdge& edge) { to.numbers(2, edge.a, edge.b); });
  out.write((Bytes() << "CELL_TYPES " << triangles + lines << '\n').view());
  write_cells(
      out, mesh, [](Bytes& to, std::size_t) { to << '5'; }, [](Bytes& to, const ConstrainedEdge&) { to << '3'; });
}

/// The names of the fields as words.
std::vector<std::string> names_of_fields(const Mesh& mesh) {
  std::vector<std::string> names = names_of_vtu_fields(mesh);
  std::ranges::transform(names, names.begin(), word_in_vtk);
  return names;
}

std::size_t count_fields(const Mesh& mesh, Field::Place place) {
  return static_cast<std::size_t>(std::ranges::count(mesh.fields, place, &Field::place));
}

void put_row(Bytes& to, const Array<double>& values, std::size_t components, std::size_t i) {
  for (std::size_t j = 0; j < components; ++j) to << (j == 0 ? "" : " ") << values[i * components + j];
}

/// The fields at points or in triangles; lines have zeroes, because VTK reads no other number that means nothing.
void write_fields(OutputFile& out, const Mesh& mesh, Field::Place place, std::size_t tuples) {
  const std::vector<std::string> names = names_of_fields(mesh);
  for (std::size_t f = 0; f < mesh.fields.size(); ++f) {
    const Field& field = mesh.fields[f];
    if (field.place != place) continue;
    const std::size_t n = field.components, rows = field.values.size() / n;
    out.write((Bytes() << names[f] << ' ' << n << ' ' << tuples << " double\n").view());
    write_records(out, tuples, [&](Bytes& to, std::size_t i) {
      if (i < rows) put_row(to, field.values, n, i);
      for (std::size_t j = 0; i >= rows && j < n; ++j) to << (j == 0 ? "0" : " 0");
      to << '\n';
    });
  }
}

void write_cell_data(OutputFile& out, const Mesh& mesh) {
  const std::size_t cells = mesh.triangles.size() + mesh.constrained_edges.size();
  const bool has_regions = !mesh.region.empty(), has_markers = !mesh.constrained_edges.empty();
  const std::size_t arrays =
      std::size_t{has_regions} + std::size_t{has_markers} + count_fields(mesh, Field::Place::triangles);
  if (arrays == 0) return;
  out.write((Bytes() << "CELL_DATA " << cells << "\nFIELD FieldData " << arrays << '\n').view());
  if (has_regions) {
    out.write((Bytes() << "region 1 " << cells << " double\n").view());
    write_cells(
        out, mesh,
        [&](Bytes& to, std::size_t t) {
          to << (mesh.region[t] == no_index ? 0.0 : mesh.region_attributes[mesh.region[t]]);
        },
        [](Bytes& to, const ConstrainedEdge&) { to << '0'; });
  }
  if (has_markers) {
    out.write((Bytes() << "marker 1 " << cells << " int\n").view());
    write_cells(
        out, mesh, [](Bytes& to, std::size_t) { to << '0'; },
        [](Bytes& to, const ConstrainedEdge& edge) { to << edge.marker; });
  }
  write_fields(out, mesh, Field::Place::triangles, cells);
}

void write_point_data(OutputFile& out, const Mesh& mesh) {
  const std::size_t n = mesh.points.size(), k = mesh.attributes_per_point;
  const bool has_markers = !mesh.point_markers.empty(), has_attributes = k > 0;
  const std::size_t arrays =
      std::size_t{has_markers} + std::size_t{has_attributes} + count_fields(mesh, Field::Place::points);
  if (arrays == 0) return;
  out.write((Bytes() << "POINT_DATA " << n << "\nFIELD FieldData " << arrays << '\n').view());
  if (has_markers) {
    out.write((Bytes() << "marker 1 " << n << " int\n").view());
    write_records(out, n, [&](Bytes& to, std::size_t i) { to << mesh.point_markers[i] << '\n'; });
  }
  if (has_attributes) {
    out.write((Bytes() << "attributes " << k << ' ' << n << " double\n").view());
    write_records(out, n, [&](Bytes& to, std::size_t i) {
      put_row(to, mesh.point_attributes, k, i);
      to << '\n';
    });
  }
  write_fields(out, mesh, Field::Place::points, n);
}

}  // namespace

Status write_vtk(const Mesh& mesh, const std::filesystem::path& file, const GoOn& go_on) {
  OutputFile out(file, go_on);
  out.write("# vtk DataFile Version 3.0\npardel\nASCII\nDATASET UNSTRUCTURED_GRID\n");
  write_geometry(out, mesh);
  write_cell_data(out, mesh);
  write_point_data(out, mesh);
  return out.commit();
}

}  // namespace pardel
