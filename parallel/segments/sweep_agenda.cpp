#include "sweep_agenda.hpp"

#include <algorithm>
#include <utility>

#include "../../core/support/point_order.hpp"
#include "../arithmetic/predicates.hpp"

namespace pardel::engine {
namespace {

std::vector<SweepSite> sorted_sites(const SweepInput& input) {
  const std::size_t n = input.points.size();
  std::vector<bool> is_visited(n);
  for (const Segment& s : input.segments) is_visited[s.a] = is_visited[s.b] = true;
  for (const Index p : input.candidates) is_visited[p] = true;
  std::vector<SweepSite> sites;
  sites.reserve(n + input.queries.size());
  for (std::size_t i = 0; i < n; ++i)
    if (is_visited[i]) sites.push_back({input.points[i], static_cast<Index>(i)});
  for (std::size_t q = 0; q < input.queries.size(); ++q)
    if (is_usable(input.queries[q])) sites.push_back({input.queries[q], static_cast<Index>(n + q)});
  SparseAsk ask(input.stop);
  std::ranges::sort(sites, [&](const SweepSite& s, const SweepSite& t) {
    ask();
    return lexicographically_less(s.place, t.place) || (s.place == t.place && s.id < t.id);
  });
  return sites;
}

}  // namespace

SweepAgenda make_agenda(const SweepInput& input) {
  SweepAgenda agenda{sorted_sites(input), {}, {}};
  auto& [sites, events, edges] = agenda;
  std::vector<Index> event_of(input.points.size(), no_index);
  events.reserve(sites.size() + 1);
  for (Index i = 0; i < sites.size(); ++i) {
    if (i == 0 || sites[i].place != sites[i - 1].place) events.push_back({sites[i].place, i});
    if (sites[i].id < event_of.size()) event_of[sites[i].id] = static_cast<Index>(events.size() - 1);
  }
  events.push_back({{}, static_cast<Index>(sites.size())});
  const auto first_event = [&](const Segment& s) { return std::min(event_of[s.a], event_of[s.b]); };
  for (const Segment& s : input.segments) ++events[first_event(s)].first_edge;
  Index before = 0;
  for (Event& event : events) before += std::exchange(event.first_edge, before);

  std::vector<Index> next(events.size());
  std::ranges::transform(events, next.begin(), &Event::first_edge);
  edges.resize(input.segments.size());
  for (Index s = 0; s < edges.size(); ++s) {
    const Segment& segment = input.segments[s];
    const auto [first, last] = std::minmax(event_of[segment.a], event_of[segment.b]);
    events[last].ending_edge = next[first];
    edges[next[first]++] = {events[first].place, events[last].place, last, s};
  }
  return agenda;
}

}  // namespace pardel::engine
