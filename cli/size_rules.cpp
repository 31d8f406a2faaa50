#include "size_rules.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

#include "../core/support/shortest.hpp"
#include "../parallel/mesher.hpp"
#include "../parallel/sizes.hpp"

namespace pardel::cli {
namespace {

/// A place that was not read from a file has no line.
std::string place_of(const std::string& name, std::size_t line) {
  return line == 0 ? name : fmt::format("{}:{}", name, line);
}

SizeSource source(Point a, Point b, double length) { return {a, b, length, length}; }

/// Adds the segments and points with the marker. Returns false if there is none.
bool add_marked(const SizeRules::OnMarker& rule, const Pslg& pslg, std::vector<SizeSource>& sources) {
  const std::size_t before = sources.size();
  for (const Segment& s : pslg.segments)
    if (s.marker == rule.marker) sources.push_back(source(pslg.points[s.a], pslg.points[s.b], rule.length));
  for (std::size_t v = 0; v < pslg.point_markers.size(); ++v)
    if (pslg.point_markers[v] == rule.marker) sources.push_back(source(pslg.points[v], pslg.points[v], rule.length));
  return sources.size() > before;
}

/// The least length of the rules for each region; infinity: there is none.
Result<std::vector<double>> lengths_in_regions(const SizeRules& rules, const std::string& name, const Pslg& pslg) {
  std::vector<double> lengths(pslg.regions.size(), std::numeric_limits<double>::infinity());
  for (const SizeRules::InRegion& rule : rules.regions) {
    bool found = false;
    for (std::size_t r = 0; r < pslg.regions.size(); ++r) {
      if (pslg.regions[r].attribute != rule.attribute) continue;
      found = true;
      lengths[r] = std::min(lengths[r], rule.length);
    }
    if (!found)
      return Error{ErrorKind::invalid_input, fmt::format("{}: no region of the domain has the attribute {}",
                                                         place_of(name, rule.line), shortest(rule.attribute))};
  }
  return lengths;
}

Status add_regions(const SizeRules& rules, const std::string& name, const ValidPslg& domain, Goal& goal) {
  if (rules.regions.empty()) return Done{};
  const Result<std::vector<double>> lengths = lengths_in_regions(rules, name, domain.pslg());
  if (!lengths) return lengths.error();
  const Result<RegionSizes> sizes = region_sizes(domain, *lengths);
  if (!sizes) return sizes.error();
  add_lengths(sizes->size, sizes->borders, goal);
  return Done{};
}

}  // namespace

Status add_rules(const SizeRules& rules, const std::string& name, const ValidPslg& domain, Goal& goal) {
  for (const SizeRules::AtPoint& rule : rules.points)
    goal.sources.push_back(source(rule.place, rule.place, rule.length));
  for (const SizeRules::OnMarker& rule : rules.markers)
    if (!add_marked(rule, domain.pslg(), goal.sources))
      return Error{ErrorKind::invalid_input, fmt::format("{}: no segment and no point of the domain has the marker {}",
                                                         place_of(name, rule.line), rule.marker)};
  return add_regions(rules, name, domain, goal);
}

void add_lengths(const std::function<double(Point)>& size, std::span<const SizeSource> sources, Goal& goal) {
  goal.sources.insert(goal.sources.end(), sources.begin(), sources.end());
  if (!size) return;
  if (!goal.size)
    goal.size = size;
  else
    goal.size = [field = std::move(goal.size), size](Point p) { return std::min(field(p), size(p)); };
}

}  // namespace pardel::cli
