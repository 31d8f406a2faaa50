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
  area,               ///< a bound on areas
  edge,               ///< a bound on edges
  caps_of_regions,    ///< smaller and larger than the bound on areas, for some regions
  field,              ///< wanted lengths that grow from a point
  lengths_at_points,  ///< wanted lengths at the points of the domain
  growth,             ///< a limit on gradation
  sources,            ///< the same, from lengths at a point and on a segment
  narrow_places,      ///< edges across narrow places
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

using Wishes = generators::Switches<Wish, 17>;

struct DecoratedCase {
  generators::Case plain;
  Wishes wishes;
  friend bool operator==(const DecoratedCase&, const DecoratedCase&) = default;
};
std::ostream& operator<<(std::ostream& out, const DecoratedCase& c);

struct DecoratedProblem {
  Problem problem;
  Options options{.threads = 1};
  Wishes wishes;
};

/// A random domain of any family with any decorations, with a random goal and options of any kind. A mesh has
/// some thousand triangles at most, unless the domain has tiny features.
[[nodiscard]] DecoratedProblem some_decorated_problem(Exhibit& exhibit);

/// Fails the case if a segment with a marker that is to be kept is split.
void require_kept_segments(const DecoratedProblem& drawn, const Meshed& meshed);

/// Fails the case if the mesh is not certified, apart from bounds that are missed in triangles which the report lists.
void require_certified(const DecoratedProblem& drawn, const Meshed& meshed);

}  // namespace pardel::properties
