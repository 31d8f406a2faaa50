#include "hemmed_in.hpp"

#include "../refinement/assessor.hpp"
#include "../refinement/insertion.hpp"

namespace pardel::engine {

std::vector<TriangleId> hemmed_in(Triangulation& t, const DomainSegments& segments, const Criteria& criteria,
                                  const Options& options, const Threads& threads) {
  const Assessor assessor(t, segments, criteria, options);
  Insertion insertion(t, criteria, options.min_edge);
  const Box everywhere;
  LocalHints hints;
  SparseAsk ask(threads.stop);
  std::vector<TriangleId> result;
  for (TriangleId id = 0; id < t.slots.size(); ++id) {
    ask();
    const Assessment a = assessor.assess_inside(id, hints);
    if (a.need == Assessment::Need::nothing) continue;
    const Outcome outcome = insertion.try_in_face(assessor.point_for(id, a, hints), id, everywhere);
    // A triangle that was left because of a patch can become free again when its surroundings are refined.
    const bool is_free = outcome == Outcome::inserted;
    if (is_free || (outcome == Outcome::encroaches && t.on_border_of_patch(insertion.blocker()))) result.push_back(id);
  }
  return result;
}

}  // namespace pardel::engine
