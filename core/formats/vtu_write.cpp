// Writes VTU, VTK's XML format for unstructured grids (version 1.0). The arrays are appended as raw bytes.
#include <algorithm>
#include <array>
#include <bit>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <span>

#include "../formats.hpp"
#include "../support/mesh_edges.hpp"
#include "../support/smallest_angle.hpp"
#include "middles.hpp"
#include "records.hpp"
#include "vtk_cells.hpp"
#include "vtu_names.hpp"

namespace pardel {
using namespace files;
namespace {

/// One array: the attributes of its element in the header, and a function that writes its bytes after the header.
struct AppendedArray {
  std::string type;
  std::string name;
  std::size_t components;
  std::size_t bytes;
  std::function<void(OutputFile&)> write;
};
/// For a piece of a mesh, also for an empty one: the numbers of its points.
using PieceNumbers = std::optional<std::span<const std::uint64_t>>;
/// The middles of the edges; null for elements of first order.
using MaybeMiddles = const Middles*;
using Section = std::pair<std::string, std::vector<AppendedArray>>;

template <class T>
std::string type_name() {
  const std::string bits = std::to_string(8 * sizeof(T));
  if constexpr (std::is_floating_point_v<T>) return "Float" + bits;
  if constexpr (std::is_signed_v<T>) return "Int" + bits;
  return "UInt" + bits;
}

/// An array that is in memory as it is in the file.
template <class T>
AppendedArray stored_array(std::string name, std::size_t components, std::span<const T> values) {
  const std::string_view bytes(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
  return {type_name<T>(), std::move(name), components, bytes.size(), [bytes](OutputFile& out) { out.write(bytes); }};
}

/// The cells are first the triangles, then the constrained edges as lines.
std::size_t cell_count(const Mesh& mesh) { return mesh.triangles.size() + mesh.constrained_edges.size(); }

/// An array of the cells: of_triangle(t) and of_line(i) return a T or several.
template <class T, class OfTriangle, class OfLine>
AppendedArray cell_array(std::string name, const Mesh& mesh, OfTriangle of_triangle, OfLine of_line) {
  const std::size_t triangles = mesh.triangles.size(), lines = mesh.constrained_edges.size();
  return {type_name<T>(), std::move(name), 1,
          triangles * sizeof(of_triangle(std::size_t{})) + lines * sizeof(of_line(std::size_t{})),
          [=](OutputFile& out) {
            write_values(out, triangles, of_triangle);
            write_values(out, lines, of_line);
          }};
}

/// The nodes of the cells, and where they end. They are integers of type Id.
template <class Id>
AppendedArray connectivity(const Mesh& mesh, MaybeMiddles second) {
  const auto corners = [&mesh](std::size_t t) {
    const auto& v = mesh.triangles[t].v;
    return std::array<Id, 3>{static_cast<Id>(v[0]), static_cast<Id>(v[1]), static_cast<Id>(v[2])};
  };
  const auto ends = [&mesh](std::size_t i) {
    const ConstrainedEdge& edge = mesh.constrained_edges[i];
    return std::array<Id, 2>{static_cast<Id>(edge.a), static_cast<Id>(edge.b)};
  };
  if (second == nullptr) return cell_array<Id>("connectivity", mesh, corners, ends);
  const auto middle = [&mesh](Index m) { return static_cast<Id>(mesh.points.size() + m); };
  return cell_array<Id>(
      "connectivity", mesh,
      [=](std::size_t t) {
        const std::array<Id, 3> v = corners(t);
        const std::array<Index, 3> m = second->of_triangle(t);
        return std::array<Id, 6>{v[0], v[1], v[2], middle(m[0]), middle(m[1]), middle(m[2])};
      },
      [=](std::size_t i) {
        const std::array<Id, 2> v = ends(i);
        return std::array<Id, 3>{v[0], v[1], middle(second->of_line[i])};
      });
}

/// If 32 bits suffice for Id, the file is half as large as with 64 bits.
template <class Id>
Section cells(const Mesh& mesh, MaybeMiddles second) {
  const std::size_t n = mesh.triangles.size(), of_triangle = second == nullptr ? 3 : 6,
                    of_line = second == nullptr ? 2 : 3;
  const auto offsets = cell_array<Id>(
      "offsets", mesh, [=](std::size_t t) { return static_cast<Id>(of_triangle * (t + 1)); },
      [=](std::size_t i) { return static_cast<Id>(of_triangle * n + of_line * (i + 1)); });
  const std::uint8_t triangle = second == nullptr ? vtk_triangle : vtk_triangle_of_6,
                     line = second == nullptr ? vtk_line : vtk_line_of_3;
  const auto types = cell_array<std::uint8_t>(
      "types", mesh, [=](std::size_t) { return triangle; }, [=](std::size_t) { return line; });
  return {"Cells", {connectivity<Id>(mesh, second), offsets, types}};
}

AppendedArray quality(const Mesh& mesh) {
  return cell_array<double>(
      vtu_quality, mesh,
      [&mesh](std::size_t t) {
        const auto& v = mesh.triangles[t].v;
        return smallest_angle({mesh.points[v[0]], mesh.points[v[1]], mesh.points[v[2]]});
      },
      [](std::size_t) { return std::numeric_limits<double>::quiet_NaN(); });
}

/// Adds the fields in the triangles. Lines have no values.
void put_fields_in_triangles(std::vector<AppendedArray>& arrays, const Mesh& mesh) {
  const std::vector<std::string> names = names_of_vtu_fields(mesh);
  for (std::size_t i = 0; i < mesh.fields.size(); ++i) {
    const Field& field = mesh.fields[i];
    if (field.place != Field::Place::triangles) continue;
    AppendedArray array = stored_array(xml_value(names[i]), field.components, field.values.span());
    const std::size_t more = mesh.constrained_edges.size() * field.components;
    array.bytes += more * sizeof(double);
    array.write = [triangles = std::move(array.write), more](OutputFile& out) {
      triangles(out);
      write_values(out, more, [](std::size_t) { return std::numeric_limits<double>::quiet_NaN(); });
    };
    arrays.push_back(std::move(array));
  }
}

/// always_markers: for a piece, because all pieces of a mesh have the same arrays.
Section cell_data(const Mesh& mesh, bool always_markers) {
  Section section{"CellData", {}};
  const bool is_empty_piece = always_markers && mesh.triangles.empty();
  if (!mesh.region.empty() || (is_empty_piece && !mesh.region_attributes.empty())) {
    section.second.push_back(cell_array<double>(
        "region", mesh,
        [&mesh](std::size_t t) {
          const Index region = mesh.region[t];
          return region == no_index ? 0.0 : mesh.region_attributes[region];
        },
        [](std::size_t) { return 0.0; }));
  }
  if (!mesh.constrained_edges.empty() || always_markers) {
    section.second.push_back(cell_array<std::int32_t>(
        "marker", mesh, [](std::size_t) { return std::int32_t{0}; },
        [&mesh](std::size_t i) { return std::int32_t{mesh.constrained_edges[i].marker}; }));
  }
  put_fields_in_triangles(section.second, mesh);
  if (!has_own_quality(mesh)) section.second.push_back(quality(mesh));
  return section;
}

/// An array of the points: the values of the vertices, then those of the middles, of_middle(m).
template <class T, class OfMiddle>
AppendedArray point_array(std::string name, std::size_t components, std::span<const T> values, MaybeMiddles second,
                          OfMiddle of_middle) {
  AppendedArray array = stored_array(std::move(name), components, values);
  if (second == nullptr) return array;
  const std::size_t middles = second->edges.size();
  array.bytes += middles * components * sizeof(T);
  array.write = [write = array.write, middles, components, of_middle](OutputFile& out) {
    write(out);
    write_values(out, middles * components, of_middle);
  };
  return array;
}

/// The values at a middle are the means of those at the ends of its edge.
AppendedArray real_array_of_points(std::string name, std::size_t components, const Array<double>& values,
                                   MaybeMiddles second) {
  return point_array(std::move(name), components, values.span(), second,
                     [&values, second, components](std::size_t i) { return second->mean(values, components, i); });
}

void put_fields_at_points(std::vector<AppendedArray>& arrays, const Mesh& mesh, MaybeMiddles second) {
  const std::vector<std::string> names = names_of_vtu_fields(mesh);
  for (std::size_t i = 0; i < mesh.fields.size(); ++i)
    if (const Field& field = mesh.fields[i]; field.place == Field::Place::points)
      arrays.push_back(real_array_of_points(xml_value(names[i]), field.components, field.values, second));
}

/// `inferred`: for vertex_markers(), because all pieces have markers.
Section point_data(const Mesh& mesh, Array<int>& inferred, const PieceNumbers& numbers, MaybeMiddles second) {
  Section section{"PointData", {}};
  if (numbers || !mesh.point_markers.empty())
    section.second.push_back(point_array("marker", 1, vertex_markers(mesh, inferred), second,
                                         [second](std::size_t m) { return second->edges[m].marker; }));
  if (numbers) section.second.push_back(stored_array(vtu_vertex_numbers, 1, *numbers));
  if (const std::size_t k = mesh.attributes_per_point; k > 0)
    section.second.push_back(real_array_of_points("attributes", k, mesh.point_attributes, second));
  put_fields_at_points(section.second, mesh, second);
  return section;
}

/// Appends the elements of a section. `offset` is the start of its first array and becomes the end of its last array.
void put_section(Bytes& to, const Section& section, std::size_t& offset) {
  const auto& [name, arrays] = section;
  to << "<" << name << ">\n";
  for (const AppendedArray& array : arrays) {
    to << "<DataArray type=\"" << array.type << "\" Name=\"" << array.name << "\" NumberOfComponents=\""
       << array.components << "\" format=\"appended\" offset=\"" << offset << "\"/>\n";
    offset += sizeof(std::uint64_t) + array.bytes;
  }
  to << "</" << name << ">\n";
}

/// The names of markers and regions as field data: the marker and 1, or the attribute and 2.
void put_names(Bytes& to, const Mesh& mesh) {
  if (mesh.names.empty()) return;
  to << "<FieldData>\n";
  for (const GroupName& name : mesh.names)
    to << "<DataArray type=\"Int64\" Name=\"" << xml_value(name.name) << "\" NumberOfTuples=\"2\" format=\"ascii\">"
       << name.value << (name.of == GroupName::Of::marker ? " 1" : " 2") << "</DataArray>\n";
  to << "</FieldData>\n";
}

void write(const Mesh& mesh, const PieceNumbers& numbers, MaybeMiddles second, OutputFile& out) {
  const std::size_t vertices = mesh.points.size(), middles = second == nullptr ? 0 : second->edges.size();
  const std::size_t n = vertices + middles;
  Array<int> inferred;
  const auto write_points = [&mesh, vertices, middles, second](OutputFile& to) {
    write_values(to, vertices, [&mesh](std::size_t i) {
      return std::array<double, 3>{mesh.points[i].x, mesh.points[i].y, 0.0};
    });
    write_values(to, middles, [&mesh, second](std::size_t m) {
      const Point p = second->point(mesh, m);
      return std::array<double, 3>{p.x, p.y, 0.0};
    });
  };
  const Section points{"Points", {{type_name<double>(), "Points", 3, 3 * n * sizeof(double), write_points}}};
  constexpr std::size_t most = std::numeric_limits<std::int32_t>::max();
  const bool small = n <= most && (second == nullptr ? 3 : 6) * cell_count(mesh) <= most;
  const std::vector<Section> sections{
      points, small ? cells<std::int32_t>(mesh, second) : cells<std::int64_t>(mesh, second),
      cell_data(mesh, numbers.has_value()), point_data(mesh, inferred, numbers, second)};

  Bytes header;
  header << "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\""
         << (std::endian::native == std::endian::little ? "LittleEndian" : "BigEndian")
         << "\" header_type=\"UInt64\">\n<UnstructuredGrid>\n";
  put_names(header, mesh);
  header << "<Piece NumberOfPoints=\"" << n << "\" NumberOfCells=\"" << cell_count(mesh) << "\">\n";
  std::size_t offset = 0;
  for (const Section& section : sections) put_section(header, section, offset);
  header << "</Piece>\n</UnstructuredGrid>\n<AppendedData encoding=\"raw\">\n_";
  out.write(header.view());
  for (const Section& section : sections) {
    for (const AppendedArray& array : section.second) {
      out.write(Bytes().raw(std::uint64_t{array.bytes}).view());
      array.write(out);
    }
  }
  out.write("\n</AppendedData>\n</VTKFile>\n");
}

/// The element of an array in a .pvtu.
void put_array(Bytes& to, const char* type, const char* name, std::size_t components = 1) {
  to << "<PDataArray type=\"" << type << "\" Name=\"" << name << "\" NumberOfComponents=\"" << components << "\"/>\n";
}

}  // namespace

Status write_vtu(const Mesh& mesh, const std::filesystem::path& file, ElementOrder elements, const GoOn& go_on) {
  OutputFile out(file, go_on);
  std::optional<Middles> middles;
  if (elements == ElementOrder::second) middles = middles_of(mesh);
  write(mesh, std::nullopt, middles ? &*middles : nullptr, out);
  return out.commit();
}

struct VtuPieces::Files {
  std::deque<OutputFile> all;
};

VtuPieces::VtuPieces() : files_(std::make_unique<Files>()) {}
VtuPieces::~VtuPieces() = default;

Status VtuPieces::add(const Mesh& mesh, std::span<const std::uint64_t> numbers, const std::filesystem::path& file) {
  // A file without a name takes a descriptor until commit(), and a process has few (usually 1,024).
  constexpr std::size_t most_unnamed = 200;
  using enum OutputFile::Aside;
  OutputFile& out = files_->all.emplace_back(file, files_->all.size() < most_unnamed ? unnamed : named);
  write(mesh, numbers, nullptr, out);
  return out.close();
}

Status VtuPieces::commit(const std::function<Status(const Status& placed)>& agree) {
  return commit_all(files_->all, agree);
}

Status write_pvtu(const PiecesOfMesh& pieces, const std::filesystem::path& file) {
  Bytes text;
  text << "<?xml version=\"1.0\"?>\n<VTKFile type=\"PUnstructuredGrid\" version=\"1.0\" byte_order=\""
       << (std::endian::native == std::endian::little ? "LittleEndian" : "BigEndian")
       << "\" header_type=\"UInt64\">\n<PUnstructuredGrid GhostLevel=\"0\">\n<PPoints>\n";
  put_array(text, "Float64", "Points", 3);
  text << "</PPoints>\n<PCellData>\n";
  if (pieces.have_regions) put_array(text, "Float64", "region");
  put_array(text, "Int32", "marker");
  put_array(text, "Float64", "quality");
  text << "</PCellData>\n<PPointData>\n";
  put_array(text, "Int32", "marker");
  put_array(text, "UInt64", vtu_vertex_numbers);
  if (pieces.attributes_per_point > 0) put_array(text, "Float64", "attributes", pieces.attributes_per_point);
  text << "</PPointData>\n";
  for (const std::string& name : pieces.files) text << "<Piece Source=\"" << name << "\"/>\n";
  text << "</PUnstructuredGrid>\n</VTKFile>\n";
  OutputFile out(file);
  out.write(text.view());
  return out.commit();
}

}  // namespace pardel
