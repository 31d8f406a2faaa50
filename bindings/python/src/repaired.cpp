#include "repaired.hpp"

#include <utility>

namespace pardel::python {
namespace {

/// The attributes of all points, each followed by another number.
std::vector<double> with_column(const Pslg& domain, const std::vector<double>& column) {
  std::vector<double> wider;
  wider.reserve(domain.point_attributes.size() + column.size());
  for (std::size_t p = 0; p < column.size(); ++p) {
    const auto first = domain.point_attributes.begin() + static_cast<std::ptrdiff_t>(p * domain.attributes_per_point);
    wider.insert(wider.end(), first, first + static_cast<std::ptrdiff_t>(domain.attributes_per_point));
    wider.push_back(column[p]);
  }
  return wider;
}

}  // namespace

Result<Repaired> repaired_with(std::vector<double>& lengths, const Pslg& domain, const RepairOptions& options) {
  const bool is_complete = lengths.size() == domain.points.size() &&
                           domain.point_attributes.size() == domain.points.size() * domain.attributes_per_point;
  if (lengths.empty() || !is_complete) return repair(domain, options);
  Pslg wider = domain;
  wider.point_attributes = with_column(domain, lengths);
  ++wider.attributes_per_point;
  Result<Repaired> repaired = repair(wider, options);
  if (!repaired) return repaired;

  Pslg narrow = repaired->domain.pslg();
  const std::size_t columns = narrow.attributes_per_point--;
  lengths.clear();
  std::vector<double> attributes;
  for (std::size_t k = 0; k < narrow.point_attributes.size(); ++k)
    (k % columns == columns - 1 ? lengths : attributes).push_back(narrow.point_attributes[k]);
  narrow.point_attributes = std::move(attributes);
  Result<ValidPslg, std::vector<Problem>> valid =
      validate(std::move(narrow), {.convex_hull = repaired->domain.convex_hull()});
  if (!valid) return Error{ErrorKind::internal, "a repaired domain is not valid"};
  repaired->domain = std::move(*valid);
  return repaired;
}

}  // namespace pardel::python
