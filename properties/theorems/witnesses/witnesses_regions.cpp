// Witnesses of T-region.
#include "../regions/point_regions.hpp"
#include "witness.hpp"

namespace pardel::properties {
namespace {

template <bool (*shows)(const MeshedScene&)>
testing::AssertionResult shown(const Scene& scene) {
  return shows(meshed(scene)) ? testing::AssertionSuccess() : testing::AssertionFailure();
}

}  // namespace

std::vector<Witness> region_witnesses() {
  return {
      {"regions_that_reach_a_common_triangle",
       "The cavities of the two points share a triangle. If both are found before either is replaced, the result "
       "differs "
       "from that of sequential insertion.",
       shown<fails_at_a_common_triangle>},
      {"regions_that_reach_a_common_edge",
       "The cavities of the two points share only an edge. If both are found before either is replaced, the result "
       "differs "
       "from that of sequential insertion.",
       shown<fails_at_a_common_edge>},
      {"regions_of_cocircular_points", "The two sequential orders of inserting the two points give different meshes.",
       shown<depends_on_the_order>},
      {"regions_kept_apart_by_a_wall",
       "Whole disks on two sides of a wall reach a common triangle. Their visible parts reach no common vertex, and "
       "all "
       "orders give one mesh.",
       shown<is_kept_apart_by_a_wall>},
      {"regions_that_reach_a_common_vertex",
       "The cavities of the two points share a vertex but no edge, and all orders give one mesh.",
       shown<holds_at_a_common_vertex>},
      {"region_that_grows_beyond_a_wall",
       "Whole disks that the two points reach share no vertex. But inserting the first makes a triangle on the wall "
       "whose "
       "disk contains the second, which does not see it.",
       shown<grows_beyond_a_wall>},
      {"tasks_that_own_one_box",
       "Two tasks that both own the whole plane insert one point each. Alternating steps do not give the sequential "
       "mesh.",
       shown<fails_for_one_box>},
  };
}

}  // namespace pardel::properties
