// A scene: what a theorem about insertion is tried on. Points with walls make a (constrained) Delaunay mesh, and
// some points are to be inserted into it. Its file is a .poly: the point marked k > 0 is the k-th insertion, all
// unmarked points are vertices of the mesh, segments are walls.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <string>
#include <vector>

#include "../../../core/pslg.hpp"
#include "../../../core/result.hpp"
#include "../../../ref/definitions.hpp"

namespace pardel::properties {

struct Scene {
  std::vector<Point> points;      ///< distinct, not all on a line
  std::vector<ref::Edge> walls;   ///< meet at most in common ends, run through no point
  std::vector<Point> insertions;  ///< in order; none is a point of the mesh
  friend bool operator==(const Scene&, const Scene&) = default;
};

/// As RapidCheck prints it.
std::ostream& operator<<(std::ostream& out, const Scene& scene);

/// The constrained Delaunay triangulation of the points' convex hull. The hull's edges are no constraints.
[[nodiscard]] ref::PlainMesh mesh_of(const Scene& scene);

[[nodiscard]] Pslg to_pslg(const Scene& scene);
/// Precondition: as written by to_pslg.
[[nodiscard]] Scene to_scene(const Pslg& pslg);

/// The mesh, each insertion with its cavity, and what is wrong with inserting all of them independently: the
/// vertices that two cavities share, and every circumcircle of the result that is not empty.
[[nodiscard]] Status draw(const Scene& scene, const std::filesystem::path& file);

}  // namespace pardel::properties
