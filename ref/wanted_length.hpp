// The edge lengths that a limit on gradation and the features of a domain ask for, as docs/sizes.md defines them.
#pragma once

#include <optional>
#include <vector>

#include "../core/goal.hpp"
#include "../core/pslg.hpp"

namespace pardel::ref {

/// A segment, or a corner if a == b. The numbers of points.
struct Feature {
  Index a, b;
};

/// True if the point is a corner: not exactly two segments meet there, or the direction turns by an angle with a cosine
/// of 0.65 or less.
[[nodiscard]] bool is_corner_of(const Pslg& pslg, Index point);

/// The segments and corners.
[[nodiscard]] std::vector<Feature> features_of(const Pslg& pslg);

/// Those of the features that count as touching f, in any order. Of a segment: all segments that a walk reaches that
/// leaves it across one of its ends, across points that are no corners, and ends before the first segment whose
/// direction differs by 90 degrees or more; and what touches the corners at which the walks end. Of a corner: itself,
/// and all segments of such walks that start there.
[[nodiscard]] std::vector<Feature> touching(const Pslg& pslg, Feature f);

/// The distance of a point of f to the nearest feature that does not touch f; infinity if there is none.
[[nodiscard]] double width_at(const Pslg& pslg, Feature f, Point p);

/// The radius of the circle that touches the two segments at a point, the shorter one in its middle. Nothing at corners
/// and where the segments have the same direction.
[[nodiscard]] std::optional<double> radius_of_turn(const Pslg& pslg, Index point);

/// The longest edge that goal.grading and goal.feature_edges allow, from its definition, by comparing everything with
/// everything. Precondition: the goal has one of the two bounds.
class WantedLength {
 public:
  /// Computes widths at so many points of each segment.
  WantedLength(const Pslg& pslg, const Goal& goal, int points_per_segment = 64);

  /// Not below the definition, and above it by at most error().
  [[nodiscard]] double at(Point p) const;
  [[nodiscard]] double error() const { return error_; }
  /// The fastest growth of at() per unit of distance.
  [[nodiscard]] double slope() const { return slope_; }

 private:
  struct From {
    SizeSource source;
    double slope;
  };
  void add(Point p, double length, double slope);

  std::vector<From> all_;
  double error_ = 0, slope_ = 0;
};

}  // namespace pardel::ref
