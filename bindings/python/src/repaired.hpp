// Repair before meshing: what is given for the points of a domain stays with them.
#pragma once

#include <pardel/parallel/repair.hpp>
#include <vector>

namespace pardel::python {

/// repair() of the domain. `lengths`: empty, or one per point; they become those of the repaired domain. A point at a
/// crossing gets an interpolated length.
[[nodiscard]] Result<Repaired> repaired_with(std::vector<double>& lengths, const Pslg& domain,
                                             const RepairOptions& options);

}  // namespace pardel::python
