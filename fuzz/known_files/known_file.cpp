#include "known_file.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <utility>

#include "../../core/formats.hpp"
#include "../file_bundle.hpp"
#include "../fuzz_one.hpp"
#include "../mesh_in_pieces.hpp"
#include "../supply.hpp"
#include "formats.hpp"
#include "values.hpp"

namespace pardel::fuzz {
namespace {

using generators::Random;
namespace fs = std::filesystem;

std::string contents(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

void require_written(const Status& written) {
  if (!written) fail("a known file cannot be written: " + written.error().message);
}

std::string bundle_of(const Scratch& scratch, const std::vector<std::string>& names) {
  std::string bundle;
  for (const std::string& name : names)
    if (fs::exists(scratch / name))
      bundle += (bundle.empty() ? "== " : "\n== ") + name + "\n" + contents(scratch / name);
  return bundle;
}

MshEncoding any_encoding(Random& random) { return random.chance(2) ? MshEncoding::ascii : MshEncoding::binary; }

/// The first n lines, and the others.
std::pair<std::string, std::string> after_lines(const std::string& text, std::size_t n) {
  std::size_t end = 0;
  for (; n > 0; --n) end = text.find('\n', end) + 1;
  return {text.substr(0, end), text.substr(end)};
}

/// A .poly, one whose points are in a .node, or a .node alone.
KnownFile any_poly(Random& random, const Scratch& scratch) {
  Pslg pslg = any_pslg(random);
  const int form = random.between(0, 3);  // 0: points only; 1: points in a .node; others: one file
  if (form == 0) {
    pslg.segments.clear();
    pslg.holes.clear();
    pslg.regions.clear();
    pslg.has_segment_markers = false;
  }
  const fs::path file = scratch / "domain.poly";
  require_written(write_poly(pslg, file, random.between(0, 1)));
  const std::string poly = contents(file);
  const auto [points, rest] = after_lines(poly, pslg.points.size() + 1);
  if (form == 0) return {"== domain.node\n" + points, std::move(pslg)};
  if (form == 1) return {"== domain.node\n" + points + "\n== domain.poly\n0 2 0 0\n" + rest, std::move(pslg)};
  return {poly, std::move(pslg)};
}

KnownFile any_triangle_files(Random& random, const Scratch& scratch) {
  Mesh mesh = any_mesh(random);
  const TriangleFiles files{.base = random.between(0, 1),
                            .write_edge = random.chance(2),
                            .write_neigh = random.chance(2),
                            .second_order = random.chance(4)};
  require_written(write_triangle_files(mesh, {}, scratch / "mesh", files));
  return {bundle_of(scratch, {"mesh.node", "mesh.ele", "mesh.poly", "mesh.edge", "mesh.neigh"}), std::move(mesh)};
}

/// MSH and OFF do not store the attributes and markers of points.
Mesh without_data_of_points(Mesh mesh) {
  mesh.attributes_per_point = 0;
  mesh.point_attributes.clear();
  mesh.point_markers.clear();
  return mesh;
}

KnownFile any_msh(Random& random, const Scratch& scratch) {
  if (random.chance(4)) return any_msh_2(random);
  const MshEncoding encoding = any_encoding(random);
  if (random.chance(4)) {
    const Mesh mesh = without_data_of_points(any_fan(random));
    const std::optional<MeshInPieces> pieces = in_pieces(mesh, std::min<std::size_t>(mesh.triangles.size(), 2));
    if (!pieces) fail("a fan cannot be divided into pieces");
    require_written(write_msh(*pieces, scratch / "mesh.msh", encoding));
    return {bundle_of(scratch, {"mesh_1.msh", "mesh_2.msh"}), mesh, false};
  }
  Mesh mesh = without_data_of_points(any_mesh(random));
  add_fields_and_names(mesh, random);
  require_written(write_msh(mesh, scratch / "mesh.msh", encoding));
  return {contents(scratch / "mesh.msh"), std::move(mesh), false};
}

KnownFile any_pvtu(Random& random, const Scratch& scratch) {
  Mesh mesh = any_fan(random);
  const std::size_t most = std::min<std::size_t>(mesh.triangles.size(), 2);
  const std::optional<MeshInPieces> pieces = in_pieces(mesh, random.chance(2) ? most : 1);
  if (!pieces) fail("a fan cannot be divided into pieces");
  require_written(write_pvtu(*pieces, scratch / "mesh.pvtu"));
  return {bundle_of(scratch, {"mesh.pvtu", "piece_0.vtu", "piece_1.vtu"}), std::move(mesh), false};
}

/// One attribute per point, and no markers of points, as in formats with a height or a depth.
Mesh with_heights(Mesh mesh) {
  mesh = without_data_of_points(std::move(mesh));
  mesh.attributes_per_point = 1;
  for (std::size_t i = 0; i < mesh.points.size(); ++i) mesh.point_attributes.push_back(static_cast<double>(i) / 3);
  return mesh;
}

/// The regions of a .2dm are materials: whole numbers from 1 on. The order of the edges changes.
KnownFile any_2dm(Random& random, const Scratch& scratch) {
  Mesh mesh = with_heights(any_mesh(random));
  mesh.region_attributes = {3};
  mesh.region.clear();
  mesh.region.resize(mesh.triangles.size(), 0);
  require_written(write_2dm(mesh, scratch / "mesh.2dm"));
  return {contents(scratch / "mesh.2dm"), std::move(mesh), false};
}

/// The constrained edges of a .gr3 are those of the boundary; where all is land, they have the marker 1.
KnownFile any_gr3(Random& random, const Scratch& scratch) {
  Mesh mesh = with_heights(any_mesh(random));
  mesh.region.clear();
  mesh.region_attributes.clear();
  mesh.constrained_edges.clear();
  for (const Triangle& t : mesh.triangles)
    for (std::size_t i = 0; i < 3; ++i)
      if (t.n[i] == no_index) mesh.constrained_edges.push_back({t.v[(i + 1) % 3], t.v[(i + 2) % 3], no_index, 1});
  require_written(write_gr3(mesh, scratch / "mesh.gr3"));
  return {contents(scratch / "mesh.gr3"), std::move(mesh), false};
}

KnownFile any_single_file(Mesh mesh, const fs::path& file) {
  require_written(write_mesh(mesh, {}, file));
  return {contents(file), std::move(mesh)};
}

}  // namespace

KnownFile any_known_file(Random& random, const std::string& main_file) {
  const std::string suffix = fs::path(main_file).extension().string();
  if (suffix == ".area" || suffix == ".sizes") return any_list(random, suffix == ".area");
  if (suffix == ".asc") return any_grid(random);
  if (suffix == ".npy") return any_array(random);
  if (suffix == ".vtu" && random.chance(2)) return any_vtu(random);
  const Scratch scratch;
  if (suffix == ".poly") return any_poly(random, scratch);
  if (suffix == ".ele") return any_triangle_files(random, scratch);
  if (suffix == ".msh") return any_msh(random, scratch);
  if (suffix == ".2dm") return any_2dm(random, scratch);
  if (suffix == ".gr3") return any_gr3(random, scratch);
  if (suffix == ".pvtu") return any_pvtu(random, scratch);
  Mesh mesh = any_mesh(random);
  if (suffix == ".vtu") add_fields_and_names(mesh, random);
  if (suffix == ".off") {
    mesh = without_data_of_points(std::move(mesh));
    mesh.region.clear();
    mesh.region_attributes.clear();
  }
  return any_single_file(std::move(mesh), scratch / main_file);
}

std::string input_for_known_file(std::uint64_t seed) {
  std::string input(1, '\0');
  for (int i = 0; i < 64; i += 8) input += static_cast<char>(seed >> i & 255U);
  return input;
}

std::optional<KnownFile> known_file_of(std::span<const std::uint8_t> input, const std::string& main_file) {
  if (input.empty() || input.front() != 0) return {};
  Random random(Supply(input.subspan(1)).word());
  return any_known_file(random, main_file);
}

}  // namespace pardel::fuzz
