// Witnesses of statements about whole refinements. Their scenes are domains without insertions.
#include "../refinement/thirty_degrees.hpp"
#include "witness.hpp"

namespace pardel::properties {

std::vector<Witness> refinement_witnesses() {
  return {
      {"halved_down_to_the_floor_at_thirty_degrees",
       "A domain without small angles. At 30 degrees triangles are halved down to the floor on edge lengths; at 28 and "
       "29 degrees the domain has a valid mesh of fewer than 50 triangles.",
       [](const Scene& scene) { return is_halved_down_to_the_floor(to_pslg(scene)); }},
  };
}

}  // namespace pardel::properties
