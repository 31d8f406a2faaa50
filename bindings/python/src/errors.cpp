#include "errors.hpp"

#include <pybind11/stl.h>

#include <array>
#include <exception>

namespace py = pybind11;

namespace pardel::python {
namespace {

const char* name_of(ErrorKind kind) {
  constexpr std::array names = {"usage", "invalid_input", "io", "resources", "cancelled", "internal"};
  return names.at(static_cast<std::size_t>(kind));
}

/// Needs the interpreter lock.
void set_exception(const Failure& failure) {
  py::list problems;
  for (const Problem& problem : failure.problems) problems.append(to_tuple(problem));
  const py::object make = py::module_::import("pardel.errors").attr("exception_of");
  const py::object exception = make(name_of(failure.error.kind), failure.error.message, problems);
  PyErr_SetObject(py::type::of(exception).ptr(), exception.ptr());
}

}  // namespace

py::tuple to_tuple(const Problem& problem) {
  return py::make_tuple(name(problem.kind), py::tuple(py::cast(problem.ids)),
                        py::make_tuple(problem.where.x, problem.where.y), problem.message());
}

void bind_errors() {
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const Failure& failure) {
      set_exception(failure);
    }
  });
}

}  // namespace pardel::python
