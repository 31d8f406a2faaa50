// What tells this machine from others, for processes that see the same files.
#pragma once

#include <filesystem>
#include <string>

namespace pardel {

/// The running system: another text on each machine, and after each start of it (Linux: the boot id). Containers of one
/// machine have the same text. Empty if unknown.
[[nodiscard]] std::string running_system();

/// Names the processes among which the number of a process is unique: those of one container on one running system, or
/// of no container. Eight hexadecimal digits; empty if unknown.
[[nodiscard]] std::string space_of_processes();

/// Equal texts of two processes mean that the names stand for the same file or folder, on the same machine. Empty if
/// there is no such file, or the machine is unknown.
[[nodiscard]] std::string identity_of(const std::filesystem::path& file);

}  // namespace pardel
