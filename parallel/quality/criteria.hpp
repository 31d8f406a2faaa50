// The criteria for bad triangles, and the points that split them. All functions are pure functions of coordinates.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "../../core/goal.hpp"
#include "../../core/user_test.hpp"
#include "../options.hpp"
#include "../sizing/local_bound.hpp"
#include "../triangulation/triangle_shape.hpp"

namespace pardel::engine {

/// The goal, prepared for comparisons with triangles. Its bounds are stricter than the bounds of the goal by a relative
/// 2^-40: a triangle that passes here, in floating point, also passes an exact comparison with the goal.
class Criteria {
 public:
  /// `placement`: not `automatic`. `region_caps`: one area cap per region of the triangulation. `area_cap`: the area
  /// cap at a point, or empty.
  Criteria(const Goal& goal, Placement placement, std::vector<double> region_caps,
           std::function<double(Point)> area_cap = {});

  /// True if the smallest angle is below the bound. For a Pair of triangles the result is a pair of answers.
  template <class T>
  [[nodiscard]] auto bad_shape(const MeasureOf<T>& s) const {
    // The smallest angle lies between the two longer sides. Its sine is twice the area divided by their product.
    return s.twice_area * s.twice_area < squared_sine_ * (s.middle_squared() * s.longest_squared());
  }
  /// True if the angle at `corner` is below the bound, where the triangle has this area. The squares of the sides would
  /// not tell on which side of 90 degrees an angle is that the shortest side of a thin triangle forms.
  [[nodiscard]] bool is_small(double twice_area, Point corner, Point p, Point q) const {
    const double px = p.x - corner.x, py = p.y - corner.y, qx = q.x - corner.x, qy = q.y - corner.y;
    return px * qx + py * qy > 0 &&
           twice_area * twice_area < squared_sine_ * ((px * px + py * py) * (qx * qx + qy * qy));
  }
  /// True if the area exceeds the bound that holds everywhere.
  template <class T>
  [[nodiscard]] auto too_large(const MeasureOf<T>& m) const {
    return m.twice_area > twice_max_area_;
  }
  /// True if the goal has a bound on areas or on edges, or a test of the user.
  [[nodiscard]] bool has_size() const { return has_local_size_ || twice_max_area_ < INFINITY; }
  /// True if the goal has bounds on edges, bounds that depend on the place, or a test of the user. too_large() does not
  /// test these.
  [[nodiscard]] bool has_local_size() const { return has_local_size_; }
  /// True if the goal has bounds that are functions of the place.
  [[nodiscard]] bool depends_on_place() const {
    return static_cast<bool>(size_) || static_cast<bool>(area_cap_) || has_user_test();
  }
  [[nodiscard]] bool has_user_test() const { return static_cast<bool>(user_test_); }
  /// True if the goal has a test of the user, and this says that the triangle must be refined. Precondition: a, b, c
  /// are counter-clockwise.
  [[nodiscard]] bool fails_user_test(Point a, Point b, Point c) const {
    return user_test_ && must_be_refined(user_test_, a, b, c);
  }
  /// True if the triangle with these corners exceeds one of these local bounds, or else fails the test of the user,
  /// which is asked last. `region`: the triangle's region, or
  /// no_index. `hints`, here and below: of the calling thread.
  [[nodiscard]] bool too_large_locally(const Measure& m, Point a, Point b, Point c, Index region,
                                       LocalHints& hints) const;
  [[nodiscard]] bool too_large_locally(const Shape& s, Index region) const {
    LocalHints none;
    return too_large_locally(s, s.p[0], s.p[1], s.p[2], region, none);
  }
  /// True if announce() does something.
  [[nodiscard]] bool announces_places() const { return static_cast<bool>(before_sizes_); }
  /// Announces the centroids of triangles that will be examined (Goal::before_sizes).
  void announce(std::span<const Point> centroids) const { before_sizes_(centroids); }
  /// Prepares for triangles whose first corner is p. It changes no answer.
  void look_around(Point p, LocalHints& hints) const {
    if (looks_around_) hints.around = size_around(p, hints);
  }
  /// True if the corner opposite a constrained side encroaches on the side, which then has to be split. For a
  /// conforming goal, the corner encroaches inside and on the diametral circle of the side; for other goals, in its
  /// diametral lens (Shewchuk, "Delaunay refinement algorithms for triangular mesh generation", 2002, section 3). If
  /// the goal has no bounds, no corner encroaches: nothing is refined, so no point will come close to the side.
  /// Theorem 2 (THEORY.md, T2) bounds all circumradii as long as no inserted point encroaches. `dot`: Measure::dot_at
  /// the corner. The other parameters: the squared lengths of the two sides at this corner.
  [[nodiscard]] bool encroaches(double dot, double squared_left, double squared_right) const {
    return dot <= 0 && dot * dot >= squared_lens_cosine_ * squared_left * squared_right;
  }

  /// True if a point encroaches on a border edge of a patch. If it sees the edge at 120 degrees or more, it would enter
  /// the circumdisk of the equilateral triangle that will be laid behind the edge. If it sees the edge at more than 180
  /// degrees minus twice the bound on angles, it would make a triangle with the edge that breaks the bound and whose
  /// circumcentre lies behind the edge. Parameters: as for encroaches().
  [[nodiscard]] bool encroaches_on_patch(double dot, double squared_left, double squared_right) const {
    return dot <= 0 && dot * dot >= squared_patch_cosine_ * squared_left * squared_right;
  }

  /// The same criteria for a domain that is filled with patches. `lengths`: the length of the edges in the patch of
  /// each region, and last in that of the triangles without a region; infinity if there is no patch.
  [[nodiscard]] Criteria with_patches(std::vector<double> lengths) const {
    Criteria result = *this;
    result.length_of_pieces_ = std::move(lengths);
    return result;
  }
  /// The length of the pieces into which segments beside triangles of a region are split (edge_split_point()); infinity
  /// if they are halved.
  [[nodiscard]] double length_of_pieces(Index region) const {
    return length_of_pieces_.empty() ? INFINITY
                                     : length_of_pieces_[std::min<std::size_t>(region, length_of_pieces_.size() - 1)];
  }

  /// The average number of triangles by which the bound on angles replaces a triangle of a Delaunay triangulation of
  /// random points.
  [[nodiscard]] double triangles_by_shape() const { return triangles_by_shape_; }

  [[nodiscard]] bool conforming() const { return conforming_; }
  /// True for Placement::search: split_point() is only the first of several candidates.
  [[nodiscard]] bool searches() const { return searches_; }

  /// The point that splits the bad triangle with the shortest side qr and the opposite corner a, counter-clockwise. It
  /// is the nearest to the side qr of these candidates:
  /// - the circumcentre;
  /// - the off-centre: with qr it forms a triangle that just keeps the bound on angles (Üngör, "Off-centers: a new type
  ///   of Steiner points", 2004);
  /// - the size point: with qr it forms a triangle as large as the bounds on size allow, but is no nearer to qr than
  ///   half the length of qr (after Engwirda and Ivers, "Off-centre Steiner points for Delaunay-refinement on curved
  ///   surfaces", 2016). Not used for triangles of more than six times the area that these bounds allow; bounds on area
  ///   only up to 31 degrees.
  /// With Placement::circumcentre, the circumcentre is the only candidate.
  [[nodiscard]] Point split_point(Point q, Point r, Point a, Index region, LocalHints& hints) const;
  [[nodiscard]] Point split_point(const Shape& s, Index region) const {
    const unsigned apex = s.shortest_side();
    LocalHints none;
    return split_point(s.p[next_corner[apex]], s.p[previous_corner[apex]], s.p[apex], region, none);
  }

  /// The estimated number of triangles by which the bounds on size replace this triangle.
  [[nodiscard]] double triangles_wanted(const Shape& s, Index region, LocalHints& hints) const;
  /// Twice the area of the triangles that the bounds on size let expect at a place of the domain.
  [[nodiscard]] double twice_area_wanted(Point p, Index region, LocalHints& hints) const;
  /// A lower bound on the number of triangles in the area of this triangle: its area divided by the area cap.
  [[nodiscard]] double triangles_needed(const Shape& s, Index region) const;

 private:
  [[nodiscard]] SizeAround size_around(Point p, LocalHints& hints) const;
  /// The bounds on size at the place of a triangle.
  struct SizeBounds {
    double twice_area, squared_edge;
  };
  [[nodiscard]] SizeBounds size_bounds(Point a, Point b, Point c, Index region, LocalHints& hints) const {
    if (!has_local_size_) return {twice_max_area_, squared_max_edge_};
    return size_bounds(centroid_of(a, b, c), region, hints);
  }
  [[nodiscard]] SizeBounds size_bounds(Point centroid, Index region, LocalHints& hints) const;
  [[nodiscard]] bool exceeds_local_bound(const Measure& m, Point a, Point b, Point c, Index region,
                                         LocalHints& hints) const;
  /// The estimated number of triangles by which the test of the user replaces this triangle: from the largest copy,
  /// halved again and again around its centroid, that passes the test. 0 if the triangle passes it, or no copy does.
  [[nodiscard]] double triangles_by_user_test(const Shape& s) const;
  /// The height, as a multiple of the shortest side, of the triangle that is as large as the bounds allow. Infinity for
  /// a triangle that is much too large.
  [[nodiscard]] double filling_height(const SizeBounds& bounds, double twice_area, double squared_shortest) const;

  bool conforming_, searches_;
  double squared_sine_;         ///< of the smallest angle allowed
  double squared_lens_cosine_;  ///< infinity if no corner encroaches
  double squared_patch_cosine_;
  double twice_max_area_;
  double squared_max_edge_;
  double triangles_by_shape_;
  double off_centre_height_ = INFINITY;  ///< height of the off-centre, as a multiple of the shortest side
  bool fills_ = false;                   ///< the size point is a candidate (split_point)
  bool fills_areas_ = false;             ///< the size point uses bounds on area, too
  double fill_ = 0.62;                   ///< the average area of a triangle, as a fraction of its cap
  std::vector<double> twice_region_cap_;
  std::vector<double> length_of_pieces_;  ///< empty: segments are halved
  LocalBound size_, area_cap_;
  std::function<void(std::span<const Point>)> before_sizes_;
  UserTest user_test_;
  bool looks_around_;  ///< the size changes slowly, so the size at a corner mostly decides about a triangle
  bool has_local_size_;
};

}  // namespace pardel::engine
