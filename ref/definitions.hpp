// The words of the theory as predicates, each the way it is defined: quantifiers are loops, numbers are
// exact. Nothing here is fast.
//
// The definitions marked [CC], in our words, are those of A. N. Chernikov and N. P. Chrisochoides, "Parallel Guaranteed
// Quality Planar Delaunay Mesh Generation by Concurrent Point Insertion", 2004.
#pragma once

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <array>
#include <set>
#include <vector>

#include "../core/pslg.hpp"

namespace pardel::ref {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Number = Kernel::FT;
using ExactPoint = Kernel::Point_2;

[[nodiscard]] inline ExactPoint exact(Point p) { return {p.x, p.y}; }
[[nodiscard]] inline Point rounded(const ExactPoint& p) { return {CGAL::to_double(p.x()), CGAL::to_double(p.y())}; }

/// Three vertices, counter-clockwise.
using Corners = std::array<Index, 3>;
/// Two vertices, the smaller first.
using Edge = std::array<Index, 2>;
[[nodiscard]] Edge edge(Index a, Index b);
/// The edge opposite corner i.
[[nodiscard]] Edge edge_of(const Corners& t, int i);

/// A mesh as the theory speaks of it: a set of triangles over points, and constrained edges.
struct PlainMesh {
  std::vector<ExactPoint> points;
  std::vector<Corners> triangles;
  std::set<Edge> constraints;
};

/// r(t)²; t must not be degenerate.
[[nodiscard]] Number squared_circumradius(const PlainMesh& mesh, const Corners& t);
[[nodiscard]] ExactPoint circumcentre(const PlainMesh& mesh, const Corners& t);
[[nodiscard]] Number squared_shortest_edge(const PlainMesh& mesh, const Corners& t);
[[nodiscard]] Number area(const PlainMesh& mesh, const Corners& t);

/// The open circumdisk of t contains p: p lies strictly inside the circle through the corners.
[[nodiscard]] bool circumdisk_contains(const PlainMesh& mesh, const Corners& t, const ExactPoint& p);

/// Does p see t: can p be joined to some point of t's interior by a segment whose inside meets no
/// constrained edge? (Constraints block sight. A constraint that ends at p, or on which p lies, does not
/// hide what is on either side of it.)
[[nodiscard]] bool sees(const PlainMesh& mesh, const ExactPoint& p, const Corners& t);

/// M is Delaunay: the open circumdisk of every triangle is empty of vertices [CC, the empty circumdisk
/// property]. With constraints: empty of vertices that see the triangle (constrained Delaunay).
/// Vertices without a triangle do not count.
[[nodiscard]] bool is_delaunay(const PlainMesh& mesh);
[[nodiscard]] bool is_constrained_delaunay(const PlainMesh& mesh);

/// M is conformal: two triangles meet in nothing, a common vertex or a common whole edge [CC], and each
/// is positively oriented. Quadratic.
[[nodiscard]] bool is_conformal(const PlainMesh& mesh);

/// The cavity C_M(p): the set of triangles of M whose open circumdisk contains p [CC] and that p sees.
/// Indices into mesh.triangles, ascending.
[[nodiscard]] std::vector<Index> cavity(const PlainMesh& mesh, const ExactPoint& p);

/// The closure of a set of triangles: the triangles with their edges and vertices. Two closures are disjoint
/// if and only if the triangles share no vertex (in a conformal mesh), so the closure is given by its vertices.
[[nodiscard]] std::set<Index> closure(const PlainMesh& mesh, const std::vector<Index>& triangles);

/// p encroaches upon the edge ab: p lies inside or on its diametral circle [CC], and is none of its ends.
[[nodiscard]] bool encroaches(const ExactPoint& p, const ExactPoint& a, const ExactPoint& b);

/// Every constrained edge upon which p encroaches, seen or unseen, in order.
[[nodiscard]] std::vector<Edge> encroached_by(const PlainMesh& mesh, const ExactPoint& p);
/// Does any vertex of a triangle encroach upon e?
[[nodiscard]] bool is_encroached(const PlainMesh& mesh, const Edge& e);

/// r̄², the least bound on r(t)² over the mesh; 0 for no triangles.
[[nodiscard]] Number squared_circumradius_bound(const PlainMesh& mesh);

}  // namespace pardel::ref
