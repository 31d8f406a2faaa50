// The mesher: makes a quality triangular mesh of a planar domain.
//
//     const Result<Pslg> pslg = read_pslg("key.poly");
//     const Result<Meshed> meshed = mesh(*pslg, {.min_angle_deg = 30, .max_area = 0.001}, {.threads = 8});
//     if (!meshed) std::cerr << meshed.error().message << '\n';
//     else if (!meshed->report.goal_met()) { /* meshed->report.exempt lists the triangles that miss the goal */ }
//
// Every function here is deterministic: the result depends on the arguments only, and not on Options::threads. No
// function prints, exits or throws. If memory runs out, the function returns ErrorKind::resources.
#pragma once

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

/// The largest Goal::min_angle_deg, in degrees, that mesh() and refine() accept without a limit on vertices. Above it,
/// refinement often does not end by itself, so Options::max_vertices is required.
inline constexpr double largest_min_angle_deg = 33;

/// Returns a `usage` error if a value of the goal or the options is out of range: a minimum angle outside 0 to 33
/// degrees (0 to 45 with Options::max_vertices), a largest area or edge or a limit on gradation that is not positive, a
/// negative or infinite Goal::feature_edges or Options::min_edge, 0 triangles per tile, a negative number of threads.
/// mesh() and refine() begin with this check.
[[nodiscard]] Status check_goal(const Goal& goal, const Options& options = {});

/// Makes the quality mesh of a domain: a constrained Delaunay triangulation, refined until every triangle satisfies the
/// goal or is listed in Report::exempt with the reason. The domain is the convex hull of the points if
/// domain.convex_hull() or goal.convex_hull is true. A domain that is valid without the hull is also valid with it.
///
/// Errors: `usage` as from check_goal(), or if Goal::size returns a number that is not positive, or if a function of
/// the goal or the options throws; `resources` if the mesh would exceed Options::max_memory, the available memory or
/// 2^29 - 1 triangles; `cancelled` if Options::progress returned false; the error of Options::after_sweep; `internal`
/// if a self-check of the engine failed.
///
/// Time: O(n log n) for the triangulation of n points, then nearly linear in the number of triangles of the result.
[[nodiscard]] Result<Meshed> mesh(const ValidPslg& domain, const Goal& goal = {}, const Options& options = {});
/// Validates the Pslg, then meshes it in the same way. An invalid Pslg gives an `invalid_input` error. Its message has
/// one line per problem, with ids counted from Pslg::first_id. Use validate() to get the problems as values.
[[nodiscard]] Result<Meshed> mesh(const Pslg& pslg, const Goal& goal = {}, const Options& options = {});

/// Makes the constrained Delaunay triangulation of a domain. Adds no vertex. Errors and time are those of mesh(); of
/// the options, only the number of threads is used.
[[nodiscard]] Result<Meshed> triangulate(const ValidPslg& domain, const Options& options = {});
/// The same, after validation as in mesh(). convex_hull: the domain is the convex hull of the points.
[[nodiscard]] Result<Meshed> triangulate(const Pslg& pslg, bool convex_hull = false, const Options& options = {});

/// Refines an existing mesh, as Triangle's switch -r does. The vertices stay. The constrained edges stay constraints;
/// the boundary edges are constraints, too. The mesh is first made constrained Delaunay by flips. A triangle keeps the
/// region of the face in which it lies. If triangles of the same face have different regions, a triangle of the result
/// has the region of the triangle of `coarse` that contains its centroid. If all triangles meet the goal, or miss it
/// only because of small angles between the segments, nothing changes. Its segments are what constrained edges form
/// that continue each other on a straight line, whatever `coarse` says about their origin.
///
/// max_areas: empty, or one area cap > 0 per triangle of `coarse`. It applies to the area that this triangle covers.
///
/// Errors: those of mesh(); `usage` if the goal has a limit on gradation or feature_edges, which need the segments of a
/// domain; `invalid_input` if `coarse` is not manifold, has a triangle that is not positively oriented, or does not fit
/// `max_areas`.
[[nodiscard]] Result<Meshed> refine(const Mesh& coarse, std::span<const double> max_areas, const Goal& goal = {},
                                    const Options& options = {});

}  // namespace pardel
