// The faces into which lines divide the plane, by definition: the arrangement of the lines in exact arithmetic (CGAL).
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "../../ref/definitions.hpp"

namespace pardel::fuzz {

class PlaneFaces {
 public:
  /// The number of a face.
  using Face = std::size_t;
  using Line = std::pair<ref::ExactPoint, ref::ExactPoint>;

  explicit PlaneFaces(const std::vector<Line>& lines);
  ~PlaneFaces();
  PlaneFaces(const PlaneFaces&) = delete;
  PlaneFaces& operator=(const PlaneFaces&) = delete;

  [[nodiscard]] std::size_t count() const;
  /// The unbounded face.
  [[nodiscard]] Face outside() const;
  /// The faces that contain p in their closures. A face may occur twice, for both sides of a line.
  [[nodiscard]] std::vector<Face> around(const ref::ExactPoint& p) const;
  /// The face on the left of the line from a to b. Precondition: this is one of the lines, and meets the others at its
  /// ends only.
  [[nodiscard]] Face left_of(const ref::ExactPoint& a, const ref::ExactPoint& b) const;
  /// Precondition: the face is bounded.
  [[nodiscard]] ref::Number area(Face face) const;

 private:
  struct Arrangement;
  std::unique_ptr<Arrangement> arrangement_;
};

}  // namespace pardel::fuzz
