// Random values are written and read back; the result must be the same value.
#include <algorithm>
#include <bit>
#include <cmath>
#include <tuple>
#include <vector>

#include "../../../core/digest.hpp"
#include "../../../core/formats.hpp"
#include "../../../core/formats/mesh_readers.hpp"
#include "../../../core/neighbours.hpp"
#include "../../../properties/theorems/framework/property.hpp"
#include "../../temporary_folder.hpp"

namespace pardel {
using namespace files;
namespace {

/// A finite double: random bits, or a small integer.
double any_double() {
  if (*rc::gen::inRange(0, 3) == 0) return *rc::gen::inRange(-20, 20);
  const double value = std::bit_cast<double>(*rc::gen::arbitrary<std::uint64_t>());
  return std::isfinite(value) ? value : 0.5;
}
Point any_point() {
  const double x = any_double();
  return {x, any_double()};
}
std::size_t up_to(std::size_t n) { return *rc::gen::inRange<std::size_t>(0, n + 1); }
Index below(std::size_t n) { return static_cast<Index>(*rc::gen::inRange<std::size_t>(0, n)); }
int any_marker() { return *rc::gen::inRange(0, 4) == 0 ? *rc::gen::arbitrary<int>() : *rc::gen::inRange(-3, 4); }
bool either() { return *rc::gen::inRange(0, 2) == 1; }

Pslg any_pslg() {
  Pslg pslg;
  const std::size_t points = 1 + up_to(12);
  pslg.attributes_per_point = up_to(3);
  for (std::size_t i = 0; i < points; ++i) pslg.points.push_back(any_point());
  for (std::size_t i = 0; i < points * pslg.attributes_per_point; ++i) pslg.point_attributes.push_back(any_double());
  if (either()) {
    for (std::size_t i = 0; i < points; ++i) pslg.point_markers.push_back(any_marker());
  }
  pslg.has_segment_markers = either();
  for (std::size_t i = up_to(10); i > 0; --i) {
    const Index a = below(points);
    const Index b = below(points);
    pslg.segments.push_back({a, b, pslg.has_segment_markers ? any_marker() : 0});
  }
  for (std::size_t i = up_to(3); i > 0; --i) pslg.holes.push_back(any_point());
  for (std::size_t i = up_to(3); i > 0; --i) {
    const Point seed = any_point();
    const double attribute = any_double();
    const double cap = std::abs(any_double());
    pslg.regions.push_back({seed, attribute, cap > 0 ? cap : std::numeric_limits<double>::infinity()});
  }
  return pslg;
}

/// Random triangles on random points. They need not be a mesh, because files store any triangles.
Mesh any_mesh() {
  Mesh mesh;
  const std::size_t points = 3 + up_to(12);
  for (std::size_t i = 0; i < points; ++i) mesh.points.push_back(any_point());
  mesh.attributes_per_point = up_to(2);
  for (std::size_t i = 0; i < points * mesh.attributes_per_point; ++i) mesh.point_attributes.push_back(any_double());
  for (std::size_t i = 0; i < points; ++i) mesh.point_markers.push_back(any_marker());
  std::vector<double> attributes;
  for (std::size_t i = up_to(15); i > 0; --i) {
    const Index first = below(points);
    const Index second = below(points - 1);
    const Index a = first;
    const Index b = static_cast<Index>((first + 1 + second) % points);
    Index c = below(points);
    while (c == a || c == b) c = static_cast<Index>((c + 1) % points);
    mesh.triangles.push_back({{a, b, c}, {}});
    attributes.push_back(any_double());
  }
  rebuild_neighbours(mesh.triangles, points);
  if (!attributes.empty() && either()) set_regions(mesh, attributes);
  for (std::size_t i = up_to(8); i > 0; --i) {
    const Index a = below(points);
    const Index b = below(points);
    mesh.constrained_edges.push_back({a, b, no_index, any_marker()});
  }
  return mesh;
}

/// Any number, also one that is missing or infinite.
double any_result() {
  const double value = std::bit_cast<double>(*rc::gen::arbitrary<std::uint64_t>());
  return std::isnan(value) ? std::nan("") : value;
}

/// A mesh with fields at points and in triangles, in this order, as readers return them, and with names.
Mesh any_mesh_with_fields() {
  Mesh mesh = any_mesh();
  const auto add = [&](Field::Place place, std::size_t places) {
    for (std::size_t i = up_to(2); i > 0; --i) {
      const std::size_t components = 1 + up_to(11);
      Array<double> values(places * components);
      for (double& value : values) value = any_result();
      mesh.fields.push_back({"field " + std::to_string(i), place, components, std::move(values), 0});
    }
  };
  add(Field::Place::points, mesh.points.size());
  add(Field::Place::triangles, mesh.triangles.size());
  for (int value = 1; value < 4; ++value)
    if (either())
      mesh.names.push_back({either() ? GroupName::Of::marker : GroupName::Of::region, value, "a & \"b\" <c>"});
  return mesh;
}

Mesh read_back(const TemporaryFolder& folder, const char* name) {
  const auto read = read_mesh(folder / name);
  RC_ASSERT(read.ok());
  return *read;
}

PARDEL_PROPERTY(RoundTrip, of_a_pslg_through_a_poly_changes_nothing,
                {.statement = "a domain written as .poly reads back equal",
                 .source = "core/formats.hpp",
                 .families = "values of every shape"}) {
  const TemporaryFolder folder;
  const Pslg pslg = any_pslg();
  RC_ASSERT(write_poly(pslg, folder / "p.poly", either() ? 1 : 0).ok());
  const auto read = read_pslg(folder / "p.poly");
  RC_ASSERT(read.ok());
  RC_ASSERT(*read == pslg);
}

PARDEL_PROPERTY(RoundTrip, of_a_mesh_through_triangles_files_changes_nothing,
                {.statement = "a mesh written as .node, .ele, .edge, .neigh reads back equal",
                 .source = "core/formats.hpp",
                 .families = "values of every shape"}) {
  const TemporaryFolder folder;
  const Mesh mesh = any_mesh();
  TriangleFiles files;
  files.base = either() ? 1 : 0;
  files.write_edge = either();
  files.write_neigh = either();
  RC_ASSERT(write_triangle_files(mesh, {}, folder / "m", files).ok());
  RC_ASSERT(read_back(folder, "m.ele") == mesh);
}

PARDEL_PROPERTY(RoundTrip, of_a_mesh_through_vtu_changes_nothing,
                {.statement = "a mesh written as .vtu reads back equal",
                 .source = "core/formats.hpp",
                 .families = "values of every shape"}) {
  const TemporaryFolder folder;
  const Mesh mesh = any_mesh_with_fields();
  RC_ASSERT(write_vtu(mesh, folder / "m.vtu").ok());
  RC_ASSERT(read_back(folder, "m.vtu") == mesh);
}

PARDEL_PROPERTY(RoundTrip, of_a_mesh_through_msh_keeps_its_points_and_its_digest,
                {.statement = "a mesh written as .msh reads back with the same points, regions and digest",
                 .source = "core/formats.hpp",
                 .families = "values of every shape"}) {
  const TemporaryFolder folder;
  const Mesh mesh = any_mesh_with_fields();
  RC_ASSERT(write_msh(mesh, folder / "m.msh", either() ? MshEncoding::ascii : MshEncoding::binary).ok());
  const Mesh read = read_back(folder, "m.msh");
  RC_ASSERT(read.points == mesh.points);
  RC_ASSERT(read.triangles.size() == mesh.triangles.size());
  RC_ASSERT(read.region_attributes == mesh.region_attributes);
  RC_ASSERT(digest(read) == digest(mesh));
  RC_ASSERT(std::ranges::is_permutation(read.names, mesh.names));
  RC_ASSERT(read.fields.size() == mesh.fields.size());
  for (std::size_t f = 0; f < mesh.fields.size(); ++f)
    RC_ASSERT(mesh.fields[f].place == Field::Place::triangles || read.fields[f] == mesh.fields[f]);
}

PARDEL_PROPERTY(RoundTrip, of_a_mesh_through_off_keeps_its_points_triangles_and_constrained_edges,
                {.statement = "a mesh written as .off reads back with the same points, triangles and constrained edges",
                 .source = "core/formats.hpp",
                 .families = "values of every shape"}) {
  const TemporaryFolder folder;
  const Mesh mesh = any_mesh();
  RC_ASSERT(write_off(mesh, folder / "m.off").ok());
  const Mesh read = read_back(folder, "m.off");
  RC_ASSERT(read.points == mesh.points);
  RC_ASSERT(read.triangles == mesh.triangles);
  const auto ends_and_marker = [](const ConstrainedEdge& e) { return std::tuple(e.a, e.b, e.marker); };
  RC_ASSERT(std::ranges::equal(read.constrained_edges, mesh.constrained_edges, {}, ends_and_marker, ends_and_marker));
}

PARDEL_PROPERTY(RoundTrip, of_a_mesh_through_vtk_changes_nothing,
                {.statement = "a mesh written as a legacy .vtk reads back equal",
                 .source = "core/formats.hpp",
                 .families = "values of every shape"}) {
  const TemporaryFolder folder;
  Mesh mesh = any_mesh_with_fields();
  mesh.names.clear();
  RC_ASSERT(write_vtk(mesh, folder / "m.vtk").ok());
  RC_ASSERT(read_back(folder, "m.vtk") == mesh);
}

/// The ends and the markers of the constrained edges, in an order that does not depend on that of the edges.
std::vector<std::tuple<Index, Index, int>> sorted_edges(const Mesh& mesh) {
  std::vector<std::tuple<Index, Index, int>> edges;
  for (const ConstrainedEdge& e : mesh.constrained_edges)
    edges.emplace_back(std::min(e.a, e.b), std::max(e.a, e.b), e.marker);
  std::sort(edges.begin(), edges.end());
  return edges;
}

/// The first attribute of each point, or 0, as files with a height have it.
std::vector<double> heights(const Mesh& mesh) {
  std::vector<double> heights(mesh.points.size(), 0);
  const std::size_t k = mesh.attributes_per_point;
  for (std::size_t i = 0; i < heights.size() && k > 0; ++i) heights[i] = mesh.point_attributes[i * k];
  return heights;
}

PARDEL_PROPERTY(
    RoundTrip, of_a_mesh_through_2dm_keeps_its_points_triangles_and_edges,
    {.statement = "a mesh written as .2dm reads back with the same points, heights, triangles and constrained "
                  "edges; written again, it does not change",
     .source = "core/formats.hpp",
     .families = "values of every shape"}) {
  const TemporaryFolder folder;
  const Mesh mesh = any_mesh();
  RC_ASSERT(write_2dm(mesh, folder / "m.2dm").ok());
  const Mesh read = read_back(folder, "m.2dm");
  RC_ASSERT(read.points == mesh.points);
  RC_ASSERT(read.triangles == mesh.triangles);
  RC_ASSERT(heights(read) == heights(mesh));
  RC_ASSERT(sorted_edges(read) == sorted_edges(mesh));
  RC_ASSERT(read.region_attributes.size() ==
            (mesh.triangles.empty() ? 0 : std::max<std::size_t>(1, mesh.region_attributes.size())));
  RC_ASSERT(write_2dm(read, folder / "again.2dm").ok());
  RC_ASSERT(read_back(folder, "again.2dm") == read);
}

PARDEL_PROPERTY(
    RoundTrip, of_a_mesh_through_gr3_keeps_its_points_triangles_and_boundary,
    {.statement = "a mesh written as .gr3 reads back with the same points, depths and triangles, and with the "
                  "edges of one triangle as constrained edges; written again, it does not change",
     .source = "core/formats.hpp",
     .families = "values of every shape"}) {
  const TemporaryFolder folder;
  const Mesh mesh = any_mesh();
  RC_ASSERT(write_gr3(mesh, folder / "m.gr3").ok());
  const Mesh read = read_back(folder, "m.gr3");
  RC_ASSERT(read.points == mesh.points);
  RC_ASSERT(read.triangles == mesh.triangles);
  RC_ASSERT(heights(read) == heights(mesh));
  Mesh boundary;
  for (const Triangle& t : mesh.triangles)
    for (std::size_t i = 0; i < 3; ++i)
      if (t.n[i] == no_index) boundary.constrained_edges.push_back({t.v[(i + 1) % 3], t.v[(i + 2) % 3], no_index, 1});
  RC_ASSERT(sorted_edges(read) == sorted_edges(boundary));
  RC_ASSERT(write_gr3(read, folder / "again.gr3").ok());
  RC_ASSERT(read_back(folder, "again.gr3") == read);
}

PARDEL_PROPERTY(
    RoundTrip, of_a_mesh_with_six_nodes_per_triangle_gives_the_mesh_of_its_corners,
    {.statement = "a mesh written in second order as .vtu reads back equal, as .msh with the same points and "
                  "digest",
     .source = "core/formats.hpp",
     .families = "values of every shape"}) {
  const TemporaryFolder folder;
  const Mesh mesh = any_mesh();
  RC_ASSERT(write_vtu(mesh, folder / "m.vtu", ElementOrder::second).ok());
  RC_ASSERT(read_back(folder, "m.vtu") == mesh);
  const MshEncoding encoding = either() ? MshEncoding::ascii : MshEncoding::binary;
  RC_ASSERT(write_msh(mesh, folder / "m.msh", encoding, ElementOrder::second).ok());
  const Mesh read = read_back(folder, "m.msh");
  RC_ASSERT(read.points == mesh.points);
  RC_ASSERT(digest(read) == digest(mesh));
}

/// A random byte of those that can make a correct file wrong.
char any_damage() { return "0123456789-.e <>\n\x00\xff"[below(19)]; }

PARDEL_PROPERTY(
    Readers, of_domains_give_only_segments_between_points_that_exist,
    {.statement = "the ends of every segment that is read from a .poly with changed digits are points of it",
     .source = "core/formats.hpp",
     .families = "files .poly"}) {
  const TemporaryFolder folder;
  const Pslg pslg = any_pslg();
  RC_PRE(!pslg.segments.empty());
  RC_ASSERT(write_poly(pslg, folder / "p.poly", either() ? 1 : 0).ok());
  std::string bytes = folder.read("p.poly");
  for (std::size_t i = 1 + up_to(4); i > 0; --i) {
    char& byte = bytes[below(bytes.size())];
    if ('0' <= byte && byte <= '9') byte = static_cast<char>('0' + below(10));
  }
  folder.write("p.poly", bytes);
  const auto read = read_pslg(folder / "p.poly");
  if (!read.ok()) return;
  for (const Segment& s : read->segments) {
    RC_ASSERT(s.a < read->points.size());
    RC_ASSERT(s.b < read->points.size());
  }
}

/// A correct file with a few bytes changed. Reading it must return a value or an error.
PARDEL_PROPERTY(Readers, never_fail_but_by_an_error,
                {.statement = "a file with some bytes changed reads as a value or gives an error with a message",
                 .source = "core/formats.hpp",
                 .families = "files of seven formats"}) {
  const TemporaryFolder folder;
  const Mesh mesh = any_mesh();
  const char* names[] = {"m.vtu", "m.off", "m.ele", "m.msh", "m.vtk", "m.2dm", "m.gr3"};
  const char* name = names[below(7)];
  RC_ASSERT(write_mesh(mesh, {}, folder / name).ok());
  std::string bytes = folder.read(name);
  for (std::size_t i = 1 + up_to(4); i > 0; --i) {
    bytes[below(bytes.size())] = any_damage();
  }
  folder.write(name, bytes);
  const auto read = read_mesh(folder / name);
  if (!read.ok()) RC_ASSERT(!read.error().message.empty());
}

}  // namespace
}  // namespace pardel
