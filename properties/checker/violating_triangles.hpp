// The triangles of which a violation of a bound speaks.
#pragma once

#include <vector>

#include "../../core/mesh.hpp"
#include "violation.hpp"

namespace pardel {

/// All triangles at the edge, if the bound is about an edge; else the one triangle. Preconditions: the violation is one
/// of a bound, and of this mesh.
[[nodiscard]] inline std::vector<Index> violating_triangles(const Violation& violation, const Mesh& mesh) {
  if (violation.kind != ViolationKind::long_edge && violation.kind != ViolationKind::not_conforming)
    return {violation.ids.front()};
  const Index from = violation.ids[0], to = violation.ids[1], t = violation.ids[2];
  const Triangle& triangle = mesh.triangles[t];
  for (std::size_t k = 0; k < 3; ++k)
    if (triangle.v[k] != from && triangle.v[k] != to)
      return triangle.n[k] == no_index ? std::vector{t} : std::vector{t, triangle.n[k]};
  return {t};
}

}  // namespace pardel
