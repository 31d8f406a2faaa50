#include "path.hpp"

#include <CGAL/Gmpq.h>
#include <CGAL/Interval_nt.h>

#include <algorithm>

#include "../../../core/support/point_order.hpp"
#include "../mesh/forced_segments.hpp"
#include "../mesh/predicates.hpp"

namespace pardel::schemes {
namespace {

/// |b - m|^2 - |a - m|^2.
template <class Number>
Number rise(Point a, Point b, Point m) {
  const Number ax(a.x), ay(a.y), bx(b.x), by(b.y), mx(m.x), my(m.y);
  return (bx - ax) * ((bx - mx) + (ax - mx)) + (by - ay) * ((by - my) + (ay - my));
}

/// Twice the area of the triangle of the three projections.
template <class Number>
Number turn(Point a, Point b, Point c, Point m) {
  const Number ay(a.y), by(b.y), cy(c.y);
  return (by - ay) * rise<Number>(a, c, m) - (cy - ay) * rise<Number>(a, b, m);
}

/// The sign of value<Number>(), by intervals if they decide it.
template <class Approximate, class Exact>
int sign_of(const Approximate& approximate, const Exact& exact) {
  {
    const CGAL::Protect_FPU_rounding<true> rounding;
    const auto value = approximate();
    if (value.inf() > 0) return 1;
    if (value.sup() < 0) return -1;
  }
  return CGAL::sign(exact());
}

using Interval = CGAL::Interval_nt<false>;

/// Positive if b is farther from m than a.
int sign_of_rise(Point a, Point b, Point m) {
  return sign_of([&] { return rise<Interval>(a, b, m); }, [&] { return rise<CGAL::Gmpq>(a, b, m); });
}

/// Does the projection of b lie below the line through those of a and c? Precondition: a.y < b.y < c.y.
bool lies_below(const std::vector<Point>& points, const std::array<Index, 3>& v, Point m, Cut cut) {
  const Point a = turned(points[v[0]], cut), b = turned(points[v[1]], cut), c = turned(points[v[2]], cut);
  const int sign = sign_of([&] { return turn<Interval>(a, b, c, m); }, [&] { return turn<CGAL::Gmpq>(a, b, c, m); });
  if (sign != 0) return sign > 0;
  return lexicographically_less(points[v[1]], points[v[0]]) && lexicographically_less(points[v[1]], points[v[2]]);
}

}  // namespace

std::vector<Index> dividing_path(const std::vector<Point>& points, const std::vector<Index>& of, Point m, Cut cut) {
  const Point centre = turned(m, cut);
  std::vector<std::pair<double, Index>> order;
  order.reserve(of.size());
  for (const Index v : of) order.emplace_back(turned(points[v], cut).y, v);
  // Of points at one height, the nearest to the line comes first.
  std::ranges::sort(order, [&](const auto& p, const auto& q) {
    if (p.first != q.first) return p.first < q.first;
    if (p.second == q.second) return false;
    const int sign = sign_of_rise(turned(points[p.second], cut), turned(points[q.second], cut), centre);
    return sign != 0 ? sign > 0 : lexicographically_less(points[p.second], points[q.second]);
  });
  std::vector<Index> path;
  double last = 0;
  for (const auto& [y, v] : order) {
    if (!path.empty() && y == last) continue;
    while (path.size() >= 2 && !lies_below(points, {path[path.size() - 2], path.back(), v}, centre, cut))
      path.pop_back();
    path.push_back(v);
    last = y;
  }
  return path;
}

std::uint64_t settle_ties(LinkedMesh& mesh) {
  std::vector<Side> sides;
  for (Index t = 0; t < mesh.faces.size(); ++t)
    for (int i = 0; i < 3; ++i)
      if (mesh.faces[t].n[i] != no_index && mesh.faces[t].n[i] < t) sides.push_back({t, i});
  const auto breaks_the_rule = [&](Side side, Side twin) {
    const auto [a, b] = ends(mesh, side);
    const Point p = mesh.points[a], q = mesh.points[b];
    const Point c = mesh.corner(side.triangle, side.i), d = mesh.corner(twin.triangle, twin.i);
    const Point smallest = std::min({p, q, c, d}, lexicographically_less);
    return smallest != p && smallest != q &&
           CGAL::side_of_oriented_circle(filtered(c), filtered(p), filtered(q), filtered(d)) ==
               CGAL::ON_ORIENTED_BOUNDARY;
  };
  return flip_where(mesh, std::move(sides), breaks_the_rule).size() / 2;
}

}  // namespace pardel::schemes
