// A scene is the input of a theorem about insertion: points and walls, which define a (constrained) Delaunay mesh, and
// further points to insert into this mesh. A wall is a constrained edge. Scenes are stored as .poly files: the point
// with marker k > 0 is the k-th insertion, points with marker 0 are vertices of the mesh, segments are walls, and holes
// are holes.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <string>
#include <vector>

#include "../../../core/pslg.hpp"
#include "../../../core/result.hpp"
#include "../../../ref/edge.hpp"

namespace pardel::ref {
struct PlainMesh;
}

namespace pardel::properties {

struct Scene {
  std::vector<Point> points;      ///< distinct, not all on one line
  std::vector<ref::Edge> walls;   ///< two walls meet only in common ends; no point lies inside a wall
  std::vector<Point> insertions;  ///< in order; different from all points
  std::vector<Point> holes{};     ///< each carves away its face: the triangles that it reaches without crossing a wall
  friend bool operator==(const Scene&, const Scene&) = default;
};

/// RapidCheck uses this to print a scene.
std::ostream& operator<<(std::ostream& out, const Scene& scene);

/// The constrained Delaunay triangulation of the convex hull of the points, without the faces of the holes. Edges of
/// the hull that are no walls are not constrained. Only edges of the mesh are constrained.
[[nodiscard]] ref::PlainMesh mesh_of(const Scene& scene);

[[nodiscard]] Pslg to_pslg(const Scene& scene);
/// The inverse of to_pslg().
[[nodiscard]] Scene to_scene(const Pslg& pslg);

/// Writes an SVG picture. It shows the mesh, each insertion with its cavity, the triangles that independent insertion
/// makes (dashed), and in red the violations: vertices that two cavities share, and circumcircles of new triangles that
/// are not empty.
[[nodiscard]] Status draw(const Scene& scene, const std::filesystem::path& file);

}  // namespace pardel::properties
