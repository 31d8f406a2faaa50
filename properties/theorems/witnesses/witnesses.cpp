#include "witness.hpp"

namespace pardel::properties {

std::vector<Witness> all_witnesses() {
  std::vector<Witness> all;
  for (const auto& table : {independence_witnesses(), radius_witnesses(), region_witnesses(), refinement_witnesses()})
    all.insert(all.end(), table.begin(), table.end());
  return all;
}

}  // namespace pardel::properties
