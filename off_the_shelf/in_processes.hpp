// Runs a mesher in processes of its own, so that meshers which are not thread-safe, crash or call exit() can use all
// cores. For Linux 5.9 and later.
#pragma once

#include <memory>

#include "../core/result.hpp"
#include "subdomain_mesher.hpp"

namespace pardel {

/// A mesher whose refine() runs that of `mesher` in one of `workers` processes. It is thread-safe; calls beyond the
/// number of workers wait. All other abilities are those of `mesher`.
///
/// The processes are copies of this one (fork()), made at once, so `mesher` may have any state. They work on copies of
/// it that know nothing of each other. Make the wrapper early: the copies share the memory that is in use now, and only
/// the calling thread exists in them. A process keeps the standard input and outputs, but no other open file. It runs
/// no handler of signals and no atexit() function that was registered before.
///
/// - If a process ends during a task, the answer is `crashed`, and `why` is "SIGSEGV" or "exit code 0". Another process
///   takes its place.
/// - If the answer does not come within Subdomain::seconds, it is `timed_out`, and the process is replaced. The mesher
///   itself gets nine tenths of this time, so that one which keeps to it can still answer.
/// - If the answer is damaged, it is `unreadable`, and the process is replaced.
/// - If no process can be started, the answer is `failed`.
///
/// Goal::size is a function and cannot be sent. It is called here, at the corners and centroids of the triangles of the
/// subdomain, and the mesher gets a function that interpolates linearly between these places. Goal::size_slope becomes
/// infinity. The other numbers of a subdomain arrive bit for bit.
///
/// The destructor ends all processes; no call of refine() may be running. They also end if this process ends in any
/// other way. SIGPIPE is never raised. Errors: `usage` if workers < 1; `resources` if the first process cannot be
/// started. Precondition: mesher is not null.
[[nodiscard]] Result<std::unique_ptr<SubdomainMesher>> in_processes(std::unique_ptr<SubdomainMesher> mesher,
                                                                    int workers);

}  // namespace pardel
