#include "scan.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>

namespace pardel::checker {
namespace {

constexpr std::uint8_t bit(Test test, bool open) { return open ? static_cast<std::uint8_t>(test) : std::uint8_t{0}; }

bool are_finite(std::span<const Point> points, StopSignal* stop) {
  std::vector<char> finite(share_count(), 1);
  for_each_run(points.size(), stop, [&](std::size_t first, std::size_t last, std::size_t share) {
    double zero = 0;  // the product with an infinite number or with NaN is NaN
    for (std::size_t i = first; i < last; ++i) zero += points[i].x * 0 + points[i].y * 0;
    if (!(zero == 0)) finite[share] = 0;
  });
  return std::all_of(finite.begin(), finite.end(), [](char each) { return each != 0; });
}

/// The part of the result that one share makes.
struct Part {
  bool corners_usable = true, neighbours_in_range = true, neighbours_reciprocal = true;
  std::uint64_t rays = 0, to_later = 0, to_earlier = 0;  ///< the last two: links to triangles with greater/less numbers
  std::vector<OpenTriangle> open;
  std::vector<BoundaryEdge> boundary;
  Measures measures;
};

class TriangleScan {
 public:
  TriangleScan(std::span<const Point> points, std::span<const Triangle> triangles, const ScanBounds& bounds,
               std::span<Index> start)
      : points_(points),
        triangles_(triangles),
        start_(start),
        bounds_(bounds),
        cotangent_(bounds.cosine < 1 ? filter::cotangent_below(bounds.cosine) : 0) {}

  void add(Index t, Part& part) const {
    prefetch(t);
    const auto& [v, n] = triangles_[t];
    if (std::max({v[0], v[1], v[2]}) >= points_.size() || v[0] == v[1] || v[1] == v[2] || v[2] == v[0]) {
      part.corners_usable = false;
      return;
    }
    const std::array<Point, 3> p{points_[v[0]], points_[v[1]], points_[v[2]]};
    const filter::Shape shape(p[0], p[1], p[2]);
    part.measures.add(t, p, shape);
    for (int k = 0; k < 3; ++k) {
      // Threads may write different triangles. Any of them will do.
      std::atomic_ref<Index>(start_[v[k]]).store(t, std::memory_order_relaxed);
      if (has_ray_at(p[k], p[next(k)], p[previous(k)])) ++part.rays;
    }
    const bool tame = shape.is_tame();
    std::uint8_t tests = tests_of(shape, tame);
    bool delaunay = true;
    for (int k = 0; k < 3; ++k) {
      if (n[k] == no_index) {
        if (bounds_.boundary) part.boundary.push_back({v[next(k)], v[previous(k)], {t, k}});
        continue;
      }
      if (n[k] >= triangles_.size()) {
        part.neighbours_in_range = false;
      } else if (n[k] > t) {
        ++part.to_later;
        delaunay = add_pair(t, k, p, shape, part) && delaunay;
      } else if (n[k] < t) {
        ++part.to_earlier;
      } else {
        part.neighbours_reciprocal = false;
      }
    }
    tests |= bit(Test::delaunay, !(tame && delaunay));
    if (tests != 0) part.open.push_back({t, tests});
  }

 private:
  /// Asks for the memory that triangles need that follow soon. Their neighbours and points may be anywhere.
  void prefetch(Index t) const {
    constexpr std::size_t soon = 24;
    if (triangles_.size() - t <= soon) return;
    for (const Index n : triangles_[t + soon].n)
      if (n < triangles_.size()) __builtin_prefetch(&triangles_[n]);
  }

  [[nodiscard]] std::uint8_t tests_of(const filter::Shape& shape, bool tame) const {
    std::uint8_t tests = bit(Test::orientation, !tame);
    if (bounds_.cosine < 1) tests |= bit(Test::angle, !(tame && filter::has_no_angle_below(shape, cotangent_)));
    if (std::isfinite(bounds_.area)) tests |= bit(Test::area, !(tame && filter::is_not_larger(shape, bounds_.area)));
    if (std::isfinite(bounds_.edge)) tests |= bit(Test::edge, !(tame && filter::is_not_longer(shape, bounds_.edge)));
    if (bounds_.circumradius > 0)
      tests |= bit(Test::circumradius, !(tame && filter::has_no_larger_circumradius(shape, bounds_.circumradius)));
    return tests;
  }

  /// The test of the triangle and its neighbour across side k. False if the Delaunay property remains open.
  bool add_pair(Index t, int k, const std::array<Point, 3>& p, const filter::Shape& shape, Part& part) const {
    const auto& v = triangles_[t].v;
    const Index from = v[next(k)], to = v[previous(k)];
    const auto& [w, m] = triangles_[triangles_[t].n[k]];
    // The corner of the neighbour that is opposite the edge from `to` to `from`, if it has this edge.
    const int j = w[0] == to ? 2 : w[1] == to ? 0 : 1;
    if (w[next(j)] != to || w[previous(j)] != from || m[j] != t || w[j] >= points_.size()) {
      part.neighbours_reciprocal = false;
      return false;
    }
    return filter::is_outside_circle(shape, k, p[next(k)], p[previous(k)], points_[w[j]]);
  }

  std::span<const Point> points_;
  std::span<const Triangle> triangles_;
  std::span<Index> start_;
  ScanBounds bounds_;
  double cotangent_;
};

}  // namespace

Scan scan(std::span<const Point> points, std::span<const Triangle> triangles, const ScanBounds& bounds,
          StopSignal* stop) {
  Scan result;
  result.points_finite = are_finite(points, stop);
  if (!result.points_finite) return result;
  result.start.resize(points.size(), no_index);
  const TriangleScan scan(points, triangles, bounds, result.start.span());
  std::vector<Part> parts(share_count());
  for_each_run(triangles.size(), stop, [&](std::size_t first, std::size_t last, std::size_t share) {
    for (std::size_t t = first; t < last; ++t) scan.add(static_cast<Index>(t), parts[share]);
  });
  std::uint64_t to_later = 0, to_earlier = 0;
  for (const Part& part : parts) {
    result.corners_usable &= part.corners_usable;
    result.neighbours_in_range &= part.neighbours_in_range;
    result.neighbours_reciprocal &= part.neighbours_reciprocal;
    result.rays += part.rays;
    to_later += part.to_later;
    to_earlier += part.to_earlier;
    result.open.insert(result.open.end(), part.open.begin(), part.open.end());
    result.boundary.insert(result.boundary.end(), part.boundary.begin(), part.boundary.end());
    result.measures.append(part.measures);
  }
  // Each link to a later triangle was tested, and its partner is a link to an earlier triangle. Different links have
  // different partners. So if the numbers are equal, each link to an earlier triangle is a partner.
  const bool links_are_pairs = to_later == to_earlier;
  result.neighbours_reciprocal &= result.neighbours_in_range && links_are_pairs;
  sort_boundary(result.boundary, stop);
  return result;
}

}  // namespace pardel::checker
