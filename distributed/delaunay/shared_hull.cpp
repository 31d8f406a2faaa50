#include "shared_hull.hpp"

#include "../../core/support/exchange_lists.hpp"

namespace pardel::engine {

SharedHull::SharedHull(const LocalDelaunay& delaunay, const OwnPoints& own, Ranks& ranks) {
  const Triangulation& t = delaunay.triangulation();
  std::vector<HullVertex> here;
  for (const Slot& slot : t.slots) {
    if (!slot.is_ghost()) continue;
    const unsigned corner = slot.corner_of(ghost);
    const VertexId v = slot.to(corner), next = slot.from(corner);
    if (delaunay.is_own(v))
      here.push_back({t.points[v], delaunay.site(v).position, delaunay.site(next).position, own.number[v],
                      own.marker.empty() ? 0 : own.marker[v]});
  }
  vertices_ = concatenated(lists_of_all(here, ranks));
  sort_by_position(vertices_);
}

}  // namespace pardel::engine
