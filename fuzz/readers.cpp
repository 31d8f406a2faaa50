// Reads the bytes as a file, or as several (file_bundle.hpp). The reader must return a value or an error that names a
// file. What was read is written in every format that can hold it and read again: it must have the same digest, and
// another round must change nothing at all. An input that begins with the byte 0 stands for a file of which the content
// is known (known_files/): the reader must read this content. So it is noticed, too, if a reader always loses
// something.
#include "readers.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <tuple>

#include "../core/digest.hpp"
#include "../core/formats.hpp"
#include "../core/support/same_attribute.hpp"
#include "../core/support/shortest.hpp"
#include "file_bundle.hpp"
#include "fuzz_one.hpp"
#include "known_files/known_file.hpp"
#include "mesh_in_pieces.hpp"

namespace pardel::fuzz {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail_at(const fs::path& file, const std::string& what) {
  fail(file.filename().string() + ": " + what);
}

void check_error(const Error& error, const fs::path& folder) {
  if (error.message.find(folder.string()) == std::string::npos)
    fail("a message without the file's name: " + error.message);
  if (error.kind == ErrorKind::internal || error.kind == ErrorKind::cancelled || error.kind == ErrorKind::usage)
    fail("an error of the wrong kind: " + error.message);
}

template <class T>
T read_back(Result<T> result, const fs::path& file) {
  if (!result) fail_at(file, "the written file is rejected: " + result.error().message);
  return std::move(result).value();
}
void require_written(const Status& written, const fs::path& file) {
  if (!written) fail_at(file, "cannot be written: " + written.error().message);
}

void round_trip(const Pslg& pslg, const Scratch& scratch) {
  if (pslg.points.empty()) return;  // a .poly without points has those of the .node
  const fs::path file = scratch / "again.poly";
  for (const int base : {0, 1}) {
    require_written(write_poly(pslg, file, base), file);
    if (read_back(read_pslg(file), file) != pslg) fail_at(file, "the written file reads back differently");
  }
}

/// The constrained edges as a file has them: it does not say to which segment an edge belongs.
std::vector<std::tuple<Index, Index, int>> edges_of(const Mesh& mesh) {
  std::vector<std::tuple<Index, Index, int>> edges;
  for (const ConstrainedEdge& e : mesh.constrained_edges) edges.emplace_back(e.a, e.b, e.marker);
  return edges;
}

/// Indices must be in range, as formats.hpp promises.
void check_ranges(const Mesh& mesh) {
  const auto is_point = [&](Index v) { return v < mesh.points.size(); };
  for (const Triangle& t : mesh.triangles) {
    if (!std::ranges::all_of(t.v, is_point)) fail("a triangle refers to a point that does not exist");
    for (const Index n : t.n)
      if (n != no_index && n >= mesh.triangles.size()) fail("a neighbour does not exist");
  }
  for (const ConstrainedEdge& e : mesh.constrained_edges)
    if (!is_point(e.a) || !is_point(e.b)) fail("an edge refers to a point that does not exist");
  for (const Index r : mesh.region)
    if (r != no_index && r >= mesh.region_attributes.size()) fail("a region does not exist");
  for (const Point p : mesh.points)
    if (!std::isfinite(p.x) || !std::isfinite(p.y)) fail("a coordinate is not finite");
  if (mesh.point_attributes.size() != mesh.points.size() * mesh.attributes_per_point) fail("attributes are missing");
  for (const Field& field : mesh.fields)
    if (field.components == 0 ||
        field.values.size() !=
            field.components * (field.place == Field::Place::points ? mesh.points.size() : mesh.triangles.size()))
      fail("values of a field are missing");
  if (!mesh.region.empty() && mesh.region.size() != mesh.triangles.size()) fail("regions are missing");
  if (!mesh.point_markers.empty() && mesh.point_markers.size() != mesh.points.size()) fail("markers are missing");
}

using Write = std::function<Status(const Mesh&, const fs::path&)>;

/// What a format keeps of a mesh beside points, triangles and constrained edges.
struct Keeps {
  bool regions = true, data_of_points = true, fields = false, names = false, edges = true;
};

/// The fields of a place, in their order.
std::vector<const Field*> fields_of(const Mesh& mesh, Field::Place place) {
  std::vector<const Field*> fields;
  for (const Field& field : mesh.fields)
    if (field.place == place) fields.push_back(&field);
  return fields;
}

/// A .msh changes the order of triangles, and a .vtu does not keep all names of fields and no times.
void require_fields(const Mesh& once, const Mesh& mesh, const fs::path& file) {
  for (const auto place : {Field::Place::points, Field::Place::triangles}) {
    const auto read = fields_of(once, place), written = fields_of(mesh, place);
    const auto same = [&](const Field* f, const Field* g) {
      return f->components == g->components && f->values.size() == g->values.size() &&
             (place == Field::Place::triangles || std::ranges::equal(f->values, g->values, is_same_attribute));
    };
    if (!std::ranges::equal(read, written, same)) fail_at(file, "other fields are read");
  }
}

/// The digest does not depend on the attributes and the markers of points.
void require_data_of_points(const Mesh& once, const Mesh& mesh, const fs::path& file) {
  if (once.attributes_per_point != mesh.attributes_per_point ||
      !std::ranges::equal(once.point_attributes, mesh.point_attributes, is_same_attribute))
    fail_at(file, "other attributes of points are read");
  if (!mesh.point_markers.empty() && once.point_markers != mesh.point_markers)
    fail_at(file, "other markers of points are read");
}

void require_same(const Mesh& read, const Mesh& mesh, Keeps keeps, const fs::path& file) {
  if (read.points != mesh.points) fail_at(file, "other points are read");
  if (keeps.data_of_points) require_data_of_points(read, mesh, file);
  if (keeps.fields) require_fields(read, mesh, file);
  if (keeps.names && !std::ranges::is_permutation(read.names, mesh.names)) fail_at(file, "other names are read");
  if (keeps.regions && digest(read) != digest(mesh)) fail_at(file, "the mesh that is read has another digest");
  if (!keeps.regions && read.triangles != mesh.triangles) fail_at(file, "other triangles are read");
  if (!keeps.regions && keeps.edges && edges_of(read) != edges_of(mesh))
    fail_at(file, "other constrained edges are read");
}

void round_trip(const Mesh& mesh, const fs::path& file, Keeps keeps, const Write& write) {
  require_written(write(mesh, file), file);
  const Mesh once = read_back(read_mesh(file), file);
  require_same(once, mesh, keeps, file);
  require_written(write(once, file), file);
  if (read_back(read_mesh(file), file) != once) fail_at(file, "the second round changes the mesh");
}

/// Writes the mesh as two ranks do, each its piece. The joined pieces must be the mesh.
void round_trip_in_pieces(const Mesh& mesh, const Scratch& scratch) {
  const std::optional<MeshInPieces> pieces = in_pieces(mesh, 2);
  if (!pieces) return;
  const fs::path folder = scratch / "in-pieces";  // names in a bundle have no hyphen
  fs::create_directory(folder);
  const auto expect_mesh = [&](const Status& written, const fs::path& file, bool keeps_data_of_points) {
    require_written(written, file);
    const Mesh joined = read_back(read_mesh(file), file);
    require_same(joined, mesh, {.data_of_points = keeps_data_of_points}, file);
  };
  const fs::path pvtu = folder / "again.pvtu", msh = folder / "again.msh";
  expect_mesh(write_pvtu(*pieces, pvtu), pvtu, true);
  for (const MshEncoding encoding : {MshEncoding::ascii, MshEncoding::binary})
    expect_mesh(write_msh(*pieces, msh, encoding), msh, false);
}

void round_trip(const Mesh& mesh, const Scratch& scratch) {
  check_ranges(mesh);
  round_trip_in_pieces(mesh, scratch);
  using Encoding = MshEncoding;
  constexpr Keeps no_data_of_points{.data_of_points = false, .fields = true, .names = true};
  round_trip(mesh, scratch / "text.msh", no_data_of_points,
             [](const Mesh& m, const fs::path& f) { return write_msh(m, f, Encoding::ascii); });
  round_trip(mesh, scratch / "binary.msh", no_data_of_points,
             [](const Mesh& m, const fs::path& f) { return write_msh(m, f, Encoding::binary); });
  round_trip(mesh, scratch / "again.vtu", {.fields = true, .names = true},
             [](const Mesh& m, const fs::path& f) { return write_vtu(m, f); });
  round_trip(mesh, scratch / "again.off", {.regions = false, .data_of_points = false},
             [](const Mesh& m, const fs::path& f) { return write_off(m, f); });
  round_trip(mesh, scratch / "again.vtk", {.fields = true},
             [](const Mesh& m, const fs::path& f) { return write_vtk(m, f); });
  // In these formats regions are whole numbers, and the edges have another order or are those of the boundary.
  constexpr Keeps triangles{.regions = false, .data_of_points = false, .edges = false};
  round_trip(mesh, scratch / "again.2dm", triangles, [](const Mesh& m, const fs::path& f) { return write_2dm(m, f); });
  round_trip(mesh, scratch / "again.gr3", triangles, [](const Mesh& m, const fs::path& f) { return write_gr3(m, f); });
  round_trip(mesh, scratch / "second.vtu", {.fields = true},
             [](const Mesh& m, const fs::path& f) { return write_vtu(m, f, ElementOrder::second); });
  round_trip(mesh, scratch / "second.msh", no_data_of_points,
             [](const Mesh& m, const fs::path& f) { return write_msh(m, f, Encoding::binary, ElementOrder::second); });
  round_trip(mesh, scratch / "again.ele", {}, [](const Mesh& m, const fs::path& f) {
    return write_triangle_files(m, {}, fs::path(f).replace_extension(), {.write_neigh = true});
  });
}

/// The same numbers, where NaN equals NaN.
bool same(const std::vector<double>& a, const std::vector<double>& b) {
  return std::ranges::equal(a, b, is_same_attribute);
}

bool same(const Raster& a, const Raster& b) {
  return a.columns == b.columns && a.rows == b.rows && a.first == b.first && a.step_x == b.step_x &&
         a.step_y == b.step_y && same(a.values, b.values);
}

/// Writes the raster as an .asc, for which the library has no writer.
void round_trip(const Raster& raster, const Scratch& scratch) {
  if (raster.values.size() != std::size_t{raster.columns} * raster.rows) fail("the raster lacks values");
  if (!(raster.step_x > 0) || !(raster.step_y > 0)) fail("a step of the raster is not positive");
  double missing = -9999;
  while (std::ranges::find(raster.values, missing) != raster.values.end()) --missing;
  std::string grid = "NCOLS " + std::to_string(raster.columns) + "\nNROWS " + std::to_string(raster.rows) +
                     "\nXLLCENTER " + shortest(raster.first.x) + "\nYLLCENTER " + shortest(raster.first.y) + "\nDX " +
                     shortest(raster.step_x) + "\nDY " + shortest(raster.step_y) + "\nNODATA_VALUE " +
                     shortest(missing) + "\n";
  for (std::size_t row = raster.rows; row-- > 0;)
    for (std::size_t column = 0; column < raster.columns; ++column) {
      const double value = raster.values[row * raster.columns + column];
      if (std::isinf(value)) return;  // an .asc has no such value
      grid += shortest(std::isnan(value) ? missing : value) + (column + 1 < raster.columns ? " " : "\n");
    }
  scratch.write({"again.asc", grid});
  if (!same(read_back(read_raster(scratch / "again.asc"), scratch / "again.asc"), raster))
    fail("the raster reads back differently");
}

bool all_finite(const Numbers& values) {
  return std::ranges::all_of(values, [](double value) { return std::isfinite(value); });
}

/// Caps of triangles are written as .area. The library has no writer for sizes.
void round_trip(const Numbers& values, const Scratch& scratch) {
  if (!std::ranges::all_of(values, [](double value) { return value > 0; })) fail("a value is not positive");
  const fs::path area = scratch / "again.area", sizes = scratch / "again.sizes";
  require_written(write_area(area, values, 1), area);
  if (read_back(read_area(area), area) != values) fail_at(area, "the written file reads back differently");
  if (!all_finite(values)) return;
  std::string lines = std::to_string(values.size()) + "\n";
  for (std::size_t i = 0; i < values.size(); ++i) lines += std::to_string(i + 1) + " " + shortest(values[i]) + "\n";
  scratch.write({"again.sizes", lines});
  if (read_back(read_sizes(sizes), sizes) != values) fail_at(sizes, "the sizes read back differently");
}

/// The content of the file, read by the reader of its suffix.
Result<Content> read(const fs::path& file) {
  const auto content = [](auto result) {
    return result ? Result<Content>(Content(std::move(*result))) : Result<Content>(result.error());
  };
  const std::string suffix = file.extension().string();
  if (suffix == ".asc" || suffix == ".npy") return content(read_raster(file));
  if (suffix == ".area") return content(read_area(file));
  if (suffix == ".sizes") return content(read_sizes(file));
  Result<std::variant<Pslg, Mesh>> either = read_pslg_or_mesh(file);
  if (!either) return either.error();
  return std::visit([](auto& value) { return Result<Content>(Content(std::move(value))); }, *either);
}

void require_same(const Content& read, const KnownFile& known, const fs::path& file) {
  if (read.index() != known.content.index()) fail_at(file, "content of another kind is read");
  if (const auto* mesh = std::get_if<Mesh>(&read)) {
    const auto& expected = std::get<Mesh>(known.content);
    if (known.keeps_order && *mesh != expected) fail_at(file, "another mesh is read");
    require_same(*mesh, expected, {.fields = true}, file);
  } else if (const auto* raster = std::get_if<Raster>(&read)) {
    if (!same(*raster, std::get<Raster>(known.content))) fail_at(file, "another raster is read");
  } else if (const auto* pslg = std::get_if<Pslg>(&read)) {
    if (*pslg != std::get<Pslg>(known.content)) fail_at(file, "another domain is read");
  } else if (std::get<Numbers>(read) != std::get<Numbers>(known.content)) {
    fail_at(file, "other numbers are read");
  }
}

}  // namespace

int fuzz_reader(std::span<const std::uint8_t> bytes, const std::string& main_file) {
  const std::optional<KnownFile> known = known_file_of(bytes, main_file);
  if (known) bytes = {reinterpret_cast<const std::uint8_t*>(known->bytes.data()), known->bytes.size()};
  const Scratch scratch;
  for (const NamedText& file : files_of(bytes, main_file)) scratch.write(file);
  const fs::path folder = (scratch / "").parent_path(), file = file_to_read(scratch, main_file);
  const Result<Content> content = read(file);
  if (known) require_same(read_back(content, file), *known, file);
  if (!content) {
    check_error(content.error(), folder);
    return 0;
  }
  if (const auto* sizes = std::get_if<Numbers>(&*content); sizes && fs::path(main_file).extension() == ".sizes")
    if (!all_finite(*sizes)) fail("a size is not finite");
  std::visit([&](const auto& value) { round_trip(value, scratch); }, *content);
  return 0;
}

}  // namespace pardel::fuzz
