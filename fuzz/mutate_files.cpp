// The mutator of the readers. From time to time it replaces the input by a correct file of a random small mesh, domain
// or raster; otherwise libFuzzer changes bytes of it. So files with all their sections need not be guessed.
#include <algorithm>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>
#include <vector>

#include "../core/formats.hpp"
#include "../core/neighbours.hpp"
#include "../properties/domains/generators/random.hpp"
#include "file_bundle.hpp"
#include "mesh_in_pieces.hpp"

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size);

namespace pardel::fuzz {
namespace {

using generators::Random;

double any_number(Random& random) { return random.chance(2) ? random.between(-9, 9) : random.uniform(-1, 1); }
Point any_point(Random& random) {
  const double x = any_number(random);
  return {x, any_number(random)};
}

Pslg any_pslg(Random& random) {
  Pslg pslg;
  const int n = random.between(3, 6);
  pslg.attributes_per_point = random.below(3);
  pslg.has_segment_markers = random.chance(2);
  const bool has_markers = random.chance(2);
  for (int i = 0; i < n; ++i) {
    pslg.points.push_back(any_point(random));
    if (has_markers) pslg.point_markers.push_back(random.between(-2, 3));
    for (std::size_t k = 0; k < pslg.attributes_per_point; ++k) pslg.point_attributes.push_back(any_number(random));
    const auto a = static_cast<Index>(i), b = static_cast<Index>((i + 1) % n);
    pslg.segments.push_back({a, b, pslg.has_segment_markers ? random.between(0, 9) : 0});
  }
  if (random.chance(2)) pslg.holes.push_back(any_point(random));
  for (int i = random.between(0, 2); i > 0; --i) {
    const Point seed = any_point(random);
    const double attribute = any_number(random);
    pslg.regions.push_back({seed, attribute, random.chance(2) ? random.uniform(0.1, 1) : Region{}.max_area});
  }
  return pslg;
}

Mesh any_mesh(Random& random) {
  Mesh mesh;
  const Pslg pslg = any_pslg(random);
  for (const Point p : pslg.points) mesh.points.push_back(p);
  mesh.attributes_per_point = pslg.attributes_per_point;
  for (const double a : pslg.point_attributes) mesh.point_attributes.push_back(a);
  for (const int marker : pslg.point_markers) mesh.point_markers.push_back(marker);
  const auto n = static_cast<Index>(mesh.points.size());
  for (Index i = 0; i + 2 < n; ++i) mesh.triangles.push_back({{0, i + 1, i + 2}, {}});
  rebuild_neighbours(mesh.triangles, n);
  if (random.chance(2)) {
    mesh.region_attributes = {-1.5, 2};
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) mesh.region.push_back(static_cast<Index>(random.below(2)));
  }
  for (const Segment& s : pslg.segments) mesh.constrained_edges.push_back({s.a, s.b, no_index, s.marker});
  return mesh;
}

std::string contents(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

/// A list of numbers, one per line, as in .area files and files of sizes.
std::string any_list(Random& random) {
  const int n = random.between(1, 5);
  std::string text = std::to_string(n) + "\n";
  for (int i = 1; i <= n; ++i) text += std::to_string(i) + " " + std::to_string(random.uniform(0.1, 9)) + "\n";
  return text;
}

std::string any_grid(Random& random) {
  const int columns = random.between(1, 3), rows = random.between(1, 3);
  std::string text = "NCOLS " + std::to_string(columns) + "\nNROWS " + std::to_string(rows) +
                     (random.chance(2) ? "\nXLLCORNER 1\nYLLCORNER -2\n" : "\nXLLCENTER 0.5\nYLLCENTER 3\n") +
                     (random.chance(2) ? "CELLSIZE 0.5\n" : "DX 2\nDY 0.25\n");
  if (random.chance(2)) text += "NODATA_VALUE 7\n";
  for (int i = columns * rows; i > 0; --i)
    text += std::to_string(random.between(1, 9)) + (i % columns == 1 ? "\n" : " ");
  return text;
}

/// An array of NumPy with its world file.
std::string any_array(Random& random) {
  const int columns = random.between(1, 3), rows = random.between(1, 3);
  const bool is_single = random.chance(2);
  std::string header = std::string("{'descr': '<") + (is_single ? "f4" : "f8") +
                       "', 'fortran_order': " + (random.chance(4) ? "True" : "False") + ", 'shape': (" +
                       std::to_string(rows) + ", " + std::to_string(columns) + "), }";
  header.resize(117, ' ');
  header += '\n';
  std::string array("\x93NUMPY\x01\x00", 8);
  array += std::string{static_cast<char>(header.size()), '\0'} + header;
  for (int i = columns * rows; i > 0; --i) {
    const double value = any_number(random);
    const auto single = static_cast<float>(value);
    array.append(is_single ? reinterpret_cast<const char*>(&single) : reinterpret_cast<const char*>(&value),
                 is_single ? sizeof single : sizeof value);
  }
  return "== lengths.wld\n0.5\n0\n0\n-0.25\n1\n2\n\n== lengths.npy\n" + array;
}

/// A mesh in a .vtu as text.
std::string any_text_vtu(Random& random) {
  const std::string type = random.chance(2) ? "Float64" : "Float32";
  return "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n"
         "<UnstructuredGrid><Piece NumberOfPoints=\"3\" NumberOfCells=\"1\">\n<Points><DataArray type=\"" +
         type +
         "\" NumberOfComponents=\"3\" format=\"ascii\">0 0 0 1 0 0 0 0.1 0</DataArray></Points>\n<Cells>"
         "<DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">0 1 2</DataArray>"
         "<DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">3</DataArray>"
         "<DataArray type=\"UInt8\" Name=\"types\" format=\"ascii\">5</DataArray></Cells>\n"
         "<CellData><DataArray type=\"Float64\" Name=\"region\" format=\"ascii\">2</DataArray></CellData>\n"
         "</Piece></UnstructuredGrid></VTKFile>\n";
}

std::string bundle_of(const Scratch& scratch, const std::vector<std::string>& names) {
  std::string bundle;
  for (const std::string& name : names)
    if (std::filesystem::exists(scratch / name))
      bundle += (bundle.empty() ? "== " : "\n== ") + name + "\n" + contents(scratch / name);
  return bundle;
}

/// A correct input of the reader.
std::string any_input(Random& random) {
  const std::filesystem::path name = PARDEL_MAIN_FILE;
  const std::string suffix = name.extension().string();
  const Scratch scratch;
  const std::filesystem::path file = scratch / name.string();
  if (suffix == ".area" || suffix == ".sizes") return any_list(random);
  if (suffix == ".asc") return any_grid(random);
  if (suffix == ".npy") return any_array(random);
  if (suffix == ".vtu" && random.chance(2)) return any_text_vtu(random);
  if (suffix == ".poly") return write_poly(any_pslg(random), file, random.between(0, 1)) ? contents(file) : "";
  if (suffix == ".ele") {
    const TriangleFiles files{
        .base = random.between(0, 1), .write_edge = random.chance(2), .write_neigh = random.chance(2)};
    if (!write_triangle_files(any_mesh(random), {}, scratch / "mesh", files)) return {};
    return bundle_of(scratch, {"mesh.node", "mesh.ele", "mesh.poly", "mesh.edge", "mesh.neigh"});
  }
  const MshEncoding encoding = random.chance(2) ? MshEncoding::ascii : MshEncoding::binary;
  const Mesh mesh = any_mesh(random);
  const std::size_t most = std::min<std::size_t>(mesh.triangles.size(), 2);
  if (suffix == ".pvtu") {
    const std::optional<MeshInPieces> pieces = in_pieces(mesh, random.chance(2) ? most : 1);
    const bool written = pieces && write_pvtu(*pieces, file);
    return written ? bundle_of(scratch, {"mesh.pvtu", "piece_0.vtu", "piece_1.vtu"}) : "";
  }
  if (suffix == ".msh" && random.chance(4)) {
    const std::optional<MeshInPieces> pieces = in_pieces(mesh, most);
    return pieces && write_msh(*pieces, file, encoding) ? bundle_of(scratch, {"mesh_1.msh", "mesh_2.msh"}) : "";
  }
  return write_mesh(mesh, {}, file, encoding) ? contents(file) : "";
}

}  // namespace
}  // namespace pardel::fuzz

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max_size,
                                               unsigned seed) {
  pardel::generators::Random random(seed);
  if (!random.chance(16)) return LLVMFuzzerMutate(data, size, max_size);
  const std::string input = pardel::fuzz::any_input(random);
  if (input.empty() || input.size() > max_size) return LLVMFuzzerMutate(data, size, max_size);
  std::copy(input.begin(), input.end(), data);
  return random.chance(2) ? input.size() : LLVMFuzzerMutate(data, input.size(), max_size);
}
