#include "samples.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

#include "../../core/support/point_order.hpp"
#include "../../parallel/construction/carve.hpp"
#include "../../parallel/construction/delaunay.hpp"
#include "../../properties/checker/arithmetic/exact.hpp"
#include "../../properties/domains/domains.hpp"

namespace pardel::engine::samples {
namespace {

std::vector<Point> distinct(std::vector<Point> points) {
  std::sort(points.begin(), points.end(), lexicographically_less);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

std::vector<Point> shifted(std::vector<Point> points, Point by) {
  for (Point& p : points) p = {p.x + by.x, p.y + by.y};
  return points;
}

/// All integer points on the circle of radius 65 (36 of them), and its centre.
std::vector<Point> cocircular_points() {
  std::vector<Point> points{{0, 0}};
  for (int x = -65; x <= 65; ++x)
    for (int y = -65; y <= 65; ++y)
      if (x * x + y * y == 65 * 65) points.push_back({double(x), double(y)});
  return points;
}

/// Points on the line y = 3x, and one point that is not on this line.
std::vector<Point> collinear_but_one(std::size_t n, Random& random) {
  std::vector<Point> points{{0.25, 0.5}};
  while (points.size() < n) {
    const double x = std::round(random.uniform(-1000, 1000));
    points.push_back({x, 3 * x});
  }
  return points;
}

/// Points rounded to the line y = x / 3. Their triples are so nearly collinear that floating point cannot decide the
/// orientation.
std::vector<Point> nearly_collinear(std::size_t n, Random& random) {
  std::vector<Point> points{{0.5, 7}};
  while (points.size() < n) {
    const double x = random.uniform(0, 1);
    points.push_back({x, x / 3});
  }
  return points;
}

std::vector<Point> clusters(std::size_t n, Random& random) {
  std::vector<Point> points;
  while (points.size() < n) {
    const Point centre{random.uniform(), random.uniform()};
    const double radius = std::exp2(-static_cast<double>(random.below(48)));
    for (int i = 0; i < 8; ++i)
      points.push_back({centre.x + random.uniform(-radius, radius), centre.y + random.uniform(-radius, radius)});
  }
  return points;
}

bool between(Point p, Point a, Point b) {
  return checker::exactly::orientation(a, b, p) == 0 && checker::exactly::progress(a, p, a, b) > 0 &&
         checker::exactly::progress(p, b, a, b) > 0;
}

bool cross(Point a, Point b, Point c, Point d) {
  return checker::exactly::orientation(a, b, c) * checker::exactly::orientation(a, b, d) < 0 &&
         checker::exactly::orientation(c, d, a) * checker::exactly::orientation(c, d, b) < 0;
}

bool reciprocal(const Triangulation& t, TriangleId id, unsigned side) {
  const Slot& slot = t.slots[id];
  const EdgeRef out = slot.n[side];
  if (out.none()) return true;
  if (out.triangle() >= t.slots.size() || out.side() > 2) return false;
  const Slot& other = t.slots[out.triangle()];
  const EdgeRef back = other.n[out.side()];
  return back == EdgeRef(id, side, out.constrained()) && other.from(out.side()) == slot.to(side) &&
         other.to(out.side()) == slot.from(side);
}

}  // namespace

std::vector<Point> uniform_points(std::size_t n, std::uint64_t seed) {
  Random random(seed);
  std::vector<Point> points(n);
  for (Point& p : points) {
    p.x = random.uniform();
    p.y = random.uniform();
  }
  return points;
}

std::vector<Point> lattice_points(int n) {
  std::vector<Point> points;
  for (int y = 0; y < n; ++y)
    for (int x = 0; x < n; ++x) points.push_back({double(x), double(y)});
  return points;
}

std::vector<Family> families(std::size_t n, std::uint64_t seed) {
  Random random(seed);
  const int side = std::max(2, static_cast<int>(std::sqrt(static_cast<double>(n))));
  std::vector<Family> all{
      {"uniform", uniform_points(n, seed)},
      {"lattice", lattice_points(side)},
      {"cocircular", cocircular_points()},
      {"collinear but one", collinear_but_one(n, random)},
      {"nearly collinear", nearly_collinear(n, random)},
      {"clusters", clusters(n, random)},
      {"uniform far away", shifted(uniform_points(n, seed + 1), {0x1p40, -0x1p41})},
      {"lattice far away", shifted(lattice_points(side), {654321, 4987654})},
      {"tiny", uniform_points(n, seed + 2)},
      {"huge", uniform_points(n, seed + 3)},
      {"dense around a point", domains::kuzmin_points(n, seed).points},
      {"dense along a line", domains::line_points(n, seed).points},
  };
  for (Point& p : all[8].points) p = {p.x * 0x1p-60, p.y * 0x1p-60};
  for (Point& p : all[9].points) p = {p.x * 0x1p60, p.y * 0x1p60};
  for (Family& family : all) {
    family.points = distinct(std::move(family.points));
    random.shuffle(family.points);
  }
  return all;
}

std::vector<Constraint> random_constraints(const std::vector<Point>& points, std::size_t tries, Random& random) {
  std::vector<Constraint> chosen;
  for (std::size_t i = 0; i < tries; ++i) {
    const Constraint c{random.below(points.size()), random.below(points.size())};
    if (c.a == c.b) continue;
    const Point a = points[c.a], b = points[c.b];
    const bool blocked =
        std::any_of(points.begin(), points.end(), [&](Point p) { return between(p, a, b); }) ||
        std::any_of(chosen.begin(), chosen.end(), [&](Constraint o) {
          return cross(a, b, points[o.a], points[o.b]) || (o.a == c.a && o.b == c.b) || (o.a == c.b && o.b == c.a);
        });
    if (!blocked) chosen.push_back(c);
  }
  return chosen;
}

std::string fault(const Triangulation& t) {
  for (TriangleId id = 0; id < t.slots.size(); ++id) {
    const Slot& slot = t.slots[id];
    const std::string here = "triangle " + std::to_string(id);
    for (unsigned side = 0; side < 3; ++side)
      if (!reciprocal(t, id, side))
        return here + " and its neighbour across side " + std::to_string(side) + " disagree";
    if (slot.is_ghost()) continue;
    const Point a = t.points[slot.v[0]], b = t.points[slot.v[1]], c = t.points[slot.v[2]];
    if (checker::exactly::orientation(a, b, c) <= 0) return here + " is not counter-clockwise";
    for (unsigned side = 0; side < 3; ++side) {
      const EdgeRef out = slot.n[side];
      if (out.constrained() || t.slot(out).is_ghost()) continue;
      if (checker::exactly::in_circle(a, b, c, t.points[t.slot(out).apex(out.side())]) > 0)
        return here + " has an unconstrained side " + std::to_string(side) + " that is not locally Delaunay";
    }
  }
  return {};
}

Triangulation delaunay_of(const std::vector<Point>& points) {
  Result<Delaunay> d = delaunay(points);
  if (!d) throw std::invalid_argument(d.error().message);
  Triangulation& t = d->triangulation;
  for (Slot& slot : t.slots)
    for (VertexId& v : slot.v)
      if (v != ghost) v = d->input_of_vertex[v];
  t.points = Array<Point>(std::span<const Point>(points));
  return std::move(t);
}

Sample triangulated(const std::vector<Point>& points, std::vector<Constraint> constraints) {
  Triangulation t = delaunay_of(points);
  if (Status inserted = insert_constraints(t, constraints); !inserted)
    throw std::invalid_argument(inserted.error().message);
  DomainRules hull;
  hull.convex_hull = true;
  for (const Constraint edge : carve(t, hull)) constraints.push_back(edge);
  t.origin.resize(t.points.size(), input_vertex);
  return {std::move(t), std::move(constraints)};
}

std::vector<std::array<Index, 3>> triples(const Triangulation& t) {
  std::vector<std::array<Index, 3>> result;
  for (const Slot& slot : t.slots) {
    if (slot.is_ghost()) continue;
    result.push_back(slot.v);
    std::sort(result.back().begin(), result.back().end());
  }
  std::sort(result.begin(), result.end());
  return result;
}

EdgeRef find_edge(const Triangulation& t, VertexId u, VertexId v) {
  for (TriangleId id = 0; id < t.slots.size(); ++id)
    for (unsigned side = 0; side < 3; ++side)
      if (t.slots[id].from(side) == u && t.slots[id].to(side) == v) return {id, side};
  for (TriangleId id = 0; id < t.slots.size(); ++id)
    for (unsigned side = 0; side < 3; ++side)
      if (t.slots[id].from(side) == v && t.slots[id].to(side) == u) return {id, side};
  return {};
}

double twice_area(const Triangulation& t) {
  double sum = 0;
  for (const Slot& slot : t.slots) {
    if (slot.is_ghost()) continue;
    const Point a = t.points[slot.v[0]], b = t.points[slot.v[1]], c = t.points[slot.v[2]];
    sum += (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  }
  return sum;
}

}  // namespace pardel::engine::samples
