// Which triangles of the result break the goal, and why nothing could be done about them.
#include "../scheduling/refine_by_sweeps.hpp"
#include "assessor.hpp"
#include "insertion.hpp"

namespace pardel::engine {

std::vector<Exemption> exemptions(Triangulation& t, const DomainSegments& segments, const Criteria& criteria,
                                  const Options& options, bool budget_reached) {
  const Judge judge(t, segments, criteria, options);
  Insertion insertion(t, criteria, options.min_edge);
  const Box everywhere;
  const auto named = [](Outcome outcome) {
    return outcome == Outcome::too_close ? ExemptReason::min_edge : ExemptReason::precision;
  };
  const auto why_not_split = [&](EdgeRef e) {
    if (judge.forbidden(e)) return ExemptReason::kept_segment;
    if (judge.below_floor(e)) return ExemptReason::min_edge;
    return named(insertion.try_on_edge(judge.point_on(e), e, everywhere));
  };
  const auto why = [&](TriangleId id) -> Exemption {
    const Shape shape(t, t.slots[id]);
    const unsigned side = judge.non_delaunay_side(id);
    if (side == 3 && !judge.too_large(id))
      if (const auto small = small_angle(t, segments, t.slots[id], shape))
        return {id, small->reason, small->apex, small->angle_deg};
    if (budget_reached) return {id, ExemptReason::budget};
    if (side < 3) return {id, why_not_split(EdgeRef(id, side))};
    if (shape.shortest_squared() < options.min_edge * options.min_edge) return {id, ExemptReason::min_edge};
    const Outcome outcome = insertion.try_in_face(criteria.split_point(shape, judge.region_of(id)), id, everywhere);
    return {id, outcome == Outcome::encroaches ? why_not_split(insertion.blocker()) : named(outcome)};
  };
  std::vector<Exemption> result;
  for (TriangleId id = 0; id < t.slots.size(); ++id)
    if (judge.breaks_goal(id)) result.push_back(why(id));
  return result;
}

}  // namespace pardel::engine
