// The part of one rank in a refinement by several ranks.
#pragma once

#include <optional>

#include "../scheduling/partners.hpp"
#include "held_part.hpp"
#include "ownership.hpp"

namespace pardel::engine {

/// The Partners of a refinement. After the refinement, it tells which rank has which triangles.
class Distribution : public Partners {
 public:
  /// `t`: the triangulation that is refined.
  Distribution(Ranks& ranks, Triangulation& t) : ranks_(ranks), t_(t) {}

  void divide(const Tiles& tiles, std::span<const double> work, PhaseRunner& runner) override;
  [[nodiscard]] bool is_at_home(TriangleId id) const override { return owner_of(t_.slots[id].v[0]) == ranks_.rank(); }
  [[nodiscard]] bool is_first() const override { return ranks_.rank() == 0; }
  [[nodiscard]] int ranks() const override { return ranks_.count(); }
  void add_up(std::span<std::uint64_t> values) override { ranks_.add_up(values); }
  void deliver(std::vector<PlannedTask>& tasks) override;
  void exchange_changes(std::vector<PlannedTask>& tasks) override;
  void refine_rest(std::span<const QueuedTriangle> rest, const RefineExcerpt& refine) override;
  void finish() override { part_->finish(); }

  // After divide():
  [[nodiscard]] Ranks& network() const { return ranks_; }
  [[nodiscard]] const Ownership& ownership() const { return *ownership_; }
  [[nodiscard]] const HeldPart& part() const { return *part_; }
  [[nodiscard]] Index cell_of(VertexId v) const { return ownership_->cell_of(t_.points[v]); }
  /// The rank that owns a vertex: the owner of its cell.
  [[nodiscard]] int owner_of(VertexId v) const { return ownership_->owner(cell_of(v)); }
  /// What all ranks had in common at the division: the number of vertices, and the indices below it that no vertex had.
  [[nodiscard]] Index common_vertices() const { return part_->common().vertices; }
  [[nodiscard]] const std::vector<IndexRange>& unused_common() const { return unused_common_; }
  /// The vertices that the tasks of a cell have inserted, in the order of the insertions.
  struct Insertions {
    Index cell;
    IndexRange vertices;
  };
  /// Of this rank; in the order of the phases.
  [[nodiscard]] std::span<const Insertions> insertions() const { return insertions_; }
  /// The vertices that refine_rest() has inserted, as the first rank has named them; in the order of coordinates, on
  /// the first rank only.
  [[nodiscard]] std::span<const Name> inserted_in_excerpt() const { return inserted_in_excerpt_; }
  /// True if all that the tasks of the cell insert lies in cells of this rank.
  [[nodiscard]] bool is_interior(Index cell) const { return other_watchers_[cell].empty(); }
  /// The rank to whose piece a triangle belongs: the owner of its lexicographically least corner.
  [[nodiscard]] int owner_of_triangle(TriangleId id) const;

 protected:
  /// Who owns the cells. The refinement works with any owners; the numbers of vertices in a piece follow the curve.
  [[nodiscard]] virtual Ownership ownership_of(const Tiles& tiles, std::span<const double> work) const {
    return {tiles, work_of_tasks(tiles, work), ranks_.count()};
  }

 private:
  /// For each rank: triangles, and the names of slots whose triangles it no longer holds.
  struct Outgoing {
    std::vector<TriangleId> triangles;
    std::vector<Name> dropped;
  };
  [[nodiscard]] bool is_held_by(int rank, const Triangulation& t, TriangleId id) const;
  [[nodiscard]] std::vector<Ranks::Bytes> exchange(std::vector<Writer>& messages);
  void receive(const std::vector<Ranks::Bytes>& messages);
  [[nodiscard]] std::vector<Ranks::Bytes> excerpt_around(std::span<const Index> cells, unsigned reach, bool& is_all);
  [[nodiscard]] bool refine_excerpt(const std::vector<Ranks::Bytes>& excerpt, std::span<const Name> names,
                                    const RefineExcerpt& refine, std::vector<Writer>& messages);

  Ranks& ranks_;
  Triangulation& t_;
  std::optional<Ownership> ownership_;
  std::optional<HeldPart> part_;
  std::vector<IndexRange> unused_common_;
  std::vector<Insertions> insertions_;
  std::vector<Name> inserted_in_excerpt_;
  std::vector<std::vector<int>> other_watchers_;  ///< per cell: Ownership::watchers_of_box() without this rank
};

}  // namespace pardel::engine
