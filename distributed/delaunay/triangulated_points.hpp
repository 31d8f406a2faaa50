// The triangulation of given points, divided among ranks.
#pragma once

#include <functional>
#include <memory>

#include "../../core/part_of_points.hpp"
#include "../../core/ranks.hpp"
#include "../../core/result.hpp"
#include "../../parallel/threads/threads.hpp"
#include "curve_division.hpp"
#include "local_delaunay.hpp"
#include "own_points.hpp"

namespace pardel::engine {

/// What a rank has of it. All triangles with an own corner are those of the triangulation of all points.
struct TriangulatedPoints {
  CurveDivision division;
  OwnPoints own;  ///< without the coordinates, which are in the triangulation
  LocalDelaunay delaunay;
};

/// What is wrong with points that cannot be triangulated. Collective.
using JudgeOfPoints = std::function<Status(const OwnPoints& own)>;

/// Uses up the points. Collective; faults of the input are errors on all ranks alike: those that `judge` finds; without
/// it, those of unusable_positions(). Precondition: the values of the points are usable (unusable_values()).
[[nodiscard]] Result<std::unique_ptr<TriangulatedPoints>> triangulated(PartOfPoints&& read, Ranks& ranks,
                                                                       const Threads& threads,
                                                                       const JudgeOfPoints& judge = {});

}  // namespace pardel::engine
