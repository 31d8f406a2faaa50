#include "defects.hpp"

#include <vector>

#include "defect_groups.hpp"

namespace pardel {

std::span<const Defect> defects() {
  static const std::vector<Defect> all = [] {
    std::vector<Defect> joined;
    for (const auto group : {defects_of_arrays(), defects_of_topology(), defects_of_coverage(), defects_of_geometry(),
                             defects_of_labels(), defects_of_goals()})
      joined.insert(joined.end(), group.begin(), group.end());
    return joined;
  }();
  return all;
}

}  // namespace pardel
