#include "defects.hpp"

#include <vector>

#include "defect_groups.hpp"

namespace pardel::defects {

std::span<const Defect> all() {
  static const std::vector<Defect> list = [] {
    std::vector<Defect> joined;
    for (const auto group : {defects_of_arrays(), defects_of_topology(), defects_of_coverage(), defects_of_geometry(),
                             defects_of_labels(), defects_of_goals()})
      joined.insert(joined.end(), group.begin(), group.end());
    return joined;
  }();
  return list;
}

}  // namespace pardel::defects
