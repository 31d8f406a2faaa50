#include "common_vertices.hpp"

#include "../../core/support/exchange_lists.hpp"

namespace pardel::engine {

CommonVertices::CommonVertices(const SharedHull& hull, std::span<const GivenSegment> segments,
                               const LocalDelaunay& delaunay, const OwnPoints& own, Ranks& ranks) {
  for (const HullVertex& v : hull.vertices()) vertices_.push_back({v.at, v.position, v.number, v.marker});
  std::vector<CommonVertex> here;
  for (const GivenSegment& segment : segments)
    for (const Site& end : {segment.a, segment.b}) {
      const VertexId v = delaunay.known(end);
      if (v == no_index || !delaunay.is_own(v)) continue;
      here.push_back({end.at, end.position, own.number[v], own.marker.empty() ? 0 : own.marker[v]});
    }
  sort_by_position(here);
  const std::vector<CommonVertex> all = concatenated(lists_of_all(here, ranks));
  vertices_.insert(vertices_.end(), all.begin(), all.end());
  sort_by_position(vertices_);
}

}  // namespace pardel::engine
