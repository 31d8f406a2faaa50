#include "shrink.hpp"

#include <utility>

namespace pardel::harness {

Result<Shrunk> shrink(LatticeDomain domain, std::size_t max_runs,
                      const std::function<Result<bool>(const LatticeDomain&)>& fails) {
  Shrunk shrunk{std::move(domain), 0, false};
  while (!shrunk.smallest) {
    shrunk.smallest = true;
    for (LatticeDomain& simpler : shrinks(shrunk.domain)) {
      if (shrunk.runs == max_runs) {
        shrunk.smallest = false;
        return shrunk;
      }
      ++shrunk.runs;
      const Result<bool> fail = fails(simpler);
      if (!fail) return fail.error();
      if (!*fail) continue;
      shrunk.domain = std::move(simpler);
      shrunk.smallest = false;
      break;
    }
  }
  return shrunk;
}

}  // namespace pardel::harness
