#include "drawn_cells.hpp"

#include <cmath>
#include <optional>
#include <vector>

#include "../core/support/doubled_area.hpp"
#include "../core/support/shortest.hpp"
#include "../parallel/mesher.hpp"
#include "../parallel/repair.hpp"

namespace pardel::fuzz {
namespace {

using generators::Random;

constexpr int side_of_frame = 5;  ///< its hole has a side of three squares
constexpr double attribute_of_frame = 100;

/// A ring around the square from (low, low) to (high, high). With all vertices, each unit of a side is an edge.
std::string ring(int x, int y, int length, bool all_vertices) {
  const int step = all_vertices ? 1 : length;
  std::vector<Point> points;
  const auto go = [&](int from_x, int from_y, int dx, int dy) {
    for (int i = 0; i < length; i += step)
      points.push_back({static_cast<double>(from_x + i * dx), static_cast<double>(from_y + i * dy)});
  };
  go(x, y, 1, 0);
  go(x + length, y, 0, 1);
  go(x + length, y + length, -1, 0);
  go(x, y + length, 0, -1);
  points.push_back(points.front());
  std::string text;
  for (const Point& p : points) text += (text.empty() ? "[[" : ",[") + shortest(p.x) + "," + shortest(p.y) + "]";
  return text + "]";
}

std::string feature(const std::string& properties, const std::string& rings) {
  return R"({"type":"Feature","properties":{)" + properties + R"(},"geometry":{"type":"Polygon","coordinates":[)" +
         rings + "]}}";
}

std::optional<Meshed> triangulated(const Pslg& domain) {
  if (Result<Meshed> meshed = triangulate(domain)) return std::move(*meshed);
  const Result<Repaired> repaired = repair(domain);
  if (!repaired) return {};
  Result<Meshed> meshed = triangulate(repaired->domain);
  if (!meshed) return {};
  return std::move(*meshed);
}

}  // namespace

DrawnCells any_cells(Random& random) {
  DrawnCells cells;
  const bool all_vertices = random.chance(2);
  const int hole = side_of_frame - 2;
  std::string features = feature(R"("attribute":)" + shortest(attribute_of_frame),
                                 ring(0, 0, side_of_frame, all_vertices) + "," + ring(1, 1, hole, all_vertices));
  cells.area_of[attribute_of_frame] = side_of_frame * side_of_frame - hole * hole;
  for (int x = 1; x <= hole; ++x)
    for (int y = 1; y <= hole; ++y) {
      const int kind = random.between(0, 3);  // 0: nothing; 1: a hole; others: a material
      if (kind == 0) continue;
      const int attribute = random.between(1, 3);
      features += ",\n" + feature(kind == 1 ? R"("hole":true)" : R"("attribute":)" + std::to_string(attribute),
                                  ring(x, y, 1, true));
      if (kind > 1) cells.area_of[attribute] += 1;
    }
  cells.text = R"({"type":"FeatureCollection","features":[)" + features + "]}";
  return cells;
}

std::string difference(const Pslg& domain, const DrawnCells& cells) {
  const std::optional<Meshed> meshed = triangulated(domain);
  if (!meshed) return "the domain has no mesh";
  const Mesh& mesh = meshed->mesh;
  std::map<double, double> area_of;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& v = mesh.triangles[t].v;
    const Index region = mesh.region.empty() ? no_index : mesh.region[t];
    area_of[region == no_index ? 0 : mesh.region_attributes[region]] +=
        0.5 * doubled_area(mesh.points[v[0]], mesh.points[v[1]], mesh.points[v[2]]);
  }
  for (const auto& [attribute, area] : area_of)
    if (const auto drawn = cells.area_of.find(attribute); drawn == cells.area_of.end() || drawn->second != area)
      return "the region " + shortest(attribute) + " has the area " + shortest(area);
  return area_of.size() == cells.area_of.size() ? "" : "a region is missing";
}

}  // namespace pardel::fuzz
