// Checks the bounds of the goal. All comparisons are exact. Two bounds are rounded before they are compared: the cosine
// of the smallest angle, and the size at a centroid, because the centroid is rounded.
#include <algorithm>
#include <cmath>
#include <optional>

#include "../../../core/user_test.hpp"
#include "../arithmetic/exact.hpp"
#include "../arithmetic/measure.hpp"
#include "../arithmetic/text.hpp"
#include "../model/wanted_size.hpp"
#include "../tolerances.hpp"
#include "justified.hpp"
#include "stages.hpp"

namespace pardel::checker {

ScanBounds bounds_of(const Subject& subject) {
  return {.cosine = angle_cosine_bound(subject.goal.min_angle_deg),
          .area = subject.goal.max_area,
          .edge = subject.goal.max_edge,
          .circumradius = std::isfinite(subject.options.max_circumradius) ? subject.options.max_circumradius : 0};
}

namespace {

class GoalCheck {
 public:
  GoalCheck(const Subject& subject, const Domain& domain, const Adjacency& adjacency, const Chains& chains,
            const InputVertices& inputs, std::span<const Index> faces, const WantedSize& wanted, bool trust_orientation)
      : subject_(subject),
        domain_(domain),
        adjacency_(adjacency),
        chains_(chains),
        inputs_(inputs),
        faces_(faces),
        wanted_(wanted),
        trust_orientation_(trust_orientation),
        cosine_bound_(angle_cosine_bound(subject.goal.min_angle_deg)) {}

  /// The tests that the scan left open.
  void check_open(Index t, Findings& found, std::vector<Justified>& justified) const {
    const std::array<Point, 3> p = corners(t);
    if (!is_oriented(p)) return;
    check_angles(t, p, found, justified);
    check_area(t, p, found);
    check_edges(t, p, found);
    check_circumradius(t, p, found);
  }

  /// True if check_places() has something to do: bounds that depend on the place of a triangle, and that the scan does
  /// not know.
  [[nodiscard]] bool has_places() const { return has_region_caps() || has_sizes(); }

  void check_user_test(Index t, Findings& found) const {
    const std::array<Point, 3> p = corners(t);
    if (!is_oriented(p)) return;
    const std::optional<bool> fails = fails_user_test(p);
    if (fails == false || !found.admit(ViolationKind::user_test)) return;
    found.keep({ViolationKind::user_test,
                ids(t),
                {p.begin(), p.end()},
                "triangle " + triangle_number(names().triangle(t)) + " has area " +
                    exactly::area_text(p[0], p[1], p[2]) +
                    (fails ? ", and must be refined, as the test of the user says"
                           : ", and the test of the user threw an exception")});
  }

  void check_places(Index t, Findings& found) const {
    const std::array<Point, 3> p = corners(t);
    if (!is_oriented(p)) return;
    const filter::Shape shape(p[0], p[1], p[2]);
    if (has_region_caps()) check_region_area(t, p, shape, found);
    if (has_sizes()) check_size(t, p, shape, found);
  }

 private:
  [[nodiscard]] std::array<Point, 3> corners(Index t) const {
    const Triangle& triangle = adjacency_.triangles()[t];
    return {subject_.corner(triangle, 0), subject_.corner(triangle, 1), subject_.corner(triangle, 2)};
  }
  [[nodiscard]] bool is_oriented(const std::array<Point, 3>& p) const {
    return trust_orientation_ || exactly::orientation(p[0], p[1], p[2]) > 0;
  }
  [[nodiscard]] bool has_region_caps() const { return subject_.goal.region_caps && !faces_.empty(); }
  [[nodiscard]] bool has_sizes() const { return subject_.goal.size || !wanted_.empty(); }

  void check_angles(Index t, const std::array<Point, 3>& p, Findings& found, std::vector<Justified>& justified) const {
    if (cosine_bound_ >= 1) return;
    const AngleVerdict verdict = judge_angles(t, cosine_bound_, subject_, domain_, adjacency_, chains_, inputs_);
    if (verdict.cause) {
      justified.push_back(*verdict.cause);
      justified.back().triangle = names().triangle(t);
    }
    const int sharp = verdict.unjustified;
    if (sharp < 0 || !found.admit(ViolationKind::small_angle)) return;
    const Point a = p[next(sharp)], b = p[previous(sharp)];
    found.keep({ViolationKind::small_angle,
                ids(t),
                {p[sharp], a, b},
                "triangle " + triangle_number(names().triangle(t)) + " has an angle of " +
                    to_text(angle_deg(p[sharp], a, b)) + " degrees < " + to_text(subject_.goal.min_angle_deg) +
                    ": its squared cosine " + exactly::squared_cosine_text(p[sharp], a, b) + " exceeds the square of " +
                    to_text(cosine_bound_) + ", and no small input angle justifies it"});
  }

  void check_area(Index t, const std::array<Point, 3>& p, Findings& found) const {
    const double cap = subject_.goal.max_area;
    if (std::isfinite(cap) && exactly::area_exceeds(p[0], p[1], p[2], cap) && found.admit(ViolationKind::large_area))
      found.keep({ViolationKind::large_area, ids(t), {p.begin(), p.end()}, area_description(t, p, cap)});
  }

  void check_region_area(Index t, const std::array<Point, 3>& p, const filter::Shape& shape, Findings& found) const {
    for (const auto& [face, region] : domain_.regions_in(faces_[t])) {
      const double cap = subject_.pslg.regions[region].max_area;
      if (!std::isfinite(cap) || (shape.is_tame() && filter::is_not_larger(shape, cap))) continue;
      if (exactly::area_exceeds(p[0], p[1], p[2], cap) && found.admit(ViolationKind::region_area))
        found.keep({ViolationKind::region_area,
                    ids(t),
                    {p.begin(), p.end()},
                    area_description(t, p, cap) + ", the cap of region " + domain_number(region)});
    }
  }

  [[nodiscard]] Witness area_description(Index t, const std::array<Point, 3>& p, double cap) const {
    return "triangle " + triangle_number(names().triangle(t)) + " has area " + exactly::area_text(p[0], p[1], p[2]) +
           " > " + to_text(cap);
  }

  void check_edges(Index t, const std::array<Point, 3>& p, Findings& found) const {
    const double cap = subject_.goal.max_edge;
    if (!std::isfinite(cap)) return;
    for (int k = 0; k < 3; ++k) {
      const Index across = adjacency_.triangles()[t].n[k];
      if (across < t || names().has_earlier_neighbour(t, k)) continue;  // the other triangle checks this edge
      const Point a = p[next(k)], b = p[previous(k)];
      if (!exactly::length_exceeds(a, b, std::max(cap, 0.0)) || !found.admit(ViolationKind::long_edge)) continue;
      const Triangle& triangle = adjacency_.triangles()[t];
      found.keep({ViolationKind::long_edge,
                  {names().vertex(triangle.v[next(k)]), names().vertex(triangle.v[previous(k)]), names().triangle(t)},
                  {a, b},
                  "edge " + names().edge_text(triangle.v[next(k)], triangle.v[previous(k)]) + " of triangle " +
                      triangle_number(names().triangle(t)) + " has squared length " +
                      exactly::squared_length_text(a, b) + ", more than the square of " + to_text(cap)});
    }
  }

  /// The centroid is rounded; the edges are compared exactly with the size there.
  void check_size(Index t, const std::array<Point, 3>& p, const filter::Shape& shape, Findings& found) const {
    const Point centroid{(p[0].x + p[1].x + p[2].x) / 3, (p[0].y + p[1].y + p[2].y) / 3};
    std::optional<double> size = std::numeric_limits<double>::infinity();
    if (subject_.goal.size) size = size_at(centroid);
    if (size && !wanted_.empty())
      size = std::min(*size, (1 + size_tolerance) * wanted_.at(centroid) + size_units * unit_at(p[0], p[1], p[2]));
    if (size && allows_edges(*size, p, shape)) return;
    const double longest = std::max({distance(p[0], p[1]), distance(p[1], p[2]), distance(p[2], p[0])});
    if (found.admit(ViolationKind::size_exceeded))
      found.keep({ViolationKind::size_exceeded,
                  ids(t),
                  {p.begin(), p.end()},
                  "triangle " + triangle_number(names().triangle(t)) + " has an edge of length " + to_text(longest) +
                      (size ? " > " + to_text(*size) + ", the size at its centroid"
                            : ", and the size function threw an exception at its centroid")});
  }

  /// True if no edge is longer than this size. A size that is not positive allows nothing.
  static bool allows_edges(double size, const std::array<Point, 3>& p, const filter::Shape& shape) {
    if (!(size > 0)) return false;
    if (shape.is_tame() && filter::is_not_longer(shape, size)) return true;
    return std::isinf(size) ||
           !(exactly::length_exceeds(p[0], p[1], size) || exactly::length_exceeds(p[1], p[2], size) ||
             exactly::length_exceeds(p[2], p[0], size));
  }

  /// Nothing if the function throws. No exception may leave the parallel loop of the checker.
  [[nodiscard]] std::optional<double> size_at(Point p) const {
    try {
      return subject_.goal.size(p);
    } catch (...) {
      return std::nullopt;
    }
  }

  /// Nothing if the test throws.
  [[nodiscard]] std::optional<bool> fails_user_test(const std::array<Point, 3>& p) const {
    try {
      return must_be_refined(subject_.goal.user_test, p[0], p[1], p[2]);
    } catch (...) {
      return std::nullopt;
    }
  }

  void check_circumradius(Index t, const std::array<Point, 3>& p, Findings& found) const {
    const double bound = subject_.options.max_circumradius;
    if (!(bound > 0) || !std::isfinite(bound) || !exactly::circumradius_exceeds(p[0], p[1], p[2], bound)) return;
    if (found.admit(ViolationKind::large_circumradius))
      found.keep({ViolationKind::large_circumradius,
                  ids(t),
                  {p.begin(), p.end()},
                  "triangle " + triangle_number(names().triangle(t)) + " has squared circumradius " +
                      exactly::squared_circumradius_text(p[0], p[1], p[2]) + ", more than the square of " +
                      to_text(bound)});
  }

  [[nodiscard]] std::vector<Index> ids(Index t) const {
    return names().triangle_and_corners(t, adjacency_.triangles()[t]);
  }
  [[nodiscard]] const Numbering& names() const { return subject_.names; }

  const Subject& subject_;
  const Domain& domain_;
  const Adjacency& adjacency_;
  const Chains& chains_;
  const InputVertices& inputs_;
  std::span<const Index> faces_;
  const WantedSize& wanted_;
  bool trust_orientation_;
  double cosine_bound_;
};

}  // namespace

void check_goal(const Subject& subject, const Domain& domain, const Adjacency& adjacency, const Chains& chains,
                const InputVertices& inputs, std::span<const Index> faces, const Scan& scan, Findings& found,
                std::vector<Justified>& justified) {
  check_goal(subject, domain, adjacency, chains, inputs, faces, WantedSize(subject.pslg, subject.goal, found.stop()),
             scan, found, justified);
}

void check_goal(const Subject& subject, const Domain& domain, const Adjacency& adjacency, const Chains& chains,
                const InputVertices& inputs, std::span<const Index> faces, const WantedSize& wanted, const Scan& scan,
                Findings& found, std::vector<Justified>& justified) {
  const bool trust_orientation = found.count(ViolationKind::degenerate_triangle) == 0;
  const GoalCheck goal(subject, domain, adjacency, chains, inputs, faces, wanted, trust_orientation);
  // The shares have consecutive triangles and are in order, so the joined list is ascending.
  std::vector<std::vector<Justified>> parts(share_count());
  const std::vector<Index> open = scan.open_for(Test::angle, Test::area, Test::edge, Test::circumradius);
  check_each(open.size(), found,
             [&](std::size_t i, Findings& mine, std::size_t share) { goal.check_open(open[i], mine, parts[share]); });
  for (const auto& part : parts) justified.insert(justified.end(), part.begin(), part.end());
  const std::size_t triangles = adjacency.triangles().size();
  if (goal.has_places())
    check_each(triangles, found,
               [&](std::size_t t, Findings& mine) { goal.check_places(static_cast<Index>(t), mine); });
  if (!subject.goal.user_test) return;
  if (subject.goal.user_test_is_free_of_state)
    return check_each(triangles, found,
                      [&](std::size_t t, Findings& mine) { goal.check_user_test(static_cast<Index>(t), mine); });
  for (std::size_t t = 0; t < triangles; ++t) {
    if (found.stop() != nullptr) found.stop()->ask();
    goal.check_user_test(static_cast<Index>(t), found);
  }
}

}  // namespace pardel::checker
