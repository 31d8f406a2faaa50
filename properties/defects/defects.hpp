// Seeded defects: changes that make a valid mesh wrong at a random place. Each defect names the kind of violation that
// the checker must then report. The defects test that the checker finds errors.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "../../core/goal.hpp"
#include "../../core/mesh.hpp"
#include "../../core/pslg.hpp"
#include "../checker/check.hpp"
#include "target.hpp"

namespace pardel::defects {

struct Defect {
  std::string_view name;
  ViolationKind expected;  ///< must be among the reported kinds; one defect may break several rules
  Target target;           ///< everything that the defect changes
  /// Makes the defect at one place that depends on the seed. Changes nothing and returns false if the mesh has no
  /// suitable place. Precondition: the mesh is valid for the Pslg and the goal, and has the origins of its vertices.
  bool (*inject)(Pslg& pslg, Mesh& mesh, Goal& goal, std::uint64_t seed);
};

/// All defects, in groups: arrays and numbers, triangles and links, coverage, geometry, segments and labels, goals.
[[nodiscard]] std::span<const Defect> all();

}  // namespace pardel::defects
