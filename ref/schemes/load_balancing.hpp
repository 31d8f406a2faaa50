// Load balancing by tiles that migrate: the domain is a lattice of tiles, the mobile objects of the paper. Workers
// refine the tiles that they have; an idle worker asks another one for some; messages follow tiles that have moved.
//
// Sources: K. Barker, A. Chernikov, N. Chrisochoides, K. Pingali, "A load balancing framework for adaptive and
// asynchronous applications", IEEE TPDS 15(2), 2004; A. Chernikov, N. Chrisochoides, "Parallel guaranteed quality
// planar Delaunay mesh generation by concurrent point insertion", 2004 (the lattice, and colours).
//
// The rule that makes the mesh independent of placement: a tile inserts a point only if the cavity lies within half a
// side around the tile, so tiles of one colour commute; a tile runs only after its neighbours of lower colours, which
// it hears of by messages. What no tile can insert is left to one worker at the end of a level. Each level halves the
// side of the tiles, and refines until circumradii are small enough for the next one.
//
// Where an implementer goes wrong: messages to a tile that has just left; messages that arrive before the tile; an end
// that is announced while a message is in flight; decisions of a tile that depend on triangles out of its reach.
//
// Work: triangles read and written, by tiles; one per item. Waste: what was read for insertions that were left.
// Messages: those for tiles, forwarded ones again; tiles; requests and refusals; the waves that detect the end.
// Critical path: the virtual time, in which a triangle takes one unit and a message `latency` to twice that. Rounds are
// phases, each with one barrier at its end.
//
// Open in the papers: who is asked, how many tiles move, how tiles are placed first, how many tiles there are, how the
// end is detected.
#pragma once

#include "load_balancing/balancer.hpp"
#include "workers/problem.hpp"

namespace pardel::schemes {

/// The worker with which a tile begins.
enum class Placement : std::uint8_t {
  territory,  ///< its owner by expected work
  rows,       ///< equal numbers of tiles, row by row
  one_worker  ///< all tiles begin with worker 0
};

struct LoadBalancingOptions {
  BalancingRules rules;  ///< its seed is added to that of the problem
  Placement placement = Placement::territory;
  double tiles_per_worker = 16;  ///< at least so many on the finest lattice; changes the mesh
  /// Bad triangles wait for the next finer lattice if their circumradius is at most this share of its side. The side of
  /// [CC] is four times the largest circumradius. A larger share leaves more to one worker. Changes the mesh.
  double share_of_side = 0.25;
  int lattice_for_workers = 0;  ///< the lattice is made for so many workers; 0: for those of the problem
  bool traces = false;
};

struct Balanced {
  Outcome outcome;  ///< points that are no inputs, and triangles, are numbered by their places
  BalancingCounts counts;
  std::vector<BalancingTrace> traces;  ///< of the levels, if asked for
};

/// Errors: those of start_of(), and too_many_points(). Typically O(n log n) time for n triangles, and O(log) time for
/// each message.
[[nodiscard]] Result<Balanced> load_balancing_with_counts(const Problem& problem,
                                                          const LoadBalancingOptions& options = {});
[[nodiscard]] Result<Outcome> load_balancing(const Problem& problem, const LoadBalancingOptions& options = {});

}  // namespace pardel::schemes
