// Errors of the library as Python exceptions. An Error becomes the class of its kind in pardel/errors.py.
#pragma once

#include <pybind11/pybind11.h>

#include <pardel/core/result.hpp>
#include <pardel/parallel/problem.hpp>
#include <utility>
#include <vector>

namespace pardel::python {

/// Thrown by bound functions. `problems`: those of a domain, for an error of the kind invalid_input.
struct Failure {
  Error error;
  std::vector<Problem> problems{};
};

/// The value of a result. Throws its error as a Failure.
template <class T>
T value_of(Result<T>&& result) {
  if (!result) throw Failure{result.error()};
  return std::move(*result);
}
inline void require(const Status& status) {
  if (!status) throw Failure{status.error()};
}

/// A problem as the tuple (kind, ids, (x, y), text).
[[nodiscard]] pybind11::tuple to_tuple(const Problem& problem);

/// Makes each Failure a Python exception.
void bind_errors();

}  // namespace pardel::python
