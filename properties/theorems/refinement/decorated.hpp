// Problems in which many things meet: data of points, segments and regions (domains/generators/decorations.hpp),
// several bounds on sizes at once, and options.
#pragma once

#include <cstdint>
#include <string>

#include "../../domains/generators/switches.hpp"
#include "meshing.hpp"

namespace pardel::properties {

/// What a goal asks for, and how the mesher works.
enum class Wish : std::uint8_t {
  area,                ///< a bound on areas
  edge,                ///< a bound on edges
  caps_of_regions,     ///< smaller and larger than the bound on areas, for some regions
  field,               ///< wanted lengths that grow from a point
  lengths_at_points,   ///< wanted lengths at the points of the domain
  growth,              ///< a limit on gradation
  sources,             ///< the same, from lengths at a point and on a segment
  raster,              ///< wanted lengths on a grid
  lengths_in_regions,  ///< wanted lengths in some regions, and on the segments around them
  narrow_places,       ///< edges across narrow places
  conforming,
  hull,           ///< the domain is the convex hull
  fill,           ///< interiors are filled with equilateral triangles
  floor,          ///< a least length of edges
  kept_markers,   ///< segments with the marker of some segment are not split
  kept_boundary,  ///< no segment on the boundary is split
  quadtree,
  small_tiles,
  circumcentres,
};
/// The name of the enumerator, for example "kept_markers".
[[nodiscard]] const char* name(Wish wish);

using Wishes = generators::Switches<Wish, 19>;

/// What happens to a domain before it is meshed, or to its mesh afterwards. None of it changes the data.
enum class Way : std::uint8_t {
  repaired,      ///< points and segments are repeated, and the domain is repaired
  in_pieces,     ///< several ranks make the mesh, and their pieces are joined
  second_order,  ///< the mesh is written with middles, and read
  refined,       ///< the mesh is refined for a goal that it meets
};
/// The name of the enumerator, for example "in_pieces".
[[nodiscard]] const char* name(Way way);

using Ways = generators::Switches<Way, 4>;

struct DecoratedCase {
  generators::Case plain;
  Wishes wishes;
  Ways ways;
  friend bool operator==(const DecoratedCase&, const DecoratedCase&) = default;
};
std::ostream& operator<<(std::ostream& out, const DecoratedCase& c);

struct DecoratedProblem {
  Problem problem;
  Options options{.threads = 1};
  Wishes wishes;
  Ways ways;
};

/// A random case, as some_decorated_problem() draws them. `size`: see generate() (domains/generators).
[[nodiscard]] DecoratedCase any_decorated_case(generators::Random& random, int size);

/// A random domain of any family with any decorations, with a random goal and options of any kind. A mesh has
/// some thousand triangles at most, unless the domain has tiny features.
[[nodiscard]] DecoratedProblem some_decorated_problem(Exhibit& exhibit);

/// Fails the case if a segment with a marker that is to be kept is split.
void require_kept_segments(const DecoratedProblem& drawn, const Meshed& meshed);

/// Fails the case if the mesh is not certified, apart from bounds that are missed in triangles which the report lists
/// for a reason that can be one there: no small angle of the domain, which the checker would accept; a segment that may
/// not be split only if there are such segments; the shortest edge and double precision only if some triangle is about
/// as narrow. `hairlines_outside`: of the domain; then segments are also not split because of double precision where
/// triangles are wide.
void require_certified(const DecoratedProblem& drawn, const Meshed& meshed, bool hairlines_outside = false);

}  // namespace pardel::properties
