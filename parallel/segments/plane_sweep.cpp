// An event is a point or a query, or several at one place. Events are visited in lexicographic order, as if the sweep
// line were vertical and turned a little to the left. So vertical segments need no special treatment: their lower ends
// are their left ends. Between two events, segments that cross exchange their places in the status. The order of these
// exchanges does not matter: whichever neighbours are in the wrong order at the next event are exchanged until none
// are. Therefore the places of crossings need not be compared with each other, only with given points.
#include "plane_sweep.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <queue>
#include <utility>

#include "../../core/support/point_order.hpp"
#include "../arithmetic/distance.hpp"
#include "../arithmetic/predicates.hpp"
#include "sweep_agenda.hpp"
#include "sweep_status.hpp"

namespace pardel::engine {
namespace {

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

class PlaneSweep {
 public:
  explicit PlaneSweep(const SweepInput& input)
      : input_(input), ask_(input.stop), agenda_(make_agenda(input)), status_(input.segments.size()) {
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
  void visit(Index event) {
    exchange_crossings_before(events_[event].place);
    find_edges_through(event);
    locate_sites(event);
    if (input_.reach != nullptr && !input_.reach->is_zero()) add_near_segments(event);
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
    for (Index i = events_[event].first_site; i < events_[event + 1].first_site; ++i) {
      const SweepSite& site = sites_[i];
      const double scale = scale_of(site), farthest = input_.reach->farthest(scale);
      const auto is_in_reach = [&](Index node) {
        return node != no_index && distance_along_line(edges_[status_.edge(node)], site.place) < 1.5 * farthest;
      };
      for (Index node = below_; is_in_reach(node); node = status_.previous(node))
        add_if_near(site, scale, status_.edge(node));
      for (Index node = above_; is_in_reach(node); node = status_.next(node))
        add_if_near(site, scale, status_.edge(node));
    }
  }
  [[nodiscard]] double scale_of(const SweepSite& site) const {
    return site.id < input_.points.size() ? input_.reach->scale_of_point(site.id)
                                          : input_.reach->scale_of_place(site.place);
  }
  double distance_along_line(const Edge& edge, Point p) {
    return std::abs(side(edge, p)) / (edge.right.x - edge.left.x);
  }
  void add_if_near(const SweepSite& site, double scale, Index e) {
    const Edge& edge = edges_[e];
    if (!sees_widely(site.place, edge)) return;
    const double reach = input_.reach->between(scale, input_.reach->scale_of_segment(edge.segment));
    if (std::abs(side(edge, site.place)) / distance(edge.left, edge.right) < reach)
      found_.near.push_back({site.id, edge.segment});
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
  const SweepAgenda agenda_;
  const std::vector<SweepSite>& sites_ = agenda_.sites;
  const std::vector<Event>& events_ = agenda_.events;
  const std::vector<Edge>& edges_ = agenda_.edges;
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

}  // namespace pardel::engine
