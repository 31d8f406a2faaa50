#include "verify_points.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "../../core/support/shortest.hpp"
#include "../../parallel/arithmetic/distance.hpp"
#include "../../parallel/arithmetic/predicates.hpp"
#include "../../parallel/arithmetic/projected.hpp"

namespace pardel::engine {
namespace {

bool same_bits(double a, double b) { return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b); }

class PointVerification {
 public:
  PointVerification(const Subdomain& subdomain, std::span<const EndPoints> lines, RefinedSubdomain& answer,
                    std::vector<PointOnEdge>& on_edges)
      : in_(subdomain), lines_(lines), out_(answer), on_edges_(on_edges) {}

  std::optional<Breach> old_points() {
    const auto& given = in_.points;
    for (std::size_t i = 0; i < given.size(); ++i) {
      if (i >= out_.points.size())
        return Breach{BreachKind::moved_point, given[i],
                      "point " + std::to_string(i) + " at " + shortest(given[i]) + " is missing"};
      if (!same_bits(given[i].x, out_.points[i].x) || !same_bits(given[i].y, out_.points[i].y))
        return Breach{
            BreachKind::moved_point, given[i],
            "point " + std::to_string(i) + " moved from " + shortest(given[i]) + " to " + shortest(out_.points[i])};
    }
    return {};
  }

  std::optional<Breach> new_points() {
    const std::size_t made = out_.points.size() - old_count();
    if (made > in_.most_new_points)
      return Breach{BreachKind::too_many_points, out_.points.back(),
                    std::to_string(made) + " new points, at most " + std::to_string(in_.most_new_points) + " allowed"};
    if (out_.edge_of_new_point.size() != made)
      return Breach{
          BreachKind::wrong_index, in_.points.empty() ? Point{} : in_.points.front(),
          std::to_string(out_.edge_of_new_point.size()) + " edges for " + std::to_string(made) + " new points"};
    for (std::size_t i = 0; i < made; ++i)
      if (auto found = new_point(static_cast<Index>(old_count() + i), out_.edge_of_new_point[i])) return found;
    return {};
  }

 private:
  [[nodiscard]] std::size_t old_count() const { return in_.points.size(); }

  std::optional<Breach> new_point(Index point, Index edge) {
    Point& p = out_.points[point];
    if (!is_usable(p))
      return Breach{BreachKind::unusable_point, p,
                    "the coordinates of " + shortest(p) + " are out of the range of exact arithmetic"};
    if (edge != no_index)
      if (auto found = move_onto_edge(point, edge)) return found;
    if (in_.cell && !in_.cell->contains(p))
      return Breach{
          BreachKind::outside_cell, p,
          shortest(p) + " is outside the cell from " + shortest(in_.cell->low) + " to " + shortest(in_.cell->high)};
    return {};
  }

  std::optional<Breach> move_onto_edge(Index point, Index edge) {
    Point& p = out_.points[point];
    if (edge >= in_.edges.size())
      return Breach{
          BreachKind::wrong_index, p,
          shortest(p) + " is said to be on edge " + std::to_string(edge) + " of " + std::to_string(in_.edges.size())};
    const SubdomainEdge& e = in_.edges[edge];
    const Point a = in_.points[e.a], b = in_.points[e.b];
    if (!e.may_be_split) return Breach{BreachKind::split_frozen_edge, p, shortest(p) + " is on " + text_of_edge(a, b)};
    const double dx = b.x - a.x, dy = b.y - a.y;
    const double along = ((p.x - a.x) * dx + (p.y - a.y) * dy) / (dx * dx + dy * dy);
    const Point on_line = projected(p, lines_[edge].a, lines_[edge].b);
    // What a mesher's own rounding can explain, far below the length of any triangle.
    const double tolerance =
        1e-9 * distance(a, b) + 0x1p-48 * std::max({std::abs(a.x), std::abs(a.y), std::abs(b.x), std::abs(b.y)});
    if (!(along > 0 && along < 1) || !(distance(p, on_line) <= tolerance) || !is_usable(on_line))
      return Breach{BreachKind::off_segment, p, shortest(p) + " is not on " + text_of_edge(a, b)};
    p = on_line;
    on_edges_.push_back({edge, along, point});
    return {};
  }

  const Subdomain& in_;
  std::span<const EndPoints> lines_;
  RefinedSubdomain& out_;
  std::vector<PointOnEdge>& on_edges_;
};

}  // namespace

std::string text_of_edge(Point a, Point b) { return "the edge from " + shortest(a) + " to " + shortest(b); }

std::optional<Breach> verify_points(const Subdomain& subdomain, std::span<const EndPoints> lines,
                                    RefinedSubdomain& answer, std::vector<PointOnEdge>& on_edges) {
  PointVerification verification(subdomain, lines, answer, on_edges);
  if (std::optional<Breach> found = verification.old_points()) return found;
  return verification.new_points();
}

}  // namespace pardel::engine
