// What all schemes are given, and what they return.
#pragma once

#include "../mesh/triangulation.hpp"
#include "../rules/ruppert.hpp"
#include "account.hpp"

namespace pardel::schemes {

struct Problem {
  const Pslg& pslg;  ///< valid
  const Goal& goal;
  int workers = 1;                       ///< at least 1
  std::uint64_t seed = 1;                ///< of what a scheme draws at random
  std::size_t most_points = 20'000'000;  ///< a run that needs more ends with an Error of kind `resources`
};

/// A mesh in which no triangle needs work, unless rounding keeps it from being split, and what it cost.
struct Outcome {
  LinkedMesh mesh;  ///< all faces are in use
  Account account;
};

/// The start of a refinement by one worker: the triangulation of the domain, and its cost in the account.
struct Start {
  LinkedMesh mesh;
  Bounds bounds;
  Account account;
};
/// Errors: those of unsupported() and triangulation_of().
[[nodiscard]] Result<Start> start_of(const Problem& problem);

[[nodiscard]] Error too_many_points(const Problem& problem);

}  // namespace pardel::schemes
