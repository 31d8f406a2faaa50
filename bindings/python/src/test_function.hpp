// A Python function of the caller as a Goal::user_test.
#pragma once

#include <pybind11/pybind11.h>

#include <array>
#include <memory>
#include <pardel/core/goal.hpp>
#include <utility>

#include "call.hpp"

namespace pardel::python {

/// An exception of the function ends the call (Call::keep_exception). Made and destroyed with the interpreter lock.
class TestFunction {
 public:
  /// keeps_lock: must_be_refined() keeps the interpreter lock (Call::hold_lock); only for work on one thread.
  TestFunction(pybind11::object function, Call& call, bool keeps_lock)
      : function_(std::move(function)), call_(call), keeps_lock_(keeps_lock) {}
  TestFunction(const TestFunction&) = delete;
  TestFunction& operator=(const TestFunction&) = delete;

  /// Takes the interpreter lock. Only in the thread that made the call.
  [[nodiscard]] bool must_be_refined(const std::array<Point, 3>& corners, double area) const;

 private:
  [[nodiscard]] bool ask(const std::array<Point, 3>& corners, double area) const;

  pybind11::object function_;
  Call& call_;
  bool keeps_lock_;
};

/// The function, or null for None. Call it with the interpreter lock.
[[nodiscard]] std::unique_ptr<TestFunction> test_of(pybind11::object function, Call& call, bool keeps_lock);

/// The goal with this test, which has to outlive it, or without a test if it is null.
[[nodiscard]] Goal with_test(Goal goal, const TestFunction* test);

}  // namespace pardel::python
