// From the triangulation of a domain to a Mesh.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "../../core/mesh.hpp"
#include "../construction/domain_triangulation.hpp"
#include "../sizing/background.hpp"
#include "../threads/threads.hpp"

namespace pardel::engine {

/// The input points, and the data that the mesh inherits from them. Attributes of new vertices are interpolated.
struct PointData {
  std::span<const Point> points;
  std::size_t attributes_per_point = 0;
  std::span<const double> attributes;
  std::span<const int> markers;
  /// Attributes of points inserted on these segments are interpolated between the two ends. Of a mesh that is refined,
  /// nothing: its subsegments have values of their own, and attributes are interpolated on the sides of its triangles.
  std::optional<std::span<const Segment>> segments{};
};

/// Converts a triangulation in place, without a second copy of its triangles. The input points come first, in the order
/// of the input; the new vertices follow in the order of their insertion. The mesh has no markers and attributes of
/// points yet. On the border of a patch that is cut out (Triangulation::on_border_of_patch), triangles have no
/// neighbour. Constrained edges are listed if they belong to a segment of the domain; those on the border do not. Of
/// `domain`, the data of the segments are left.
[[nodiscard]] Mesh export_triangulation(DomainTriangulation& domain, std::vector<double> region_attributes,
                                        std::span<const Point> input_points, const Threads& threads);

/// Gives the points of a mesh their markers and attributes. Attributes are interpolated along the segments, and
/// elsewhere on the triangles `background` (corners as indices of input points); it may be empty if there are no
/// attributes. `domain`: the one that was exported.
void add_point_data(Mesh& mesh, const DomainTriangulation& domain, const PointData& data,
                    std::vector<std::array<Index, 3>> background, const Threads& threads);

/// Both in turn.
[[nodiscard]] Mesh export_mesh(DomainTriangulation&& domain, std::vector<double> region_attributes,
                               const PointData& data, std::vector<std::array<Index, 3>> background,
                               const Threads& threads = {});

// Parts of the conversion, for meshes in pieces as well:

/// A constrained side of a triangle, with the indices of the triangulation. Its marker is 1 if it has none and lies on
/// the boundary. Nothing if it belongs to no segment, as on the border of a patch.
[[nodiscard]] std::optional<ConstrainedEdge> constrained_edge(const DomainTriangulation& domain, const Slot& slot,
                                                              unsigned side);
/// For each vertex inside a domain segment, replaces the index of this segment by the input segment or hull_vertex.
void name_input_segments(DomainTriangulation& domain, const Threads& threads);
/// The attributes that are interpolated at these places on the input points, place by place.
[[nodiscard]] std::vector<double> interpolated_attributes(const Background& on, std::span<const Point> places,
                                                          const PointData& data, const Threads& threads);
/// Writes the attributes of the vertices that were inserted on segments of `data`. `origin` and `attributes`: of all
/// vertices. Precondition: data.segments is given.
void interpolate_along_segments(std::span<const Point> vertices, std::span<const Index> origin, const PointData& data,
                                std::span<double> attributes, const Threads& threads);

}  // namespace pardel::engine
