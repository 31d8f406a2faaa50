// Drawing: a domain, and where the vertices and the chains of a mesh of it lie. The mesh is the constrained Delaunay
// triangulation of the chains, without the parts that have no triangles. If the chains lie where the segments are, the
// mesh is valid. If they lie elsewhere, this is the only thing that is wrong with it.
#pragma once

#include <initializer_list>
#include <optional>
#include <vector>

#include "place.hpp"
#include "wrong_mesh.hpp"

namespace pardel::wrong_meshes {

class Drawing {
 public:
  explicit Drawing(const Place& where) : place(where) { of.goal.min_angle_deg = 0; }

  /// An input point, at a point of the lattice or anywhere. All input points come before the first inserted vertex.
  Index point(double x, double y) { return point(place.at(x, y)); }
  Index point(Point p);
  /// A segment of the input. Its chain is one edge until vertices are inserted.
  Index segment(Index a, Index b);
  /// A segment that lies outside the domain. The mesh has no chain for it.
  Index absent_segment(Index a, Index b);
  /// Segments from each point to the next one, and from the last to the first. Returns the first of them.
  Index ring(const std::vector<Index>& corners);
  /// The seed of a hole that the mesh has, too.
  void hole(double x, double y);
  /// A seed of a part of the mesh without triangles. The domain has no hole there.
  void gap(Point seed) { gaps_.push_back(seed); }
  /// The triangulation does not have this input point.
  void leave_out(Index point) { left_out_.push_back(point); }
  void region(double x, double y, double attribute);
  /// A chain of the convex hull.
  Index hull_side(Index a, Index b);

  /// An inserted vertex inside a face.
  Index inner(Point p) { return insert(p, interior_vertex); }
  /// An inserted vertex at the end of the chain of a segment, or of a side of the hull, that is known so far.
  Index on(Index chain, Point p);
  /// The chain passes this vertex as well.
  void pass(Index chain, Index vertex) { chains_[chain].inside.push_back(vertex); }
  /// An inserted vertex at this share of the segment.
  Index on_at(Index chain, double share) { return on(chain, between(start(chain), end(chain), share)); }

  [[nodiscard]] Point at(Index vertex) const;
  [[nodiscard]] Point start(Index chain) const { return at(chains_[chain].a); }
  [[nodiscard]] Point end(Index chain) const { return at(chains_[chain].b); }
  [[nodiscard]] std::size_t points() const { return of.pslg.points.size() + inserted_.size(); }

  /// Where the checker has to find the fault, within a distance of the lattice.
  void fault(std::initializer_list<Point> places, double reach);

  /// Makes the mesh. Nothing if chains cross.
  [[nodiscard]] std::optional<WrongMesh> draw();
  /// True if, after draw(), an edge of this mesh joins two vertices of a chain that do not follow each other in it. The
  /// edge may be a chain of its own.
  [[nodiscard]] bool has_shortcut(const Mesh& mesh, Index chain) const;

  WrongMesh of;
  Place place;

 private:
  struct Chain {
    Index a, b, segment;
    bool is_absent = false;
    std::vector<Index> inside;
  };
  Index insert(Point p, Index origin);
  bool triangulate();

  std::vector<Chain> chains_;
  std::vector<Point> inserted_, gaps_;
  std::vector<Index> origins_, left_out_;
};

}  // namespace pardel::wrong_meshes
