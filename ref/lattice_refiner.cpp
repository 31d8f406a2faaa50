#include "lattice_refiner.hpp"

#include <algorithm>

#include "independent.hpp"
#include "insertion.hpp"
#include "ruppert.hpp"

namespace pardel::ref {
namespace {

/// The data that the phases of a sweep share.
struct Work {
  Refinement& state;
  Criteria& criteria;
  const Lattice& lattice;
};

/// In a phase, only cells of its colour insert points [CC].
bool is_at_work(const Cell& cell, const Phase& phase) { return colour_of(cell) == phase.colour; }

/// Records the triangles and vertices that inserting p uses; returns the cavity of p.
std::vector<Index> touch(Touched& touched, const PlainMesh& mesh, const ExactPoint& p) {
  const std::vector<Index> hole = cavity(mesh, p);
  touched.vertices.merge(closure(mesh, hole));
  std::set<Edge> rim;
  for (const Edge& e : boundary(mesh, hole)) rim.insert(edge(e[0], e[1]));
  for (Index t : hole) touched.triangles.insert(mesh.triangles[t]);
  for (const Corners& t : mesh.triangles)
    for (int i = 0; i < 3; ++i)
      if (rim.contains(edge_of(t, i))) touched.triangles.insert(t);
  return hole;
}

/// Requests a split of the subsegment e, because the cell `from` found that e must be split. The cell that contains the
/// midpoint inserts it. If this is another cell, the subsegment is handed on to that cell.
void hand_on(const Work& work, Phase& phase, const Cell& from, const Edge& e) {
  if (work.state.waiting.contains(e)) return;
  request_split(work.state, e);
  const ExactPoint middle = work.state.waiting.at(e);
  const Cell to = cell_of(work.lattice, middle);
  if (to == from) return;
  phase.handed_on.push_back({from, to, middle});
}

/// The next point to insert for each working cell that has one: the midpoint of a subsegment that waits for its split,
/// or else the circumcentre of a bad triangle, if it encroaches upon no subsegment. All points are found in one mesh.
std::map<Cell, ExactPoint> candidates(const Work& work, Phase& phase) {
  const PlainMesh& mesh = work.state.mesh;
  std::map<Cell, ExactPoint> found;
  const auto offer = [&](const ExactPoint& middle) {
    const Cell cell = cell_of(work.lattice, middle);
    if (is_at_work(cell, phase)) found.try_emplace(cell, middle);
  };
  for (const auto& [e, middle] : work.state.waiting) offer(middle);

  for (const Corners& t : mesh.triangles) {
    const std::optional<ExactPoint>& centre = work.criteria.split_point(mesh, t);
    if (!centre) continue;
    // A bad triangle is split in the phase of the cell that contains its circumcentre.
    const Cell cell = cell_of(work.lattice, *centre);
    if (!is_at_work(cell, phase) || found.contains(cell)) continue;
    // If a subsegment hides the circumcentre from its triangle, some subsegment is encroached and already waits for its
    // split (THEORY.md, Lemma 7).
    if (!circumdisk_contains(mesh, t, *centre) || !sees(mesh, *centre, t)) continue;
    const std::vector<Edge> upon = encroached_by(mesh, *centre);
    if (upon.empty()) {
      found.emplace(cell, *centre);
      continue;
    }
    const auto waits = [&](const Edge& e) { return work.state.waiting.contains(e); };
    if (!std::ranges::all_of(upon, waits)) touch(phase.touched[cell], mesh, *centre);
    for (const Edge& e : upon) hand_on(work, phase, cell, e);
    for (const Edge& e : upon)
      if (waits(e)) offer(work.state.waiting.at(e));
  }
  return found;
}

enum class Round : std::uint8_t {
  nothing_left,  ///< no working cell has a candidate
  inserted,      ///< points were inserted
  outgrown,      ///< points were inserted, and a new circumradius is too large for the cells
};

/// Every working cell that has a candidate inserts it; all insertions are independent.
Round insert_round(const Work& work, Phase& phase) {
  Refinement& state = work.state;
  const std::map<Cell, ExactPoint> found = candidates(work, phase);
  if (found.empty() || state.failure) return Round::nothing_left;

  std::vector<ExactPoint> points;
  std::vector<std::optional<Edge>> splits;
  std::set<Index> deleted;
  for (const auto& [cell, p] : found) {
    points.push_back(p);
    splits.push_back(constraint_through(state.mesh, p));
    phase.insertions.push_back({cell, p});
    for (Index t : touch(phase.touched[cell], state.mesh, p))
      if (!deleted.insert(t).second) state.failure = Error{ErrorKind::invalid_input, "Two cells met in one triangle."};
  }
  if (state.failure) return Round::nothing_left;  // the result would not be a mesh
  const auto first = static_cast<Index>(state.mesh.points.size());
  state.mesh = insert_independently(state.mesh, points);

  for (Index k = 0; k < points.size(); ++k) record_origin(state, first + k, splits[k]);
  for (Index k = 0; k < points.size(); ++k) {
    if (!splits[k]) continue;  // inserted circumcentres encroach upon nothing
    for (const Edge& e : newly_encroached(state, first + k)) hand_on(work, phase, cell_of(work.lattice, points[k]), e);
  }

  const auto fits = [&](const Corners& t) { return allows(work.lattice, squared_circumradius(state.mesh, t)); };
  const auto is_new = [&](const Corners& t) { return std::ranges::any_of(t, [&](Index v) { return v >= first; }); };
  const bool all_fit =
      std::ranges::all_of(state.mesh.triangles, [&](const Corners& t) { return !is_new(t) || fits(t); });
  return all_fit ? Round::inserted : Round::outgrown;
}

/// Runs one phase per colour; stops early if the cells are too small for a new circumradius.
Sweep run_sweep(const Work& work) {
  Sweep sweep{work.lattice, {}};
  for (const Colour& colour : all_colours) {
    Phase phase{colour, {}, {}, {}, {}};
    Round round = Round::inserted;
    while (round == Round::inserted) round = insert_round(work, phase);
    phase.after = work.state.mesh;
    sweep.phases.push_back(std::move(phase));
    if (round == Round::outgrown) break;
  }
  return sweep;
}

bool did_nothing(const Sweep& sweep) {
  return std::ranges::all_of(sweep.phases, [](const Phase& phase) { return phase.insertions.empty(); });
}

}  // namespace

Result<LatticeRefinement> refine_on_lattice(const Pslg& pslg, const Goal& goal, const Goal& coarse) {
  for (const Goal& asked : {goal, coarse})
    if (auto error = unsupported(pslg, asked)) return *error;
  Refinement state = conforming_delaunay(pslg);
  Criteria coarse_criteria(pslg, coarse, state.mesh), criteria(pslg, goal, state.mesh);
  refine_sequentially(state, coarse_criteria);
  if (state.failure) return *state.failure;

  LatticeRefinement result;
  result.preprocessed = state.mesh;
  Lattice lattice = lattice_over(state.mesh);
  do {
    result.sweeps.push_back(run_sweep({state, criteria, lattice}));
    if (state.failure) return *state.failure;
    if (!allows(lattice, squared_circumradius_bound(state.mesh))) lattice = lattice_over(state.mesh);
  } while (!did_nothing(result.sweeps.back()) || !state.waiting.empty());

  if (std::ranges::any_of(state.mesh.triangles,
                          [&](const Corners& t) { return criteria.split_point(state.mesh, t).has_value(); }))
    return Error{ErrorKind::invalid_input, "A circumcentre is not representable inside the domain."};
  result.mesh = to_mesh(state.mesh, state.provenance, pslg);
  return result;
}

}  // namespace pardel::ref
