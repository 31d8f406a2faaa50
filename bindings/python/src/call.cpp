#include "call.hpp"

#include <string>

#include "errors.hpp"

namespace py = pybind11;

namespace pardel::python {
namespace {

constexpr std::chrono::milliseconds between_signals{20}, between_reports{100};

/// The message of the Error that stands for the exception of this number.
std::string message_of(std::size_t number) { return "exception " + std::to_string(number) + " of the caller"; }

}  // namespace

bool Call::go_on() {
  held_.reset();
  if (has_failed()) return false;
  const Clock::time_point now = Clock::now();
  if (now < next_signal_) return true;
  next_signal_ = now + between_signals;
  const py::gil_scoped_acquire acquired;
  try {
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    return true;
  } catch (...) {
    (void)keep_exception();
    return false;
  }
}

bool Call::go_on(const Progress& now) {
  if (!go_on()) return false;
  if (progress_.is_none() || Clock::now() < next_progress_) return true;
  next_progress_ = Clock::now() + between_reports;
  const py::gil_scoped_acquire acquired;
  try {
    return progress_(now.triangles, now.estimate).ptr() != Py_False;
  } catch (...) {
    (void)keep_exception();
    return false;
  }
}

Error Call::keep_exception() {
  const std::scoped_lock lock(keeping_);
  kept_.push_back(std::current_exception());
  return {ErrorKind::usage, message_of(kept_.size() - 1)};
}

bool Call::has_failed() const {
  const std::scoped_lock lock(keeping_);
  return !kept_.empty();
}

void Call::throw_failure(std::exception_ptr otherwise) const {
  const std::scoped_lock lock(keeping_);
  if (kept_.empty()) std::rethrow_exception(otherwise);
  try {
    if (otherwise) std::rethrow_exception(otherwise);
  } catch (const Failure& failure) {
    // Several threads may have failed. The library chooses the error that does not depend on their number.
    for (std::size_t k = 0; k < kept_.size(); ++k)
      if (failure.error.message == message_of(k)) std::rethrow_exception(kept_[k]);
  } catch (...) {  // the exception of the caller is the cause
  }
  std::rethrow_exception(kept_.front());
}

}  // namespace pardel::python
