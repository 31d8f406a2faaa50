// A process that starts and ends the processes in which a mesher runs. It is a copy of this process, made when this one
// is still small, and has one thread. So another worker can be started at any time, also while other threads hold locks
// and the mesh is large.
#pragma once

#include <sys/types.h>

#include <memory>
#include <mutex>
#include <string>

#include "../../core/result.hpp"
#include "../subdomain_mesher.hpp"
#include "channel.hpp"

namespace pardel::engine {

class Starter {
 public:
  /// Makes the process. `mesher`: what the workers run. Errors: `resources`.
  [[nodiscard]] static Result<std::unique_ptr<Starter>> make(SubdomainMesher& mesher);
  Starter(const Starter&) = delete;
  Starter& operator=(const Starter&) = delete;
  /// Ends the process and all workers. In another process than the one that made the starter, does nothing.
  ~Starter();

  /// Starts a worker, and returns the channel to it. `number`: its name, of which no worker is running. Errors:
  /// `resources`. Thread-safe.
  [[nodiscard]] Result<Channel> start(Index number);
  /// Ends a worker, and all processes that it has started. Returns how it ended, if it already had, as in "SIGSEGV" or
  /// "exit code 1"; otherwise "SIGKILL". Thread-safe.
  [[nodiscard]] std::string end(Index number);

 private:
  Starter(Descriptor control, pid_t process);

  std::mutex one_at_a_time_;
  Descriptor control_;
  pid_t process_, owner_;
};

}  // namespace pardel::engine
