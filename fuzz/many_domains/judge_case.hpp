// Makes the meshes of a case and judges them.
#pragma once

#include <cstddef>
#include <string>

#include "generated_case.hpp"

namespace pardel::fuzz {

struct Verdict {
  std::string fault;          ///< one line; empty if there is none
  std::size_t triangles = 0;  ///< of the mesh
  std::size_t listed = 0;     ///< triangles that miss the goal, with reasons
};

/// Meshes the domain, judges the mesh exactly, and compares it with the mesh of one thread and with that of several
/// ranks. Refines it again if the case says so.
[[nodiscard]] Verdict judge(const GeneratedCase& drawn);

}  // namespace pardel::fuzz
