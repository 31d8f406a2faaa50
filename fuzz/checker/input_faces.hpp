// The faces of a domain by definition.
#pragma once

#include <set>
#include <vector>

#include "../../core/pslg.hpp"
#include "plane_faces.hpp"

namespace pardel::fuzz {

/// A segment of the input, or a side of the convex hull of the points if this hull is the outline.
struct Wall {
  Index a, b;     ///< input points
  Index segment;  ///< no_index for a side of the hull
  int marker;
  PlaneFaces::Face left = 0, right = 0;            ///< the faces on its two sides
  bool left_inside = false, right_inside = false;  ///< does the domain lie on this side?

  [[nodiscard]] int sides_inside() const { return int(left_inside) + int(right_inside); }
};

class InputFaces {
 public:
  using Face = PlaneFaces::Face;

  /// Precondition: the Pslg is valid.
  InputFaces(const Pslg& pslg, bool convex_hull);
  InputFaces(const InputFaces&) = delete;
  InputFaces& operator=(const InputFaces&) = delete;

  /// The input segments, then the sides of the hull.
  [[nodiscard]] const std::vector<Wall>& walls() const { return walls_; }
  /// A face that contains p in its closure: the only one, unless p lies on a wall.
  [[nodiscard]] Face face_at(const ref::ExactPoint& p) const { return faces_.around(p).front(); }
  /// Does the face belong to the domain?
  [[nodiscard]] bool is_inside(Face face) const { return !outside_.contains(face); }
  /// Does the closed domain contain p?
  [[nodiscard]] bool contains(const ref::ExactPoint& p) const;
  /// The regions whose seeds lie in the face.
  [[nodiscard]] std::set<Index> regions_in(Face face) const;
  /// The area of the domain.
  [[nodiscard]] ref::Number area() const;

 private:
  std::vector<Wall> walls_;
  PlaneFaces faces_;
  std::set<Face> outside_;
  std::vector<Face> face_of_region_;
};

}  // namespace pardel::fuzz
