// Segments that may not be split, chosen by their markers.
#include <algorithm>
#include <vector>

#include "../framework/shares.hpp"
#include "decorated.hpp"

namespace pardel::properties {
namespace {

constexpr int kept_marker = 7;

/// Marks each segment with probability 1/3. Returns true if one was marked.
bool mark_some_segments(Pslg& pslg) {
  bool any = false;
  for (Segment& s : pslg.segments)
    if (*rc::gen::inRange(0, 3) == 0) {
      s.marker = kept_marker;
      any = true;
    }
  pslg.has_segment_markers = true;
  return any;
}

PARDEL_PROPERTY(KeptSegments, are_not_split_and_what_misses_a_bound_for_this_is_listed,
                {.statement = "Choose segments by a marker and keep them, and sometimes the boundary, too. In the mesh "
                              "each of the chosen segments is one edge. The mesh conforms and is constrained "
                              "Delaunay, and each triangle that misses a bound is listed in the report. Two threads "
                              "make the same mesh.",
                 .source = "parallel/options.hpp, Options::kept_markers",
                 .families = every_family}) {
  Problem problem = some_problem(exhibit);
  problem.goal.conforming = false;  // a mesh with segments that may not be split is not Delaunay in general
  const bool any = mark_some_segments(problem.pslg);
  Options options = some_options();
  options.kept_markers = {kept_marker};
  options.no_boundary_splits = *rc::gen::arbitrary<bool>();
  const Meshed result = meshed(problem, exhibit, options);
  const DecoratedProblem drawn{problem, options, {}, {}};
  require_kept_segments(drawn, result);
  require_certified(drawn, result);
  const bool is_missed = result.report.count(ExemptReason::kept_segment) > 0;
  RC_ASSERT(any || options.no_boundary_splits || !is_missed);
  classify(is_missed, "a bound is missed because of a kept segment", 20);
  options.threads = 2;
  RC_ASSERT(value_of(pardel::mesh(problem.pslg, problem.goal, options)).mesh == result.mesh);
}

PARDEL_PROPERTY(KeptSegments, of_other_markers_change_nothing,
                {.statement = "If no segment has a marker that is kept, the mesh is that of a run without kept "
                              "markers, where the interior is refined.",
                 .source = "parallel/options.hpp, Options::kept_markers",
                 .families = every_family}) {
  const Problem problem = some_problem(exhibit);
  Options options = some_options();
  const Mesh plain = meshed(problem, exhibit, options).mesh;
  options.kept_markers = {-kept_marker};
  RC_ASSERT(value_of(mesh(problem.pslg, problem.goal, options)).mesh == plain);
}

PARDEL_PROPERTY(KeptSegments, can_be_all_segments,
                {.statement = "Keeping the markers of all segments is the same as Options::no_segment_splits.",
                 .source = "parallel/options.hpp, Options::kept_markers",
                 .families = every_family}) {
  Problem problem = some_problem(exhibit);
  problem.goal.conforming = false;
  std::set<int> markers{1};  // of unmarked edges on the boundary
  for (const Segment& s : problem.pslg.segments) markers.insert(s.marker);
  Options options = some_options();
  options.kept_markers.assign(markers.begin(), markers.end());
  const Mesh kept = meshed(problem, exhibit, options).mesh;
  options.kept_markers.clear();
  options.no_segment_splits = true;
  RC_ASSERT(value_of(mesh(problem.pslg, problem.goal, options)).mesh == kept);
}

}  // namespace
}  // namespace pardel::properties
