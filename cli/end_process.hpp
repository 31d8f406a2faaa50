// Ends the process in the middle of its work, at a signal or above --max-memory, so that no loop has to ask.
#pragma once

#include <string_view>

#include "../core/result.hpp"

namespace pardel::cli {

/// Messages of end_process() begin with this name instead of `pardel`. The text has to live as long as threads that may
/// call end_process(). Thread-safe.
void name_process(const char* name);

/// Removes the partial output files, prints the message unless it is empty, and ends the process with the exit code of
/// the kind of error. Other threads may be anywhere: nothing waits for them, and no destructor runs. So this takes
/// milliseconds, whatever the process is doing. It allocates no memory. Of a long message the first 500 bytes are
/// printed. Thread-safe.
[[noreturn]] void end_process(ErrorKind kind, std::string_view message);

}  // namespace pardel::cli
