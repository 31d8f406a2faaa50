#include "faces.hpp"

#include <algorithm>
#include <numeric>

namespace pardel::generators {
namespace {

/// The pairs of points with no point on their right and none between them.
std::vector<Segment> sides_of_hull(const std::vector<LatticePoint>& points) {
  std::vector<Segment> sides;
  for (Index a = 0; a < points.size(); ++a)
    for (Index b = 0; b < points.size(); ++b) {
      const bool is_side = a != b && std::ranges::none_of(points, [&](LatticePoint p) {
                             return turn(points[a], points[b], p) < 0 || lies_inside(p, points[a], points[b]);
                           });
      if (is_side) sides.push_back({a, b});
    }
  return sides;
}

/// Compares directions by their angle from the positive x-axis, counter-clockwise.
bool comes_before(LatticePoint u, LatticePoint v) {
  const auto in_lower_half = [](LatticePoint w) { return w.y < 0 || (w.y == 0 && w.x < 0); };
  if (in_lower_half(u) != in_lower_half(v)) return in_lower_half(v);
  return cross(u, v) > 0;
}

}  // namespace

LatticeFaces::LatticeFaces(const std::vector<LatticePoint>& points, const std::vector<Segment>& segments) {
  for (const LatticePoint p : points) quarters_.push_back(4 * p);
  for (const Segment& s : segments.empty() ? sides_of_hull(points) : segments) {
    ends_.push_back({s.a, s.b});
    ends_.push_back({s.b, s.a});
  }
  link();
  trace_contours();
  is_domain_.assign(count_, true);
  is_domain_[exterior] = false;
}

LatticeFaces::LatticeFaces(const LatticeDomain& domain) : LatticeFaces(domain.points, domain.segments) {
  for (const LatticePoint hole : domain.holes) make_hole(containing(hole));
}

void LatticeFaces::link() {
  by_origin_.resize(ends_.size());
  std::iota(by_origin_.begin(), by_origin_.end(), Index{0});
  std::ranges::sort(by_origin_, [&](Index g, Index h) {
    const auto [a, b] = ends_[g];
    const auto [c, d] = ends_[h];
    return a != c ? a < c : comes_before(at(b) - at(a), at(d) - at(c));
  });
  first_.assign(quarters_.size() + 1, 0);
  for (const HalfEdge e : ends_) ++first_[e.a + 1];
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
}

void LatticeFaces::trace_contours() {
  contour_of_.assign(ends_.size(), no_index);
  std::vector<Index> lowest;  // per contour: the lowest of its leftmost points
  for (Index start = 0; start < ends_.size(); ++start) {
    if (contour_of_[start] != no_index) continue;
    const auto contour = static_cast<Index>(lowest.size());
    lowest.push_back(ends_[start].a);
    std::int64_t twice_area = 0;
    Index h = start;
    do {
      contour_of_[h] = contour;
      const auto [a, b] = ends_[h];
      twice_area += cross(at(a) - at(ends_[start].a), at(b) - at(ends_[start].a));
      if (at(b) < at(lowest.back())) lowest.back() = b;
      // Turn left as sharply as possible: the next half-edge clockwise from the twin.
      const std::span<const Index> star = around(b);
      const auto back = std::ranges::find(star, twin(h));
      h = back == star.begin() ? star.back() : *(back - 1);
    } while (h != start);
    is_outer_.push_back(twice_area > 0);
    face_of_.push_back(twice_area > 0 ? count_++ : no_index);
  }
  // The face around a component is the face above the half-edge directly below the component's leftmost point. The
  // contour of that half-edge has a leftmost point further left or further down, so the search ends.
  for (std::size_t contour = 0; contour < lowest.size(); ++contour) {
    std::size_t around = contour;
    while (face_of_[around] == no_index) {
      const Index below = directly_below(at(lowest[around]));
      if (below == no_index) {
        face_of_[around] = exterior;
      } else {
        around = contour_of_[below];
      }
    }
    face_of_[contour] = face_of_[around];
  }
}

bool LatticeFaces::is_above(Index half_edge, Index other) const {
  const LatticePoint a = at(ends_[half_edge].a), b = at(ends_[half_edge].b);
  const LatticePoint c = at(ends_[other].a), d = at(ends_[other].b);
  if (a.x >= c.x) {
    const std::int64_t side = turn(c, d, a);
    return (side != 0 ? side : turn(c, d, b)) > 0;
  }
  const std::int64_t side = turn(a, b, c);
  return (side != 0 ? side : turn(a, b, d)) < 0;
}

Index LatticeFaces::directly_below(LatticePoint place) const {
  Index highest = no_index;
  for (Index h = 0; h < ends_.size(); ++h) {
    const LatticePoint a = at(ends_[h].a), b = at(ends_[h].b);
    if (a.x > place.x || b.x <= place.x || turn(a, b, place) <= 0) continue;
    if (highest == no_index || is_above(h, highest)) highest = h;
  }
  return highest;
}

bool LatticeFaces::on_a_segment(LatticePoint seed) const {
  return std::ranges::any_of(
      ends_, [&](HalfEdge e) { return turn(at(e.a), at(e.b), seed) == 0 && dot(at(e.a) - seed, at(e.b) - seed) <= 0; });
}

Index LatticeFaces::containing(LatticePoint seed) const {
  const Index below = directly_below(seed);
  return below == no_index ? exterior : left_of(below);
}

LatticePoint LatticeFaces::seed_left_of(Index half_edge) const {
  const LatticePoint a = at(ends_[half_edge].a), b = at(ends_[half_edge].b);
  const auto suits = [&](LatticePoint c) {
    const bool holds_a_point = std::ranges::any_of(quarters_, [&](LatticePoint p) {
      return p != a && p != b && p != c && turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0;
    });
    return !holds_a_point && std::ranges::none_of(ends_, [&](HalfEdge e) {
      return cross_each_other(at(e.a), at(e.b), b, c) || cross_each_other(at(e.a), at(e.b), c, a);
    });
  };
  const auto c = std::ranges::find_if(quarters_, [&](LatticePoint p) { return turn(a, b, p) > 0 && suits(p); });
  // c exists, because every triangulation of the face has a triangle here. The coordinates are multiples of 4.
  const LatticePoint sum = a + a + b + *c;
  return {sum.x / 4, sum.y / 4};
}

Index LatticeFaces::domain_faces() const {
  return static_cast<Index>(std::ranges::count(is_domain_, static_cast<char>(true)));
}

}  // namespace pardel::generators
