#include "places.hpp"

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
  cli::DrawnLengths lengths = value_of(cli::lengths_of(std::move(drawing), name, mended));
  return {.drawn = std::move(lengths), .name = std::move(name)};
}

void add_places(const Places& places, const ValidPslg& domain, Goal& goal) {
  require(cli::add_rules(places.rules, places.name, domain, goal));
  cli::add_lengths(places.drawn.size, places.drawn.sources, goal);
}

}  // namespace pardel::python
