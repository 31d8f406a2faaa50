#include "labels.hpp"

#include <gmpxx.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "../../core/support/same_attribute.hpp"

namespace pardel::fuzz {

using ref::Corners;
using ref::Edge;

namespace {

/// The rule of the program Triangle: the wall's own marker if it is not zero, else 1 on the boundary, else 0.
int marker_of(const Wall& wall) { return wall.marker != 0 ? wall.marker : wall.sides_inside() == 1 ? 1 : 0; }

}  // namespace

std::set<Index> with_wrong_origin(const ExactMesh& mesh, const Pslg& pslg, const WallsOfMesh& walls) {
  std::set<Index> found;
  for (Index v = 0; v < mesh.given.origin.size(); ++v) {
    const Wall* wall = walls.of_vertex[v];
    const Index origin = v < pslg.points.size()      ? input_vertex
                         : wall == nullptr           ? interior_vertex
                         : wall->segment == no_index ? hull_vertex
                                                     : origin_on_segment(wall->segment);
    if (mesh.given.origin[v] != origin) found.insert(v);
  }
  return found;
}

std::set<Index> with_wrong_marker(const ExactMesh& mesh, const Pslg& pslg, const InputFaces& faces,
                                  const WallsOfMesh& walls, bool foreign) {
  std::vector<std::set<int>> possible(mesh.given.points.size());
  for (const auto& [e, wall] : walls.of_edge)
    for (const Index v : e)
      if (const int marker = marker_of(*wall); marker != 0) possible[v].insert(marker);
  // Triangle marks the ends of segments outside the domain, too.
  for (const Wall& wall : faces.walls())
    if (foreign && wall.sides_inside() == 0 && wall.marker != 0)
      for (const Index end : {wall.a, wall.b}) possible[end].insert(wall.marker);
  std::set<Index> found;
  for (Index v = 0; v < mesh.given.point_markers.size(); ++v) {
    const int own = v < pslg.point_markers.size() ? pslg.point_markers[v] : 0;
    if (own != 0) possible[v] = {own};
    if (own == 0 && !mesh.has_triangle[v]) continue;
    if (possible[v].empty()) possible[v] = {0};
    if (!possible[v].contains(mesh.given.point_markers[v])) found.insert(v);
  }
  return found;
}

ListFaults faults_of_list(const ExactMesh& mesh, const WallsOfMesh& walls, bool foreign) {
  ListFaults faults;
  const auto& list = mesh.given.constrained_edges;
  if (foreign && list.empty()) return faults;
  // A file may list edges without markers.
  const bool has_markers =
      !foreign || std::ranges::any_of(list, [](const ConstrainedEdge& edge) { return edge.marker != 0; });
  Edges listed;
  for (Index i = 0; i < list.size(); ++i) {
    const ConstrainedEdge& edge = list[i];
    const Edge e = ref::edge(edge.a, edge.b);
    const auto wall = walls.of_edge.find(e);
    if (wall == walls.of_edge.end() || !listed.insert(e).second) {
      faults.wrong.insert(i);
      continue;
    }
    const bool may_be_unknown = foreign && edge.segment == no_index;
    if (edge.segment != wall->second->segment && !may_be_unknown) faults.wrong.insert(i);
    if (has_markers && edge.marker != marker_of(*wall->second)) faults.wrong_marker.insert(i);
  }
  for (const auto& [e, wall] : walls.of_edge)
    if (!listed.contains(e)) faults.missing.insert(e);
  return faults;
}

Triangles with_wrong_region(const ExactMesh& mesh, const Pslg& pslg, const InputFaces& faces,
                            const std::vector<InputFaces::Face>& face, bool foreign) {
  if (mesh.given.region.empty() || (foreign && pslg.regions.empty())) return {};
  return triangles_that(mesh, [&](Index t, const Corners&) {
    const std::set<Index> regions = faces.regions_in(face[t]);
    const Index given = mesh.given.region[t];
    if (given == no_index) return !regions.empty();
    const double attribute = mesh.given.region_attributes[given];
    if (regions.empty()) return !foreign || attribute != 0;
    return std::ranges::none_of(regions, [&](Index region) {
      return (foreign || given == region) && attribute == pslg.regions[region].attribute;
    });
  });
}

Triangles larger_than_caps(const ExactMesh& mesh, const Pslg& pslg, const InputFaces& faces,
                           const std::vector<InputFaces::Face>& face) {
  return triangles_that(mesh, [&](Index t, const Corners& c) {
    const std::set<Index> regions = faces.regions_in(face[t]);
    return std::ranges::any_of(regions, [&](Index r) {
      const double cap = pslg.regions[r].max_area;
      return std::isfinite(cap) && ref::area(mesh.plain, c) > cap;
    });
  });
}

namespace {

/// Is a value between the least and the greatest of others, up to a billionth of the larger magnitude?
bool is_in_range(double value, const std::vector<double>& others) {
  if (!std::isfinite(value)) return false;
  const auto [least, greatest] = std::ranges::minmax(others);
  const mpq_class spare = mpq_class(1e-9) * std::max(std::abs(least), std::abs(greatest));
  return least - spare <= value && value <= greatest + spare;
}

/// Is attribute k in its range at each inserted vertex? `range(v)`: the input points whose values are the range at v.
/// Where the input has values that are not finite, every value is.
template <class Range>
void add_out_of_range(const ExactMesh& mesh, const Pslg& pslg, std::size_t k, const Range& range,
                      std::set<Index>& found) {
  const std::size_t per_point = mesh.given.attributes_per_point;
  const auto of_input = [&](Index point) { return pslg.point_attributes[point * per_point + k]; };
  for (Index i = 0; i < pslg.points.size(); ++i)
    if (!std::isfinite(of_input(i))) return;
  for (auto v = static_cast<Index>(pslg.points.size()); v < mesh.given.points.size(); ++v) {
    std::vector<double> values;
    for (const Index i : range(v)) values.push_back(of_input(i));
    if (!is_in_range(mesh.given.point_attributes[v * per_point + k], values)) found.insert(v);
  }
}

}  // namespace

std::set<Index> with_wrong_attributes(const ExactMesh& mesh, const Pslg& pslg, const WallsOfMesh* walls) {
  std::set<Index> found;
  const std::size_t per_point = mesh.given.attributes_per_point, of_input = pslg.point_attributes.size();
  if (per_point == 0 || of_input == 0) return found;  // a foreign mesh may have none
  for (std::size_t i = 0; i < of_input; ++i)
    if (!is_same_attribute(mesh.given.point_attributes[i], pslg.point_attributes[i]))
      found.insert(static_cast<Index>(i / per_point));
  std::vector<Index> all(pslg.points.size());
  std::iota(all.begin(), all.end(), Index{0});
  const auto range = [&](Index v) {
    const Wall* wall = walls == nullptr ? nullptr : walls->of_vertex[v];
    return wall == nullptr || wall->segment == no_index ? all : std::vector{wall->a, wall->b};
  };
  for (std::size_t k = 0; k < per_point; ++k) add_out_of_range(mesh, pslg, k, range, found);
  return found;
}

}  // namespace pardel::fuzz
