// Wrong meshes: each breaks the definition of a valid mesh (properties/checker/check.hpp) by construction, and stays
// within what a tolerance, an excuse or a missing rule might let through. They test that the checker refuses each. Some
// kinds are right meshes at the edge of a tolerance, which the checker must accept.
//
// Seeded defects (properties/defects) damage meshes that the mesher made. Wrong meshes need no mesher, and no defect
// would find the input that makes them pass.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "../../core/goal.hpp"
#include "../../core/mesh.hpp"
#include "../../core/pslg.hpp"
#include "../checker/check.hpp"

namespace pardel::wrong_meshes {

struct WrongMesh {
  Pslg pslg;
  Mesh mesh;
  Goal goal;
  CheckOptions options;
  std::vector<Point> fault;  ///< where the mesh is wrong
  double reach = 0;          ///< how far from there the checker may say that it is
};

struct Kind {
  std::string_view family;
  std::string_view name;                ///< a sentence
  std::vector<ViolationKind> expected;  ///< one of them must be reported; none: the mesh is right
  /// Deterministic. Nothing if the random choices do not fit together.
  std::optional<WrongMesh> (*make)(std::uint64_t seed);

  [[nodiscard]] bool is_right() const { return expected.empty(); }
};

/// All kinds, ordered by family.
[[nodiscard]] std::span<const Kind> all();

/// The mesh of a kind for a seed; nothing only if many random choices do not fit together.
[[nodiscard]] std::optional<WrongMesh> make(const Kind& kind, std::uint64_t seed);

/// What the checker missed, as text; empty if the certificate is as expected. A violation of an expected kind counts
/// if it has ids, and a place within reach of the fault.
[[nodiscard]] std::string missed(const Kind& kind, const WrongMesh& mesh, const Certificate& certificate);

}  // namespace pardel::wrong_meshes
