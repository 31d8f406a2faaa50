// Ends the process in the middle of its work.
#pragma once

#include "../core/result.hpp"

namespace pardel::cli {

/// Removes the partial output files, prints the error, and ends the process with the exit code of the error. Other
/// threads may be anywhere: nothing waits for them, and no destructor runs. So this takes milliseconds, whatever the
/// process is doing. It allocates no memory. Of a long message the first 500 bytes are printed. Thread-safe.
[[noreturn]] void end_process(const Error& error);

}  // namespace pardel::cli
