#include <vector>

#include "workload.hpp"

namespace pardel::workloads {

std::span<const Workload> all() {
  static const std::vector<Workload> list = [] {
    std::vector<Workload> gated = {{"predicates", true, false, mixed_predicates}}, others;
    for (const std::span<const Workload> part :
         {of_predicates(), of_meshes(), of_small_meshes(), of_files(), of_input_files()})
      for (const Workload& each : part) (each.gated ? gated : others).push_back(each);
    gated.insert(gated.end(), others.begin(), others.end());
    return gated;
  }();
  return list;
}

}  // namespace pardel::workloads
