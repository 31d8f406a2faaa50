// The edge lengths that the features of a domain ask for. docs/sizes.md has the definitions.
#pragma once

#include <vector>

#include "../../core/pslg.hpp"
#include "polylines.hpp"
#include "size_envelope.hpp"

namespace pardel::engine {

/// Sources for Goal::feature_edges = edges > 0. Together, their lengths are at most those of the definition, and mostly
/// at least two thirds of these. Lengths grow by `slope` per unit of distance. The sources depend on coordinates only,
/// not on the order of points and segments. Precondition: the Pslg is valid, and these are its polylines. Time:
/// O((n + k) log n) for k sources, on typical input.
[[nodiscard]] std::vector<GrowingSize> feature_sources(const Pslg& pslg, const Polylines& lines, double edges,
                                                       double slope, const Threads& threads);

/// Sources for Goal::grading: on each segment its own length. Mostly at least five sixths of it, where neighbouring
/// segments of a polyline become one source.
[[nodiscard]] std::vector<GrowingSize> segment_sources(const Pslg& pslg, const Polylines& lines, double slope);

}  // namespace pardel::engine
