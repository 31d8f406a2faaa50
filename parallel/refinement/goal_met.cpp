#include "goal_met.hpp"

#include "assessor.hpp"

namespace pardel::engine {

std::optional<std::vector<Exemption>> exemptions_if_met(const Triangulation& t, const DomainSegments& segments,
                                                        const Criteria& criteria, const ExactGoal& goal,
                                                        const Options& options, const Threads& threads) {
  const Assessor assessor(t, segments, criteria, options);
  std::vector<Exemption> exempt;
  LocalHints hints;
  SparseAsk ask(threads.stop);
  for (TriangleId id = 0; id < t.slots.size(); ++id) {
    ask();
    if (!assessor.breaks_goal(id, hints)) continue;
    const auto& v = t.slots[id].v;
    const Point a = t.points[v[0]], b = t.points[v[1]], c = t.points[v[2]];
    if (assessor.non_delaunay_side(id) < 3 || !goal.keeps_sizes(a, b, c)) return {};
    if (goal.keeps_angles(a, b, c)) continue;
    const auto small = small_angle(t, segments, criteria, t.slots[id], Shape(t, t.slots[id]));
    if (!small) return {};
    exempt.push_back({id, small->reason, small->apex, small->angle_deg});
  }
  return exempt;
}

}  // namespace pardel::engine
