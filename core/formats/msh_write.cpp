// Writes Gmsh's MSH 4.1, ASCII and binary (gmsh.info, "MSH file format"). Regions and markers are physical groups, each
// with one entity: surfaces `region ATTRIBUTE` (`domain` for triangles without a region), curves `marker NUMBER`. The
// tag of a group is the attribute or marker itself if that is a positive int, else the smallest free number.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <tuple>

#include "../formats.hpp"
#include "records.hpp"

namespace pardel {
using namespace files;
namespace {

/// A physical group and its only entity, which has the same tag.
struct Group {
  std::string name;
  int tag = 0;
  Point low{std::numeric_limits<double>::max(), std::numeric_limits<double>::max()};
  Point high{std::numeric_limits<double>::lowest(), std::numeric_limits<double>::lowest()};

  void cover(const Point& p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
};

/// Makes one group per value. The values are ascending and distinct; a NaN at the end means "no region".
std::vector<Group> groups_of(const std::vector<double>& values, const std::string& prefix) {
  const auto is_tag = [](double v) { return v >= 1 && v <= std::numeric_limits<int>::max() && v == std::floor(v); };
  std::set<int> taken;
  for (const double value : values) {
    if (is_tag(value)) taken.insert(static_cast<int>(value));
  }
  std::vector<Group> groups;
  int free = 1;
  for (const double value : values) {
    Group group;
    group.name = std::isnan(value) ? "domain" : std::string((Bytes() << prefix << ' ' << value).view());
    if (is_tag(value)) {
      group.tag = static_cast<int>(value);
    } else {
      while (!taken.insert(free).second) ++free;
      group.tag = free;
    }
    groups.push_back(std::move(group));
  }
  return groups;
}

/// The numbers 0 .. n-1 by group. Group g has members[start[g]] .. members[start[g + 1] - 1], in ascending order.
struct Gathered {
  std::vector<std::size_t> start;
  Array<Index> members;
  [[nodiscard]] std::span<const Index> operator[](std::size_t g) const {
    return members.span().subspan(start[g], start[g + 1] - start[g]);
  }
  [[nodiscard]] std::size_t groups_in_use() const {
    std::size_t used = 0;
    for (std::size_t g = 0; g + 1 < start.size(); ++g) used += start[g] < start[g + 1] ? 1 : 0;
    return used;
  }
};

template <class GroupOf>
Gathered gather(std::size_t n, std::size_t groups, const GroupOf& group_of) {
  Gathered gathered{std::vector<std::size_t>(groups + 1, 0), Array<Index>(n)};
  for (std::size_t i = 0; i < n; ++i) ++gathered.start[group_of(i) + 1];
  for (std::size_t g = 0; g < groups; ++g) gathered.start[g + 1] += gathered.start[g];
  std::vector<std::size_t> next = gathered.start;
  for (std::size_t i = 0; i < n; ++i) gathered.members[next[group_of(i)]++] = static_cast<Index>(i);
  return gathered;
}

/// The mesh in Gmsh's terms: everything belongs to an entity. The numbers of curves come before those of surfaces.
struct Model {
  std::vector<Group> curves;
  std::vector<Group> surfaces;
  Gathered lines;      ///< the constrained edges, grouped by curve
  Gathered triangles;  ///< grouped by surface
  Gathered points;     ///< grouped by curve, then by surface
};

std::size_t place_of(const std::vector<double>& values, double value) {
  const auto end = std::isnan(values.back()) ? values.end() - 1 : values.end();
  return static_cast<std::size_t>((std::isnan(value) ? end : std::lower_bound(values.begin(), end, value)) -
                                  values.begin());
}

/// The distinct values in ascending order; a NaN, if any, comes last.
std::vector<double> distinct(std::vector<double> values) {
  const auto end = std::partition(values.begin(), values.end(), [](double v) { return !std::isnan(v); });
  const bool none = end != values.end();
  std::sort(values.begin(), end);
  values.erase(std::unique(values.begin(), end), values.end());
  if (none) values.push_back(std::numeric_limits<double>::quiet_NaN());
  return values;
}

Model model_of(const Mesh& mesh) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  Model model;
  std::vector<double> markers;
  for (const ConstrainedEdge& e : mesh.constrained_edges) markers.push_back(e.marker);
  markers = distinct(std::move(markers));
  model.curves = groups_of(markers, "marker");
  model.lines = gather(mesh.constrained_edges.size(), model.curves.size(),
                       [&](std::size_t i) { return place_of(markers, mesh.constrained_edges[i].marker); });

  // The surface of each region; the last entry is for triangles without a region.
  std::vector<double> attributes = mesh.region_attributes;
  attributes.push_back(none);
  std::vector<char> used(attributes.size(), 0);
  const auto region_of = [&](std::size_t t) -> std::size_t {
    const Index region = mesh.region.empty() ? no_index : mesh.region[t];
    return region == no_index ? attributes.size() - 1 : region;
  };
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) used[region_of(t)] = 1;
  if (mesh.triangles.empty()) used.back() = 1;  // each point needs an entity
  std::vector<double> values;
  for (std::size_t r = 0; r < attributes.size(); ++r) {
    if (used[r] != 0) values.push_back(attributes[r]);
  }
  values = distinct(std::move(values));
  std::vector<std::size_t> surface_of_region;
  for (const double attribute : attributes) surface_of_region.push_back(place_of(values, attribute));
  model.surfaces = groups_of(values, "region");
  model.triangles = gather(mesh.triangles.size(), model.surfaces.size(),
                           [&](std::size_t t) { return surface_of_region[region_of(t)]; });

  // A point belongs to the first curve through it, else to a surface around it, else to the first surface.
  Array<Index> entity_of_point(mesh.points.size(), static_cast<Index>(model.curves.size()));
  const auto assign = [&](std::size_t entity, Group& group, Index point) {
    entity_of_point[point] = static_cast<Index>(entity);
    group.cover(mesh.points[point]);
  };
  for (std::size_t s = model.surfaces.size(); s-- > 0;) {
    for (const Index t : model.triangles[s]) {
      for (const Index v : mesh.triangles[t].v) assign(model.curves.size() + s, model.surfaces[s], v);
    }
  }
  for (std::size_t c = model.curves.size(); c-- > 0;) {
    for (const Index i : model.lines[c]) {
      for (const Index v : {mesh.constrained_edges[i].a, mesh.constrained_edges[i].b}) assign(c, model.curves[c], v);
    }
  }
  model.points = gather(mesh.points.size(), model.curves.size() + model.surfaces.size(),
                        [&](std::size_t i) { return entity_of_point[i]; });
  return model;
}

/// Writes numbers in the encoding of the file. In ASCII they are rows of text; in binary they are consecutive bytes.
class MshWriter {
 public:
  MshWriter(OutputFile& out, MshEncoding encoding) : out_(out), binary_(encoding == MshEncoding::binary) {}

  void write(const Mesh& mesh) {
    const Model model = model_of(mesh);
    write_format();
    write_names(model);
    write_entities(model);
    write_nodes(model, mesh);
    write_elements(model, mesh);
  }

 private:
  /// The format distinguishes int, std::size_t and double. Each argument must have the type that the format prescribes.
  template <class... Numbers>
  void row(Bytes& to, Numbers... numbers) const {
    if (binary_) {
      (to.raw(numbers), ...);
    } else {
      to.numbers(numbers...) << '\n';
    }
  }
  template <class... Numbers>
  void write_row(Numbers... numbers) {
    Bytes to;
    row(to, numbers...);
    out_.write(to.view());
  }
  /// Writes n rows: numbers(i) returns an array of the numbers of row i.
  template <class NumbersOf>
  void write_rows(std::size_t n, const NumbersOf& numbers) {
    if (binary_) return write_values(out_, n, numbers);
    write_records(out_, n,
                  [&](Bytes& to, std::size_t i) { std::apply([&](auto... each) { row(to, each...); }, numbers(i)); });
  }
  void open(std::string_view section) { out_.write((Bytes() << '$' << section << '\n').view()); }
  void close(std::string_view section) {
    out_.write((Bytes() << (binary_ ? "\n" : "") << "$End" << section << '\n').view());
  }

  void write_format() {
    open("MeshFormat");
    out_.write(binary_ ? "4.1 1 8\n" : "4.1 0 8\n");
    if (binary_) write_row(1);
    close("MeshFormat");
  }

  /// Writes text, in ASCII and in binary files.
  void write_names(const Model& model) {
    Bytes to;
    to << "$PhysicalNames\n" << model.curves.size() + model.surfaces.size() << '\n';
    for (const Group& g : model.curves) to << "1 " << g.tag << " \"" << g.name << "\"\n";
    for (const Group& g : model.surfaces) to << "2 " << g.tag << " \"" << g.name << "\"\n";
    out_.write((to << "$EndPhysicalNames\n").view());
  }

  void write_entities(const Model& model) {
    const std::size_t none = 0;
    const std::size_t one = 1;
    open("Entities");
    write_row(none, model.curves.size(), model.surfaces.size(), none);
    for (const auto* groups : {&model.curves, &model.surfaces}) {
      for (const Group& g : *groups) {
        const bool empty = g.low.x > g.high.x;
        const Point low = empty ? Point{} : g.low;
        const Point high = empty ? Point{} : g.high;
        write_row(g.tag, low.x, low.y, 0.0, high.x, high.y, 0.0, one, g.tag, none);
      }
    }
    close("Entities");
  }

  void write_nodes(const Model& model, const Mesh& mesh) {
    const std::size_t n = mesh.points.size();
    open("Nodes");
    write_row(model.points.groups_in_use(), n, std::size_t{n > 0}, n);
    for (std::size_t e = 0; e < model.curves.size() + model.surfaces.size(); ++e) {
      const auto points = model.points[e];
      if (points.empty()) continue;
      const bool curve = e < model.curves.size();
      const Group& group = curve ? model.curves[e] : model.surfaces[e - model.curves.size()];
      write_row(curve ? 1 : 2, group.tag, 0, points.size());
      write_rows(points.size(), [&](std::size_t i) { return std::array{std::size_t{points[i]} + 1}; });
      write_rows(points.size(), [&](std::size_t i) {
        const Point& p = mesh.points[points[i]];
        return std::array{p.x, p.y, 0.0};
      });
    }
    close("Nodes");
  }

  void write_elements(const Model& model, const Mesh& mesh) {
    constexpr int line = 1;
    constexpr int triangle = 2;
    const std::size_t lines = mesh.constrained_edges.size();
    const std::size_t n = lines + mesh.triangles.size();
    open("Elements");
    write_row(model.lines.groups_in_use() + model.triangles.groups_in_use(), n, std::size_t{n > 0}, n);
    for (std::size_t c = 0; c < model.curves.size(); ++c) {
      const auto members = model.lines[c];
      write_row(1, model.curves[c].tag, line, members.size());
      write_rows(members.size(), [&](std::size_t i) {
        const ConstrainedEdge& e = mesh.constrained_edges[members[i]];
        return std::array{std::size_t{members[i]} + 1, std::size_t{e.a} + 1, std::size_t{e.b} + 1};
      });
    }
    for (std::size_t s = 0; s < model.surfaces.size(); ++s) {
      const auto members = model.triangles[s];
      if (members.empty()) continue;
      write_row(2, model.surfaces[s].tag, triangle, members.size());
      write_rows(members.size(), [&](std::size_t i) {
        const auto& v = mesh.triangles[members[i]].v;
        return std::array{lines + members[i] + 1, std::size_t{v[0]} + 1, std::size_t{v[1]} + 1, std::size_t{v[2]} + 1};
      });
    }
    close("Elements");
  }

  OutputFile& out_;
  bool binary_;
};

}  // namespace

Status write_msh(const Mesh& mesh, const std::filesystem::path& file, MshEncoding encoding) {
  OutputFile out(file);
  MshWriter(out, encoding).write(mesh);
  return out.commit();
}

}  // namespace pardel
