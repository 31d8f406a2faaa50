// The faces of a domain by definition: the arrangement of its segments in exact arithmetic (CGAL).
#pragma once

#include <memory>
#include <set>
#include <vector>

#include "../../core/pslg.hpp"
#include "../../ref/definitions.hpp"

namespace pardel::fuzz {

/// A segment of the input, or a side of the convex hull of the points if this hull is the outline.
struct Wall {
  Index a, b;     ///< input points
  Index segment;  ///< no_index for a side of the hull
  int marker;
  int sides_inside = 0;  ///< on how many of its two sides the domain lies
};

class InputFaces {
 public:
  /// The number of a face.
  using Face = std::size_t;

  /// Precondition: the Pslg is valid.
  InputFaces(const Pslg& pslg, bool convex_hull);
  ~InputFaces();
  InputFaces(const InputFaces&) = delete;
  InputFaces& operator=(const InputFaces&) = delete;

  /// The input segments, then the sides of the hull.
  [[nodiscard]] const std::vector<Wall>& walls() const { return walls_; }
  /// A face that contains p in its closure: the only one, unless p lies on a wall.
  [[nodiscard]] Face face_at(const ref::ExactPoint& p) const { return around(p).front(); }
  /// Does the face belong to the domain?
  [[nodiscard]] bool is_inside(Face face) const { return !outside_.contains(face); }
  /// Does the closed domain contain p?
  [[nodiscard]] bool contains(const ref::ExactPoint& p) const { return count_inside(p) > 0; }
  /// The regions whose seeds lie in the face.
  [[nodiscard]] std::set<Index> regions_in(Face face) const;
  /// The area of the domain.
  [[nodiscard]] ref::Number area() const;

 private:
  /// The faces that contain p in their closures. A face may occur twice, for both sides of a wall.
  [[nodiscard]] std::vector<Face> around(const ref::ExactPoint& p) const;
  [[nodiscard]] int count_inside(const ref::ExactPoint& p) const;

  struct Arrangement;
  std::unique_ptr<Arrangement> arrangement_;
  std::vector<Wall> walls_;
  std::set<Face> outside_;
  std::vector<Face> face_of_region_;
};

}  // namespace pardel::fuzz
