// Puts together what the ranks have found.
#pragma once

#include <vector>

#include "../../../core/ranks.hpp"
#include "../certificate.hpp"
#include "../stages/findings.hpp"

namespace pardel::checker {

/// The findings of all ranks, in the order of the ranks, on all ranks. Collective.
[[nodiscard]] Findings merged(const Findings& here, Ranks& ranks);

/// Replaces the extremes, the histogram and the number of equilateral triangles of a piece by those of the whole mesh,
/// on all ranks. Collective. `first_triangle`: the number of the piece's first triangle in the whole mesh.
void merge_measures(Certificate& certificate, Index first_triangle, Ranks& ranks);

/// The lists of all ranks, one after the other, on all ranks. Collective.
[[nodiscard]] std::vector<Justified> merged(const std::vector<Justified>& here, Ranks& ranks);

}  // namespace pardel::checker
