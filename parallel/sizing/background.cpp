#include "background.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "../../core/neighbours.hpp"
#include "../../core/support/point_order.hpp"
#include "../arithmetic/distance.hpp"
#include "../arithmetic/predicates.hpp"
#include "../decomposition/hilbert_order.hpp"

namespace pardel::engine {
namespace {

double squared_distance(const Box& box, Point p) {
  const double dx = std::max({box.min_x - p.x, 0.0, p.x - box.max_x});
  const double dy = std::max({box.min_y - p.y, 0.0, p.y - box.max_y});
  return dx * dx + dy * dy;
}

/// The point of the segment a-b nearest to p, as a fraction of the segment from a.
double nearest_fraction(Point a, Point b, Point p) {
  const double dx = b.x - a.x, dy = b.y - a.y;
  const double length = dx * dx + dy * dy;
  return length > 0 ? std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / length, 0.0, 1.0) : 0.0;
}

/// The turn from a over b to p. Its determinant divided by that of the triangle is a barycentric weight of p.
Orientation<double> turn(Point a, Point b, Point p) { return {b.x - a.x, b.y - a.y, p.x - a.x, p.y - a.y}; }

/// The weights of a point in a triangle, from the three determinants, which are positive or 0, and twice the area. If a
/// corner is far away, rounding may change a small determinant much. The weights are divided by their sum then, so that
/// a value lies between those at the corners.
std::array<double, 3> weights_of(const std::array<double, 3>& determinants, double twice_area) {
  constexpr double usual_rounding = 1e-12;
  const double sum = determinants[0] + determinants[1] + determinants[2];
  const double whole = std::abs(sum - twice_area) > usual_rounding * twice_area ? sum : twice_area;
  return {determinants[0] / whole, determinants[1] / whole, determinants[2] / whole};
}

}  // namespace

Background::Background(std::span<const Point> points, std::vector<std::array<Index, 3>> triangles,
                       const Threads& threads)
    : points_(points.begin(), points.end()), leaf_count_(std::bit_ceil(std::max<std::size_t>(1, triangles.size()))) {
  SparseAsk ask(threads.stop);
  std::vector<Point> centre;
  centre.reserve(triangles.size());
  for (const auto& v : triangles) {
    ask();
    const Point a = points_[v[0]], b = points_[v[1]], c = points_[v[2]];
    centre.push_back({(a.x + b.x + c.x) / 3, (a.y + b.y + c.y) / 3});
  }
  number_ = hilbert_order(centre, threads);
  Array<Triangle> ordered;
  ordered.reserve(number_.size());
  for (const Index i : number_) ordered.push_back({triangles[i], {}});
  rebuild_neighbours(ordered, points_.size());
  boxes_.assign(2 * leaf_count_, empty_box);
  leaves_.reserve(ordered.size());
  for (const Triangle& triangle : ordered) {
    ask();
    Box& box = boxes_[leaf_count_ + leaves_.size()];
    for (const Index v : triangle.v) box.cover(Box::around(points_[v]));
    leaves_.push_back({triangle.v, triangle.n, 0});
    const auto c = corners(leaves_.back());
    leaves_.back().twice_area = turn(c[0], c[1], c[2]).determinant;
  }
  for (std::size_t i = leaf_count_ - 1; i > 0; --i) {
    ask();
    boxes_[i].cover(boxes_[2 * i]);
    boxes_[i].cover(boxes_[2 * i + 1]);
  }
}

Located Background::weights_in(Index leaf, Point p) const {
  const auto c = corners(leaves_[leaf]);
  const double area = leaves_[leaf].twice_area;
  bool inside = area > 0, differs_from_zero = false;
  std::array<double, 3> determinants{};
  for (unsigned i = 0; i < 3; ++i) {
    determinants[i] = turn(c[(i + 1) % 3], c[(i + 2) % 3], p).determinant;
    inside = inside && determinants[i] >= 0;
    differs_from_zero = differs_from_zero || determinants[i] > 0;
  }
  if (!inside || !differs_from_zero) return nearest_in(leaf, p);
  return {number_[leaf], leaves_[leaf].v, weights_of(determinants, area)};
}

/// The weights of the point on the boundary of a triangle that is nearest to p.
Located Background::nearest_in(Index leaf, Point p) const {
  const auto c = corners(leaves_[leaf]);
  Located result{number_[leaf], leaves_[leaf].v, {}};
  double best = INFINITY;
  for (unsigned i = 0; i < 3; ++i) {
    const unsigned j = (i + 1) % 3;
    const double f = nearest_fraction(c[i], c[j], p);
    const double x = c[i].x + f * (c[j].x - c[i].x) - p.x, y = c[i].y + f * (c[j].y - c[i].y) - p.y;
    if (x * x + y * y >= best) continue;
    best = x * x + y * y;
    result.weight = {};
    result.weight[i] = 1 - f;
    result.weight[j] = f;
  }
  return result;
}

/// The side of a triangle beyond which p lies; no_side if p lies inside, on_side if p lies on a side. Exact.
unsigned Background::side_towards(Point p, const Leaf& leaf) const {
  const auto c = corners(leaf);
  bool inside = true;
  for (unsigned side = 0; side < 3; ++side) {
    const double sign = orient2d(c[(side + 1) % 3], c[(side + 2) % 3], p);
    if (sign < 0) return side;
    inside = inside && sign > 0;
  }
  return inside ? no_side : on_side;
}

/// Walks from `leaf` towards p, through sides that have p on their other side. `leaf` is then the last triangle and, if
/// it has p in its interior, `found` the position. The walk is `lost` if it would leave the triangulation, or after
/// `steps` steps: where edges are not Delaunay it may go round in a circle.
Background::Walk Background::walk(Point p, Index& leaf, int steps, Located& found) const {
  for (; steps > 0; --steps) {
    const Leaf& at = leaves_[leaf];
    const auto c = corners(at);
    const Orientation<double> a = turn(c[1], c[2], p), b = turn(c[2], c[0], p), d = turn(c[0], c[1], p);
    if (a.determinant > a.error && b.determinant > b.error && d.determinant > d.error && at.twice_area > 0) {
      // The weights of weights_in(), with the same bits.
      found = {number_[leaf], at.v, weights_of({a.determinant, b.determinant, d.determinant}, at.twice_area)};
      return Walk::inside;
    }
    unsigned side = a.determinant < -a.error ? 0 : b.determinant < -b.error ? 1 : d.determinant < -d.error ? 2 : 3;
    if (side == 3) side = side_towards(p, at);
    if (side == on_side) return Walk::on_edge;
    if (side == no_side) {
      found = weights_in(leaf, p);
      return Walk::inside;
    }
    if (at.n[side] == no_index) return Walk::lost;
    leaf = at.n[side];
  }
  return Walk::lost;
}

/// A triangle near p: descends into the nearer box.
Index Background::leaf_near(Point p) const {
  std::size_t node = 1;
  while (node < leaf_count_) {
    node *= 2;
    if (squared_distance(boxes_[node + 1], p) < squared_distance(boxes_[node], p)) ++node;
  }
  return static_cast<Index>(std::min(node - leaf_count_, leaves_.size() - 1));
}

Located Background::locate(Point p, LocationHint& hint) const {
  if (leaves_.empty()) return {};
  constexpr int near = 32, far = 1000;
  Located found;
  Walk end = hint.leaf == no_index ? Walk::lost : walk(p, hint.leaf, near, found);
  if (end == Walk::lost) {
    hint.leaf = leaf_near(p);
    end = walk(p, hint.leaf, far, found);
  }
  return end == Walk::inside ? found : search(p);
}

/// Finds the triangle by the hierarchy alone. Triangles that have p on a side come before the others, then the nearest,
/// then that with the least corners. So the result depends on the triangles near p only, not on their order.
Located Background::search(Point p) const {
  Located best;
  double best_distance = INFINITY;
  bool best_contains = false;
  std::vector<std::size_t> stack{1};
  while (!stack.empty()) {
    const std::size_t node = stack.back();
    stack.pop_back();
    // A box at the same distance is searched, too: it may contain the triangle that has p in its interior.
    const double to_box = squared_distance(boxes_[node], p);
    if (to_box > best_distance) continue;
    if (node < leaf_count_) {
      const bool left_first = squared_distance(boxes_[2 * node], p) <= squared_distance(boxes_[2 * node + 1], p);
      stack.push_back(2 * node + (left_first ? 1 : 0));
      stack.push_back(2 * node + (left_first ? 0 : 1));
      continue;
    }
    if (node - leaf_count_ >= leaves_.size()) continue;
    auto leaf = static_cast<Index>(node - leaf_count_);
    Located here;
    const Walk end = walk(p, leaf, 1, here);
    if (end == Walk::inside) return here;
    const bool contains = end == Walk::on_edge;
    here = weights_in(static_cast<Index>(node - leaf_count_), p);
    // Rounding must not put the point nearer than the box: then the order of the search would count.
    const double distance = contains ? 0 : std::max(to_box, squared_distance_to(here, p));
    if (distance < best_distance || (contains && !best_contains) ||
        (distance == best_distance && contains == best_contains && has_lesser_corners(here, best))) {
      best = here;
      best_distance = distance;
      best_contains = contains;
    }
  }
  return best;
}

/// From p to the place with these weights, rounded; 0 if it is in the interior of its triangle.
double Background::squared_distance_to(const Located& at, Point p) const {
  if (at.weight[0] > 0 && at.weight[1] > 0 && at.weight[2] > 0) return 0;
  const Point q = point_at(at);
  return (q.x - p.x) * (q.x - p.x) + (q.y - p.y) * (q.y - p.y);
}

bool Background::has_lesser_corners(const Located& a, const Located& b) const {
  unsigned i = 0;
  while (i < 2 && points_[a.v[i]] == points_[b.v[i]]) ++i;
  return lexicographically_less(points_[a.v[i]], points_[b.v[i]]);
}

Point Background::point_at(const Located& at) const {
  Point q{0, 0};
  for (unsigned i = 0; i < 3; ++i) {
    q.x += at.weight[i] * points_[at.v[i]].x;
    q.y += at.weight[i] * points_[at.v[i]].y;
  }
  return q;
}

double Background::value_at(const Located& at, std::span<const double> value_per_point) const {
  double value = 0;
  for (unsigned i = 0; i < 3; ++i) value += at.weight[i] * value_per_point[at.v[i]];
  return value;
}

/// Is the border one chain without a turn to the right?
bool Background::is_convex() const {
  std::vector<Index> next(points_.size(), no_index);
  std::size_t edges = 0;
  Index start = no_index;
  for (const Leaf& leaf : leaves_)
    for (unsigned side = 0; side < 3; ++side) {
      if (leaf.n[side] != no_index) continue;
      start = leaf.v[(side + 1) % 3];
      if (std::exchange(next[start], leaf.v[(side + 2) % 3]) != no_index) return false;
      ++edges;
    }
  if (start == no_index) return false;
  Index a = start;
  do {
    const Index b = next[a];
    if (next[b] == no_index || orient2d(points_[a], points_[b], points_[next[b]]) < 0) return false;
    a = b;
  } while (--edges > 0 && a != start);
  return edges == 0 && a == start;
}

Steepness Background::steepness(std::span<const double> value_per_point) const {
  constexpr double thin = 1e-10;            // area divided by the squared longest side
  constexpr double slope_to_spare = 1.001;  // the relative rounding error of a slope is less than 64 * 2^-53 / thin
  constexpr double roundings = 64 * 0x1p-53;
  if (!is_convex()) return {};
  Steepness all{0, 0};
  for (const Leaf& leaf : leaves_) {
    const auto c = corners(leaf);
    const double ux = c[1].x - c[0].x, uy = c[1].y - c[0].y, vx = c[2].x - c[0].x, vy = c[2].y - c[0].y;
    const double longest_squared =
        std::max({ux * ux + uy * uy, vx * vx + vy * vy, (vx - ux) * (vx - ux) + (vy - uy) * (vy - uy)});
    if (!(leaf.twice_area > thin * longest_squared)) return {};
    const double a = value_per_point[leaf.v[0]];
    const double b = value_per_point[leaf.v[1]] - a, d = value_per_point[leaf.v[2]] - a;
    const double x = b * vy - d * uy, y = d * ux - b * vx;
    all.slope = std::max(all.slope, slope_to_spare * std::sqrt(x * x + y * y) / leaf.twice_area);
    const double largest = std::abs(a) + std::abs(b) + std::abs(d);
    all.blur = std::max(all.blur, roundings * largest * (longest_squared / leaf.twice_area));
  }
  return all;
}

bool Background::is_near(const Located& at, Point p) const {
  if (at.weight[0] > 0 && at.weight[1] > 0 && at.weight[2] > 0) return true;
  const std::array<Point, 3> c{points_[at.v[0]], points_[at.v[1]], points_[at.v[2]]};
  const double longest = std::max({distance(c[0], c[1]), distance(c[1], c[2]), distance(c[2], c[0])});
  return distance(point_at(at), p) <= longest;
}

}  // namespace pardel::engine
