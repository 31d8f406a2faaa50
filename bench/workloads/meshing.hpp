// A workload that makes the mesh of a domain.
#pragma once

#include "../../core/goal.hpp"
#include "../../core/pslg.hpp"
#include "../../parallel/options.hpp"
#include "workload.hpp"

namespace pardel::workloads {

[[nodiscard]] Job meshing(const Setup& setup, const Pslg& pslg, const Goal& goal, Interior interior = Interior::refine);

}  // namespace pardel::workloads
