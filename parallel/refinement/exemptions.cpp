#include "exemptions.hpp"

#include "../triangulation/held.hpp"
#include "assessor.hpp"
#include "insertion.hpp"

namespace pardel::engine {
namespace {

/// Why triangles and edges were not split.
class Reasons {
 public:
  Reasons(Triangulation& t, const DomainSegments& segments, const Criteria& criteria, const Options& options,
          bool budget_reached)
      : t_(t),
        segments_(segments),
        criteria_(criteria),
        budget_reached_(budget_reached),
        assessor_(t, segments, criteria, options),
        insertion_(t, criteria, options.min_edge) {}

  [[nodiscard]] bool breaks_goal(TriangleId id) { return assessor_.breaks_goal(id, hints_); }
  [[nodiscard]] const Assessor& assessor() const { return assessor_; }

  [[nodiscard]] ExemptReason of_edge(EdgeRef e) {
    if (assessor_.forbidden(e)) return ExemptReason::kept_segment;
    if (assessor_.below_floor(e)) return ExemptReason::min_edge;
    const Point p = assessor_.point_on(e);
    if (!assessor_.may_split(e, assessor_.segment_of(e), p)) return ExemptReason::precision;
    return of(insertion_.try_on_edge(p, e, everywhere_));
  }

  [[nodiscard]] Exemption of_triangle(TriangleId id) {
    const Shape shape(t_, t_.slots[id]);
    const unsigned side = assessor_.non_delaunay_side(id);
    if (side == 3 && !assessor_.too_large(id, hints_))
      if (const auto small = small_angle(t_, segments_, criteria_, t_.slots[id], shape))
        return {id, small->reason, small->apex, small->angle_deg};
    if (budget_reached_) return {id, ExemptReason::budget};
    if (side < 3) return {id, of_edge(EdgeRef(id, side))};
    if (assessor_.below_floor(id, shape)) return {id, ExemptReason::min_edge};
    const Point p = criteria_.split_point(shape, assessor_.region_of(id));
    const Outcome outcome = insertion_.try_in_face(p, id, everywhere_);
    return {id, outcome == Outcome::encroaches ? of_edge(insertion_.blocker()) : of(outcome)};
  }

 private:
  [[nodiscard]] static ExemptReason of(Outcome outcome) {
    return outcome == Outcome::too_close ? ExemptReason::min_edge : ExemptReason::precision;
  }

  Triangulation& t_;
  const DomainSegments& segments_;
  const Criteria& criteria_;
  bool budget_reached_;
  Assessor assessor_;
  Insertion insertion_;
  LocalHints hints_;
  Box everywhere_;
};

/// True if a side whose far side is held is not Delaunay. Otherwise lists the sides whose far sides are not held.
bool decided_by_other_sides(const Assessor& assessor, TriangleId id, std::vector<EdgeRef>& undecided) {
  std::vector<EdgeRef> unknown;
  for (unsigned side = 0; side < 3; ++side) {
    const EdgeRef e(id, side);
    try {
      if (assessor.is_non_delaunay_segment(e)) return true;
    } catch (const NotHeld&) {
      unknown.push_back(e);
    }
  }
  undecided.insert(undecided.end(), unknown.begin(), unknown.end());
  return false;
}

}  // namespace

std::vector<Exemption> exemptions(Triangulation& t, const DomainSegments& segments, const Criteria& criteria,
                                  const Options& options, bool budget_reached, const Threads& threads,
                                  const std::function<bool(TriangleId)>& counts, std::vector<EdgeRef>* undecided) {
  Reasons reasons(t, segments, criteria, options, budget_reached);
  const auto breaks_goal = [&](TriangleId id) {
    try {
      return reasons.breaks_goal(id);
    } catch (const NotHeld&) {
      return decided_by_other_sides(reasons.assessor(), id, *undecided);
    }
  };
  std::vector<Exemption> result;
  SparseAsk ask(threads.stop);
  for (TriangleId id = 0; id < t.slots.size(); ++id) {
    ask();
    if ((counts && !counts(id)) || !breaks_goal(id)) continue;
    try {
      result.push_back(reasons.of_triangle(id));
    } catch (const NotHeld&) {
      result.push_back({id, ExemptReason::precision});
    }
  }
  return result;
}

ExemptReason why_not_split(Triangulation& t, const DomainSegments& segments, const Criteria& criteria,
                           const Options& options, EdgeRef side) try {
  return Reasons(t, segments, criteria, options, false).of_edge(side);
} catch (const NotHeld&) {
  return ExemptReason::precision;
}

}  // namespace pardel::engine
