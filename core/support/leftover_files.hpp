// The names of partial files, and the removal of those that a process has left behind when it was killed.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>

namespace pardel {

/// `FILE.SPACE-PROCESS-NUMBER.partial` for this process (see space_of_processes()).
[[nodiscard]] std::filesystem::path partial_name(const std::filesystem::path& file, std::uint64_t number);

/// Removes the partial files of these files whose process has ended. They stay if this is not certain: if they come
/// from another machine or container or from before a restart, or if another process has the same number.
void remove_leftovers(std::span<const std::filesystem::path> files);

}  // namespace pardel
