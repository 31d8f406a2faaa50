#include "overload.hpp"

#include <vector>

namespace pardel::engine {

double overload(const Triangulation& t, const Criteria& criteria, const Assessor& assessor, const Lattice& lattice,
                const Threads& threads) {
  const double twice_cell = 2 * lattice.width() * lattice.height();
  std::vector<double> in_cell(lattice.cells(), 0);
  double all = 0, weighted = 0;  // weighted: the sum over all final triangles of the number in their cells
  LocalHints hints;
  SparseAsk ask(threads.stop);
  for (TriangleId id = 0; id < t.slots.size(); ++id) {
    ask();
    const Shape shape(t, t.slots[id]);
    const double wanted = criteria.triangles_wanted(shape, assessor.region_of(id), hints);
    all += wanted;
    if (shape.twice_area > twice_cell)
      weighted += wanted * (wanted * twice_cell / shape.twice_area);
    else
      in_cell[lattice.cell_of(shape.centroid())] += wanted;
  }
  for (const double wanted : in_cell) weighted += wanted * wanted;
  return all > 0 ? weighted * lattice.cells() / (all * all) : 1;
}

}  // namespace pardel::engine
