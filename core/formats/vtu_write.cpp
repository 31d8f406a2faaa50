// Writes VTU, VTK's XML format for unstructured grids (version 1.0). The arrays are appended as raw bytes.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <functional>
#include <numbers>

#include "../formats.hpp"
#include "../support/mesh_edges.hpp"
#include "records.hpp"

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

template <class T>
std::string type_name() {
  return (std::is_floating_point_v<T> ? "Float" : std::is_signed_v<T> ? "Int" : "UInt") + std::to_string(8 * sizeof(T));
}

/// n tuples of `components` values of type T; format(bytes, i) appends tuple i.
template <class T, class Format>
AppendedArray array_of(std::string name, std::size_t components, std::size_t n, Format format) {
  return {type_name<T>(), std::move(name), components, n * components * sizeof(T),
          [n, format = std::move(format)](OutputFile& out) { write_records(out, n, format); }};
}

/// The smallest angle in degrees, which lies opposite the shortest edge; 0 if the triangle is flat.
double smallest_angle(const std::array<Point, 3>& p) {
  const auto squared_length = [&](std::size_t i) {  // of the edge opposite corner i
    const Point& a = p[(i + 1) % 3];
    const Point& b = p[(i + 2) % 3];
    return (b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y);
  };
  const std::array<double, 3> lengths{squared_length(0), squared_length(1), squared_length(2)};
  const auto at = static_cast<std::size_t>(std::min_element(lengths.begin(), lengths.end()) - lengths.begin());
  const Point& a = p[(at + 1) % 3];
  const Point& b = p[(at + 2) % 3];
  const double ux = a.x - p[at].x, uy = a.y - p[at].y, vx = b.x - p[at].x, vy = b.y - p[at].y;
  return std::atan2(std::abs(ux * vy - uy * vx), ux * vx + uy * vy) * (180 / std::numbers::pi);
}

using Section = std::pair<std::string, std::vector<AppendedArray>>;

std::size_t cell_count(const Mesh& mesh) { return mesh.triangles.size() + mesh.constrained_edges.size(); }

/// The cells: first the triangles, then the constrained edges as lines. Corners and offsets are integers of type Id. If
/// 32 bits suffice, the file is half as large as with 64 bits.
template <class Id>
Section cells(const Mesh& mesh) {
  const std::size_t n = mesh.triangles.size(), corners = 3 * n;
  Section section{"Cells", {}};
  section.second.push_back(
      array_of<Id>("connectivity", 1, corners + 2 * mesh.constrained_edges.size(), [&mesh](Bytes& to, std::size_t i) {
        const std::size_t of_triangles = 3 * mesh.triangles.size();
        if (i < of_triangles) return void(to.raw(static_cast<Id>(mesh.triangles[i / 3].v[i % 3])));
        const ConstrainedEdge& edge = mesh.constrained_edges[(i - of_triangles) / 2];
        to.raw(static_cast<Id>((i - of_triangles) % 2 == 0 ? edge.a : edge.b));
      }));
  section.second.push_back(array_of<Id>("offsets", 1, cell_count(mesh), [n](Bytes& to, std::size_t i) {
    to.raw(static_cast<Id>(i < n ? 3 * (i + 1) : 3 * n + 2 * (i - n + 1)));
  }));
  static constexpr std::uint8_t vtk_line = 3, vtk_triangle = 5;
  section.second.push_back(array_of<std::uint8_t>(
      "types", 1, cell_count(mesh), [n](Bytes& to, std::size_t i) { to.raw(i < n ? vtk_triangle : vtk_line); }));
  return section;
}

Section cell_data(const Mesh& mesh) {
  const std::size_t n = mesh.triangles.size();
  Section section{"CellData", {}};
  if (!mesh.region.empty()) {
    section.second.push_back(array_of<double>("region", 1, cell_count(mesh), [&mesh, n](Bytes& to, std::size_t t) {
      to.raw(t >= n || mesh.region[t] == no_index ? 0.0 : mesh.region_attributes[mesh.region[t]]);
    }));
  }
  if (!mesh.constrained_edges.empty()) {
    section.second.push_back(
        array_of<std::int32_t>("marker", 1, cell_count(mesh), [&mesh, n](Bytes& to, std::size_t i) {
          to.raw(static_cast<std::int32_t>(i < n ? 0 : mesh.constrained_edges[i - n].marker));
        }));
  }
  section.second.push_back(array_of<double>("quality", 1, cell_count(mesh), [&mesh, n](Bytes& to, std::size_t t) {
    if (t >= n) return void(to.raw(std::numeric_limits<double>::quiet_NaN()));
    const auto& v = mesh.triangles[t].v;
    to.raw(smallest_angle({mesh.points[v[0]], mesh.points[v[1]], mesh.points[v[2]]}));
  }));
  return section;
}

Section point_data(const Mesh& mesh, const Array<int>& markers) {
  Section section{"PointData", {}};
  section.second.push_back(array_of<std::int32_t>("marker", 1, markers.size(), [&markers](Bytes& to, std::size_t i) {
    to.raw(static_cast<std::int32_t>(markers[i]));
  }));
  if (const std::size_t k = mesh.attributes_per_point; k > 0) {
    section.second.push_back(
        array_of<double>("attributes", k, mesh.points.size(), [&mesh, k](Bytes& to, std::size_t i) {
          for (std::size_t j = 0; j < k; ++j) to.raw(mesh.point_attributes[i * k + j]);
        }));
  }
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

}  // namespace

Status write_vtu(const Mesh& mesh, const std::filesystem::path& file) {
  OutputFile out(file);
  const std::size_t n = mesh.points.size();
  const Array<int> markers = vertex_markers(mesh);
  Section points{"Points", {}};
  points.second.push_back(array_of<double>(
      "Points", 3, n, [&](Bytes& to, std::size_t i) { to.raw(mesh.points[i].x).raw(mesh.points[i].y).raw(0.0); }));
  constexpr std::size_t most = std::numeric_limits<std::int32_t>::max();
  const bool small = n <= most && 3 * cell_count(mesh) <= most;
  const std::vector<Section> sections{points, small ? cells<std::int32_t>(mesh) : cells<std::int64_t>(mesh),
                                      cell_data(mesh), point_data(mesh, markers)};

  Bytes header;
  header << "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\""
         << (std::endian::native == std::endian::little ? "LittleEndian" : "BigEndian")
         << "\" header_type=\"UInt64\">\n<UnstructuredGrid>\n<Piece NumberOfPoints=\"" << n << "\" NumberOfCells=\""
         << cell_count(mesh) << "\">\n";
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
  return out.commit();
}

}  // namespace pardel
