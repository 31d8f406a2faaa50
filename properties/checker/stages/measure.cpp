#include "../arithmetic/measure.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include "../arithmetic/exact_sum.hpp"
#include "stages.hpp"

namespace pardel::checker {
namespace {

constexpr std::size_t histogram_bins = 18;

/// Extremes over a range of triangles. If several triangles attain a value, the first is kept.
struct Measures {
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  Extreme min_angle{infinity, no_index, {}}, min_edge{infinity, no_index, {}};
  Extreme max_angle{-infinity, no_index, {}}, max_area{-infinity, no_index, {}}, max_edge{-infinity, no_index, {}};
  Extreme max_circumradius{-infinity, no_index, {}}, max_ratio{-infinity, no_index, {}};
  std::array<std::uint64_t, histogram_bins> histogram{};
  ExactSum doubled_area_sum;

  void add(Index t, const std::array<Point, 3>& p) {
    std::array<double, 3> length;
    for (int k = 0; k < 3; ++k) length[k] = distance(p[next(k)], p[previous(k)]);
    const double area2 = doubled_area(p[0], p[1], p[2]);
    for (int k = 0; k < 3; ++k) {
      const double angle = angle_deg(p[k], p[next(k)], p[previous(k)]);
      ++histogram[std::min(static_cast<std::size_t>(angle / 10), histogram_bins - 1)];
      lower(min_angle, angle, t, p[k]);
      raise(max_angle, angle, t, p[k]);
      const Point middle = midpoint(p[next(k)], p[previous(k)]);
      lower(min_edge, length[k], t, middle);
      raise(max_edge, length[k], t, middle);
      doubled_area_sum.add_cross(p[k], p[next(k)]);
    }
    const Point centroid{p[0].x / 3 + p[1].x / 3 + p[2].x / 3, p[0].y / 3 + p[1].y / 3 + p[2].y / 3};
    raise(max_area, area2 / 2, t, centroid);
    const double radius = length[0] / (2 * area2) * length[1] * length[2];
    raise(max_circumradius, radius, t, centroid);
    raise(max_ratio, radius / *std::min_element(length.begin(), length.end()), t, centroid);
  }

  /// Adds the measures of a later range.
  void append(const Measures& later) {
    for (const auto extreme : {&Measures::min_angle, &Measures::min_edge})
      if ((later.*extreme).value < (this->*extreme).value) this->*extreme = later.*extreme;
    for (const auto extreme : {&Measures::max_angle, &Measures::max_area, &Measures::max_edge,
                               &Measures::max_circumradius, &Measures::max_ratio})
      if ((later.*extreme).value > (this->*extreme).value) this->*extreme = later.*extreme;
    for (std::size_t bin = 0; bin < histogram_bins; ++bin) histogram[bin] += later.histogram[bin];
    doubled_area_sum += later.doubled_area_sum;
  }

 private:
  static void lower(Extreme& extreme, double value, Index t, Point where) {
    if (value < extreme.value) extreme = {value, t, where};
  }
  static void raise(Extreme& extreme, double value, Index t, Point where) {
    if (value > extreme.value) extreme = {value, t, where};
  }
};

Extreme found(const Extreme& extreme) { return extreme.triangle == no_index ? Extreme{} : extreme; }

}  // namespace

void measure(const Mesh& mesh, Certificate& certificate, StopSignal* stop) {
  std::vector<Measures> parts(static_cast<std::size_t>(omp_get_max_threads()));
  for_each_index(mesh.triangles.size(), stop, [&](std::size_t t, std::size_t thread) {
    const auto& v = mesh.triangles[t].v;
    parts[thread].add(static_cast<Index>(t), {mesh.points[v[0]], mesh.points[v[1]], mesh.points[v[2]]});
  });
  for (std::size_t i = 1; i < parts.size(); ++i) parts[0].append(parts[i]);
  const Measures& all = parts[0];
  certificate.min_angle_deg = found(all.min_angle);
  certificate.max_angle_deg = found(all.max_angle);
  certificate.max_area = found(all.max_area);
  certificate.max_edge = found(all.max_edge);
  certificate.min_edge = found(all.min_edge);
  certificate.max_circumradius = found(all.max_circumradius);
  certificate.max_radius_edge_ratio = found(all.max_ratio);
  certificate.area = all.doubled_area_sum.rounded() / 2;
  certificate.angle_histogram.assign(all.histogram.begin(), all.histogram.end());
}

}  // namespace pardel::checker
