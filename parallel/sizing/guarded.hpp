// The functions of the caller, guarded: their mistakes reach the interface of the engine as one exception,
// CallbackError, and become an Error there.
#pragma once

#include "../../core/goal.hpp"
#include "../../core/result.hpp"
#include "../options.hpp"

namespace pardel::engine {

/// Thrown by a guarded function. Parallel loops pass it on to the calling thread (threads/parallel_for.hpp).
struct CallbackError {
  Error error;
};

/// The goal with guarded functions. The guarded size function throws CallbackError if Goal::size throws, or if it
/// returns a number that is not positive. Infinity is allowed, and means that there is no bound. The functions
/// that interpolated_size() makes keep their type, and need no guard. The guarded test throws CallbackError if
/// Goal::user_test throws.
[[nodiscard]] Goal guarded(Goal goal);

/// The options with guarded functions. They throw CallbackError if the functions of the caller throw.
[[nodiscard]] Options guarded(Options options);

/// Call this where an exception has been caught. Returns the error of a CallbackError, an Error itself, and `resources`
/// for std::bad_alloc. Throws all other exceptions again.
[[nodiscard]] Error error_of_exception();

}  // namespace pardel::engine
