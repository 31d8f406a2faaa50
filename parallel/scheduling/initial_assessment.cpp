#include "initial_assessment.hpp"

#include <algorithm>
#include <vector>

#include "../quality/estimates.hpp"
#include "../quality/parts.hpp"
#include "../threads/parallel_arrays.hpp"
#include "../threads/parallel_for.hpp"

namespace pardel::engine {
namespace {

/// The least number of triangles by which the bound on angles replaces one triangle of the input.
constexpr double triangles_per_input_triangle = 1.7;

/// So many triangles are announced at once. A few triangles have thousands of parts in all (divisions_for()).
constexpr std::size_t announced_at_once = 1024;

}  // namespace

InitialAssessment assess_all(const Triangulation& t, const Criteria& criteria, const Assessor& assessor,
                             const Threads& threads, const std::function<bool(TriangleId)>& is_counted) {
  const std::size_t count = t.slots.size();
  const std::size_t blocks = block_count(count);
  std::vector<TriangleEstimates> estimates(blocks);
  std::vector<std::vector<Deferred>> bad(blocks);
  std::vector<char> left_alone(blocks, 0);
  const int divisions = divisions_for(criteria, count);
  parallel_blocks(threads, count, [&](std::size_t first, std::size_t last, std::size_t block) {
    LocalHints hints;
    for (std::size_t id = first; id < last; ++id) {
      if (criteria.announces_places() && (id - first) % announced_at_once == 0)
        announce_parts(criteria, t, id, std::min(id + announced_at_once, last), divisions);
      const auto triangle = static_cast<TriangleId>(id);
      if (is_counted && !is_counted(triangle)) continue;
      const Shape shape(t, t.slots[triangle]);
      double wanted = 0;
      visit_parts(shape, divisions, [&](const Shape& part) {
        wanted += criteria.triangles_wanted(part, assessor.region_of(triangle), hints);
      });
      estimates[block].without_angle_bound += estimate(std::max(triangles_per_input_triangle, wanted));
      estimates[block].with_angle_bound += estimate(std::max(criteria.triangles_by_shape(), wanted));
      if (const double needed = criteria.triangles_needed(shape, assessor.region_of(triangle)); needed > 0)
        estimates[block].lower_bound += estimate_below(needed);
      const Assessment a = assessor.assess(triangle, shape, hints);
      if (a.need != Assessment::Need::nothing) bad[block].push_back({assessor.entry(triangle, a), a});
      if (a.left_alone) left_alone[block] = 1;
    }
  });
  InitialAssessment all;
  append_blocks(threads, bad, all.bad);
  all.left_alone = std::any_of(left_alone.begin(), left_alone.end(), [](char c) { return c != 0; });
  for (const TriangleEstimates& block : estimates) {
    all.estimates.without_angle_bound += block.without_angle_bound;
    all.estimates.with_angle_bound += block.with_angle_bound;
    all.estimates.lower_bound += block.lower_bound;
  }
  return all;
}

double overload(const Triangulation& t, const Criteria& criteria, const Assessor& assessor, const Lattice& lattice,
                const Threads& threads) {
  const double twice_cell = 2 * lattice.width() * lattice.height();
  std::vector<double> in_cell(lattice.cells(), 0);
  double all = 0, weighted = 0;  // weighted: the sum over all final triangles of the number in their cells
  LocalHints hints;
  SparseAsk ask(threads.stop);
  const int divisions = divisions_for(criteria, t.slots.size());
  for (TriangleId id = 0; id < t.slots.size(); ++id) {
    ask();
    visit_parts(Shape(t, t.slots[id]), divisions, [&](const Shape& part) {
      const double wanted = criteria.triangles_wanted(part, assessor.region_of(id), hints);
      all += wanted;
      if (part.twice_area > twice_cell)
        weighted += wanted * (wanted * twice_cell / part.twice_area);
      else
        in_cell[lattice.cell_of(part.centroid())] += wanted;
    });
  }
  for (const double wanted : in_cell) weighted += wanted * wanted;
  return all > 0 ? weighted * lattice.cells() / (all * all) : 1;
}

}  // namespace pardel::engine
