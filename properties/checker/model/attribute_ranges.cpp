#include "attribute_ranges.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "../tolerances.hpp"

namespace pardel::checker {

bool AttributeRange::contains(double value) const {
  const double spare = attribute_tolerance * std::max(std::abs(least), std::abs(greatest));
  return std::isfinite(value) && value >= least - spare && value <= greatest + spare;
}

AttributeRanges::AttributeRanges(const Pslg& pslg) : pslg_(&pslg) {
  const std::size_t k = pslg.attributes_per_point;
  if (k == 0 || pslg.points.empty() || pslg.point_attributes.size() != k * pslg.points.size()) return;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::vector<char> is_finite(k, 1);
  ranges_.assign(k, {infinity, -infinity});
  for (std::size_t i = 0; i < pslg.point_attributes.size(); ++i) {
    const double value = pslg.point_attributes[i];
    AttributeRange& range = ranges_[i % k];
    if (!std::isfinite(value)) is_finite[i % k] = 0;
    range = {std::min(range.least, value), std::max(range.greatest, value)};
  }
  for (std::size_t a = 0; a < k; ++a)
    if (is_finite[a] == 0) ranges_[a] = {-infinity, infinity};
}

AttributeRange AttributeRanges::between(std::size_t attribute, const Segment& segment) const {
  const std::size_t k = ranges_.size();
  const auto [least, greatest] = std::minmax(pslg_->point_attributes[segment.a * k + attribute],
                                             pslg_->point_attributes[segment.b * k + attribute]);
  return {least, greatest};
}

std::optional<AttributeOutside> AttributeRanges::first_outside(const Mesh& mesh, Index v, const Segment* on) const {
  const std::size_t k = ranges_.size();
  if (k == 0 || mesh.attributes_per_point != k || mesh.point_attributes.size() != k * mesh.points.size()) return {};
  for (std::size_t a = 0; a < k; ++a) {
    if (std::isinf(ranges_[a].greatest)) continue;
    const AttributeRange range = on == nullptr ? ranges_[a] : between(a, *on);
    if (!range.contains(mesh.point_attributes[v * k + a])) return AttributeOutside{a, range};
  }
  return {};
}

}  // namespace pardel::checker
