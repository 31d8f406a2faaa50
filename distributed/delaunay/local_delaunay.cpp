#include "local_delaunay.hpp"

#include <algorithm>
#include <utility>

#include "../../core/support/stop_signal.hpp"
#include "../../core/support/without_repetitions.hpp"
#include "../../parallel/construction/crossed_edges.hpp"
#include "../../parallel/construction/delaunay.hpp"

namespace pardel::engine {

LocalDelaunay::LocalDelaunay(Array<Point> own, std::uint64_t first)
    : first_(first), own_(static_cast<Index>(own.size())), order_(first, own_), inserter_(t_, order_) {
  t_.points = std::move(own);
}

Status LocalDelaunay::triangulate(std::span<const Site> others, const Threads& threads) {
  for (const Site& site : others) {
    if (is_own_position(site.position) ||
        !others_.emplace(site.position, static_cast<VertexId>(t_.points.size())).second)
      continue;
    t_.points.push_back(site.at);
    order_.append(site.position);
  }
  if (Status made = triangulate_points(t_, order_, threads); !made) return made;
  TriangleId start = 0;
  while (t_.slots[start].is_ghost()) ++start;
  inserter_.start(Box{}, start);
  at_.resize_uninitialised(t_.points.size());
  for (TriangleId id = 0; id < t_.slots.size(); ++id)
    for (const VertexId v : t_.slots[id].v)
      if (v != ghost) at_[v] = id;
  return Done{};
}

bool LocalDelaunay::has_own_corner(TriangleId id) const {
  return std::ranges::any_of(t_.slots[id].v, [&](VertexId v) { return v != ghost && is_own(v); });
}

VertexId LocalDelaunay::known(const Site& site) const {
  if (is_own_position(site.position)) return static_cast<VertexId>(site.position - first_);
  const auto at = others_.find(site.position);
  return at != others_.end() ? at->second : no_index;
}

VertexId LocalDelaunay::vertex(const Site& site) {
  if (is_own_position(site.position)) return static_cast<VertexId>(site.position - first_);
  const auto [known, is_new] = others_.emplace(site.position, static_cast<VertexId>(t_.points.size()));
  const VertexId v = known->second;
  if (!is_new) return v;
  t_.points.push_back(site.at);
  order_.append(site.position);
  const auto fresh = static_cast<TriangleId>(t_.slots.size());
  if (fresh + 2 > max_engine_triangles)
    throw Stopped{{ErrorKind::resources, "a rank has more triangles than it can number"}};
  t_.slots.resize_uninitialised(fresh + std::size_t{2});
  if (inserter_.insert(v, fresh) != Inserted::yes)
    throw Stopped{{ErrorKind::internal, "the triangulation of a rank is inconsistent at a point of another rank"}};
  fresh_.insert(fresh_.end(), inserter_.made().begin(), inserter_.made().end());
  at_.push_back(inserter_.made().front());
  return v;
}

TriangleId LocalDelaunay::triangle_at(VertexId v) {
  const auto is_at_vertex = [&](TriangleId id) {
    return !t_.slots[id].is_ghost() && std::ranges::count(t_.slots[id].v, v) > 0;
  };
  TriangleId id = at_[v];
  if (!is_at_vertex(id)) {
    id = inserter_.locate(t_.points[v]);
    if (id == no_index || !is_at_vertex(id))
      throw Stopped{{ErrorKind::internal, "the triangulation of a rank is inconsistent at one of its vertices"}};
    at_[v] = id;
  }
  inserter_.start(Box{}, id);
  return id;
}

std::vector<VertexId> LocalDelaunay::neighbours_in_disk(const Corners& corners) {
  const Slot asked{corners, {}};
  std::vector<VertexId> found;
  for (const VertexId corner : corners) {
    if (corner == ghost) continue;
    for_each_around(t_, corner, triangle_at(corner), [&](TriangleId id, unsigned at) {
      const VertexId neighbour = t_.slots[id].from(at);
      if (neighbour != ghost && is_in_disk(t_, asked, neighbour, order_)) found.push_back(neighbour);
      return false;
    });
  }
  sort_without_repetitions(found);
  return found;
}

}  // namespace pardel::engine
