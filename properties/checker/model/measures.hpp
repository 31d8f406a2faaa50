// Measures: the extremes of angles, edges, areas and circumradii over a range of triangles, a histogram of angles, and
// the number of equilateral triangles.
#pragma once

#include <array>
#include <cstdint>
#include <limits>

#include "../arithmetic/filter.hpp"
#include "../certificate.hpp"

namespace pardel::checker {

/// All values are computed by the formulas of arithmetic/measure.hpp. If several triangles attain a value, the first is
/// kept. Most triangles attain none, and a comparison with a margin for rounding shows this without these formulas.
class Measures {
 public:
  static constexpr std::size_t bins = 18;  ///< of 10 degrees

  /// Triangles have to be added in ascending order. `p` are the corners of `shape`.
  void add(Index t, const std::array<Point, 3>& p, const filter::Shape& shape) {
    if (!shape.is_tame()) {
      add_extremes(t, p);
      add_angles(p);
      if (is_equilateral(p)) ++equilateral_;
      return;
    }
    if (may_be_extreme(shape)) add_extremes(t, p);
    if (!add_clear_angles(shape)) add_angles(p);
    if (shape.longest <= shape.shortest * (1 + 2 * equilateral_tolerance)) ++equilateral_;
  }

  /// Adds the measures of a later range of triangles.
  void append(const Measures& later);

  /// Sets the extremes, the histogram and the number of equilateral triangles of a certificate.
  void report(Certificate& certificate) const;

 private:
  static constexpr double equilateral_tolerance = 1e-6;  ///< see Certificate::equilateral
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  /// The angles whose cotangent lies in a cell of width 1/16: they are in bin `above` if their cotangent is greater
  /// than `limit`, else in the next bin.
  struct Cell {
    double limit;
    std::uint32_t above;
  };
  static constexpr double most_cotangent = 6, cells_per_unit = 16;
  static constexpr std::size_t cells = 193;
  static const std::array<Cell, cells>& table();

  /// False if no measure of the tame triangle is an extreme. Cotangents of its angles have errors below
  /// 2^-29 (1 + |cotangent|), see Shape::is_tame(); the bounds have margins of 2^-24 and, for lengths, of 2^-30.
  [[nodiscard]] bool may_be_extreme(const filter::Shape& shape) const {
    const double product = shape.squared[0] * shape.squared[1] * shape.squared[2];
    const double squared_area = shape.doubled_area * shape.doubled_area;
    return shape.largest_dot >= bounds_.cotangent_of_least * shape.doubled_area ||
           shape.least_dot <= bounds_.cotangent_of_largest * shape.doubled_area || shape.shortest <= bounds_.shortest ||
           shape.longest >= bounds_.longest || shape.doubled_area > bounds_.doubled_area ||
           product >= bounds_.radius * squared_area || product >= bounds_.ratio * squared_area * shape.shortest;
  }

  /// Counts the angles of a tame triangle. False, and nothing is counted, if one of them is so near to a multiple of
  /// 10 degrees that rounding may decide its bin.
  [[nodiscard]] bool add_clear_angles(const filter::Shape& shape) {
    const double inverse = 1 / shape.doubled_area;
    std::array<std::uint32_t, 3> bin;
    bool clear = true;
    for (std::size_t k = 0; k < 3; ++k) {
      const double cotangent = std::min(std::max(shape.dot[k] * inverse, -most_cotangent), most_cotangent);
      const Cell& at = (*cells_)[static_cast<std::size_t>((cotangent + most_cotangent) * cells_per_unit)];
      const double over = cotangent - at.limit;
      clear = clear && std::abs(over) > 0x1p-20;
      bin[k] = at.above + (over > 0 ? 0 : 1);
    }
    if (!clear) return false;
    for (std::size_t k = 0; k < 3; ++k) ++histogram_[k][bin[k]];
    return true;
  }

  [[nodiscard]] static bool is_equilateral(const std::array<Point, 3>& p);
  void add_extremes(Index t, const std::array<Point, 3>& p);
  void add_angles(const std::array<Point, 3>& p);
  void set_bounds();

  Extreme min_angle_{infinity, no_index, {}}, min_edge_{infinity, no_index, {}};
  Extreme max_angle_{-infinity, no_index, {}}, max_area_{-infinity, no_index, {}}, max_edge_{-infinity, no_index, {}};
  Extreme max_circumradius_{-infinity, no_index, {}}, max_ratio_{-infinity, no_index, {}};
  /// A tame triangle within these bounds changes no extreme.
  struct Bounds {
    double cotangent_of_least = -infinity, cotangent_of_largest = infinity;
    double shortest = infinity, longest = 0;  ///< squared lengths
    double doubled_area = -infinity;
    double radius = 0, ratio = 0;  ///< four times the squares
  } bounds_;
  const std::array<Cell, cells>* cells_ = &table();
  std::array<std::array<std::uint64_t, bins>, 3> histogram_{};  ///< one for each corner; the sum counts
  std::uint64_t equilateral_ = 0;
};

}  // namespace pardel::checker
