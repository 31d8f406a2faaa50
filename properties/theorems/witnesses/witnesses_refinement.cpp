// Witnesses about whole refinements: their scenes are domains, and nothing is inserted.
#include "../refinement/thirty_degrees.hpp"
#include "witness.hpp"

namespace pardel::properties {

std::vector<Witness> refinement_witnesses() {
  return {
      {"halved_down_to_the_floor_at_thirty_degrees",
       "A domain without a small angle whose triangles are halved down to the floor on edges at 30 degrees, and which "
       "has a valid mesh of fewer than 50 triangles at 28 and at 29.",
       [](const Scene& scene) { return is_halved_down_to_the_floor(to_pslg(scene)); }},
  };
}

}  // namespace pardel::properties
