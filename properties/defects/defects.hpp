// Seeded defects: ways to make a right mesh wrong, each with the kind of violation that the checker must
// then report. They show that the checker can say no.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "../../core/goal.hpp"
#include "../../core/mesh.hpp"
#include "../../core/pslg.hpp"
#include "../checker/check.hpp"

namespace pardel::defects {

struct Defect {
  std::string_view name;
  ViolationKind expected;  ///< among what the checker reports; one defect may break several rules
  /// Makes one defect at a place that the seed chooses. False, and nothing changed, where the mesh offers
  /// no place for it. The mesh must be right for the Pslg and the goal, and carry its origins.
  bool (*inject)(Pslg& pslg, Mesh& mesh, Goal& goal, std::uint64_t seed);
};

/// All of them, in groups: arrays and numbers, triangles and links, coverage, geometry, segments and labels, goals.
[[nodiscard]] std::span<const Defect> all();

}  // namespace pardel::defects
