// ChainGraph: the planar graph of the boundary edges of a mesh and of the edges of its chains, with its faces.
#pragma once

#include <span>
#include <vector>

#include "adjacency.hpp"
#include "chains.hpp"
#include "planar_faces.hpp"

namespace pardel::checker {

class ChainGraph {
 public:
  /// O(n log n) for n edges.
  ChainGraph(std::span<const Point> points, const Adjacency& adjacency, const Chains& chains, StopSignal* stop);
  ChainGraph(const ChainGraph&) = delete;
  ChainGraph& operator=(const ChainGraph&) = delete;

  /// The vertices of the graph: those of the mesh in ascending order, and their points.
  [[nodiscard]] std::span<const Index> vertices() const { return vertices_; }
  [[nodiscard]] std::span<const Point> points() const { return points_; }
  /// The edges, by positions in vertices(): first the boundary edges, in the order of Adjacency::boundary().
  [[nodiscard]] std::span<const Segment> edges() const { return edges_; }
  [[nodiscard]] std::span<const Segment> boundary() const { return edges().first(boundary_); }
  [[nodiscard]] const PlanarFaces& faces() const { return faces_; }

  /// The face of the graph on one side of an edge of a chain, seen in the direction of the chain. `position`: in
  /// Chains::edges. no_index for an edge without triangles.
  [[nodiscard]] Index face(std::size_t position, Side side) const;

 private:
  /// Where an edge of a chain is in edges_, and whether it runs the other way there.
  struct Place {
    Index edge = no_index;
    bool reversed = false;
  };
  std::vector<Segment> edges_of(std::span<const Point> points, const Adjacency& adjacency, const Chains& chains,
                                StopSignal* stop);

  std::size_t boundary_ = 0;
  std::vector<Index> vertices_;
  std::vector<Point> points_;
  std::vector<Place> place_;  ///< per edge of the chains
  std::vector<Segment> edges_;
  PlanarFaces faces_;
};

}  // namespace pardel::checker
