// The records of Triangle's files, one line each.
#pragma once

#include <cstdint>
#include <span>

#include "../pslg.hpp"
#include "records.hpp"

namespace pardel::files {

/// `<point #> <x> <y> [attributes] [marker]`
inline void put_point(Bytes& to, std::uint64_t number, const Point& p, std::span<const double> attributes,
                      const int* marker) {
  to.numbers(number, p.x, p.y);
  for (const double attribute : attributes) to << ' ' << attribute;
  if (marker != nullptr) to << ' ' << *marker;
  to << '\n';
}

/// `<# of points> <dimension, 2> <# of attributes> <# of markers, 0 or 1>`
inline void put_point_header(Bytes& to, std::uint64_t points, std::size_t attributes, bool markers) {
  to << points << " 2 " << attributes << (markers ? " 1\n" : " 0\n");
}

/// `<# of edges> <# of markers, 0 or 1>`
inline void put_edge_header(Bytes& to, std::uint64_t edges, bool markers) {
  to << edges << (markers ? " 1\n" : " 0\n");
}

/// `<edge #> <end> <end> [marker]`: a segment, a constrained edge, an edge.
inline void put_edge(Bytes& to, std::uint64_t number, std::uint64_t a, std::uint64_t b, const int* marker) {
  to.numbers(number, a, b);
  if (marker != nullptr) to << ' ' << *marker;
  to << '\n';
}

/// `<# of triangles> <nodes per triangle> <# of attributes>`
inline void put_triangle_header(Bytes& to, std::uint64_t triangles, int nodes, bool regions) {
  to.numbers(triangles, nodes, regions ? 1 : 0) << '\n';
}

/// Holes and, if there are any, regions: the end of a .poly. The area -1 means that a region has no area cap.
void put_holes_and_regions(Bytes& to, const Pslg& pslg, int base);

}  // namespace pardel::files
