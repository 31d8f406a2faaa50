// One call of the library from Python. The work runs without the interpreter lock. The lock is taken again to ask
// for signals, and to call functions of the caller; an exception ends the work and then reaches the caller as itself.
#pragma once

#include <pybind11/pybind11.h>

#include <chrono>
#include <exception>
#include <functional>
#include <mutex>
#include <optional>
#include <pardel/core/result.hpp>
#include <pardel/parallel/options.hpp>
#include <utility>
#include <vector>

namespace pardel::python {

class Call {
 public:
  /// progress: None, or a Python function of the number of triangles and its estimate, which is called about every
  /// tenth of a second. It ends the work if it returns False.
  explicit Call(pybind11::object progress = pybind11::none()) : progress_(std::move(progress)) {}

  /// Returns work(). Call it with the interpreter lock.
  template <class Work>
  auto run(const Work& work) -> decltype(work()) {
    std::optional<decltype(work())> result;
    std::exception_ptr thrown;
    {
      const pybind11::gil_scoped_release released;
      try {
        result.emplace(work());
      } catch (...) {
        thrown = std::current_exception();
      }
      held_.reset();
    }
    if (thrown || has_failed()) throw_failure(thrown);
    return *std::move(result);
  }

  /// For the functions of the library that ask whether to go on: false after a signal (Ctrl-C), or after an exception
  /// of a function of the caller. Called in the calling thread, without the lock.
  [[nodiscard]] bool go_on();
  [[nodiscard]] bool go_on(const Progress& now);
  [[nodiscard]] std::function<bool()> question() {
    return [this] { return go_on(); };
  }

  /// Takes the interpreter lock and keeps it until the next go_on(), about 4 ms later: to take it for every call of a
  /// function would cost more than the function. Only for work on one thread, and in this thread.
  void hold_lock() {
    if (!held_) held_.emplace();
  }

  /// Keeps the exception that is being handled, a Python one, and returns the Error that stands for it: thrown out
  /// of a function of the caller, it ends the work. Thread-safe.
  [[nodiscard]] Error keep_exception();

 private:
  using Clock = std::chrono::steady_clock;

  [[nodiscard]] bool has_failed() const;
  /// Throws the exception of the caller that the library's error stands for, or else the first one. Without any, throws
  /// `otherwise`.
  [[noreturn]] void throw_failure(std::exception_ptr otherwise) const;

  pybind11::object progress_;
  Clock::time_point next_signal_ = Clock::now(), next_progress_ = Clock::now();
  std::optional<pybind11::gil_scoped_acquire> held_{};
  mutable std::mutex keeping_;
  std::vector<std::exception_ptr> kept_{};
};

}  // namespace pardel::python
