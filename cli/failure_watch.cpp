#include "failure_watch.hpp"

#include <atomic>
#include <cstdlib>
#include <exception>
#include <new>

#include "end_process.hpp"

namespace pardel::cli {
namespace {

/// True while a FailureWatch exists. The handlers have no arguments, so they find it here.
std::atomic<bool>& is_watched() {
  static std::atomic<bool> watched = false;
  return watched;
}

void handle_exit() {
  if (is_watched()) end_process(ErrorKind::resources, "a library cannot go on; its message is above");
}

[[noreturn]] void handle_terminate() {
  try {
    if (is_watched() && std::current_exception()) throw;
  } catch (const std::bad_alloc&) {
    end_process(ErrorKind::resources, "out of memory");
  } catch (...) {
    end_process(ErrorKind::internal, "internal error: an exception that cannot be caught");
  }
  std::abort();  // no exception is the cause
}

}  // namespace

FailureWatch::FailureWatch() {
  is_watched() = true;
  (void)std::atexit(handle_exit);  // does nothing when this object is gone, so it may stay
  std::set_terminate(handle_terminate);
}

FailureWatch::~FailureWatch() { is_watched() = false; }

}  // namespace pardel::cli
