// A part of the mesh in work, taken out for a mesher, and the way back.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "../../parallel/arithmetic/clearance.hpp"
#include "../../parallel/refinement/assessor.hpp"
#include "../subdomain_mesher.hpp"

namespace pardel::engine {

/// A mesh in work: constrained Delaunay, without ghosts and gaps.
struct MeshInWork {
  Triangulation& t;
  const DomainSegments& segments;
  const Assessor& assessor;
};

/// What a task works on.
struct Portion {
  std::vector<TriangleId> triangles;  ///< ascending
  std::optional<SubdomainCell> cell{};
};

struct Part {
  /// Where an edge of the subdomain is in the mesh.
  struct Seam {
    EdgeRef inner;  ///< a side of a triangle of the part; it runs from SubdomainEdge::a to b
    EdgeRef outer;  ///< the same edge as a side of the triangle across; none() on the domain's boundary
    Index segment;  ///< the segment of the domain; no_index: the edge is not constrained
    Index left_region = no_index, right_region = no_index;  ///< right: if the edge is inside the part
  };
  Subdomain subdomain;
  std::vector<TriangleId> triangles;  ///< the triangle of each triangle of the subdomain
  std::vector<VertexId> vertices;     ///< the vertex of each point of the subdomain
  std::vector<Seam> seams;            ///< one per edge of the subdomain
  std::vector<EndPoints> lines;       ///< for each edge of the subdomain, the line on which its new points lie
};

/// Takes parts out of a mesh. An object is for one thread, and keeps its memory.
class PartMaker {
 public:
  /// `portion_of`: for each triangle, the number of the portion that contains it; no_index if none does.
  PartMaker(const MeshInWork& mesh, std::span<const Index> portion_of) : mesh_(mesh), portion_of_(portion_of) {}

  /// Everything of the part but the goal and the limits. `splits_segments`: false: all edges are frozen. O(n) for n
  /// triangles of the portion.
  [[nodiscard]] Part take_out(const Portion& portion, bool splits_segments);

 private:
  [[nodiscard]] Index point_of(VertexId v, Part& part);
  void add_edge(EdgeRef inner, bool splits_segments, Part& part);

  const MeshInWork& mesh_;
  std::span<const Index> portion_of_;
  std::vector<Index> point_of_vertex_;  ///< no_index between two parts
};

}  // namespace pardel::engine
