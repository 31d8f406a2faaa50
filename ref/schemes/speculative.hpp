// Speculative insertion with set-backs: every worker refines its part of the domain at once, without barriers. An
// insertion takes locks on the triangles that it reads, one after the other. If it meets a triangle that another worker
// holds, one of the two is set back: it releases what it holds, and tries again later.
//
// Sources: D. Nave, N. Chrisochoides, L. P. Chew, "Guaranteed-quality parallel Delaunay refinement for restricted
// polyhedral domains", SCG 2002, and Computational Geometry 28, 2004; N. Chrisochoides, D. Nave, "Parallel Delaunay
// mesh generation kernel", International Journal for Numerical Methods in Engineering 58, 2003.
//
// Where an implementer goes wrong: locks on the cavity alone (the triangles around it are read and written, too);
// set-backs after which a lock or a mark remains, or the bad triangle is lost; two workers that set each other back for
// ever, because nothing decides who goes first; an old split of a segment whose triangles were released in between.
//
// Work: one for each triangle that is locked and read, or written. Waste: the work of an insertion that is set back, or
// that finds at the end of its search that it encroaches upon a segment. Messages: a request and an answer for each
// lock on a triangle of another worker's part, one for its release, one for a lock that is taken away, and one for a
// bad triangle that belongs to another worker. Critical path: the latest of the workers' clocks. A clock goes on by one
// with each step, and is set forward to that of the worker which made or released what it takes.
//
// Open in the papers: who gives up (Precedence), when it tries again (here: after all that is in its queue), the order
// of the queue (here: first in, first out), and the speeds of the workers (Schedule).
#pragma once

#include "speculative/speculation.hpp"

namespace pardel::schemes {

/// Which worker is given the next step. Idle workers are passed over.
enum class Schedule : std::uint8_t {
  round_robin,  ///< one after the other
  random,       ///< drawn from the seed of the problem
  adversary     ///< the one that would be set back, else the one with the fewest locks; but nobody waits for ever
};

struct SpeculativeOptions {
  Schedule schedule = Schedule::round_robin;
  Precedence precedence = Precedence::older_insertion;
  Locked locked = Locked::cavity_and_ring;
  /// A run with more steps ends with an Error of kind `resources`.
  std::uint64_t most_steps = 100'000'000'000;
};

/// Errors: those of start_of(), too_many_points(), and too many steps. O(n) time for n steps if the queues are rarely
/// empty; O(n workers) with the adversary.
[[nodiscard]] Result<Outcome> speculative(const Problem& problem, const SpeculativeOptions& options = {});

}  // namespace pardel::schemes
