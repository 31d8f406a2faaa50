#include "measures.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "../arithmetic/measure.hpp"
#include "adjacency.hpp"

namespace pardel::checker {
namespace {

void lower(Extreme& extreme, double value, Index t, Point where) {
  if (value < extreme.value) extreme = {value, t, where};
}
void raise(Extreme& extreme, double value, Index t, Point where) {
  if (value > extreme.value) extreme = {value, t, where};
}

Extreme found(const Extreme& extreme) { return extreme.triangle == no_index ? Extreme{} : extreme; }

double cotangent_of(double degrees) { return 1 / std::tan(degrees * std::numbers::pi / 180); }

constexpr double cotangent_margin(double cotangent) { return 0x1p-24 * (1 + std::abs(cotangent)); }

/// Four times the square of a length, less a margin; 0 if it is not positive.
double squared_bound(double length) { return length > 0 ? 4 * length * length * (1 - 0x1p-30) : 0; }

}  // namespace

const std::array<Measures::Cell, Measures::cells>& Measures::table() {
  static const std::array<Cell, cells> made = [] {
    std::array<double, bins> limit{};  // the cotangent at the end of each bin
    for (std::size_t bin = 0; bin < bins; ++bin) limit[bin] = cotangent_of(10.0 * static_cast<double>(bin + 1));
    limit.back() = -infinity;
    std::array<Cell, cells> table{};
    for (std::size_t i = 0; i < cells; ++i) {
      const double low = static_cast<double>(i) / cells_per_unit - most_cotangent;
      std::uint32_t bin = 0;
      while (limit[bin] > low + 1 / cells_per_unit) ++bin;
      table[i] = {limit[bin], bin};
    }
    return table;
  }();
  return made;
}

void Measures::add_extremes(Index t, const std::array<Point, 3>& p) {
  std::array<double, 3> length;
  for (int k = 0; k < 3; ++k) length[k] = distance(p[next(k)], p[previous(k)]);
  const double area2 = doubled_area(p[0], p[1], p[2]);
  for (int k = 0; k < 3; ++k) {
    const double angle = angle_deg(p[k], p[next(k)], p[previous(k)]);
    lower(min_angle_, angle, t, p[k]);
    raise(max_angle_, angle, t, p[k]);
    const Point middle = midpoint(p[next(k)], p[previous(k)]);
    lower(min_edge_, length[k], t, middle);
    raise(max_edge_, length[k], t, middle);
  }
  const Point centroid{p[0].x / 3 + p[1].x / 3 + p[2].x / 3, p[0].y / 3 + p[1].y / 3 + p[2].y / 3};
  raise(max_area_, area2 / 2, t, centroid);
  const double radius = length[0] / (2 * area2) * length[1] * length[2];
  raise(max_circumradius_, radius, t, centroid);
  raise(max_ratio_, radius / *std::min_element(length.begin(), length.end()), t, centroid);
  set_bounds();
}

void Measures::add_angles(const std::array<Point, 3>& p) {
  for (int k = 0; k < 3; ++k) {
    const double bin = angle_deg(p[k], p[next(k)], p[previous(k)]) / 10;  // no number, if a side has no length
    ++histogram_[0][bin < static_cast<double>(bins) ? static_cast<std::size_t>(bin) : bins - 1];
  }
}

bool Measures::is_equilateral(const std::array<Point, 3>& p) {
  const auto [shortest, longest] = std::minmax({distance(p[0], p[1]), distance(p[1], p[2]), distance(p[2], p[0])});
  return shortest > 0 && longest <= shortest * (1 + equilateral_tolerance);
}

void Measures::set_bounds() {
  // The angles of a tame triangle are more than 10^-5 degrees away from 0 and 180.
  constexpr double flat = 1e-5;
  const double least = cotangent_of(min_angle_.value), largest = cotangent_of(max_angle_.value);
  bounds_.cotangent_of_least = !(min_angle_.value > flat)        ? infinity
                               : min_angle_.triangle == no_index ? -infinity
                                                                 : least - cotangent_margin(least);
  bounds_.cotangent_of_largest = !(max_angle_.value < 180 - flat)  ? -infinity
                                 : max_angle_.triangle == no_index ? infinity
                                                                   : largest + cotangent_margin(largest);
  bounds_.shortest = min_edge_.value * min_edge_.value * (1 + 0x1p-30);
  bounds_.longest = squared_bound(max_edge_.value) / 4;
  bounds_.doubled_area = 2 * max_area_.value;
  bounds_.radius = squared_bound(max_circumradius_.value);
  bounds_.ratio = squared_bound(max_ratio_.value);
}

void Measures::append(const Measures& later) {
  for (const auto extreme : {&Measures::min_angle_, &Measures::min_edge_})
    if ((later.*extreme).value < (this->*extreme).value) this->*extreme = later.*extreme;
  for (const auto extreme : {&Measures::max_angle_, &Measures::max_area_, &Measures::max_edge_,
                             &Measures::max_circumradius_, &Measures::max_ratio_})
    if ((later.*extreme).value > (this->*extreme).value) this->*extreme = later.*extreme;
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t bin = 0; bin < bins; ++bin) histogram_[k][bin] += later.histogram_[k][bin];
  equilateral_ += later.equilateral_;
  set_bounds();
}

void Measures::report(Certificate& certificate) const {
  certificate.min_angle_deg = found(min_angle_);
  certificate.max_angle_deg = found(max_angle_);
  certificate.max_area = found(max_area_);
  certificate.max_edge = found(max_edge_);
  certificate.min_edge = found(min_edge_);
  certificate.max_circumradius = found(max_circumradius_);
  certificate.max_radius_edge_ratio = found(max_ratio_);
  certificate.equilateral = equilateral_;
  certificate.angle_histogram.resize(bins);
  for (std::size_t bin = 0; bin < bins; ++bin)
    certificate.angle_histogram[bin] = histogram_[0][bin] + histogram_[1][bin] + histogram_[2][bin];
}

}  // namespace pardel::checker
