#include "drawn_faces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "../parallel/mesher.hpp"
#include "../parallel/repair.hpp"
#include "centroid.hpp"
#include "faces.hpp"

namespace pardel::cli {
namespace {

/// True if the number of edges to the right of p is odd. The differences of doubles are nearly always exact in a long
/// double, and p is not near an edge.
bool crosses_an_odd_number(const std::vector<Point>& ring, Point p) {
  bool is_odd = false;
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
    const Point &a = ring[j], &b = ring[i];
    if ((a.y > p.y) == (b.y > p.y)) continue;
    const long double ax = a.x, ay = a.y, px = p.x, py = p.y;
    const long double area = (b.x - ax) * (py - ay) - (b.y - ay) * (px - ax);
    if ((area > 0) == (b.y > a.y)) is_odd = !is_odd;
  }
  return is_odd;
}

bool covers(const DrawnPolygon& polygon, Point p) {
  bool is_inside = false;
  for (const std::vector<Point>& ring : polygon.rings) is_inside = is_inside != crosses_an_odd_number(ring, p);
  return is_inside;
}

/// Finds the polygons that may cover a point: those whose box reaches into the same vertical strip.
class Strips {
 public:
  explicit Strips(const std::vector<DrawnPolygon>& polygons) : polygons_(polygons) {
    double high = std::numeric_limits<double>::lowest();
    for (const DrawnPolygon& polygon : polygons)
      for (const Point& p : polygon.rings.front()) {
        low_ = std::min(low_, p.x);
        high = std::max(high, p.x);
      }
    strips_.resize(1 + static_cast<std::size_t>(std::sqrt(polygons.size())));
    width_ = high / static_cast<double>(strips_.size()) - low_ / static_cast<double>(strips_.size());
    for (std::size_t k = 0; k < polygons.size(); ++k) {
      const auto [first, last] = std::ranges::minmax(polygons[k].rings.front(), {}, &Point::x);
      for (std::size_t s = strip_of(first.x); s <= strip_of(last.x); ++s) strips_[s].push_back(k);
    }
  }

  /// Calls act(polygon) for the polygons that cover p, in the order of the file.
  template <class Act>
  void each_at(Point p, const Act& act) const {
    for (const std::size_t k : strips_[strip_of(p.x)])
      if (covers(polygons_[k], p)) act(polygons_[k]);
  }

 private:
  [[nodiscard]] std::size_t strip_of(double x) const {
    const double strip = width_ > 0 ? (x - low_) / width_ : 0;
    return static_cast<std::size_t>(std::clamp(strip, 0.0, static_cast<double>(strips_.size() - 1)));
  }

  const std::vector<DrawnPolygon>& polygons_;
  double low_ = std::numeric_limits<double>::max(), width_ = 0;
  std::vector<std::vector<std::size_t>> strips_;
};

/// The convex hull of the points, divided by the segments. No triangles if that is not possible.
Mesh divided_hull(const Pslg& pslg) {
  Result<Meshed> hull = triangulate(pslg, true);
  if (hull) return std::move(hull->mesh);
  const Result<Repaired> repaired = repair(pslg);
  if (!repaired) return {};
  hull = triangulate(repaired->domain.pslg(), true);
  return hull ? std::move(hull->mesh) : Mesh{};
}

}  // namespace

std::vector<DrawnFace> drawn_faces(const DrawnDomain& domain) {
  const Mesh mesh = divided_hull(domain.pslg);
  EdgeSet walls;
  for (const ConstrainedEdge& edge : mesh.constrained_edges)
    if (edge.segment != no_index) walls.edges.push_back({edge.a, edge.b});
  walls.finish();
  const std::vector<Index> face = faces(mesh, walls), best = largest(mesh, face);
  const std::vector<char> is_open = open_faces(mesh, walls, face, best.size());
  const Strips strips(domain.polygons);
  std::vector<DrawnFace> all(best.size());
  for (std::size_t f = 0; f < best.size(); ++f) {
    all[f].seed = centroid(mesh, mesh.triangles[best[f]]);
    all[f].is_open = is_open[f] != 0;
    strips.each_at(all[f].seed, [&](const DrawnPolygon& polygon) { all[f].polygons.push_back(&polygon); });
  }
  return all;
}

}  // namespace pardel::cli
