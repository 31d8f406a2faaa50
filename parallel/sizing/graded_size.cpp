#include "graded_size.hpp"

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include "../decomposition/bounding_box.hpp"
#include "feature_sources.hpp"
#include "local_bound.hpp"

namespace pardel::engine {

bool is_graded(const Goal& goal) { return goal.grading < INFINITY || goal.feature_edges > 0; }

std::function<double(Point)> graded_size(const Goal& goal, const Pslg& pslg, const Threads& threads) {
  const double edges = goal.feature_edges > 0 ? goal.feature_edges : 1;
  const Polylines lines = find_polylines(pslg, threads);
  std::vector<GrowingSize> sources = feature_sources(pslg, lines, edges, std::min(goal.grading, 1 / edges), threads);
  if (goal.grading < INFINITY) {
    const std::vector<GrowingSize> lengths = segment_sources(pslg, lines, goal.grading);
    sources.insert(sources.end(), lengths.begin(), lengths.end());
    for (const SizeSource& source : goal.sources) sources.push_back({source, goal.grading});
  }
  const Box box = bounding_box(threads, pslg.points.size(), [&](std::size_t i) { return pslg.points[i]; });
  GradedValues values{local_bound(goal.size, goal.size_slope), SizeEnvelope(sources, box, threads)};
  return OnBackground<GradedValues>{std::make_shared<const GradedValues>(std::move(values))};
}

}  // namespace pardel::engine
