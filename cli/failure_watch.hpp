// The end of the process if a library cannot go on.
#pragma once

namespace pardel::cli {

/// While an object of this class exists, two ways in which a library ends a process end it with end_process() instead:
/// - exit(), which OpenMP and MPI call if the system gives them no thread or no memory. Their exit status 1 would mean
///   that the check found violations.
/// - std::terminate(), because an exception cannot leave a destructor. The libraries for command lines and JSON
///   allocate memory in destructors.
/// main() makes one object. abort() and signals such as SIGSEGV are not changed.
class FailureWatch {
 public:
  FailureWatch();
  ~FailureWatch();
  FailureWatch(const FailureWatch&) = delete;
  FailureWatch& operator=(const FailureWatch&) = delete;
};

}  // namespace pardel::cli
