// How many processors the process may use.
#pragma once

#include <optional>
#include <string_view>

namespace pardel::cli {

/// The number of processors that the file cpu.max of a control group grants (cgroups(7), version 2): its quota divided
/// by its period, rounded up. Nothing if there is no limit.
[[nodiscard]] std::optional<int> processors_granted(std::string_view cpu_max);

/// Without OMP_NUM_THREADS, OpenMP starts a thread for each processor that the system has. In a container with a quota
/// that would be too many, so this lowers the number to that of the control group.
void keep_to_processor_quota();

}  // namespace pardel::cli
