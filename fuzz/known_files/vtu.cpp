// Meshes as other programs write them in .vtu: each array as text or base64 or in the appended data, numbers of several
// types, plain or compressed.
#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "../../core/support/shortest.hpp"
#include "../fuzz_one.hpp"
#include "formats.hpp"
#include "values.hpp"

namespace pardel::fuzz {
namespace {

using generators::Random;

std::string base64(std::string_view bytes) {
  constexpr const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t n = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k)
      group = group << 8U | (k < n ? static_cast<std::uint8_t>(bytes[i + k]) : std::uint8_t{0});
    for (std::size_t k = 0; k < 4; ++k) text += k <= n ? digits[group >> (18 - 6 * k) & 63U] : '=';
  }
  return text;
}

template <class Stored>
void append(std::string& bytes, double value) {
  const auto stored = static_cast<Stored>(value);
  bytes.append(reinterpret_cast<const char*>(&stored), sizeof stored);
}

/// A .vtu that grows array by array. The file has one kind of headers, and is compressed or not.
class VtuText {
 public:
  explicit VtuText(Random& random)
      : random_(random), long_headers_(random.chance(2)), compressed_(random.chance(2)), raw_(random.chance(2)) {}

  [[nodiscard]] std::string root() const {
    return std::string(
               "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" "
               "byte_order=\"LittleEndian\" header_type=\"") +
           (long_headers_ ? "UInt64\"" : "UInt32\"") +
           (compressed_ ? " compressor=\"vtkZLibDataCompressor\">\n" : ">\n");
  }

  /// `type`: Float64, Float32, Int64, Int32 or UInt8, which can hold all values.
  std::string array(const std::string& name, const std::string& type, const std::vector<double>& values,
                    int components = 1) {
    std::string element = "<DataArray type=\"" + type + "\" Name=\"" + name + "\" NumberOfComponents=\"" +
                          std::to_string(components) + "\" format=\"";
    const std::size_t format = random_.below(3);
    if (format == 0) return element + "ascii\">" + listed(type, values) + "</DataArray>\n";
    const std::vector<std::string> parts = encoded(type, values);
    if (format == 1) return element + "binary\">\n" + in_base64(parts) + "\n</DataArray>\n";
    element += "appended\" offset=\"" + std::to_string(appended_.size()) + "\"/>\n";
    for (const std::string& part : parts) appended_ += raw_ ? part : "";
    if (!raw_) appended_ += in_base64(parts);
    return element;
  }

  [[nodiscard]] std::string appended() const {
    if (appended_.empty()) return {};
    return std::string("<AppendedData encoding=\"") + (raw_ ? "raw" : "base64") + "\">\n_" + appended_ +
           "\n</AppendedData>\n";
  }

 private:
  std::string listed(const std::string& type, const std::vector<double>& values) {
    const bool is_whole = !type.starts_with("Float");
    std::string list;
    for (const double x : values)
      list +=
          (random_.chance(4) ? "\n" : " ") + (is_whole ? std::to_string(static_cast<std::int64_t>(x)) : shortest(x));
    return list;
  }

  void append_header(std::string& header, std::size_t number) const {
    header.append(reinterpret_cast<const char*>(&number), long_headers_ ? 8 : 4);
  }

  /// The parts that are encoded one after another: VTK encodes the header of compressed data separately, and other
  /// programs also that of plain data.
  std::vector<std::string> encoded(const std::string& type, const std::vector<double>& values) {
    std::string bytes;
    for (const double x : values) {
      if (type == "Float64") append<double>(bytes, x);
      if (type == "Float32") append<float>(bytes, x);
      if (type == "Int64") append<std::int64_t>(bytes, x);
      if (type == "Int32") append<std::int32_t>(bytes, x);
      if (type == "UInt8") append<std::uint8_t>(bytes, x);
    }
    if (compressed_) return compressed(bytes);
    std::string header;
    append_header(header, bytes.size());
    if (random_.chance(2)) return {header, bytes};
    return {header + bytes};
  }

  std::vector<std::string> compressed(const std::string& bytes) {
    const std::size_t block = random_.chance(2) ? 32768 : static_cast<std::size_t>(random_.between(1, 40));
    const std::size_t blocks = (bytes.size() + block - 1) / block;
    std::string header, data;
    append_header(header, blocks);
    append_header(header, block);
    append_header(header, bytes.size() % block);
    for (std::size_t i = 0; i < blocks; ++i) {
      const std::string part = bytes.substr(i * block, block);
      uLongf size = compressBound(part.size());
      std::string small(size, '\0');
      if (compress(reinterpret_cast<Bytef*>(small.data()), &size, reinterpret_cast<const Bytef*>(part.data()),
                   part.size()) != Z_OK)
        fail("zlib does not compress a block");
      append_header(header, size);
      data += small.substr(0, size);
    }
    return {header, data};
  }

  static std::string in_base64(const std::vector<std::string>& parts) {
    std::string text;
    for (const std::string& part : parts) text += base64(part);
    return text;
  }

  Random& random_;
  bool long_headers_, compressed_, raw_;
  std::string appended_;
};

/// The cells of a mesh: its triangles and, before, between or behind them, its constrained edges.
struct Cells {
  std::vector<double> connectivity, offsets, types, region, marker;
};

Cells cells_of(const Mesh& mesh, Random& random) {
  Cells cells;
  std::size_t t = 0, e = 0;
  const bool mixed = random.chance(2);
  while (t < mesh.triangles.size() || e < mesh.constrained_edges.size()) {
    const bool is_last = t == mesh.triangles.size();
    const bool is_line = is_last || (mixed && e < mesh.constrained_edges.size() && random.chance(2));
    if (is_line) {
      cells.connectivity.insert(cells.connectivity.end(), {static_cast<double>(mesh.constrained_edges[e].a),
                                                           static_cast<double>(mesh.constrained_edges[e].b)});
    } else {
      for (const Index v : mesh.triangles[t].v) cells.connectivity.push_back(v);
    }
    cells.offsets.push_back(static_cast<double>(cells.connectivity.size()));
    cells.types.push_back(is_line ? 3 : 5);
    cells.region.push_back(is_line || mesh.region.empty() ? 0 : mesh.region_attributes[mesh.region[t]]);
    cells.marker.push_back(is_line ? mesh.constrained_edges[e].marker : 0);
    ++(is_line ? e : t);
  }
  return cells;
}

/// The nearest point whose coordinates are floats. Coordinates that no float can hold become 1.
Point as_floats(Point p) {
  const auto rounded = [](double x) {
    const bool fits = std::abs(x) <= std::numeric_limits<float>::max();
    return fits ? static_cast<double>(static_cast<float>(x)) : 1.0;
  };
  return {rounded(p.x), rounded(p.y)};
}

}  // namespace

KnownFile any_vtu(Random& random) {
  Mesh mesh = any_mesh(random);
  const bool has_floats = random.chance(4);
  for (std::size_t i = 0; has_floats && i < mesh.points.size(); ++i) mesh.points[i] = as_floats(mesh.points[i]);
  const Cells cells = cells_of(mesh, random);
  VtuText file(random);
  std::vector<double> xyz, attributes, markers;
  for (const Point p : mesh.points) xyz.insert(xyz.end(), {p.x, p.y, 0});
  for (const double a : mesh.point_attributes) attributes.push_back(a);
  for (const int m : mesh.point_markers) markers.push_back(m);
  const std::string whole = random.chance(2) ? "Int64" : "Int32";

  std::string piece;
  if (!markers.empty() || !attributes.empty()) piece += "<PointData>\n";
  if (!markers.empty()) piece += file.array("marker", "Int32", markers);
  if (!attributes.empty())
    piece += file.array("attributes", "Float64", attributes, static_cast<int>(mesh.attributes_per_point));
  if (!markers.empty() || !attributes.empty()) piece += "</PointData>\n";
  piece += "<CellData>\n" + file.array("marker", whole, cells.marker);
  if (!mesh.region.empty()) piece += file.array("region", "Float64", cells.region);
  piece += "</CellData>\n<Points>\n" + file.array("Points", has_floats ? "Float32" : "Float64", xyz, 3) +
           "</Points>\n<Cells>\n" + file.array("connectivity", whole, cells.connectivity) +
           file.array("offsets", whole, cells.offsets) + file.array("types", "UInt8", cells.types) + "</Cells>\n";
  return {file.root() + "<UnstructuredGrid>\n<Piece NumberOfPoints=\"" + std::to_string(mesh.points.size()) +
              "\" NumberOfCells=\"" + std::to_string(cells.types.size()) + "\">\n" + piece +
              "</Piece>\n</UnstructuredGrid>\n" + file.appended() + "</VTKFile>\n",
          mesh};
}

}  // namespace pardel::fuzz
