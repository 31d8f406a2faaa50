#include "beside_mesh.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <string_view>
#include <vector>

#include "drawing/valid_utf8.hpp"
#include "exit_code.hpp"

namespace pardel::cli {
namespace {

using List = std::vector<std::string>;

/// The parts of a mesh that only some formats store.
struct Stores {
  enum class Regions : std::uint8_t { none, whole_numbers, all };
  Regions regions = Regions::all;
  bool markers_of_edges = true, markers_of_points = true;
  std::size_t attributes_of_points = std::numeric_limits<std::size_t>::max();
  bool fields = false, names = false, times = false;
};
Stores stores(MeshFormat format) {
  switch (format) {
    case MeshFormat::msh:
      return {.markers_of_points = false, .attributes_of_points = 0, .fields = true, .names = true, .times = true};
    case MeshFormat::vtu:
      return {.fields = true, .names = true};
    case MeshFormat::off:
      return {.regions = Stores::Regions::none, .markers_of_points = false, .attributes_of_points = 0};
    case MeshFormat::two_dm:
      return {.regions = Stores::Regions::whole_numbers, .markers_of_points = false, .attributes_of_points = 1};
    case MeshFormat::gr3:
      return {.regions = Stores::Regions::none,
              .markers_of_edges = false,
              .markers_of_points = false,
              .attributes_of_points = 1};
    case MeshFormat::inp:
      return {.markers_of_points = false, .attributes_of_points = 0};
    case MeshFormat::vtk:
      return {.fields = true};
    case MeshFormat::triangle:
    case MeshFormat::svg:
      break;
  }
  return {};
}

/// A name from a file, in quotation marks. A terminal obeys control characters, so they become blanks.
std::string in_marks(std::string_view name) {
  std::string text = valid_utf8(name);
  std::ranges::replace_if(
      text, [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }, ' ');
  return "\"" + text + "\"";
}

std::string joined(const List& list) { return fmt::format("{}", fmt::join(list, ", ")); }

std::string_view place_of(const Field& field) {
  return field.place == Field::Place::points ? "at points" : "in triangles";
}

/// The lost part of the regions; empty if there is none.
std::string_view lost_regions(const Mesh& mesh, Stores::Regions kept) {
  const auto is_whole = [](double a) { return a >= 1 && a <= std::numeric_limits<int>::max() && a == std::floor(a); };
  if (kept == Stores::Regions::none && !mesh.region_attributes.empty()) return "regions";
  if (kept == Stores::Regions::whole_numbers && !std::ranges::all_of(mesh.region_attributes, is_whole))
    return "attributes of regions that are not whole numbers from 1 on";
  return {};
}

/// True if a constrained edge has another marker than 1, which land at the boundary has, or lies inside the domain.
bool has_more_than_a_boundary(const Mesh& mesh) {
  std::ptrdiff_t sides = 0;
  for (const Triangle& t : mesh.triangles) sides += std::ranges::count(t.n, no_index);
  return std::ssize(mesh.constrained_edges) > sides ||
         std::ranges::any_of(mesh.constrained_edges, [](const ConstrainedEdge& edge) { return edge.marker != 1; });
}

/// True if a point has a marker that no constrained edge at it has.
bool has_markers_apart(const Mesh& mesh) {
  std::vector<char> is_of_edge(mesh.point_markers.size(), 0);
  for (const ConstrainedEdge& edge : mesh.constrained_edges)
    for (const Index v : {edge.a, edge.b})
      if (v < is_of_edge.size() && edge.marker == mesh.point_markers[v]) is_of_edge[v] = 1;
  for (std::size_t v = 0; v < is_of_edge.size(); ++v)
    if (mesh.point_markers[v] != 0 && is_of_edge[v] == 0) return true;
  return false;
}

void add_losses_beside(const Mesh& mesh, const Stores& kept, List& list) {
  if (mesh.attributes_per_point > kept.attributes_of_points)
    list.emplace_back(kept.attributes_of_points == 0 ? "attributes of points" : "attributes of points but the first");
  if (!kept.fields)
    for (const Field& field : mesh.fields) list.push_back("the field " + in_marks(field.name));
  if (!kept.names)
    for (const GroupName& name : mesh.names) list.push_back("the name " + in_marks(name.name));
  const bool has_times = std::ranges::any_of(mesh.fields, [](const Field& field) { return field.time != 0; });
  if (kept.fields && !kept.times && has_times) list.emplace_back("times of fields");
}

}  // namespace

void note_beside_mesh(const Mesh& mesh, const std::filesystem::path& file, const std::string& use) {
  List fields;
  for (const Field& field : mesh.fields) fields.push_back(fmt::format("{} {}", in_marks(field.name), place_of(field)));
  if (!fields.empty())
    warn(fmt::format("{}: note: the file has {} {}{}", file.string(), fields.size() == 1 ? "the field" : "the fields",
                     joined(fields), use));
  if (const List& things = mesh.left_out.things(); !things.empty())
    warn(fmt::format("{}: note: not read: {}", file.string(), joined(things)));
}

std::string losses(const Mesh& mesh, MeshFormat format, PointMarkers from) {
  const Stores kept = stores(format);
  List list;
  if (const std::string_view lost = lost_regions(mesh, kept.regions); !lost.empty()) list.emplace_back(lost);
  if (!kept.markers_of_edges && has_more_than_a_boundary(mesh))
    list.emplace_back("markers of edges and edges inside the domain");
  if (!kept.markers_of_points && (from == PointMarkers::file ? !mesh.point_markers.empty() : has_markers_apart(mesh)))
    list.emplace_back("markers of points");
  add_losses_beside(mesh, kept, list);
  return joined(list);
}

void note_losses(const std::string& list, const std::filesystem::path& file, std::optional<MeshFormat> format) {
  if (list.empty()) return;
  const bool is_stream = format && !mesh_format(file);
  warn(fmt::format("{}: note: {} cannot store: {}", file.string(), is_stream ? "its format" : file.extension().string(),
                   list));
}

MeshFormat format_of_output(const std::filesystem::path& file, std::optional<MeshFormat> of_stream) {
  return of_stream && file == "-" ? *of_stream : mesh_format(file).value_or(MeshFormat::svg);
}

std::string text_of(const GroupName& name) {
  return fmt::format("{} {} {}", name.of == GroupName::Of::marker ? "marker" : "region", name.value,
                     in_marks(name.name));
}

}  // namespace pardel::cli
