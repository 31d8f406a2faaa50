// A triangulation of given points with the criteria and the assessor of a goal.
#pragma once

#include <vector>

#include "../../../parallel/refinement/assessor.hpp"
#include "../samples.hpp"

namespace pardel::engine::samples {

struct AssessedSample {
  Sample sample;
  DomainSegments segments;
  Options options;
  Criteria criteria;
  Assessor assessor;

  AssessedSample(const std::vector<Point>& points, const Goal& goal, Placement placement, const Options& with = {})
      : sample(triangulated(points)),
        segments(sample.triangulation.points, sample.constraints),
        options(with),
        criteria(goal, placement, {}),
        assessor(sample.triangulation, segments, criteria, options) {}
  // The assessor refers to the other members.
  AssessedSample(const AssessedSample&) = delete;
  AssessedSample& operator=(const AssessedSample&) = delete;
};

}  // namespace pardel::engine::samples
