#include "exemptions.hpp"

#include "../triangulation/held.hpp"
#include "assessor.hpp"
#include "insertion.hpp"

namespace pardel::engine {

std::vector<Exemption> exemptions(Triangulation& t, const DomainSegments& segments, const Criteria& criteria,
                                  const Options& options, bool budget_reached, const Threads& threads,
                                  const std::function<bool(TriangleId)>& counts, std::vector<TriangleId>* undecided) {
  const Assessor assessor(t, segments, criteria, options);
  Insertion insertion(t, criteria, options.min_edge);
  const Box everywhere;
  LocalHints hints;
  const auto reason_of = [](Outcome outcome) {
    return outcome == Outcome::too_close ? ExemptReason::min_edge : ExemptReason::precision;
  };
  const auto why_edge_not_split = [&](EdgeRef e) {
    if (assessor.forbidden(e)) return ExemptReason::kept_segment;
    if (assessor.below_floor(e)) return ExemptReason::min_edge;
    return reason_of(insertion.try_on_edge(assessor.point_on(e), e, everywhere));
  };
  const auto why_not_split = [&](TriangleId id) -> Exemption {
    const Shape shape(t, t.slots[id]);
    const unsigned side = assessor.non_delaunay_side(id);
    if (side == 3 && !assessor.too_large(id, hints))
      if (const auto small = small_angle(t, segments, t.slots[id], shape))
        return {id, small->reason, small->apex, small->angle_deg};
    if (budget_reached) return {id, ExemptReason::budget};
    if (side < 3) return {id, why_edge_not_split(EdgeRef(id, side))};
    if (shape.shortest_squared() < options.min_edge * options.min_edge) return {id, ExemptReason::min_edge};
    const Point p = criteria.split_point(shape, assessor.region_of(id));
    const Outcome outcome = insertion.try_in_face(p, id, everywhere);
    return {id, outcome == Outcome::encroaches ? why_edge_not_split(insertion.blocker()) : reason_of(outcome)};
  };
  std::vector<Exemption> result;
  SparseAsk ask(threads.stop);
  for (TriangleId id = 0; id < t.slots.size(); ++id) {
    ask();
    if (counts && !counts(id)) continue;
    bool is_decided = false;
    try {
      const bool breaks_goal = assessor.breaks_goal(id, hints);
      is_decided = true;
      if (breaks_goal) result.push_back(why_not_split(id));
    } catch (const NotHeld&) {
      if (is_decided || undecided == nullptr)
        result.push_back({id, ExemptReason::precision});
      else
        undecided->push_back(id);
    }
  }
  return result;
}

}  // namespace pardel::engine
