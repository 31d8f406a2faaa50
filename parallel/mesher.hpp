// The mesher: makes a quality triangular mesh of a planar domain.
//
//     const Result<Pslg> pslg = read_pslg("key.poly");
//     const Result<Meshed> meshed = mesh(*pslg, {.min_angle_deg = 30, .max_area = 0.001}, {.threads = 8});
//     if (!meshed) std::cerr << meshed.error().message << '\n';
//     else if (!meshed->report.goal_met()) { /* meshed->report.exempt lists the triangles that miss the goal */ }
//
// Every function here is deterministic: the result depends on the arguments only, and not on Options::threads. None
// prints, exits or throws; running out of memory gives ErrorKind::resources.
#pragma once

#include <functional>
#include <span>

#include "../core/goal.hpp"
#include "../core/mesh.hpp"
#include "../core/pslg.hpp"
#include "../core/result.hpp"
#include "options.hpp"
#include "report.hpp"
#include "validate.hpp"

namespace pardel {

struct Meshed {
  Mesh mesh;
  Report report;
};

/// The largest Goal::min_angle_deg that mesh() and refine() accept, in degrees.
inline constexpr double largest_min_angle_deg = 33;

/// `usage` where a bound of the goal or the options is out of its range: a minimum angle outside 0 to 33 degrees, a
/// largest area or edge that is not positive, a negative or infinite Options::min_edge, 0 triangles per tile. mesh()
/// and refine() begin with this check.
[[nodiscard]] Status check_goal(const Goal& goal, const Options& options = {});

/// The quality mesh of a domain: a constrained Delaunay triangulation, refined until every triangle satisfies the goal
/// or is listed in Report::exempt with the reason. The domain is the convex hull where either domain.convex_hull() or
/// goal.convex_hull is true; a domain that is valid without the hull is valid with it, too.
///
/// Errors: `usage` as from check_goal(); `resources` where the mesh would exceed Options::max_memory, the memory or
/// 2^29 - 1 triangles; `cancelled` where Options::progress returned false; the error of Options::after_sweep;
/// `internal` where a self-check of the engine failed.
///
/// Time: O(n log n) for the triangulation of n points, then close to linear in the triangles of the result.
[[nodiscard]] Result<Meshed> mesh(const ValidPslg& domain, const Goal& goal = {}, const Options& options = {});
/// The same, after validation. Every problem of the Pslg is a line of the message of an `invalid_input` error, with ids
/// counted from Pslg::first_id. Use validate() to get the problems as values.
[[nodiscard]] Result<Meshed> mesh(const Pslg& pslg, const Goal& goal = {}, const Options& options = {});

/// The constrained Delaunay triangulation of a domain. No vertex is added. Errors, time: as mesh().
[[nodiscard]] Result<Meshed> triangulate(const ValidPslg& domain, const Options& options = {});
/// The same, after validation as in mesh(). convex_hull: the domain is the convex hull of the points.
[[nodiscard]] Result<Meshed> triangulate(const Pslg& pslg, bool convex_hull = false, const Options& options = {});

/// Refines an existing mesh, as Triangle's switch -r does. The vertices stay. The constrained edges stay constraints;
/// the boundary edges are constraints, too. The mesh is first made constrained Delaunay by flips.
///
/// max_areas: one area cap per triangle of `coarse`, > 0, which holds wherever that triangle was; or empty.
///
/// Errors: as mesh(), and `invalid_input` where `coarse` is not manifold, has a triangle that is not positively
/// oriented, or does not fit `max_areas`.
[[nodiscard]] Result<Meshed> refine(const Mesh& coarse, std::span<const double> max_areas, const Goal& goal = {},
                                    const Options& options = {});

/// A function for Goal::size that interpolates one edge length per point linearly over the constrained Delaunay
/// triangulation of the domain. It owns its data and may be called from several threads. A call takes O(log n).
///
/// sizes: one length per point, finite and > 0; anything else gives `invalid_input`.
[[nodiscard]] Result<std::function<double(Point)>> interpolated_size(const ValidPslg& domain,
                                                                     std::span<const double> sizes);
/// The same, after validation as in mesh().
[[nodiscard]] Result<std::function<double(Point)>> interpolated_size(const Pslg& pslg, std::span<const double> sizes,
                                                                     bool convex_hull = false);

}  // namespace pardel
