#include "convex_hull.hpp"

#include <algorithm>
#include <array>

#include "../../core/support/point_order.hpp"
#include "../arithmetic/predicates.hpp"

namespace pardel::engine {
namespace {

/// The points that are extreme in eight directions, counter-clockwise. Rounding can pick points that are not quite
/// extreme. This does no harm: a point strictly to the left of all sides of a closed polygon is inside the polygon's
/// hull.
std::array<Point, 8> octagon(std::span<const Point> points, SparseAsk& ask) {
  std::array<Point, 8> corner;
  corner.fill(points[0]);
  for (const Point& p : points) {
    ask();
    const auto improve = [&](std::size_t i, double value, double best) {
      if (value > best) corner[i] = p;
    };
    improve(0, -p.x, -corner[0].x);
    improve(1, -p.x - p.y, -corner[1].x - corner[1].y);
    improve(2, -p.y, -corner[2].y);
    improve(3, p.x - p.y, corner[3].x - corner[3].y);
    improve(4, p.x, corner[4].x);
    improve(5, p.x + p.y, corner[5].x + corner[5].y);
    improve(6, p.y, corner[6].y);
    improve(7, p.y - p.x, corner[7].y - corner[7].x);
  }
  return corner;
}

/// The points that can be on the hull, sorted lexicographically, without duplicates.
std::vector<Index> candidates(std::span<const Point> points, SparseAsk& ask) {
  const std::array<Point, 8> corner = octagon(points, ask);
  const auto is_inside = [&](Point p) {
    for (std::size_t i = 0; i < corner.size(); ++i) {
      const Point a = corner[i], b = corner[(i + 1) % corner.size()];
      if (a != b && orient2d(a, b, p) <= 0) return false;
    }
    return true;
  };
  std::vector<Index> chosen;
  for (Index i = 0; i < points.size(); ++i) {
    ask();
    if (!is_inside(points[i])) chosen.push_back(i);
  }
  std::ranges::sort(chosen, [&](Index i, Index j) {
    ask();
    return lexicographically_less(points[i], points[j]) || (points[i] == points[j] && i < j);
  });
  const auto equal = [&](Index i, Index j) { return points[i] == points[j]; };
  chosen.erase(std::unique(chosen.begin(), chosen.end(), equal), chosen.end());
  return chosen;
}

}  // namespace

bool all_collinear(std::span<const Point> points, const Threads& threads) {
  SparseAsk ask(threads.stop);
  const auto other = std::ranges::find_if(points, [&](Point p) { return p != points[0]; });
  return std::ranges::all_of(other, points.end(), [&](Point p) {
    ask();
    return orient2d(points[0], *other, p) == 0;
  });
}

/// By Andrew's monotone chains (1979).
std::vector<Index> convex_hull(std::span<const Point> points, const Threads& threads) {
  SparseAsk ask(threads.stop);
  const std::vector<Index> sorted = candidates(points, ask);
  std::vector<Index> hull;
  const auto extend = [&](std::size_t chain_begin, Index next) {
    ask();
    while (hull.size() >= chain_begin + 2 &&
           orient2d(points[hull[hull.size() - 2]], points[hull.back()], points[next]) < 0)
      hull.pop_back();
    hull.push_back(next);
  };
  for (const Index i : sorted) extend(0, i);
  const std::size_t upper = hull.size() - 1;
  for (std::size_t i = sorted.size() - 1; i-- > 0;) extend(upper, sorted[i]);
  hull.pop_back();
  return hull;
}

}  // namespace pardel::engine
