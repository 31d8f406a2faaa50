// The stages of the check, in the order in which they run. Each judges one thing and reports what it finds;
// a later stage relies on what the earlier ones have made sure of.
#pragma once

#include <optional>
#include <vector>

#include "../check.hpp"
#include "../model/adjacency.hpp"
#include "../model/chains.hpp"
#include "../model/domain.hpp"
#include "../model/input_vertices.hpp"
#include "findings.hpp"

namespace pardel::checker {

struct Subject {
  const Pslg& pslg;
  const Mesh& mesh;
  const Goal& goal;
  const CheckOptions& options;
  [[nodiscard]] Point corner(const Triangle& t, int i) const { return mesh.points[t.v[i]]; }
};

/// Every id in range, every count right, every coordinate finite. What the rest of the check may touch.
struct Sanity {
  bool geometry = true;    ///< points and corners can be used
  bool neighbours = true;  ///< neighbour ids can be used
  bool labels = true;      ///< constrained edges, regions, origins, markers and attributes can be used
};
[[nodiscard]] Sanity check_sanity(const Subject& subject, Findings& found);

/// Orientation, neighbours, manifold edges and vertices, duplicates, Euler's characteristic.
[[nodiscard]] Adjacency check_topology(const Subject& subject, bool neighbours_usable, Findings& found);

/// Every input point of the domain is a vertex, every vertex is used.
[[nodiscard]] InputVertices check_input_vertices(const Subject& subject, const Domain& domain,
                                                 const Adjacency& adjacency, Findings& found);

/// Every segment of the domain is a chain of mesh edges.
[[nodiscard]] Chains check_segments(const Subject& subject, const Domain& domain, const Adjacency& adjacency,
                                    const InputVertices& inputs, Findings& found);

/// The triangles tile exactly the domain.
void check_coverage(const Subject& subject, const Domain& domain, const Adjacency& adjacency, const Chains& chains,
                    Findings& found);

/// What the mesh says of itself: constrained edges, markers, origins, regions, attributes.
void check_labels(const Subject& subject, const Domain& domain, const Adjacency& adjacency, const Chains& chains,
                  const InputVertices& inputs, std::span<const Index> faces, Findings& found);

/// Every unconstrained edge (every edge, for a conforming goal) is locally Delaunay.
void check_delaunay(const Subject& subject, const Adjacency& adjacency, const Chains& chains, Findings& found);

/// The bounds on angles, areas, edges, sizes and circumradii; appends the angles that are justified.
void check_goal(const Subject& subject, const Domain& domain, const Adjacency& adjacency, const Chains& chains,
                const InputVertices& inputs, std::span<const Index> faces, Findings& found,
                std::vector<Justified>& justified);

/// Fills in the certificate's extremes, histogram and area.
void measure(const Mesh& mesh, Certificate& certificate);

}  // namespace pardel::checker
