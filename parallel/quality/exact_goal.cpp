#include "exact_goal.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "../../core/user_test.hpp"
#include "../arithmetic/expansion.hpp"
#include "../triangulation/triangle_shape.hpp"

namespace pardel::engine {
namespace {

using exact::Expansion;

/// The exact difference of two points.
struct Vector {
  Vector(Point from, Point to) : x(exact::two_difference(to.x, from.x)), y(exact::two_difference(to.y, from.y)) {}
  Expansion<2> x, y;
};

auto dot(const Vector& u, const Vector& v) { return u.x * v.x + u.y * v.y; }
auto cross(const Vector& u, const Vector& v) { return u.x * v.y - u.y * v.x; }
Expansion<2> exact_square(double x) { return Expansion<2>(exact::two_product(x, x)); }

/// True if the first number is greater than the second.
template <std::size_t N, std::size_t M>
bool exceeds(const Expansion<N>& first, const Expansion<M>& second) {
  return (first - second).estimate() > 0;
}

bool area_exceeds(Point a, Point b, Point c, double bound) {
  if (!(bound < INFINITY)) return false;
  return exceeds(cross({a, b}, {a, c}), Expansion<2>(exact::Two{2 * bound, 0}));
}

bool is_longer(Point a, Point b, double bound) {
  const Vector side(a, b);
  return bound < INFINITY && exceeds(dot(side, side), exact_square(bound));
}

/// True if the cosine of the angle at `corner` is greater than `cosine`, which is not negative.
bool cosine_exceeds(Point corner, Point p, Point q, double cosine) {
  const Vector u(corner, p), v(corner, q);
  const auto product = dot(u, v);
  return product.estimate() > 0 && exceeds(product * product, dot(u, u) * exact_square(cosine) * dot(v, v));
}

}  // namespace

ExactGoal::ExactGoal(const Goal& goal, std::function<double(Point)> area_cap)
    : max_area_(goal.max_area),
      max_edge_(goal.max_edge),
      cosine_(goal.min_angle_deg > 0 ? std::cos(goal.min_angle_deg * std::numbers::pi / 180) : 1),
      size_(goal.size),
      area_cap_(std::move(area_cap)),
      user_test_(goal.user_test) {}

bool ExactGoal::keeps_angles(Point a, Point b, Point c) const {
  return cosine_ >= 1 ||
         !(cosine_exceeds(a, b, c, cosine_) || cosine_exceeds(b, c, a, cosine_) || cosine_exceeds(c, a, b, cosine_));
}

bool ExactGoal::keeps_sizes(Point a, Point b, Point c) const {
  const Point centroid = centroid_of(a, b, c);
  const double edge = size_ ? std::min(max_edge_, size_(centroid)) : max_edge_;
  const double area = area_cap_ ? std::min(max_area_, area_cap_(centroid)) : max_area_;
  if (area_exceeds(a, b, c, area) || is_longer(a, b, edge) || is_longer(b, c, edge) || is_longer(c, a, edge))
    return false;
  return !user_test_ || !must_be_refined(user_test_, a, b, c);
}

}  // namespace pardel::engine
