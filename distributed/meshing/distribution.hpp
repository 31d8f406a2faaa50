// The part of one rank in a refinement by several ranks.
#pragma once

#include <optional>

#include "../../parallel/scheduling/communicator.hpp"
#include "../subdomain/subdomain.hpp"
#include "../subdomain/submeshes.hpp"
#include "ownership.hpp"

namespace pardel::engine {

/// The Communicator of a refinement. After the refinement, it tells which rank has which triangles.
class Distribution : public Communicator {
 public:
  /// `t`: the triangulation that is refined. The others belong to the input: for each vertex that is an input point,
  /// its number; the markers of these points, or empty.
  Distribution(Ranks& ranks, Triangulation& t, std::span<const Index> input_of_vertex = {},
               std::span<const int> input_markers = {})
      : ranks_(ranks), t_(t), input_of_vertex_(input_of_vertex), input_markers_(input_markers) {}

  [[nodiscard]] int ranks() const override { return ranks_.count(); }
  void add_up(std::span<std::uint64_t> values) override;
  void add_up_estimates(std::span<double> estimates) override;
  void take_largest(std::span<double> values) override;
  [[nodiscard]] Box bounds_of_all(const Box& here) override { return here; }
  void begin(PhaseRunner& /*runner*/) override {}
  [[nodiscard]] std::function<bool(TriangleId)> counted() const override { return {}; }
  [[nodiscard]] Waiting refine_coarse(const CoarseWork& work) override;
  void divide(const Division& division, PhaseRunner& runner) override;
  void deliver(std::vector<PlannedTask>& tasks) override;
  void exchange_changes(std::vector<PlannedTask>& tasks) override;
  void refine_rest(const RestOfWork& work) override;
  void finish(Triangulation& /*t*/, const PhaseRunner& /*runner*/, const Threads& /*threads*/) override {
    part_->finish();
  }

  /// Divides the tiles among the ranks, and removes what this rank need not hold. Precondition: all ranks have the same
  /// mesh.
  virtual void divide_by(const Tiles& finest, std::span<const double> work, PhaseRunner& runner);
  /// True if no rank has ever had the whole mesh.
  [[nodiscard]] virtual bool is_input_divided() const { return false; }
  /// False as long as all ranks have the same mesh.
  [[nodiscard]] bool is_in_parts() const { return part_.has_value(); }

  // After divide():
  [[nodiscard]] Ranks& network() const { return ranks_; }
  [[nodiscard]] const Ownership& ownership() const { return *ownership_; }
  [[nodiscard]] const Subdomain& part() const { return *part_; }
  [[nodiscard]] Index cell_of(VertexId v) const { return ownership_->cell_of(t_.points[v]); }
  /// The rank that owns a vertex: the owner of its cell.
  [[nodiscard]] int owner_of(VertexId v) const { return ownership_->owner(cell_of(v)); }
  /// What all ranks had in common at the division: the number of vertices, and the indices below it that no vertex had.
  [[nodiscard]] Index common_vertices() const { return part_->common().vertices; }
  [[nodiscard]] const std::vector<IndexRange>& unused_common() const { return unused_common_; }

  /// What a rank knows about points of the input: about the vertices below known_inputs().
  struct InputPoint {
    std::uint64_t number = 0;
    int marker = 0;  ///< 0 if it has none
  };
  [[nodiscard]] virtual Index known_inputs() const { return static_cast<Index>(input_of_vertex_.size()); }
  [[nodiscard]] virtual InputPoint input_point(VertexId v) const {
    const Index input = input_of_vertex_[v];
    return {input, input_markers_.empty() ? 0 : input_markers_[input]};
  }
  /// The number of points of the input, on all ranks.
  [[nodiscard]] virtual std::uint64_t inputs() const { return input_of_vertex_.size(); }
  /// True if a rank can have vertices that are input points and above known_inputs(), with markers.
  [[nodiscard]] virtual bool lacks_markers() const { return false; }
  /// The vertices that the first rank has inserted into a submesh before the division, as it has named them; in the
  /// order of their numbers, on the first rank only. All other vertices from before the division are common or input
  /// points.
  [[nodiscard]] std::span<const Name> inserted_before_division() const { return inserted_before_division_; }
  /// The vertices that the tasks of a cell have inserted, in the order of the insertions.
  struct Insertions {
    Index cell;
    IndexRange vertices;
  };
  /// Of this rank; in the order of the phases.
  [[nodiscard]] std::span<const Insertions> insertions() const { return insertions_; }
  /// The vertices that refine_rest() has inserted, as the first rank has named them; in the order of coordinates, on
  /// the first rank only.
  [[nodiscard]] std::span<const Name> inserted_in_submesh() const { return inserted_in_submesh_; }
  /// True if all that the tasks of the cell insert lies in cells of this rank.
  [[nodiscard]] bool is_interior(Index cell) const { return other_watchers_[cell].empty(); }
  /// The rank to whose piece a triangle belongs: the owner of its lexicographically least corner.
  [[nodiscard]] int owner_of_triangle(TriangleId id) const;

 protected:
  /// Who owns the cells. The refinement works with any owners; the numbers of vertices in a piece follow the curve.
  [[nodiscard]] virtual Ownership ownership_of(const Tiles& tiles, std::span<const double> work) const {
    return {tiles, work_of_tasks(tiles, work), ranks_.count()};
  }

  /// The owners are set. Then the ranks that watch a part of each cell's box are found.
  void set_owners(Ownership ownership);
  [[nodiscard]] bool is_held_by(int rank, const Triangulation& t, TriangleId id) const;

  Ranks& ranks_;
  Triangulation& t_;
  std::optional<Ownership> ownership_;
  std::optional<Subdomain> part_;
  std::vector<Name> inserted_before_division_;

 private:
  /// For one rank: triangles, and the names of slots whose triangles it no longer holds.
  struct Outgoing {
    std::vector<TriangleId> triangles;
    std::vector<Name> dropped;
  };

  std::span<const Index> input_of_vertex_;
  std::span<const int> input_markers_;
  std::vector<IndexRange> unused_common_;
  std::vector<Insertions> insertions_;
  std::vector<Name> inserted_in_submesh_;
  std::vector<std::vector<int>> other_watchers_;  ///< per cell: Ownership::watchers_of_box() without this rank
};

}  // namespace pardel::engine
