#include "ruppert.hpp"

#include <algorithm>

#include "insertion.hpp"

namespace pardel::ref {

void refine_sequentially(Refinement& state, Criteria& criteria) {
  while (!state.failure) {
    const auto bad = std::ranges::find_if(
        state.mesh.triangles, [&](const Corners& t) { return criteria.split_point(state.mesh, t).has_value(); });
    if (bad == state.mesh.triangles.end()) return;

    const ExactPoint centre = *criteria.split_point(state.mesh, *bad);
    const std::vector<Edge> upon = encroached_by(state.mesh, centre);
    if (!upon.empty()) {
      for (const Edge& e : upon) request_split(state, e);
      split_waiting(state);
    } else if (cavity(state.mesh, centre).empty()) {
      state.failure = Error{ErrorKind::invalid_input, "A circumcentre is not representable inside the domain."};
    } else {
      record_origin(state, insert(state.mesh, centre), std::nullopt);
    }
  }
}

Result<Mesh> ruppert(const Pslg& pslg, const Goal& goal) {
  if (auto error = unsupported(pslg, goal)) return *error;
  Refinement state = conforming_delaunay(pslg);
  Criteria criteria(pslg, goal, state.mesh);
  refine_sequentially(state, criteria);
  if (state.failure) return *state.failure;
  return to_mesh(state.mesh, state.provenance, pslg);
}

}  // namespace pardel::ref
