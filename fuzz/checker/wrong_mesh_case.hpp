// Wrong meshes (properties/wrong_meshes) as cases: their verdict is known by construction.
#pragma once

#include "../supply.hpp"

namespace pardel::fuzz {

/// Draws a kind, a seed, a scale, and what else to change in the mesh. Fails if the checker does not report what the
/// kind demands, or if it differs from the definitions. Returns what fuzz_one() returns.
int try_wrong_mesh(Supply bytes);

}  // namespace pardel::fuzz
