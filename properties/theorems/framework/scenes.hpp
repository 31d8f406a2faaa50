// Random scenes in named families, with their meshes and their shrinker. Everything lies on an integer lattice: the
// points are spaced about ten units apart, so that several circumradii fit into a scene, and insertions lie on halves,
// so that degenerate positions are no accident.
#pragma once

#include <rapidcheck.h>

#include <iosfwd>
#include <limits>
#include <string>
#include <vector>

#include "../../domains/generators/random.hpp"
#include "scene.hpp"

namespace pardel::properties {

/// What a theorem asks of a scene. Separations are multiples of r̄, the largest circumradius of the scene's mesh.
struct SceneWish {
  bool walls = false;
  int insertions = 2;                                     ///< 0: the property chooses itself what it inserts
  int more = 0;                                           ///< up to so many more insertions, where there is room
  double least = 0;                                       ///< |pq| ≥ least · r̄ for every two insertions
  double most = std::numeric_limits<double>::infinity();  ///< |pq| < most · r̄ for each insertion and some former one
  bool on_walls = false;                                  ///< may an insertion lie on a wall, which it splits?
  bool encroaching = true;  ///< may an insertion encroach upon a wall that bounds its cavity?
};

/// Names of families: exactly one "points: …", any of "walls: …", one "inserted: …" for every insertion.
using Families = std::vector<std::string>;

struct MeshedScene {
  Scene scene;
  ref::PlainMesh mesh;        ///< mesh_of(scene): without the insertions
  ref::Number squared_bound;  ///< r̄² of that mesh
  Families families;          ///< how it was made
};
std::ostream& operator<<(std::ostream& out, const MeshedScene& meshed);

[[nodiscard]] MeshedScene meshed(Scene scene, Families families = {});

/// Scenes that grant the wish, and so do those that they shrink to. Where no insertion that does so is found in a few
/// hundred trials, which is rare up to a separation of about four, the case is discarded.
[[nodiscard]] rc::Gen<MeshedScene> scenes(const SceneWish& wish);

/// The generator as a plain function; with fewer insertions than wished for where none was found.
[[nodiscard]] MeshedScene random_scene(generators::Random& random, const SceneWish& wish);

/// The edges around the mesh's convex hull, counter-clockwise, in no order.
[[nodiscard]] std::vector<ref::Edge> hull_of(const ref::PlainMesh& mesh);

/// Do the insertions lie in the mesh, on no vertex, on walls only where the wish says so, and as far from each other
/// and from encroaching as it says?
[[nodiscard]] bool grants(const MeshedScene& meshed, const SceneWish& wish);

/// Simpler scenes that keep what Scene promises of points and walls, the simplest first: with fewer insertions (but
/// never fewer than two), fewer walls, fewer points, at the origin, on a coarser lattice.
[[nodiscard]] std::vector<Scene> simpler(const Scene& scene);

/// For the catalogue: tags the current case with its families.
void tag_families(const MeshedScene& meshed);

}  // namespace pardel::properties
