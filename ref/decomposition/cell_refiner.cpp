#include "cell_refiner.hpp"

#include <algorithm>
#include <functional>

#include "../independent.hpp"
#include "../insertion.hpp"
#include "../ruppert.hpp"

namespace pardel::ref {
namespace {

/// The data that the phases of a sweep share.
template <class Cells>
struct Work {
  Refinement& state;
  Criteria& criteria;
  const Cells& cells;
  const Turns& turns;
};

/// In a phase, only cells of its colour insert points [CC].
template <class Cells>
bool is_at_work(const Cells& cells, const Cell& cell, const Phase& phase) {
  return colour_of(cells, cell) == phase.colour;
}

/// Requests a split of the subsegment e, because the cell `from` found that e must be split. The cell that contains the
/// midpoint inserts it. If this is another cell, the subsegment is handed on to that cell.
template <class Cells>
void hand_on(const Work<Cells>& work, Phase& phase, const Cell& from, const Edge& e) {
  if (work.state.waiting.contains(e)) return;
  request_split(work.state, e);
  const ExactPoint middle = work.state.waiting.at(e);
  const Cell to = cell_of(work.cells, middle);
  if (to == from) return;
  phase.handed_on.insert({from, to, middle});
}

/// The points that a cell may have to insert.
struct Candidates {
  std::set<ExactPoint> midpoints;              ///< of subsegments that wait for their split
  std::multimap<ExactPoint, Corners> centres;  ///< the circumcentres of bad triangles, with the triangles
};

template <class Cells>
std::map<Cell, Candidates> candidates(const Work<Cells>& work, const Phase& phase) {
  const PlainMesh& mesh = work.state.mesh;
  std::map<Cell, Candidates> found;
  for (const auto& [e, middle] : work.state.waiting)
    if (const Cell cell = cell_of(work.cells, middle); is_at_work(work.cells, cell, phase))
      found[cell].midpoints.insert(middle);
  for (const Corners& t : mesh.triangles) {
    const std::optional<ExactPoint>& centre = work.criteria.split_point(mesh, t);
    if (!centre) continue;
    // A bad triangle is split in the phase of the cell that contains its circumcentre.
    const Cell cell = cell_of(work.cells, *centre);
    if (is_at_work(work.cells, cell, phase)) found[cell].centres.emplace(*centre, t);
  }
  return found;
}

bool meets_circumdisk(const PlainMesh& mesh, const Corners& t, const Edge& e) {
  const Kernel::Segment_2 segment(mesh.points[e[0]], mesh.points[e[1]]);
  return CGAL::squared_distance(circumcentre(mesh, t), segment) < squared_circumradius(mesh, t);
}

/// Must the bad triangle t wait until another cell has split a subsegment? Ruppert's algorithm splits all subsegments
/// before it looks at a triangle: then no vertex, seen or not, lies in the circumdisk (THEORY.md, Lemma 7). Here it is
/// enough that none of the subsegments that wait meets the circumdisk. Those that other cells found in this phase are
/// not asked, because the answer would depend on the order of the cells.
template <class Cells>
bool must_wait(const Work<Cells>& work, const Phase& phase, const Cell& cell, const Corners& t) {
  const PlainMesh& mesh = work.state.mesh;
  return std::ranges::any_of(work.state.waiting, [&](const auto& split) {
    const Edge& e = split.first;
    const bool is_known = phase.waiting_before.contains(e) ||
                          phase.handed_on.contains({cell, cell_of(work.cells, split.second), split.second});
    return is_known && meets_circumdisk(mesh, t, e);
  });
}

/// One step of Ruppert's loop in a cell: the point that the cell inserts, if it has one. It is a midpoint, or else a
/// circumcentre that encroaches upon no subsegment.
template <class Cells>
std::optional<ExactPoint> next_point(const Work<Cells>& work, Phase& phase, const Cell& cell, Candidates found) {
  const PlainMesh& mesh = work.state.mesh;
  if (!found.midpoints.empty()) return *found.midpoints.begin();
  for (const auto& [centre, t] : found.centres) {
    if (!circumdisk_contains(mesh, t, centre) || must_wait(work, phase, cell, t)) continue;
    const std::vector<Edge> upon = encroached_by(mesh, centre);
    // A subsegment that hides the centre from t is encroached by the centre, or waits (THEORY.md, Lemma 7).
    if (upon.empty() && !sees(mesh, centre, t)) continue;
    if (upon.empty()) return centre;
    const auto waits = [&](const Edge& e) { return work.state.waiting.contains(e); };
    if (!std::ranges::all_of(upon, waits)) record_touched(phase.touched[cell], mesh, centre);
    for (const Edge& e : upon) hand_on(work, phase, cell, e);
    for (const Edge& e : upon)
      if (waits(e) && cell_of(work.cells, work.state.waiting.at(e)) == cell)
        found.midpoints.insert(work.state.waiting.at(e));
    if (!found.midpoints.empty()) return *found.midpoints.begin();
  }
  return std::nullopt;
}

/// Inserts one point in each cell; all insertions are independent.
template <class Cells>
void insert_at_once(const Work<Cells>& work, Phase& phase, const std::map<Cell, ExactPoint>& points_of) {
  Refinement& state = work.state;
  std::vector<ExactPoint> points;
  std::vector<std::optional<Edge>> splits;
  std::set<Index> deleted;
  for (const auto& [cell, p] : points_of) {
    points.push_back(p);
    splits.push_back(constraint_through(state.mesh, p));
    phase.insertions.push_back({cell, p});
    for (Index t : record_touched(phase.touched[cell], state.mesh, p))
      if (!deleted.insert(t).second) state.failure = Error{ErrorKind::internal, "Two cells met in one triangle."};
  }
  if (state.failure) return;  // the result would not be a mesh
  const auto first = static_cast<Index>(state.mesh.points.size());
  state.mesh = insert_independently(state.mesh, points);

  for (Index k = 0; k < points.size(); ++k) record_origin(state, first + k, splits[k]);
  for (Index k = 0; k < points.size(); ++k) {
    if (!splits[k]) continue;  // inserted circumcentres encroach upon nothing
    for (const Edge& e : newly_encroached(state, first + k)) hand_on(work, phase, cell_of(work.cells, points[k]), e);
  }
}

/// The cells of the colour work until none of them has a point to insert. A cell that has finished stays idle: the
/// others make no work for it (THEORY.md, Lattice).
template <class Cells>
Phase run_phase(const Work<Cells>& work, int colour) {
  Phase phase;
  phase.colour = colour;
  for (const auto& [e, middle] : work.state.waiting) phase.waiting_before.insert(e);
  std::set<Cell> unfinished;
  for (const auto& [cell, found] : candidates(work, phase)) unfinished.insert(cell);
  while (!unfinished.empty() && !work.state.failure) {
    std::map<Cell, Candidates> found = candidates(work, phase);
    std::map<Cell, ExactPoint> points_of;
    for (const Cell& cell : work.turns(unfinished))
      if (const auto p = next_point(work, phase, cell, std::move(found[cell])))
        points_of.emplace(cell, *p);
      else
        unfinished.erase(cell);
    insert_at_once(work, phase, points_of);
  }
  phase.after = work.state.mesh;
  return phase;
}

/// Runs one phase per colour; stops early if the cells are too small for a new circumradius.
template <class Cells>
Sweep<Cells> run_sweep(const Work<Cells>& work) {
  Sweep<Cells> sweep{work.cells, {}};
  for (int colour = 0; colour < colours(work.cells) && !work.state.failure; ++colour) {
    sweep.phases.push_back(run_phase(work, colour));
    if (!allows(work.cells, work.state.mesh)) break;
  }
  return sweep;
}

template <class Cells>
bool did_nothing(const Sweep<Cells>& sweep) {
  return std::ranges::all_of(sweep.phases, [](const Phase& phase) { return phase.insertions.empty(); });
}

/// `first_cells` makes the cells for the preprocessed mesh.
template <class Cells>
Result<CellRefinement<Cells>> refine_on(const std::function<Cells(const PlainMesh&)>& first_cells, const Pslg& pslg,
                                        const Goal& goal, const Goal& coarse, const Turns& turns) {
  for (const Goal& asked : {goal, coarse})
    if (auto error = unsupported(pslg, asked)) return *error;
  Refinement state = conforming_delaunay(pslg);
  Criteria coarse_criteria(pslg, coarse, state.mesh), criteria(pslg, goal, state.mesh);
  refine_sequentially(state, coarse_criteria);
  if (state.failure) return *state.failure;

  CellRefinement<Cells> result;
  result.preprocessed = state.mesh;
  Cells cells = first_cells(state.mesh);
  do {
    result.sweeps.push_back(run_sweep(Work<Cells>{state, criteria, cells, turns}));
    if (state.failure) return *state.failure;
    cells = cells_after(cells, state.mesh);
  } while (!did_nothing(result.sweeps.back()) || !state.waiting.empty());

  if (std::ranges::any_of(state.mesh.triangles,
                          [&](const Corners& t) { return criteria.split_point(state.mesh, t).has_value(); }))
    return Error{ErrorKind::invalid_input, "A circumcentre is not representable inside the domain."};
  result.mesh = to_mesh(state.mesh, state.provenance, pslg);
  return result;
}

}  // namespace

std::vector<Index> record_touched(Touched& touched, const PlainMesh& mesh, const ExactPoint& p) {
  std::vector<Index> hole = cavity(mesh, p);
  for (const Index v : closure(mesh, hole)) touched.vertices.insert(mesh.points[v]);
  std::set<Edge> rim;
  for (const Edge& e : boundary(mesh, hole)) rim.insert(edge(e[0], e[1]));
  for (Index t : hole) touched.triangles.insert(mesh.triangles[t]);
  for (const Corners& t : mesh.triangles)
    for (int i = 0; i < 3; ++i)
      if (rim.contains(edge_of(t, i))) touched.triangles.insert(t);
  return hole;
}

Result<LatticeRefinement> refine_on_lattice(const Pslg& pslg, const Goal& goal, const Goal& coarse,
                                            const Turns& turns) {
  const auto over = [](const PlainMesh& mesh) { return lattice_over(mesh); };
  return refine_on<Lattice>(over, pslg, goal, coarse, turns);
}

Result<LatticeRefinement> refine_on_lattice_sized_by(RadiusTheorem theorem, const Pslg& pslg, const Goal& goal,
                                                     const Goal& coarse, const Turns& turns) {
  if (auto error = unsupported(pslg, coarse)) return *error;
  const Result<Number> squared_bound = squared_radius_bound(coarse, theorem);
  if (!squared_bound) return squared_bound.error();
  Lattice lattice = lattice_over(pslg.points, *squared_bound);
  const auto before_a_mesh = [&](const PlainMesh&) { return lattice; };
  Result<LatticeRefinement> result = refine_on<Lattice>(before_a_mesh, pslg, goal, coarse, turns);
  if (!result) return result;
  const auto is_another = [&](const Sweep<Lattice>& sweep) { return sweep.cells.side != lattice.side; };
  if (!allows(lattice, result->preprocessed) || std::ranges::any_of(result->sweeps, is_another))
    return Error{ErrorKind::internal, "A circumradius exceeds the bound of Lattice (f)."};
  return result;
}

Result<QuadtreeRefinement> refine_on_quadtree(const Pslg& pslg, const Goal& goal, const Goal& coarse,
                                              const Turns& turns) {
  return refine_on<Quadtree>(quadtree_over, pslg, goal, coarse, turns);
}

}  // namespace pardel::ref
