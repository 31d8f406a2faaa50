#include "causes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "units.hpp"

namespace pardel::fuzz {

using ref::Corners;
using ref::ExactPoint;
using ref::Number;

namespace {

// What rounding may change, as the checker promises. The numbers are repeated here, so that a change of the checker's
// numbers is a difference.
const Number shell_share = 1e-9, shell_units = 8;    // of distances from the apex
const Number across_share = 1e-8, across_units = 8;  // of the least tangent, and of coordinates
constexpr double cosine_of_60_degrees = 0.5, cosine_of_one_degree = 0.9998477;

Number dot(const ExactPoint& at, const ExactPoint& p, const ExactPoint& q) { return (p - at) * (q - at); }
Number squared(const Number& x) { return x * x; }

/// The double that stands for a bound on angles.
double cosine_of(double min_angle_deg) {
  return min_angle_deg > 0 ? std::cos(std::min(min_angle_deg, 90.0) * std::numbers::pi / 180) : 1;
}

/// Is the cosine of the angle at a point between p and q greater than the bound, a number between 0 and 1?
bool is_sharper(const ExactPoint& at, const ExactPoint& p, const ExactPoint& q, double cosine) {
  const Number product = dot(at, p, q);
  return product > 0 &&
         squared(product) > squared(Number(cosine)) * CGAL::squared_distance(at, p) * CGAL::squared_distance(at, q);
}

/// Do p and q have the same distance from the apex, up to a share and to `spare`? That is: not
/// (1 - share) |far| > |near| + spare, which is squared twice.
bool are_on_one_shell(const ExactPoint& apex, const ExactPoint& p, const ExactPoint& q, const Number& spare) {
  const bool p_is_nearer = CGAL::compare_distance_to_point(apex, p, q) == CGAL::SMALLER;
  const Number near = CGAL::squared_distance(apex, p_is_nearer ? p : q);
  const Number far = CGAL::squared_distance(apex, p_is_nearer ? q : p);
  const Number rest = squared(1 - shell_share) * far - near - squared(spare);
  return rest <= 0 || squared(rest) <= 4 * squared(spare) * near;
}

/// The triangles of a mesh, and its chains.
class Causes {
 public:
  Causes(const ExactMesh& mesh, const Chains& chains) : mesh_(mesh), chains_(chains) {}

  /// The apexes of the causes of the angle at `corner`, between p and q.
  [[nodiscard]] std::set<Index> of_angle(Index corner, Index p, Index q) const {
    std::set<Index> apexes;
    for (const Chain& of_p : chains_)
      for (const Chain& of_q : chains_)
        for (const Index apex : {of_p.wall->a, of_p.wall->b}) {
          if (&of_p == &of_q || !of_q.ends_at(apex)) continue;
          const bool is_cause = is_between(corner, p, q, apex, of_p, of_q) || is_across(p, q, apex, of_p, of_q);
          if (is_cause && !is_below_least(corner, p, q, apex, of_p, of_q)) apexes.insert(apex);
        }
    return apexes;
  }

 private:
  [[nodiscard]] Point at(Index v) const { return mesh_.given.points[v]; }
  [[nodiscard]] const ExactPoint& exact_at(Index v) const { return mesh_.plain.points[v]; }
  [[nodiscard]] const ExactPoint& far_end(const Chain& chain, Index apex) const {
    return exact_at(chain.wall->a == apex ? chain.wall->b : chain.wall->a);
  }
  [[nodiscard]] bool meet_below(double cosine, Index apex, const Chain& s, const Chain& r) const {
    return is_sharper(exact_at(apex), far_end(s, apex), far_end(r, apex), cosine);
  }

  /// Nestled: do the two chains begin at the corner with the edges to p and q?
  [[nodiscard]] bool is_between(Index corner, Index p, Index q, Index apex, const Chain& of_p,
                                const Chain& of_q) const {
    return corner == apex && of_p.next_to(apex) == p && of_q.next_to(apex) == q &&
           meet_below(cosine_of_60_degrees, apex, of_p, of_q);
  }

  /// Seditious: do p and q lie on one shell, inside of the two chains? One may be the end of its chain if these meet at
  /// less than one degree.
  [[nodiscard]] bool is_across(Index p, Index q, Index apex, const Chain& of_p, const Chain& of_q) const {
    if (!of_p.passes(p) || !of_q.passes(q) || p == apex || q == apex) return false;
    const int ends = int(of_p.ends_at(p)) + int(of_q.ends_at(q));
    if (ends == 2) return false;
    return meet_below(ends == 0 ? cosine_of_60_degrees : cosine_of_one_degree, apex, of_p, of_q) &&
           are_on_one_shell(exact_at(apex), exact_at(p), exact_at(q), shell_units * unit_at(at(apex), at(p), at(q)));
  }

  /// Is the tangent of the angle at `corner` less than sin θ / (2 - cos θ), where θ is the angle of the two walls, even
  /// if p and q are moved by some units? With C and D for the cross and the dot product of the walls, and L for the
  /// product of their lengths, the least tangent is C / (2 L - D). The comparison is multiplied by (2 L - D), and then
  /// squared, because L is a root.
  [[nodiscard]] bool is_below_least(Index corner, Index p, Index q, Index apex, const Chain& of_p,
                                    const Chain& of_q) const {
    const ExactPoint &centre = exact_at(apex), &far_p = far_end(of_p, apex), &far_q = far_end(of_q, apex);
    const Number c = CGAL::abs(cross(centre, far_p, far_q)), d = dot(centre, far_p, far_q);
    const Number squared_l = CGAL::squared_distance(centre, far_p) * CGAL::squared_distance(centre, far_q);
    const ExactPoint& from = exact_at(corner);
    const Number moved = across_units * unit_at(at(apex), at(p), at(q)) *
                         (sum_of_coordinates(exact_at(p) - from) + sum_of_coordinates(exact_at(q) - from));
    const Number height = CGAL::abs(cross(from, exact_at(p), exact_at(q))) + moved;
    const Number right = (1 - across_share) * c * dot(from, exact_at(p), exact_at(q)) + height * d;
    return right > 0 && 4 * squared(height) * squared_l < squared(right);
  }
  [[nodiscard]] static Number sum_of_coordinates(const ref::Kernel::Vector_2& v) {
    return CGAL::abs(v.x()) + CGAL::abs(v.y());
  }

  const ExactMesh& mesh_;
  const Chains& chains_;
};

/// The corners of a triangle with angles below the bound.
std::vector<int> small_corners(const ExactMesh& mesh, const Corners& c, double cosine) {
  const auto& p = mesh.plain.points;
  std::vector<int> small;
  for (int i = 0; i < 3; ++i)
    if (is_sharper(p[c[i]], p[c[(i + 1) % 3]], p[c[(i + 2) % 3]], cosine)) small.push_back(i);
  return small;
}

}  // namespace

SmallAngles small_angles(const ExactMesh& mesh, const Chains& chains, double min_angle_deg) {
  SmallAngles found;
  const Causes causes(mesh, chains);
  for (Index t = 0; t < mesh.plain.triangles.size(); ++t) {
    const Corners& c = mesh.plain.triangles[t];
    const auto& p = mesh.plain.points;
    std::map<Number, std::set<Index>> apexes;  // by the length of the opposite edge: of the smallest angle first
    bool has_causes = true;
    for (const int i : small_corners(mesh, c, cosine_of(min_angle_deg))) {
      const Index q = c[(i + 1) % 3], r = c[(i + 2) % 3];
      const std::set<Index> of_angle = causes.of_angle(c[i], q, r);
      has_causes = has_causes && !of_angle.empty();
      apexes[CGAL::squared_distance(p[q], p[r])].insert(of_angle.begin(), of_angle.end());
    }
    if (!has_causes)
      found.without_cause.insert(t);
    else if (!apexes.empty())
      found.apexes.emplace(t, apexes.begin()->second);
  }
  return found;
}

Triangles with_small_angles(const ExactMesh& mesh, double min_angle_deg) {
  return triangles_that(
      mesh, [&](Index, const Corners& c) { return !small_corners(mesh, c, cosine_of(min_angle_deg)).empty(); });
}

}  // namespace pardel::fuzz
