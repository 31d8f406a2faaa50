// The terms of the theory (properties/THEORY.md, Conventions) as functions. Each function follows its definition
// literally: "for all" and "there is" are loops, and numbers are exact. The functions are slow.
//
// [CC] marks definitions from A. N. Chernikov and N. P. Chrisochoides, "Parallel Guaranteed Quality Planar Delaunay
// Mesh Generation by Concurrent Point Insertion", 2004. They are not quoted verbatim.
#pragma once

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <set>
#include <vector>

#include "edge.hpp"

namespace pardel::ref {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Number = Kernel::FT;
using ExactPoint = Kernel::Point_2;

[[nodiscard]] inline ExactPoint exact(Point p) { return {p.x, p.y}; }
[[nodiscard]] inline Point rounded(const ExactPoint& p) { return {CGAL::to_double(p.x()), CGAL::to_double(p.y())}; }

/// A mesh as the theory defines it: a set of triangles over points, and a set of constrained edges (walls).
struct PlainMesh {
  std::vector<ExactPoint> points;
  std::vector<Corners> triangles;
  std::set<Edge> constraints;
};

/// r(t)², the square of the circumradius. Precondition: the corners are not collinear.
[[nodiscard]] Number squared_circumradius(const PlainMesh& mesh, const Corners& t);
[[nodiscard]] ExactPoint circumcentre(const PlainMesh& mesh, const Corners& t);
[[nodiscard]] Number squared_shortest_edge(const PlainMesh& mesh, const Corners& t);
[[nodiscard]] Number area(const PlainMesh& mesh, const Corners& t);

/// Does the open circumdisk of t contain p? That is, does p lie strictly inside the circle through the corners?
[[nodiscard]] bool circumdisk_contains(const PlainMesh& mesh, const Corners& t, const ExactPoint& p);

/// Does p see t? That is, is there a point in the interior of t such that the open segment from p to it meets no
/// constrained edge? A constrained edge that contains p, or ends at p, hides nothing from p.
[[nodiscard]] bool sees(const PlainMesh& mesh, const ExactPoint& p, const Corners& t);

/// Is the mesh Delaunay? That is, does the open circumdisk of every triangle contain no vertex [CC, the empty
/// circumdisk property]? Points that are corners of no triangle are ignored.
[[nodiscard]] bool is_delaunay(const PlainMesh& mesh);
/// Is the mesh constrained Delaunay? That is, does the open circumdisk of every triangle contain no vertex that sees
/// the triangle? Points that are corners of no triangle are ignored.
[[nodiscard]] bool is_constrained_delaunay(const PlainMesh& mesh);

/// Is the mesh conformal? That is, is the intersection of every two triangles empty, a common vertex or a common whole
/// edge [CC]? Every triangle must also be positively oriented. Quadratic time.
[[nodiscard]] bool is_conformal(const PlainMesh& mesh);

/// The cavity C_M(p): the triangles whose open circumdisk contains p [CC] and that p sees. Returns ascending indices
/// into mesh.triangles.
[[nodiscard]] std::vector<Index> cavity(const PlainMesh& mesh, const ExactPoint& p);

/// The closure of a set of triangles is the set of these triangles with their edges and vertices. In a conformal mesh
/// two closures are disjoint if and only if the triangles share no vertex. So the function returns only the vertices.
[[nodiscard]] std::set<Index> closure(const PlainMesh& mesh, const std::vector<Index>& triangles);

/// Does p encroach upon the edge ab? That is, does p lie inside or on the circle with diameter ab [CC], and is p
/// neither a nor b?
[[nodiscard]] bool encroaches(const ExactPoint& p, const ExactPoint& a, const ExactPoint& b);

/// The constrained edges upon which p encroaches, in ascending order, whether or not p sees them.
[[nodiscard]] std::vector<Edge> encroached_by(const PlainMesh& mesh, const ExactPoint& p);
/// Does any vertex encroach upon e? Points that are corners of no triangle are ignored.
[[nodiscard]] bool is_encroached(const PlainMesh& mesh, const Edge& e);

/// The largest r(t)² over all triangles; 0 for a mesh without triangles.
[[nodiscard]] Number squared_circumradius_bound(const PlainMesh& mesh);

}  // namespace pardel::ref
