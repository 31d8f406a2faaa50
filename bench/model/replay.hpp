// The run of one process, replayed as if many ranks had made it: who would have sent what to whom.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "../../distributed/meshing/ownership.hpp"
#include "../../distributed/subdomain/subdomain.hpp"
#include "../../parallel/scheduling/phase.hpp"
#include "simulation.hpp"

namespace pardel::bench {

/// The steps of a number of ranks. The engine's own Ownership says who owns and who watches what. Bytes differ from
/// those of a real run in two respects only. Slots of triangles are reused in another order, so other slots are known
/// to other ranks. Messages about gaps of the input count as empty.
class Replay {
 public:
  Replay(const engine::Tiles& tiles, std::span<const double> work, int ranks);

  [[nodiscard]] int ranks() const { return ranks_; }
  [[nodiscard]] const engine::Ownership& ownership() const { return ownership_; }
  [[nodiscard]] const std::vector<Step>& steps() const { return steps_; }
  /// The triangles that all ranks hold at the end, together. Defined after finish().
  [[nodiscard]] std::uint64_t held() const { return held_; }

  void sum(std::size_t values);
  /// The seeds of the tasks travel to the owners of the cells. cell_with(seed): the cell whose owner has it.
  void deliver(const std::vector<engine::PlannedTask>& tasks,
               const std::function<Index(engine::QueuedTriangle)>& cell_with);
  /// The tasks have run, each for so many seconds; what they changed travels. `common`: the slots below this one
  /// existed before the division.
  void exchange_changes(const std::vector<engine::PlannedTask>& tasks, std::span<const double> seconds,
                        const engine::Triangulation& t, engine::TriangleId common);
  /// The ranks make their pieces. `all`: the triangles of the mesh. `inserter`: per vertex, the cell whose task has
  /// inserted it, or no_index.
  void finish(const engine::Triangulation& t, const engine::Subdomain& all, std::span<const Index> inserter);
  /// To be called after finish(): the processor time that one rank would take for the whole mesh. The
  /// ranks take it in proportion to the triangles that they hold.
  void set_piece_seconds(double seconds);

 private:
  using TriangleId = engine::TriangleId;
  struct Message {
    std::vector<TriangleId> triangles;
    std::uint64_t dropped = 0;
  };
  using Pair = std::pair<int, int>;  ///< sender and receiver

  [[nodiscard]] std::vector<int> holders(const engine::Slot& slot, const engine::Triangulation& t) const;
  void add_exchange(Step::Kind kind, std::vector<double> work, const std::map<Pair, std::uint64_t>& bytes);
  void add_exchange_of_all(std::uint64_t least, const std::map<Pair, std::uint64_t>& more);

  int ranks_;
  engine::Ownership ownership_;
  std::vector<std::vector<int>> watchers_;  ///< per cell, as in engine::Distribution, with the owner
  std::vector<bool> is_known_elsewhere_;    ///< per slot
  std::vector<Step> steps_;
  std::size_t first_of_pieces_ = 0;  ///< in steps_, after finish()
  std::uint64_t held_ = 0;
};

}  // namespace pardel::bench
