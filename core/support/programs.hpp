// Programs by name: where a shell would find them.
#pragma once

#include <filesystem>
#include <string>

#include "../result.hpp"

namespace pardel {

/// True for a file that may be executed.
[[nodiscard]] bool is_program(const std::filesystem::path& file);

/// The program's absolute path, or an empty path if it is not on the PATH.
[[nodiscard]] std::filesystem::path on_path(const std::string& program);

/// The absolute path of the program that is the first word of a command: a name on the PATH, or a path, if it contains
/// a slash. Error: `io` if there is no such program.
[[nodiscard]] Result<std::filesystem::path> find_program(const std::string& word);

/// The path of a program of this project. It is looked up first in the folder of the running executable, then in the
/// folder ../bench relative to that folder, where the programs of the benchmarks are. Empty if it is in neither.
[[nodiscard]] std::filesystem::path beside_this_program(const std::string& program);

}  // namespace pardel
