#include "steep_edges.hpp"

#include <algorithm>
#include <tuple>

namespace pardel::engine {
namespace {

struct FieldEdge {
  Index a, b;
  bool steep;
  friend bool operator<(const FieldEdge& e, const FieldEdge& f) { return std::tie(e.a, e.b) < std::tie(f.a, f.b); }
};

/// True if the gradient is longer than `grading`, or nearly so.
bool is_steep(const std::array<Point, 3>& p, const std::array<double, 3>& value, double grading) {
  const double x = p[1].x - p[0].x, y = p[1].y - p[0].y, u = p[2].x - p[0].x, w = p[2].y - p[0].y;
  const double f = value[1] - value[0], g = value[2] - value[0], area = x * w - y * u;
  const double gx = f * w - g * y, gy = g * x - f * u, bound = 0.999 * grading * area;
  return !(gx * gx + gy * gy < bound * bound);
}

}  // namespace

std::vector<SizeSource> steep_edges(std::span<const Point> points, std::span<const std::array<Index, 3>> triangles,
                                    std::span<const double> values, double grading) {
  std::vector<FieldEdge> edges;
  edges.reserve(3 * triangles.size());
  for (const auto& v : triangles) {
    const bool steep =
        is_steep({points[v[0]], points[v[1]], points[v[2]]}, {values[v[0]], values[v[1]], values[v[2]]}, grading);
    for (unsigned i = 0; i < 3; ++i) {
      const Index a = v[i], b = v[(i + 1) % 3];
      edges.push_back({std::min(a, b), std::max(a, b), steep});
    }
  }
  std::ranges::sort(edges, std::less<>());
  std::vector<SizeSource> sources;
  for (std::size_t i = 0, next; i < edges.size(); i = next) {
    bool steep = false;
    for (next = i; next < edges.size() && !(edges[i] < edges[next]); ++next) steep = steep || edges[next].steep;
    const auto [a, b, unused] = edges[i];
    if (steep || next - i == 1) sources.push_back({points[a], points[b], values[a], values[b]});
  }
  return sources;
}

}  // namespace pardel::engine
