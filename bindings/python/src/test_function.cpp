#include "test_function.hpp"

#include <pybind11/numpy.h>

#include <string>

namespace py = pybind11;

namespace pardel::python {

bool TestFunction::must_be_refined(const std::array<Point, 3>& corners, double area) const {
  if (keeps_lock_) {
    call_.hold_lock();
    return ask(corners, area);
  }
  const py::gil_scoped_acquire acquired;
  return ask(corners, area);
}

bool TestFunction::ask(const std::array<Point, 3>& corners, double area) const {
  try {
    py::array_t<double> array({py::ssize_t{3}, py::ssize_t{2}});
    double* out = array.mutable_data();
    for (const Point p : corners) {
      *out++ = p.x;
      *out++ = p.y;
    }
    const py::object answer = function_(array, area);
    if (answer.is_none()) throw py::type_error("refine_if returned None; it must return True or False");
    const int is_true = PyObject_IsTrue(answer.ptr());
    if (is_true < 0) throw py::error_already_set();
    return is_true > 0;
  } catch (...) {
    throw call_.keep_exception();
  }
}

std::unique_ptr<TestFunction> test_of(py::object function, Call& call, bool keeps_lock) {
  if (function.is_none()) return nullptr;
  return std::make_unique<TestFunction>(std::move(function), call, keeps_lock);
}

Goal with_test(Goal goal, const TestFunction* test) {
  if (test != nullptr)
    goal.user_test = [test](const std::array<Point, 3>& corners, double area) {
      return test->must_be_refined(corners, area);
    };
  return goal;
}

}  // namespace pardel::python
