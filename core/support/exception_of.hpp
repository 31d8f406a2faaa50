// No exception may leave a parallel loop: it is caught inside and thrown again outside.
#pragma once

#include <exception>

namespace pardel {

/// Calls work(). Returns the exception that it throws; null if it throws none.
template <class Work>
[[nodiscard]] std::exception_ptr exception_of(const Work& work) noexcept {
  try {
    work();
    return nullptr;
  } catch (...) {
    return std::current_exception();
  }
}

}  // namespace pardel
