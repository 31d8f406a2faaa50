#include "sides_of_triangles.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "../../core/support/exchange_lists.hpp"
#include "../../core/support/stop_signal.hpp"
#include "../../parallel/construction/crossed_edges.hpp"

namespace pardel::engine {
namespace {

/// A segment, and the corners opposite it of the triangles on both sides.
struct TravellingSide {
  Site a, b;
  std::array<Site, 2> beside;
};

EdgeRef side_between(LocalDelaunay& delaunay, VertexId a, VertexId b) {
  const Triangulation& t = delaunay.triangulation();
  EdgeRef found;
  for_each_around(t, a, delaunay.triangle_at(a), [&](TriangleId id, unsigned corner) {
    if (t.slots[id].from(corner) != b) return false;
    found = EdgeRef(id, previous_corner[corner]);
    return true;
  });
  return found;
}

EdgeRef present_side(LocalDelaunay& delaunay, VertexId a, VertexId b) {
  const EdgeRef e = side_between(delaunay, a, b);
  if (e.none()) throw Stopped{{ErrorKind::internal, "a segment is no edge of the triangulation of its rank"}};
  return e;
}

}  // namespace

EdgeRef side_between(LocalDelaunay& delaunay, const Site& a, const Site& b) {
  const VertexId u = delaunay.known(a), v = delaunay.known(b);
  return v == no_index ? EdgeRef() : side_between(delaunay, u, v);
}

std::vector<Constraint> learn_sides(std::span<const GivenSegment> own_segments, LocalDelaunay& delaunay,
                                    const OwnPoints& own, Ranks& ranks) {
  const Triangulation& t = delaunay.triangulation();
  std::vector<Constraint> sides;
  std::vector<std::vector<TravellingSide>> leaving(static_cast<std::size_t>(ranks.count()));
  for (const GivenSegment& segment : own_segments) {
    const Constraint& side = sides.emplace_back(Constraint{delaunay.known(segment.a), delaunay.known(segment.b)});
    if (!delaunay.is_own(side.a)) continue;  // the rank at end a tells others
    const EdgeRef left = present_side(delaunay, side.a, side.b), right = t.slot(left).n[left.side()];
    const std::array<VertexId, 2> beside{t.slot(left).apex(left.side()), t.slot(right).apex(right.side())};
    const TravellingSide told{segment.a, segment.b, {delaunay.site(beside[0]), delaunay.site(beside[1])}};
    std::array knowing{own.owner(told.a.position), own.owner(told.b.position), ranks.rank()};
    for (const Site& site : told.beside) {
      const int rank = own.owner(site.position);
      if (std::ranges::find(knowing, rank) != knowing.end()) continue;
      leaving[rank].push_back(told);
      knowing.back() = rank;
    }
  }
  for (const TravellingSide& side : concatenated(exchange_lists(std::move(leaving), ranks))) {
    for (const Site& site : side.beside) static_cast<void>(delaunay.vertex(site));
    sides.push_back({delaunay.vertex(side.a), delaunay.vertex(side.b)});
  }
  return sides;
}

void constrain(std::span<const Constraint> edges, LocalDelaunay& delaunay) {
  for (const Constraint& edge : edges) delaunay.triangulation().constrain(present_side(delaunay, edge.a, edge.b));
}

}  // namespace pardel::engine
