#include "verify.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "../../core/support/shortened.hpp"
#include "../../core/support/shortest.hpp"
#include "../../parallel/arithmetic/predicates.hpp"
#include "flip_answer.hpp"
#include "half_edges.hpp"
#include "room.hpp"
#include "verify_points.hpp"

namespace pardel::engine {
namespace {

using Corners = HalfEdges::Corners;

double distance_from_line(Point p, Point a, Point b) {
  const double dx = b.x - a.x, dy = b.y - a.y;
  return std::abs(dx * (p.y - a.y) - dy * (p.x - a.x)) / std::sqrt(dx * dx + dy * dy);
}

/// The steps of verify(). Each returns the first breach that it finds. A step relies on those before it.
class Verification {
 public:
  Verification(const Subdomain& subdomain, RefinedSubdomain& answer, std::span<const EndPoints> lines,
               const Floor& floor)
      : in_(subdomain), out_(answer), lines_(lines), floor_(floor) {}

  std::optional<Breach> run() {
    for (const auto step :
         {&Verification::ending, &Verification::points, &Verification::corners, &Verification::orientations,
          &Verification::pair_sides, &Verification::edges_that_stay, &Verification::border, &Verification::flip,
          &Verification::lengths, &Verification::distances_from_edges})
      if (std::optional<Breach> found = (this->*step)()) return found;
    return {};
  }

  VerifiedSubdomain take() { return std::move(result_); }

 private:
  [[nodiscard]] std::size_t old_count() const { return in_.points.size(); }
  [[nodiscard]] Index start_of(Index side) const { return out_.triangles[side / 3][(side + 1) % 3]; }
  [[nodiscard]] Index end_of(Index side) const { return out_.triangles[side / 3][(side % 3 + 2) % 3]; }
  [[nodiscard]] Point at(Index point) const { return out_.points[point]; }

  std::optional<Breach> ending() {
    using Ending = RefinedSubdomain::Ending;
    const Point where = in_.points.empty() ? Point{} : in_.points.front();
    switch (out_.ending) {
      case Ending::failed:
        return Breach{BreachKind::failed, where, shortened(out_.why)};
      case Ending::crashed:
        return Breach{BreachKind::crashed, where, shortened(out_.why)};
      case Ending::timed_out:
        return Breach{BreachKind::timed_out, where, shortened(out_.why)};
      case Ending::unreadable:
        return Breach{BreachKind::unreadable, where, shortened(out_.why)};
      default:
        return {};
    }
  }

  std::optional<Breach> points() { return verify_points(in_, lines_, out_, on_edges_); }

  std::optional<Breach> corners() {
    if (out_.triangles.size() > 2 * out_.points.size())
      return Breach{BreachKind::overlap, in_.points.front(),
                    std::to_string(out_.triangles.size()) + " triangles, more than " +
                        std::to_string(out_.points.size()) + " points can have"};
    std::vector<char> used(out_.points.size(), 0);
    for (const Corners& v : out_.triangles)
      for (const Index corner : v) {
        if (corner >= out_.points.size())
          return Breach{BreachKind::wrong_index,
                        {},
                        "a triangle has the corner " + std::to_string(corner) + " of " +
                            std::to_string(out_.points.size()) + " points"};
        used[corner] = 1;
      }
    const auto unused = std::ranges::find(used, 0);
    if (unused == used.end()) return {};
    const Point p = out_.points[static_cast<std::size_t>(unused - used.begin())];
    return Breach{BreachKind::unused_point, p, shortest(p) + " is the corner of no triangle"};
  }

  std::optional<Breach> orientations() {
    for (const Corners& v : out_.triangles)
      if (!(orient2d(at(v[0]), at(v[1]), at(v[2])) > 0))
        return Breach{BreachKind::wrong_orientation, at(v[0]),
                      "the triangle " + shortest(at(v[0])) + " " + shortest(at(v[1])) + " " + shortest(at(v[2])) +
                          " is not counter-clockwise"};
    return {};
  }

  std::optional<Breach> pair_sides() {
    sides_.emplace(out_.triangles, out_.points.size());
    across_.assign(3 * out_.triangles.size(), no_index);
    on_edge_.assign(across_.size(), no_index);
    for (Index a = 0; a < out_.points.size(); ++a)
      for (const HalfEdges::Out& there : sides_->from(a)) {
        if (there.to < a) continue;
        bool is_overlap = false;
        sides_->for_each_side(there.to, a, [&](Index back) {
          is_overlap = across_[there.side] != no_index || across_[back] != no_index;
          across_[there.side] = back;
          across_[back] = there.side;
          return is_overlap;
        });
        if (is_overlap) return overlap(a, there.to);
      }
    for (Index side = 0; side < across_.size(); ++side) {
      if (across_[side] != no_index) continue;
      int count = 0;
      sides_->for_each_side(start_of(side), end_of(side), [&](Index) { return ++count > 1; });
      if (count > 1) return overlap(start_of(side), end_of(side));
    }
    return {};
  }
  [[nodiscard]] Breach overlap(Index a, Index b) const {
    return {BreachKind::overlap, at(a), "two triangles lie on the same side of " + text_of_edge(at(a), at(b))};
  }

  std::optional<Breach> edges_that_stay() {
    std::ranges::sort(on_edges_, {}, [](const PointOnEdge& p) { return std::pair(p.edge, p.along); });
    auto next = on_edges_.begin();
    for (Index edge = 0; edge < in_.edges.size(); ++edge) {
      Index from = in_.edges[edge].a;
      for (; next != on_edges_.end() && next->edge == edge; ++next) {
        if (auto found = piece(edge, from, next->point)) return found;
        from = next->point;
      }
      if (auto found = piece(edge, from, in_.edges[edge].b)) return found;
    }
    return {};
  }

  /// A piece of an edge that stays has to be a side of triangles.
  std::optional<Breach> piece(Index edge, Index from, Index to) {
    const Index left = sides_->find(from, to), right = sides_->find(to, from);
    if (left == no_index || (in_.edges[edge].inside && right == no_index))
      return Breach{BreachKind::lost_edge, at(from), text_of_edge(at(from), at(to)) + " is missing"};
    on_edge_[left] = edge;
    if (in_.edges[edge].inside) on_edge_[right] = edge;
    return {};
  }

  std::optional<Breach> border() {
    for (Index side = 0; side < across_.size(); ++side) {
      if (across_[side] != no_index && on_edge_[side] == no_index) continue;
      const bool ends_here = on_edge_[side] != no_index && !in_.edges[on_edge_[side]].inside;
      const Point from = at(start_of(side)), to = at(end_of(side));
      if (across_[side] == no_index && !ends_here)
        return Breach{BreachKind::open_edge, from, text_of_edge(from, to) + " has a triangle on one side only"};
      if (across_[side] != no_index && ends_here)
        return Breach{BreachKind::overlap, from, "a triangle lies beyond the border, at " + text_of_edge(from, to)};
    }
    return {};
  }

  /// Two points can lie close to each other without an edge between them. In the constrained Delaunay triangulation,
  /// there is one.
  std::optional<Breach> flip() {
    sides_.reset();  // it belongs to the triangles before the flips
    result_ = {std::move(out_.points), std::move(out_.edge_of_new_point), std::move(out_.triangles), std::move(across_),
               std::move(on_edge_)};
    flip_to_delaunay(result_);
    return {};
  }

  [[nodiscard]] Index corner_of(Index side, Index k) const { return result_.triangles[side / 3][(side + k) % 3]; }

  std::optional<Breach> lengths() {
    for (Index side = 0; side < result_.across.size(); ++side) {
      if (result_.across[side] < side) continue;  // tested from the other side
      const Index from = corner_of(side, 1), to = corner_of(side, 2), newest = std::max(from, to);
      if (newest < old_count()) continue;
      const Point a = result_.points[from], b = result_.points[to], p = result_.points[newest];
      const double dx = b.x - a.x, dy = b.y - a.y, least = std::max(floor_.at(p), room_at(p));
      if (!(dx * dx + dy * dy >= (1 - 0x1p-39) * least * least))
        return Breach{BreachKind::too_short_edge, a, text_of_edge(a, b) + " is too short"};
    }
    return {};
  }

  /// A new point close to an edge that stays has no short edge. Of all points near the edge, the corner of the triangle
  /// at it is the nearest one, up to a constant factor.
  std::optional<Breach> distances_from_edges() {
    for (Index side = 0; side < result_.on_edge.size(); ++side) {
      if (result_.on_edge[side] == no_index || corner_of(side, 0) < old_count()) continue;
      const Point p = result_.points[corner_of(side, 0)], a = result_.points[corner_of(side, 1)],
                  b = result_.points[corner_of(side, 2)];
      if (distance_from_line(p, a, b) < room_at(p))
        return Breach{BreachKind::too_near_edge, p, shortest(p) + " is too close to " + text_of_edge(a, b)};
    }
    return {};
  }

  const Subdomain& in_;
  RefinedSubdomain& out_;
  std::span<const EndPoints> lines_;
  const Floor& floor_;
  std::vector<PointOnEdge> on_edges_;
  std::optional<HalfEdges> sides_;
  std::vector<Index> across_, on_edge_;
  VerifiedSubdomain result_;
};

}  // namespace

Result<VerifiedSubdomain, Breach> verify(const Subdomain& subdomain, RefinedSubdomain&& answer,
                                         std::span<const EndPoints> lines, const Floor& floor) {
  Verification verification(subdomain, answer, lines, floor);
  if (std::optional<Breach> found = verification.run()) return *std::move(found);
  return verification.take();
}

}  // namespace pardel::engine
