// The mesher: Pslg and Goal in, Mesh and Report out. Deterministic: the result depends on nothing but the
// arguments. Never prints, exits or aborts.
#pragma once

#include <functional>
#include <span>

#include "../core/goal.hpp"
#include "../core/mesh.hpp"
#include "../core/pslg.hpp"
#include "../core/result.hpp"
#include "options.hpp"
#include "report.hpp"

namespace pardel {

struct Meshed {
  Mesh mesh;
  Report report;
};

/// The constrained Delaunay triangulation of the domain, nothing inserted (conforming and sizes ignored).
[[nodiscard]] Result<Meshed> triangulate(const Pslg& pslg, bool convex_hull = false, const Options& options = {});

/// The quality mesh. An invalid Pslg gives invalid_input with every problem in the message; a goal
/// out of range (an angle over 33°, a negative cap, NaN) gives usage. A hypothesis of the engine that does not hold
/// gives internal.
[[nodiscard]] Result<Meshed> mesh(const Pslg& pslg, const Goal& goal = {}, const Options& options = {});

/// Refines an existing mesh (Triangle's -r): its constrained edges (or, where it has none, its boundary
/// edges) stay constraints, its vertices stay, each triangle of it obeys its cap in `max_areas` (empty: none).
/// The mesh must be manifold and positively oriented; it is made constrained Delaunay first.
[[nodiscard]] Result<Meshed> refine(const Mesh& coarse, std::span<const double> max_areas, const Goal& goal = {},
                                    const Options& options = {});

/// The sizing function that interpolates one size per input vertex linearly over the constrained Delaunay
/// triangulation of the input. Owns what it needs; pure; callable from several threads.
[[nodiscard]] Result<std::function<double(Point)>> interpolated_size(const Pslg& pslg, std::span<const double> sizes,
                                                                     bool convex_hull = false);

}  // namespace pardel
