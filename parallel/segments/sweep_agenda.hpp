// The events that a sweep of the plane visits, in order, with the points and the segments that are at each.
#pragma once

#include <vector>

#include "../../core/pslg.hpp"
#include "plane_sweep.hpp"

namespace pardel::engine {

/// A segment, with its lexicographically smaller end as the left end. Edges are sorted by the events of these ends.
struct Edge {
  Point left, right;
  Index end;  ///< the event of the right end
  Index segment;
};

struct Event {
  Point place;
  Index first_site;              ///< into the sorted sites
  Index first_edge = 0;          ///< of the edges that begin here
  Index ending_edge = no_index;  ///< one of the edges that end here
};

/// Points, by their indices, and queries, by their indices plus the number of points, that are visited.
struct SweepSite {
  Point place;
  Index id;
};

struct SweepAgenda {
  std::vector<SweepSite> sites;  ///< sorted by place, then by id
  std::vector<Event> events;     ///< with one event after the last as the end of its lists
  std::vector<Edge> edges;
};

[[nodiscard]] SweepAgenda make_agenda(const SweepInput& input);

}  // namespace pardel::engine
