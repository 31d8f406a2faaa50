// The stages of the check, in the order in which they run. Each stage checks one group of rules. A later stage relies
// on the results of the earlier stages.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "../certificate.hpp"
#include "../check_options.hpp"
#include "../model/adjacency.hpp"
#include "../model/chain_graph.hpp"
#include "../model/chains.hpp"
#include "../model/domain.hpp"
#include "../model/input_vertices.hpp"
#include "../model/number_set.hpp"
#include "../model/numbering.hpp"
#include "../model/scan.hpp"
#include "../model/wanted_size.hpp"
#include "findings.hpp"

namespace pardel::checker {

/// The input of the check.
struct Subject {
  const Pslg& pslg;
  const Mesh& mesh;
  const Goal& goal;
  const CheckOptions& options;
  Numbering names{};
  [[nodiscard]] Point corner(const Triangle& t, int i) const { return mesh.points[t.v[i]]; }
};

/// Which parts of the mesh the later stages may read.
struct Sanity {
  bool geometry = true;    ///< points and corners of triangles
  bool neighbours = true;  ///< neighbour ids
  bool labels = true;      ///< constrained edges, regions, origins, markers and attributes
};
/// True if the mesh is foreign and its triangles name no neighbours at all.
[[nodiscard]] bool lacks_neighbours(const Subject& subject);

/// The bounds of the goal and of the options, for the scan.
[[nodiscard]] ScanBounds bounds_of(const Subject& subject);

/// Checks the points, seeds and segments of the input. True if later stages may read them.
[[nodiscard]] bool check_input(const Pslg& pslg, Findings& found);

/// Checks the mesh: that ids are in range, that arrays have the right length, and that coordinates are finite. `scan`
/// is the scan of the mesh.
[[nodiscard]] Sanity check_sanity(const Subject& subject, const Scan& scan, Findings& found);

/// Checks orientation, neighbours, manifold edges and vertices, duplicates and the Euler characteristic. `scan` is the
/// scan of the mesh. If the neighbours are rebuilt, it becomes the scan of the triangles with these neighbours. Moves
/// `start` and `boundary` out of the scan.
[[nodiscard]] Adjacency check_topology(const Subject& subject, bool neighbours_usable, Scan& scan, Findings& found);

/// The part of check_topology() that one piece of a mesh can decide for itself: orientation, and neighbours in the
/// piece. Vertices, and edges with too many triangles, are not reported.
[[nodiscard]] Adjacency check_topology_of_piece(const Subject& subject, bool neighbours_usable, Scan& scan,
                                                Findings& found);

/// Reports edges with too many triangles, and the equal triangles among these.
void report_non_manifold(const Subject& subject, std::span<const NonManifoldEdge> edges, Findings& found);

/// Reports the vertices at boundary edges whose triangles do not form open fans.
void check_boundary_vertices(const Subject& subject, Adjacency& adjacency, Findings& found);

/// Checks that every input point of the domain is a vertex, and that every vertex is used. `settled`: if the mesh is a
/// part of a larger one, the input points that are vertices of the rest, as they should be. If vertices have names,
/// these ascend.
[[nodiscard]] InputVertices check_input_vertices(const Subject& subject, const Domain& domain,
                                                 const Adjacency& adjacency, Findings& found,
                                                 const NumberSet& settled = {});

/// Checks that every segment of the domain is a chain of mesh edges, and that chains meet in input points only, around
/// which they are in the order of their segments.
[[nodiscard]] Chains check_segments(const Subject& subject, const Domain& domain, const Adjacency& adjacency,
                                    const InputVertices& inputs, const Scan& scan, Findings& found);
/// "segment 7", or "the hull" for a piece of the hull.
[[nodiscard]] Witness segment_text(const Domain& domain, Index segment);
/// The part of check_segments() on the order around input points.
void check_chain_order(const Subject& subject, const Domain& domain, const Chains& chains, const InputVertices& inputs,
                       Findings& found);

/// Checks that the triangles cover the domain exactly once, and cover nothing else, except for check_holes(); and that
/// the chains divide the plane as the segments do. Returns the holes with seeds that triangles may contain.
[[nodiscard]] std::vector<Index> check_coverage(const Subject& subject, const Domain& domain,
                                                const Adjacency& adjacency, const Chains& chains, Findings& found);

/// The part of check_coverage() on the correspondence of faces. Examines nothing if earlier stages have found that the
/// chains are incomplete, meet or cross, or that a side of them is covered wrongly.
void check_faces(const Subject& subject, const Domain& domain, const Chains& chains, const ChainGraph& graph,
                 Findings& found);

/// Reports triangles that contain the seed of one of these holes, unless the seed is so near to a segment on which the
/// triangle has an edge that rounding may have moved the edge across it.
void check_holes(const Subject& subject, const Domain& domain, const Chains& chains, std::span<const Index> suspects,
                 Findings& found);

/// Checks the data that the mesh lists, except for regions: constrained edges, markers, origins, attributes.
void check_labels(const Subject& subject, const Domain& domain, const Adjacency& adjacency, const Chains& chains,
                  const InputVertices& inputs, Findings& found);

/// A triangle must have the attribute of the region of its face; where the face has no region, it must have none. In a
/// foreign mesh the attribute 0 counts as none, and if the input has no regions, attributes have no meaning and are not
/// compared. A mesh that is not foreign must have the region's number, too. `faces`: per triangle, or empty if the
/// input has no regions.
void check_regions(const Subject& subject, const Domain& domain, std::span<const Index> faces, Findings& found);

/// Checks that every unconstrained edge (for a conforming goal: every edge) is locally Delaunay.
void check_delaunay(const Subject& subject, const Adjacency& adjacency, const Chains& chains, const Scan& scan,
                    Findings& found);

/// Checks the bounds on angles, areas, edges, sizes and circumradii. Appends the justified triangles to `justified`.
void check_goal(const Subject& subject, const Domain& domain, const Adjacency& adjacency, const Chains& chains,
                const InputVertices& inputs, std::span<const Index> faces, const Scan& scan, Findings& found,
                std::vector<Justified>& justified);
/// The same, with the lengths that the goal wants. They belong to the input, so several pieces have them in common.
void check_goal(const Subject& subject, const Domain& domain, const Adjacency& adjacency, const Chains& chains,
                const InputVertices& inputs, std::span<const Index> faces, const WantedSize& wanted, const Scan& scan,
                Findings& found, std::vector<Justified>& justified);

/// Sets the certificate's extremes, histogram and area.
void measure(const Mesh& mesh, const Adjacency& adjacency, const Scan& scan, Certificate& certificate);

}  // namespace pardel::checker
