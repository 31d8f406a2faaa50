// Random scenes in named families, with their meshes, and a shrinker for scenes. Points lie on an integer lattice,
// about ten units apart, so that a scene is several circumradii wide. Coordinates of insertions are multiples of 1/2,
// because degenerate positions are then frequent.
#pragma once

#include <rapidcheck.h>

#include <iosfwd>
#include <limits>
#include <string>
#include <vector>

#include "../../../ref/definitions.hpp"
#include "../../domains/generators/random.hpp"
#include "scene.hpp"

namespace pardel::properties {

/// The properties that a theorem requires of a scene. Separations are multiples of r̄, the largest circumradius of the
/// mesh of the scene.
struct SceneSpec {
  bool walls = false;
  bool carved = false;  ///< are pockets and holes carved away, and is every edge of the border a wall?
  int insertions = 2;   ///< number of insertions
  int more = 0;         ///< largest number of additional insertions, if space allows
  double least = 0;     ///< |pq| ≥ least · r̄ for every two insertions
  double most = std::numeric_limits<double>::infinity();  ///< |pq| < most · r̄ for each insertion p and an earlier q
  bool on_walls = false;                                  ///< may an insertion lie on a wall, which it splits?
  bool mostly_on_walls = false;  ///< is every second position tried on a wall, anywhere between its ends?
  bool encroaching =
      true;  ///< may an insertion encroach upon a wall on the boundary of its cavity that it does not split?
};

/// Names of families: exactly one "points: …", any number of "walls: …", and one "inserted: …" for each insertion.
using Families = std::vector<std::string>;

struct MeshedScene {
  Scene scene;
  ref::PlainMesh mesh;        ///< mesh_of(scene), the mesh without the insertions
  ref::Number squared_bound;  ///< r̄² of `mesh`
  Families families;          ///< the families of the points, walls and insertions of the scene
};
std::ostream& operator<<(std::ostream& out, const MeshedScene& meshed);

[[nodiscard]] MeshedScene meshed(Scene scene, Families families = {});

/// Scenes that satisfy the specification; the scenes that they shrink to satisfy it, too. If a few hundred trials find
/// no suitable insertion, the case is discarded. This is rare for separations up to about four.
[[nodiscard]] rc::Gen<MeshedScene> scenes(const SceneSpec& spec);

/// The generator as a plain function. The scene has fewer insertions than specified if no suitable positions were
/// found.
[[nodiscard]] MeshedScene random_scene(generators::Random& random, const SceneSpec& spec);

/// Draws the kind of domain: the convex hull, the hull with walls, or a carved domain. One third of the cases each.
[[nodiscard]] SceneSpec in_any_domain(SceneSpec spec);
/// Draws the kind of domain with walls: the hull with walls or a carved domain. One half of the cases each.
[[nodiscard]] SceneSpec in_any_walled_domain(SceneSpec spec);

/// Does p lie in a triangle of the mesh, or on its border?
[[nodiscard]] bool lies_in(const ref::PlainMesh& mesh, const ref::ExactPoint& p);

/// The edges of the mesh's border, each directed with the mesh on its left, in no particular order. For the
/// triangulation of a convex hull these are the edges of the hull.
[[nodiscard]] std::vector<ref::Edge> border_of(const ref::PlainMesh& mesh);

/// Does the scene satisfy the specification: the number and separation of insertions, positions on walls, encroachment?
/// Are all insertions in the mesh, and not at vertices? Are all walls edges of the mesh?
[[nodiscard]] bool satisfies(const MeshedScene& meshed, const SceneSpec& spec);

/// Simpler valid scenes, the simplest first. They have fewer insertions (but at least two), fewer walls or fewer
/// points, lie at the origin, or lie on a coarser lattice.
[[nodiscard]] std::vector<Scene> simpler(const Scene& scene);

/// Tags the current case with the families of the scene, for the catalogue.
void tag_families(const MeshedScene& meshed);

}  // namespace pardel::properties
