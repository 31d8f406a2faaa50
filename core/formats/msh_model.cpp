#include "msh_model.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace pardel::files {
namespace {

constexpr double no_attribute = std::numeric_limits<double>::quiet_NaN();

/// The names of markers or of regions.
using Names = std::map<int, std::string>;

Names names_of(const Mesh& mesh, GroupName::Of of) {
  Names names;
  for (const GroupName& name : mesh.names)
    if (name.of == of) names[name.value] = name.name;
  return names;
}

/// Makes one group per value. The tag of a group is the value itself if that is a positive int, else the smallest free
/// number. The names that are used are removed from `names`.
std::vector<MshGroup> groups_of(const std::vector<double>& values, const std::string& prefix, Names& names) {
  const auto is_tag = [](double v) { return v >= 1 && v <= std::numeric_limits<int>::max() && v == std::floor(v); };
  std::set<int> taken;
  for (const auto& [tag, name] : names) taken.insert(tag);
  for (const double value : values) {
    if (is_tag(value)) taken.insert(static_cast<int>(value));
  }
  std::vector<MshGroup> groups;
  int free = 1;
  for (const double value : values) {
    MshGroup group;
    group.name = std::isnan(value) ? "domain" : std::string((Bytes() << prefix << ' ' << value).view());
    if (is_tag(value)) {
      group.tag = static_cast<int>(value);
      if (const auto named = names.extract(group.tag); !named.empty()) group.name = named.mapped();
    } else {
      while (!taken.insert(free).second) ++free;
      group.tag = free;
    }
    groups.push_back(std::move(group));
  }
  return groups;
}

std::size_t place_of(const std::vector<double>& values, double value) {
  if (values.empty()) return 0;
  const auto end = std::isnan(values.back()) ? values.end() - 1 : values.end();
  return static_cast<std::size_t>((std::isnan(value) ? end : std::lower_bound(values.begin(), end, value)) -
                                  values.begin());
}

/// The attributes of the regions, and one for triangles without a region.
std::vector<double> attributes_of_regions(const Mesh& mesh) {
  std::vector<double> attributes = mesh.region_attributes;
  attributes.push_back(no_attribute);
  return attributes;
}

/// The place in attributes_of_regions().
std::size_t region_of(const Mesh& mesh, std::size_t t) {
  const Index region = mesh.region.empty() ? no_index : mesh.region[t];
  return region == no_index ? mesh.region_attributes.size() : region;
}

void write_entity(MshRows& out, const MshGroup& g) {
  const MshBox box = g.box.finite();
  const std::size_t none = 0, one = 1;
  out.row(g.tag, box.low.x, box.low.y, 0.0, box.high.x, box.high.y, 0.0, one, g.tag, none);
}

}  // namespace

void MshBox::cover(const Point& p) { cover(MshBox{p, p}); }

void MshBox::cover(const MshBox& other) {
  low = {std::min(low.x, other.low.x), std::min(low.y, other.low.y)};
  high = {std::max(high.x, other.high.x), std::max(high.y, other.high.y)};
}

std::size_t Gathered::groups_in_use() const {
  std::size_t used = 0;
  for (std::size_t g = 0; g + 1 < start.size(); ++g) used += start[g] < start[g + 1] ? 1 : 0;
  return used;
}

std::vector<double> distinct(std::vector<double> values) {
  const auto end = std::partition(values.begin(), values.end(), [](double v) { return !std::isnan(v); });
  const bool none = end != values.end();
  std::sort(values.begin(), end);
  values.erase(std::unique(values.begin(), end), values.end());
  if (none) values.push_back(no_attribute);
  return values;
}

MshValues values_of(const Mesh& mesh) {
  MshValues values;
  for (const ConstrainedEdge& e : mesh.constrained_edges) values.markers.push_back(e.marker);
  const std::vector<double> attributes = attributes_of_regions(mesh);
  std::vector<char> used(attributes.size(), 0);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) used[region_of(mesh, t)] = 1;
  for (std::size_t r = 0; r < attributes.size(); ++r)
    if (used[r] != 0) values.attributes.push_back(attributes[r]);
  return {distinct(std::move(values.markers)), distinct(std::move(values.attributes))};
}

MshModel msh_model(const Mesh& mesh, MshValues values) {
  if (values.attributes.empty()) values.attributes.push_back(no_attribute);  // each point needs an entity
  MshModel model;
  Names markers = names_of(mesh, GroupName::Of::marker), regions = names_of(mesh, GroupName::Of::region);
  model.curves = groups_of(values.markers, "marker", markers);
  model.lines = gather(mesh.constrained_edges.size(), model.curves.size(),
                       [&](std::size_t i) { return place_of(values.markers, mesh.constrained_edges[i].marker); });
  std::vector<std::size_t> surface_of_region;
  for (const double attribute : attributes_of_regions(mesh))
    surface_of_region.push_back(place_of(values.attributes, attribute));
  model.surfaces = groups_of(values.attributes, "region", regions);
  for (const auto& [tag, name] : markers) model.empty_groups.push_back({GroupName::Of::marker, tag, name});
  for (const auto& [tag, name] : regions) model.empty_groups.push_back({GroupName::Of::region, tag, name});
  model.triangles = gather(mesh.triangles.size(), model.surfaces.size(),
                           [&](std::size_t t) { return surface_of_region[region_of(mesh, t)]; });

  model.entity_of_point.resize(mesh.points.size(), static_cast<Index>(model.curves.size()));
  const auto assign = [&](std::size_t entity, MshGroup& group, Index point) {
    model.entity_of_point[point] = static_cast<Index>(entity);
    group.box.cover(mesh.points[point]);
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
  return model;
}

void write_names(MshRows& out, const MshModel& model) {
  Bytes to;
  to << "$PhysicalNames\n" << model.curves.size() + model.surfaces.size() + model.empty_groups.size() << '\n';
  for (const MshGroup& g : model.curves) to << "1 " << g.tag << " \"" << g.name << "\"\n";
  for (const MshGroup& g : model.surfaces) to << "2 " << g.tag << " \"" << g.name << "\"\n";
  for (const GroupName& g : model.empty_groups)
    to << (g.of == GroupName::Of::marker ? "1 " : "2 ") << g.value << " \"" << g.name << "\"\n";
  out.text(to << "$EndPhysicalNames\n");
}

void write_entities(MshRows& out, const MshModel& model) {
  const std::size_t none = 0;
  out.open("Entities");
  out.row(none, model.curves.size(), model.surfaces.size(), none);
  for (const MshGroup& g : model.curves) write_entity(out, g);
  for (const MshGroup& g : model.surfaces) write_entity(out, g);
  out.close("Entities");
}

}  // namespace pardel::files
