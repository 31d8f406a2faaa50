// An event is a point or a query, or several at one place. Events are visited in lexicographic order, as if the sweep
// line were vertical and turned a little to the left. So vertical segments need no special treatment: their lower ends
// are their left ends. Between two events, segments that cross exchange their places in the status. The order of these
// exchanges does not matter: whichever neighbours are in the wrong order at the next event are exchanged until none
// are. Therefore the places of crossings need not be compared with each other, only with given points.
#include "plane_sweep.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <queue>
#include <utility>

#include "../../core/support/point_order.hpp"
#include "../arithmetic/predicates.hpp"
#include "sweep_status.hpp"

namespace pardel::engine {
namespace {

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
struct Site {
  Point place;
  Index id;
};

/// Two edges that are neighbours and will cross.
struct Meeting {
  Point place;  ///< rounded
  Index lower, upper;
};
struct IsLater {
  bool operator()(const Meeting& m, const Meeting& n) const { return lexicographically_less(n.place, m.place); }
};

/// False if the exact crossing, whose rounded place is given, surely comes after p.
bool may_precede(Point rounded, Point p) {
  return rounded.x - 0x1p-49 * std::abs(rounded.x) - smallest_coordinate <= p.x;
}
bool surely_precedes(Point rounded, Point p) {
  return rounded.x + 0x1p-49 * std::abs(rounded.x) + smallest_coordinate < p.x;
}

/// True if p sees the edge at an angle of more than 120 degrees. No triangle has two such corners. Therefore bending an
/// edge of a thin triangle to the opposite corner cannot be undone by bending the new edge to the old one.
bool sees_widely(Point p, const Edge& edge) {
  const double ux = edge.left.x - p.x, uy = edge.left.y - p.y, vx = edge.right.x - p.x, vy = edge.right.y - p.y;
  return ux * vx + uy * vy < -0.5 * std::sqrt(ux * ux + uy * uy) * std::sqrt(vx * vx + vy * vy);
}

std::vector<Site> sorted_sites(const SweepInput& input) {
  const std::size_t n = input.points.size();
  std::vector<bool> is_visited(n);
  for (const Segment& s : input.segments) is_visited[s.a] = is_visited[s.b] = true;
  for (const Index p : input.candidates) is_visited[p] = true;
  std::vector<Site> sites;
  sites.reserve(n + input.queries.size());
  for (std::size_t i = 0; i < n; ++i)
    if (is_visited[i]) sites.push_back({input.points[i], static_cast<Index>(i)});
  for (std::size_t q = 0; q < input.queries.size(); ++q)
    if (is_usable(input.queries[q])) sites.push_back({input.queries[q], static_cast<Index>(n + q)});
  SparseAsk ask(input.stop);
  std::ranges::sort(sites, [&](const Site& s, const Site& t) {
    ask();
    return lexicographically_less(s.place, t.place) || (s.place == t.place && s.id < t.id);
  });
  return sites;
}

class PlaneSweep {
 public:
  explicit PlaneSweep(const SweepInput& input)
      : input_(input), ask_(input.stop), sites_(sorted_sites(input)), status_(input.segments.size()) {
    make_events();
    found_.below.assign(input.points.size() + input.queries.size(), no_index);
    found_.through.assign(input.queries.size(), no_index);
  }

  Swept run() && {
    for (Index event = 0; event + 1 < events_.size() && !is_full_; ++event) {
      ask_();
      visit(event);
    }
    std::ranges::sort(found_.conflicts);
    return std::move(found_);
  }

 private:
  /// Makes the events, with one event after the last as the end of its lists, and the edges.
  void make_events() {
    std::vector<Index> event_of(input_.points.size(), no_index);
    for (Index i = 0; i < sites_.size(); ++i) {
      if (i == 0 || sites_[i].place != sites_[i - 1].place) events_.push_back({sites_[i].place, i});
      if (sites_[i].id < event_of.size()) event_of[sites_[i].id] = static_cast<Index>(events_.size() - 1);
    }
    events_.push_back({{}, static_cast<Index>(sites_.size())});
    const auto first_event = [&](const Segment& s) { return std::min(event_of[s.a], event_of[s.b]); };
    for (const Segment& s : input_.segments) ++events_[first_event(s)].first_edge;
    Index before = 0;
    for (Event& event : events_) before += std::exchange(event.first_edge, before);

    std::vector<Index> next(events_.size());
    std::ranges::transform(events_, next.begin(), &Event::first_edge);
    edges_.resize(input_.segments.size());
    for (Index s = 0; s < edges_.size(); ++s) {
      const Segment& segment = input_.segments[s];
      const auto [first, last] = std::minmax(event_of[segment.a], event_of[segment.b]);
      events_[last].ending_edge = next[first];
      edges_[next[first]++] = {events_[first].place, events_[last].place, last, s};
    }
  }

  void visit(Index event) {
    exchange_crossings_before(events_[event].place);
    find_edges_through(event);
    locate_sites(event);
    if (input_.reach > 0) add_near_segments(event);
    make_continuing(event);
    add_conflicts_at(event);
    replace_edges();
  }

  /// Positive if p is above the edge.
  double side(const Edge& edge, Point p) {
    ++found_.orientations;
    return orient2d(edge.left, edge.right, p);
  }
  double side(Index node, Point p) { return side(edges_[status_.edge(node)], p); }

  void exchange_crossings_before(Point p) {
    postponed_.clear();
    while (!meetings_.empty() && may_precede(meetings_.top().place, p) && !is_full_) {
      ask_();
      const Meeting meeting = meetings_.top();
      meetings_.pop();
      const Index lower = status_.node_of(meeting.lower), upper = status_.node_of(meeting.upper);
      if (lower == no_index || upper == no_index || status_.next(lower) != upper) continue;
      if (precedes(meeting, p))
        exchange(lower, upper);
      else
        postponed_.push_back(meeting);
    }
    for (const Meeting& meeting : postponed_) meetings_.push(meeting);
  }
  [[nodiscard]] bool precedes(const Meeting& meeting, Point p) const {
    if (surely_precedes(meeting.place, p)) return true;
    const Edge &s = edges_[meeting.lower], &t = edges_[meeting.upper];
    return compare_crossing(s.left, s.right, t.left, t.right, p) < 0;
  }
  void exchange(Index lower, Index upper) {
    add(ConflictKind::crossing, edges_[status_.edge(lower)], edges_[status_.edge(upper)]);
    status_.exchange(lower, upper);
    expect_crossing(status_.previous(lower), lower);
    expect_crossing(upper, status_.next(upper));
  }

  /// Adds a meeting if the edges of two neighbours, which may be no_index, cross to the right of the sweep line. If
  /// they only touch, the event of that point finds it.
  void expect_crossing(Index lower, Index upper) {
    if (lower == no_index || upper == no_index) return;
    const Index e = status_.edge(lower), f = status_.edge(upper);
    const Edge &s = edges_[e], &t = edges_[f];
    if (s.end == t.end) return;
    const bool cross = s.end < t.end ? side(t, s.right) > 0 : side(s, t.right) < 0;
    if (cross) meetings_.push({crossing_point(s.left, s.right, t.left, t.right), e, f});
  }

  /// Finds the nodes of the edges through the place of the event. These nodes are neighbours.
  void find_edges_through(Index event) {
    const Point p = events_[event].place;
    through_.clear();
    if (const Index ending = events_[event].ending_edge; ending != no_index) {
      const Index known = status_.node_of(ending);
      below_ = status_.previous(known);
      while (below_ != no_index && side(below_, p) == 0) {
        through_.push_back(below_);
        below_ = status_.previous(below_);
      }
      std::ranges::reverse(through_);
      through_.push_back(known);
      above_ = status_.next(known);
    } else {
      above_ = status_.first_not_below([&](Index edge) { return side(edges_[edge], p) > 0; });
      below_ = above_ != no_index ? status_.previous(above_) : status_.last();
    }
    while (above_ != no_index && side(above_, p) == 0) {
      through_.push_back(above_);
      above_ = status_.next(above_);
    }
  }

  void locate_sites(Index event) {
    for (Index i = events_[event].first_site; i < events_[event + 1].first_site; ++i) {
      const Index id = sites_[i].id;
      if (below_ != no_index) found_.below[id] = edges_[status_.edge(below_)].segment;
      if (id < input_.points.size()) continue;
      Index& through = found_.through[id - input_.points.size()];
      if (!through_.empty())
        through = edges_[status_.edge(through_[0])].segment;
      else if (events_[event].first_edge != events_[event + 1].first_edge)
        through = edges_[events_[event].first_edge].segment;
    }
  }

  /// Walks up and down along the sweep line. The distance along the line grows from edge to edge, and it is at most
  /// 1.42 times the distance from an edge that is not steeper than a diagonal.
  void add_near_segments(Index event) {
    const Point p = events_[event].place;
    const auto is_in_reach = [&](Index node) {
      return node != no_index && distance_along_line(edges_[status_.edge(node)], p) < 1.5 * input_.reach;
    };
    for (Index node = below_; is_in_reach(node); node = status_.previous(node)) add_if_near(event, status_.edge(node));
    for (Index node = above_; is_in_reach(node); node = status_.next(node)) add_if_near(event, status_.edge(node));
  }
  double distance_along_line(const Edge& edge, Point p) {
    return std::abs(side(edge, p)) / (edge.right.x - edge.left.x);
  }
  void add_if_near(Index event, Index e) {
    const Edge& edge = edges_[e];
    const Point p = events_[event].place;
    if (!sees_widely(p, edge)) return;
    const double length = std::hypot(edge.right.x - edge.left.x, edge.right.y - edge.left.y);
    if (std::abs(side(edge, p)) / length >= input_.reach) return;
    for (Index i = events_[event].first_site; i < events_[event + 1].first_site; ++i)
      found_.near.push_back({sites_[i].id, edge.segment});
  }

  /// Collects the edges that continue to the right of the place of the event, from below. Edges with the same direction
  /// are overlapping; they get the same number.
  void make_continuing(Index event) {
    const Point p = events_[event].place;
    continuing_.clear();
    for (const Index node : through_)
      if (const Index e = status_.edge(node); edges_[e].end != event) continuing_.push_back({e, 0});
    for (Index e = events_[event].first_edge; e < events_[event + 1].first_edge; ++e) continuing_.push_back({e, 0});
    if (continuing_.size() < 2) return;
    const auto turn = [&](Index e, Index f) {
      ++found_.orientations;
      return orient2d(p, edges_[e].right, edges_[f].right);
    };
    std::ranges::sort(continuing_, [&](const Continuing& s, const Continuing& t) {
      const double left_turn = turn(s.edge, t.edge);
      return left_turn > 0 || (left_turn == 0 && s.edge < t.edge);
    });
    for (std::size_t i = 1; i < continuing_.size(); ++i) {
      const bool differs = turn(continuing_[i - 1].edge, continuing_[i].edge) != 0;
      continuing_[i].direction = continuing_[i - 1].direction + (differs ? 1 : 0);
    }
  }

  void add_conflicts_at(Index event) {
    const auto begins_here = [&](Index edge) { return edge >= events_[event].first_edge; };
    passing_.clear();
    for (std::size_t i = 0, first = 0; i < continuing_.size(); ++i) {
      const auto [edge, direction] = continuing_[i];
      if (direction != continuing_[first].direction) first = i;
      // In one direction, edges that begin at earlier events come first. They are known to overlap each other.
      if (begins_here(edge))
        for (std::size_t j = first; j < i; ++j)
          add(ConflictKind::overlapping, edges_[edge], edges_[continuing_[j].edge]);
      else
        passing_.push_back(continuing_[i]);
    }
    if (passing_.empty()) return;
    for (std::size_t i = 0; i < passing_.size(); ++i)
      for (std::size_t j = 0; j < i && passing_[j].direction != passing_[i].direction; ++j)
        add(ConflictKind::crossing, edges_[passing_[i].edge], edges_[passing_[j].edge]);
    for (Index i = events_[event].first_site; i < events_[event + 1].first_site; ++i)
      if (sites_[i].id < input_.points.size())
        for (const Continuing& c : passing_)
          add({ConflictKind::point_on_segment, sites_[i].id, edges_[c.edge].segment});
  }

  /// Replaces the edges of the nodes in through_ by those that continue. Uses the same nodes as far as possible.
  void replace_edges() {
    for (const Index node : through_) status_.forget(status_.edge(node));
    for (std::size_t i = 0; i < continuing_.size(); ++i) {
      if (i < through_.size())
        status_.assign(through_[i], continuing_[i].edge);
      else
        status_.insert_before(above_, continuing_[i].edge);
    }
    for (std::size_t i = continuing_.size(); i < through_.size(); ++i) status_.erase(through_[i]);
    if (continuing_.empty()) {
      if (!through_.empty()) expect_crossing(below_, above_);
      return;
    }
    expect_crossing(below_, status_.node_of(continuing_.front().edge));
    expect_crossing(status_.node_of(continuing_.back().edge), above_);
  }

  void add(ConflictKind kind, const Edge& e, const Edge& f) {
    add({kind, std::min(e.segment, f.segment), std::max(e.segment, f.segment)});
  }
  void add(const Conflict& conflict) {
    if (is_full_) return;
    found_.conflicts.push_back(conflict);
    is_full_ = ++count_[static_cast<std::size_t>(conflict.kind)] >= input_.most;
  }

  struct Continuing {
    Index edge;
    Index direction;
  };

  const SweepInput input_;
  SparseAsk ask_;
  std::vector<Site> sites_;
  std::vector<Event> events_;
  std::vector<Edge> edges_;
  SweepStatus status_;
  std::priority_queue<Meeting, std::vector<Meeting>, IsLater> meetings_;
  Swept found_;
  std::array<std::size_t, 3> count_{};
  bool is_full_ = false;

  // At the current event:
  std::vector<Index> through_;                 ///< the nodes of the edges that contain the place, from below
  Index below_ = no_index, above_ = no_index;  ///< the nodes around them
  std::vector<Continuing> continuing_, passing_;
  std::vector<Meeting> postponed_;
};

}  // namespace

Swept sweep_plane(const SweepInput& input) { return PlaneSweep(input).run(); }

std::vector<NearPoint> find_near_points(const SweepInput& input, const Swept& swept) {
  const auto transposed = [](std::span<const Point> points) {
    std::vector<Point> result;
    result.reserve(points.size());
    for (const Point& p : points) result.push_back({p.y, p.x});
    return result;
  };
  const std::vector<Point> points = transposed(input.points), queries = transposed(input.queries);
  SweepInput other = input;
  other.points = points;
  other.queries = queries;
  std::vector<NearPoint> near = sweep_plane(other).near;
  near.insert(near.end(), swept.near.begin(), swept.near.end());
  std::ranges::sort(near);
  near.erase(std::unique(near.begin(), near.end()), near.end());
  return near;
}

}  // namespace pardel::engine
