// The simulation of a run: what each of many ranks computes, and what they send to each other, step by step.
#pragma once

#include <cstdint>
#include <vector>

#include "network.hpp"

namespace pardel::bench {

/// A call in which all ranks communicate (core/ranks.hpp), and the work of each rank before it.
struct Step {
  enum class Kind : std::uint8_t {
    sum,       ///< add_up() of a few values
    cell_sum,  ///< add_up() of a value for each cell
    rank_sum,  ///< add_up() of a value for each rank
    gaps,      ///< exchange() of the gaps of the input, which are few or none
    seeds,     ///< exchange() of the triangles with which tasks start
    changes,   ///< exchange() of the changed triangles, once per phase
    piece,     ///< exchange() in which every rank asks every other one about vertices
  };
  Kind kind = Kind::sum;
  std::uint64_t bytes = 0;  ///< of a sum: the length of the list of values
  // Per rank, or empty for none:
  std::vector<double> work = {};       ///< processor seconds before the step that the ranks share
  std::vector<double> selection = {};  ///< processor seconds to find what has to be sent
  std::vector<Traffic> traffic = {};   ///< of an exchange; none: all messages are empty

  [[nodiscard]] bool is_sum() const { return kind <= Kind::rank_sum; }
};

/// The steps of more ranks, each of which does what one of the traced ranks did: for meshes that are too large for this
/// machine, with as many triangles per rank. `cells`: of the larger mesh.
[[nodiscard]] std::vector<Step> repeated(const std::vector<Step>& steps, int traced_ranks, int ranks,
                                         std::uint64_t cells);

/// What every rank has to do, whatever its share: in processor seconds.
struct RankCosts {
  double before = 0;      ///< input, triangulation and coarse levels: alike on all ranks
  double divide = 0;      ///< who owns what, and removal of what the rank does not hold
  double phase = 0;       ///< a phase without tasks
  double write_byte = 0;  ///< to write a byte of a message of changed triangles
  double read_byte = 0;   ///< to read it, and to link the triangles
};

/// The time of a run, and its parts. The parts are means over ranks; they add up to `seconds`.
struct Prediction {
  double seconds = 0;
  double before = 0;         ///< RankCosts::before
  double divide = 0;         ///< RankCosts::divide
  double phases = 0;         ///< RankCosts::phase, in all phases
  double work = 0;           ///< Step::work
  double messages = 0;       ///< to select, to write and to read what is sent
  double waiting = 0;        ///< for ranks with more work
  double announcements = 0;  ///< in the network: who will send how much to whom (MPI_Alltoall)
  double sums = 0;           ///< in the network: MPI_Allreduce
  double transfer = 0;       ///< in the network: the messages

  [[nodiscard]] double network() const { return announcements + sums + transfer; }
};

/// Gives each rank a clock. A rank that communicates waits for the last one, since all exchanges begin with an
/// MPI_Alltoall. O(ranks * steps).
[[nodiscard]] Prediction simulate(int ranks, const std::vector<Step>& steps, const RankCosts& costs,
                                  const Network& network);

}  // namespace pardel::bench
