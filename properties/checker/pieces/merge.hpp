// Puts together what the ranks have found.
#pragma once

#include <vector>

#include "../../../core/ranks.hpp"
#include "../certificate.hpp"
#include "../model/measures.hpp"
#include "../stages/findings.hpp"

namespace pardel::checker {

/// The findings of all ranks, in the order of the ranks, on all ranks. Collective.
[[nodiscard]] Findings merged(const Findings& here, Ranks& ranks);

/// Adds the measures of a later piece. `first_triangle`: the number of its first triangle in the whole mesh.
void add_measures(Certificate& certificate, const Measures& measures, Index first_triangle);

/// Replaces the extremes, the histogram and the number of equilateral triangles of the pieces of a rank by those of the
/// whole mesh, on all ranks. Collective.
void merge_measures(Certificate& certificate, Ranks& ranks);

/// The lists of all ranks, one after the other, on all ranks. Collective.
[[nodiscard]] std::vector<Justified> merged(const std::vector<Justified>& here, Ranks& ranks);

}  // namespace pardel::checker
