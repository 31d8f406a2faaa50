// Runs cases in child processes, so that a crash or an endless loop costs one case and not the run.
#pragma once

#include <cstdint>
#include <functional>

#include "record.hpp"

namespace pardel::fuzz {

struct Watch {
  int jobs = 1;
  double seconds = 60;    ///< of processor time that one case may take; ten times as many by the clock
  int per_process = 200;  ///< cases that one child process runs one after another
};

/// Runs one case in a child process. It first calls announce() with the kinds of the case, and then returns the record.
/// Number and seconds of the record are set by the caller.
using RunCase =
    std::function<Record(std::uint64_t number, const std::function<void(const std::string& kinds)>& announce)>;

/// Runs the cases in the list, and calls done(record) for each of them, in this process. The list is ascending. The
/// caller must not have used OpenMP, because children of such a process cannot use it. Throws std::system_error if no
/// process can be started.
void run_watched(const std::vector<std::uint64_t>& numbers, const Watch& watch, const RunCase& run,
                 const std::function<void(const Record&)>& done);

}  // namespace pardel::fuzz
