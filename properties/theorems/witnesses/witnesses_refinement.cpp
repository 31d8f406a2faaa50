// Witnesses of statements about whole refinements, whose scenes are domains without insertions, and about quadtrees.
#include "../refinement/leaves_apart.hpp"
#include "../refinement/thirty_degrees.hpp"
#include "witness.hpp"

namespace pardel::properties {
namespace {

template <bool (*shows)(const Scene&)>
testing::AssertionResult is_shown(const Scene& scene) {
  return shows(scene) ? testing::AssertionSuccess() : testing::AssertionFailure();
}

}  // namespace

std::vector<Witness> refinement_witnesses() {
  return {
      {"halved_down_to_the_floor_at_thirty_degrees",
       "A domain without small angles. At 30 degrees triangles are halved down to the floor on edge lengths; at 28 and "
       "29 degrees the domain has a valid mesh of fewer than 50 triangles.",
       [](const Scene& scene) { return is_halved_down_to_the_floor(to_pslg(scene)); }},
      {"leaves_that_share_a_vertex_above_a_quarter",
       "Two points lie in leaves of a quadtree with one leaf between them. Circumradii are below 0.251 times the sides "
       "of the leaves, but not below a quarter. The cavities of the points share a vertex.",
       is_shown<share_a_vertex_above_a_quarter>},
      {"leaves_that_depend_on_each_other_above_a_half",
       "Two points lie in leaves of a quadtree with one leaf between them. Circumradii are below 0.506 times the sides "
       "of the leaves. The points are not independent.",
       is_shown<are_dependent_above_a_half>},
  };
}

}  // namespace pardel::properties
