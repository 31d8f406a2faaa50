// Sweeps over the cells of a division, as in the paper: a sweep has one phase per colour, and in a phase all cells of
// the colour are refined at the same time, each by its own task.
//
// Source: [CC] A. N. Chernikov, N. P. Chrisochoides, "Parallel guaranteed quality planar Delaunay mesh generation by
// concurrent point insertion", 2004: cells, colours, and the exchange after each phase.
#pragma once

#include "../workers/phase.hpp"
#include "../workers/problem.hpp"
#include "task.hpp"

namespace pardel::schemes::cells {

/// The order in which simulated tasks of a phase take their steps. No result may depend on it.
enum class Turns {
  one_after_the_other,  ///< each cell is refined to the end, as with a sequential mesher in each cell
  in_rounds,            ///< each cell inserts one point in each round
};

/// What happened in a phase, for tests.
struct PhaseRecord {
  const Division& division;
  const LinkedMesh& mesh;  ///< after the phase
  std::size_t sweep = 0;   ///< counted from 0
  int colour = 0;
  bool ends_sweep = false;  ///< the division does not allow a new circumdisk
  std::uint64_t insertions = 0;
  std::vector<std::pair<Index, Touched>> touched;    ///< by the cells that worked
  std::vector<std::array<Index, 2>> handed_on = {};  ///< from a cell to a cell
};
using Watch = std::function<void(const PhaseRecord&)>;

/// A refinement in cells, between two sweeps.
struct Refinement {
  const Problem& problem;
  Start start;  ///< mesh, bounds, and the account so far
  Turns turns = Turns::one_after_the_other;
  Watch watch{};
  std::vector<Waiting> waiting{};   ///< needs work in the present division
  std::vector<Waiting> later{};     ///< needs work in a later division
  std::vector<Waiting> left_box{};  ///< its insertion leaves the box of its cell
  std::size_t sweeps = 0;
  bool is_outgrown = false;         ///< the last sweep ended early
  std::vector<std::size_t> seen{};  ///< of each triangle: the phase whose end has seen it
};

/// Puts all triangles that need work to `waiting`.
void assess_all(Refinement& r);

/// Runs a sweep, or a part of it: it ends after a phase that made a triangle whose circumdisk the division does not
/// allow. Returns the number of insertions. The account has work, messages, rounds and barriers; measuring circumradii
/// is not counted.
///
/// Messages of a phase: a cell's worker sends each worker of a touching cell the new triangles with a corner in the box
/// of that cell, and each worker what it hands on to his cells.
std::uint64_t sweep(Refinement& r, const Division& division);

/// Sweeps until nothing waits. `divide`: makes the division for a sweep; called again if a sweep has ended early, or
/// has inserted more than `growth` times as many points as there were. What still waits after two sweeps without an
/// insertion cannot be split because of rounding. Returns the last division.
Division sweep_to_fixpoint(Refinement& r, const std::function<Division()>& divide, double growth);

/// The largest number of triangles that a worker holds: those with a corner in the box of one of its cells.
[[nodiscard]] std::uint64_t most_held(const LinkedMesh& mesh, const Division& division, int workers);

/// The mesh without unused triangles, with the number of insertions; an Error if it has too many points.
[[nodiscard]] Result<Outcome> outcome_of(Refinement&& r);

}  // namespace pardel::schemes::cells
