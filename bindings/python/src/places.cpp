#include "places.hpp"

#include <algorithm>
#include <iterator>
#include <pardel/parallel/repair.hpp>
#include <utility>

#include "../../../cli/size_rules.hpp"
#include "errors.hpp"

namespace pardel::python {
namespace {

Result<ValidPslg> mended(cli::FramedSides sides) {
  Result<ValidPslg, std::vector<Problem>> valid = validate(sides.pslg, {.convex_hull = true});
  if (valid) return std::move(*valid);
  Result<Repaired> repaired = repair(sides.pslg, {.convex_hull = true});
  if (!repaired) return repaired.error();
  return std::move(repaired->domain);
}

}  // namespace

Places places_of(cli::DrawnDomain drawing, std::string name) {
  std::vector<cli::DrawnPolygon> polygons;
  std::ranges::copy_if(drawing.polygons, std::back_inserter(polygons),
                       [](const cli::DrawnPolygon& polygon) { return polygon.length.has_value(); });
  cli::DrawnLengths lengths = value_of(cli::lengths_of(std::move(drawing), name, mended));
  return {.drawn = std::move(lengths), .polygons = std::move(polygons), .name = std::move(name)};
}

Places places_of(std::vector<cli::DrawnPolygon> polygons, std::vector<SizeSource> sources, std::string name) {
  cli::DrawnDomain drawing{{}, std::move(polygons), std::move(sources)};
  for (const cli::DrawnPolygon& polygon : drawing.polygons)
    for (const std::vector<Point>& ring : polygon.rings)
      drawing.pslg.points.insert(drawing.pslg.points.end(), ring.begin(), ring.end());
  return places_of(std::move(drawing), std::move(name));
}

void add_places(const Places& places, const ValidPslg& domain, Goal& goal) {
  require(cli::add_rules(places.rules, places.name, domain, goal));
  cli::add_lengths(places.drawn.size, places.drawn.sources, goal);
}

}  // namespace pardel::python
