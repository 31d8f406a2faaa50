// When a triangle is bad, and where the point goes that splits it. Pure functions of coordinates.
#pragma once

#include <array>
#include <cmath>
#include <functional>
#include <vector>

#include "../../core/goal.hpp"
#include "../arithmetic/pair.hpp"
#include "../options.hpp"
#include "../triangulation/triangulation.hpp"

namespace pardel::engine {

/// What a triangle's quality is read from. T: double; or Pair, for two triangles at once.
template <class T>
struct MeasureOf {
  std::array<T, 3> squared{};  ///< squared length of the side opposite each corner
  T twice_area{};

  [[nodiscard]] T shortest_squared() const { return least(least(squared[0], squared[1]), squared[2]); }
  [[nodiscard]] T longest_squared() const { return greatest(greatest(squared[0], squared[1]), squared[2]); }
  [[nodiscard]] T middle_squared() const {
    const T low = least(squared[0], squared[1]), high = greatest(squared[0], squared[1]);
    return greatest(low, least(high, squared[2]));
  }
  [[nodiscard]] T squared_circumradius() const {
    return squared[0] * (squared[1] / twice_area) * (squared[2] / twice_area) / 4;
  }
  /// The shortest side; the smallest angle lies at the corner of the same number.
  [[nodiscard]] unsigned shortest_side() const {
    const auto second = static_cast<unsigned>(squared[1] < squared[0]);
    const auto third = static_cast<unsigned>(squared[2] < least(squared[0], squared[1]));
    return third << 1U | (second & ~third);
  }
  /// (b - a) . (c - a) for the corner a.
  [[nodiscard]] T dot_at(unsigned corner) const {
    return 0.5 * (squared[next_corner[corner]] + squared[previous_corner[corner]] - squared[corner]);
  }
};
using Measure = MeasureOf<double>;

[[nodiscard]] inline Point centroid_of(Point a, Point b, Point c) {
  return {(a.x + b.x + c.x) / 3, (a.y + b.y + c.y) / 3};
}

/// The corners of a triangle with its measure.
struct Shape : Measure {
  std::array<Point, 3> p;

  Shape(const Triangulation& t, const Slot& slot)
      : Shape(t.points[slot.v[0]], t.points[slot.v[1]], t.points[slot.v[2]]) {}
  /// All lengths from differences to the first corner, as an insertion has them at hand: the same bits both ways, and
  /// of the area too, where floating point decides its sign.
  Shape(Point a, Point b, Point c) : p{a, b, c} {
    const double abx = b.x - a.x, aby = b.y - a.y;
    const double acx = c.x - a.x, acy = c.y - a.y;
    const double bcx = acx - abx, bcy = acy - aby;
    squared = {bcx * bcx + bcy * bcy, acx * acx + acy * acy, abx * abx + aby * aby};
    twice_area = abx * acy - aby * acx;
  }

  [[nodiscard]] Point centroid() const { return centroid_of(p[0], p[1], p[2]); }
};

/// A Goal made ready. A hair stricter than the goal, so that what passes here in floating point passes an
/// exact comparison with the goal.
class Criteria {
 public:
  /// region_caps: one cap per region of the triangulation. area_cap: a cap by position, or empty.
  Criteria(const Goal& goal, Placement placement, std::vector<double> region_caps,
           std::function<double(Point)> area_cap = {});

  template <class T>
  [[nodiscard]] auto bad_shape(const MeasureOf<T>& s) const {
    // The smallest angle lies between the two longer sides: its sine is twice the area over their product.
    return s.twice_area * s.twice_area < squared_sine_ * (s.middle_squared() * s.longest_squared());
  }
  template <class T>
  [[nodiscard]] auto too_large(const MeasureOf<T>& m) const {
    return m.twice_area > twice_max_area_;
  }
  [[nodiscard]] bool has_size() const { return has_local_size_ || twice_max_area_ < INFINITY; }
  /// There are sizes that depend on the place: too_large alone does not tell.
  [[nodiscard]] bool has_local_size() const { return has_local_size_; }
  [[nodiscard]] bool too_large_locally(const Shape& s, Index region) const;
  /// The corner opposite a constrained side sees it at so large an angle that the side has to be split:
  /// inside or on the diametral circle for a conforming goal, else in the diametral lens (Shewchuk,
  /// "Delaunay refinement algorithms for triangular mesh generation", 2002, section 3).
  [[nodiscard]] bool encroaches(double dot, double squared_left, double squared_right) const {
    return dot <= 0 && dot * dot >= squared_lens_cosine_ * squared_left * squared_right;
  }

  /// How many triangles the bound on angles makes of one of the Delaunay triangulation of random points, on average.
  [[nodiscard]] double triangles_by_shape() const { return triangles_by_shape_; }

  [[nodiscard]] bool conforming() const { return squared_lens_cosine_ == 0; }

  /// The point to insert for a bad triangle with the shortest side qr and the apex a, counter-clockwise: its
  /// circumcentre, or a point nearer to the shortest side that makes of that side a triangle that just keeps the bound
  /// on angles (Üngör, "Off-centers: a new type of Steiner points", 2004), or just fills the bounds on size where that
  /// is nearer still (after Engwirda and Ivers, "Off-centre Steiner points for Delaunay-refinement on curved surfaces",
  /// 2016), though no lower than half the side. Triangles much too large do not fill bounds, nor do areas above 31
  /// degrees.
  [[nodiscard]] Point split_point(Point q, Point r, Point a, Index region) const;
  [[nodiscard]] Point split_point(const Shape& s, Index region) const {
    const unsigned apex = s.shortest_side();
    return split_point(s.p[next_corner[apex]], s.p[previous_corner[apex]], s.p[apex], region);
  }

  /// The estimated number of triangles that the sizes ask for where this one lies.
  [[nodiscard]] double triangles_wanted(const Shape& s, Index region) const;
  /// The least number of triangles that bounds on area allow where this one lies: area over cap.
  [[nodiscard]] double triangles_needed(const Shape& s, Index region) const;

 private:
  /// The bounds on size where a triangle lies.
  struct SizeBounds {
    double twice_area, squared_edge;
  };
  [[nodiscard]] SizeBounds size_bounds(Point a, Point b, Point c, Index region) const;
  /// The height, in lengths of the shortest side, of what just fills the bounds; infinity for a triangle that is much
  /// too large.
  [[nodiscard]] double filling_height(const SizeBounds& bounds, double twice_area, double squared_shortest) const;

  double squared_sine_;  ///< of the smallest angle allowed
  double squared_lens_cosine_;
  double twice_max_area_;
  double squared_max_edge_;
  double triangles_by_shape_;
  double off_centre_height_ = INFINITY;  ///< of what just keeps the bound on angles, in lengths of the shortest side
  bool fills_ = false;                   ///< off-centres are to fill bounds on size
  bool fills_areas_ = false;             ///< on areas, too
  double fill_ = 0.62;                   ///< of its cap, what a triangle fills on average
  std::vector<double> twice_region_cap_;
  std::function<double(Point)> size_, area_cap_;
  bool has_local_size_;
};

}  // namespace pardel::engine
