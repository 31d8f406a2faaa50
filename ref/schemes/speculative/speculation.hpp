// The workers of speculative insertion, as machines that are given one step at a time.
#pragma once

#include "../workers/problem.hpp"
#include "../workers/territory.hpp"
#include "worker.hpp"

namespace pardel::schemes {

/// Who gives up where an insertion meets a triangle that another one holds. An insertion that writes never gives up.
enum class Precedence : std::uint8_t {
  nobody,          ///< whoever meets the lock gives up; some schedules then never end
  lower_worker,    ///< the worker with the higher number
  older_insertion  ///< the insertion that was begun later; one that gave up keeps its age
};

/// Which triangles an insertion takes locks on.
enum class Locked : std::uint8_t {
  cavity_and_ring,  ///< all that it reads or writes: those of the cavity, and those across its boundary
  cavity            ///< too few: two insertions whose cavities touch can both end
};

struct SpeculativeCounts {
  std::uint64_t steps = 0;        ///< of all workers
  std::uint64_t late = 0;         ///< circumcentres that were given up because they encroach
  std::uint64_t taken_away = 0;   ///< set-backs of a worker that held the triangle, not of the one that met it
  std::uint64_t remote_asks = 0;  ///< locks asked for on triangles of others' territories
  std::uint64_t remote_ends = 0;  ///< locks on such triangles that were released
  std::uint64_t handed_on = 0;    ///< bad triangles that went to another worker's queue
};

class Speculation {
 public:
  /// Every bad triangle is in the queue of its owner.
  Speculation(Start start, const Problem& problem, Precedence precedence, Locked locked);

  /// Has the worker neither an insertion nor a bad triangle?
  [[nodiscard]] bool is_idle(int w) const { return !workers_[place(w)].attempt && workers_[place(w)].queue.empty(); }
  /// Are all workers idle?
  [[nodiscard]] bool is_over() const { return pending_ == 0; }
  /// One step: the worker takes a lock on one triangle and reads it, is set back by one that it cannot have, or writes
  /// one triangle. All triangles of an insertion change at its last step; until then nobody else can read them.
  /// Precondition: the worker is not idle.
  void step(int w);

  /// The worker that the worker's next step sets back, itself or another one; no_worker if it sets nobody back.
  /// Precondition: it is not idle.
  [[nodiscard]] int would_set_back(int w) const;
  /// Does the worker's next step change the mesh?
  [[nodiscard]] bool will_change_the_mesh(int w) const {
    const auto& attempt = workers_[place(w)].attempt;
    return attempt && attempt->writes == 1;
  }
  [[nodiscard]] const LinkedMesh& mesh() const { return mesh_; }
  /// The worker that has the lock on t; -1 if nobody has.
  [[nodiscard]] int holder(Index t) const { return t < marks_.size() ? marks_[t].holder : no_worker; }
  /// The triangles on which the worker has locks.
  [[nodiscard]] const std::vector<Index>& held(int w) const { return workers_[place(w)].held; }
  /// When the worker has done its last step, in units of work.
  [[nodiscard]] std::uint64_t clock(int w) const { return workers_[place(w)].clock; }
  [[nodiscard]] const SpeculativeCounts& counts() const { return counts_; }
  [[nodiscard]] std::size_t points() const { return mesh_.points.size(); }

  /// The mesh and its account. Precondition: is_over().
  [[nodiscard]] Outcome outcome() &&;
  [[nodiscard]] const Account& account() const { return account_; }

 private:
  [[nodiscard]] static std::size_t place(int w) { return static_cast<std::size_t>(w); }
  void add_if_bad(int from, Index t, std::uint64_t ready);
  [[nodiscard]] bool wins(std::uint64_t age, int w, int holder) const;
  [[nodiscard]] bool take_lock(int w, Index t);
  void release(int w, const std::vector<Index>& except, bool changed);
  void set_back(int w);
  void give_up(int w);
  void read_first(int w);
  void aim(int w, Point p, std::vector<Index> starts, Side split);
  void expand(int w);
  void complete(int w);
  void write(int w);

  LinkedMesh mesh_;
  Bounds bounds_;
  Account account_;
  Territory territory_;
  Precedence precedence_;
  Locked locked_;
  std::vector<SpeculativeWorker> workers_;
  std::vector<LockMark> marks_;
  std::size_t inputs_, pending_ = 0;
  std::uint64_t begun_ = 0;
  SpeculativeCounts counts_;
};

}  // namespace pardel::schemes
