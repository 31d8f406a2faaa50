// A task that finds its cavities by walks, as programs do, and that rounds the points at which it splits walls, so that
// walls bend (properties/THEORY.md, T-region-walks).
#pragma once

#include <optional>
#include <set>
#include <vector>

#include "../../../ref/region.hpp"

namespace pardel::properties {

using Triangles = std::set<ref::Corners>;

/// The triangles that can be reached from those of `from`, across free edges, through triangles whose open circumdisks
/// meet the region; with those of `from`. They are closed for the region.
[[nodiscard]] Triangles closed_set(const ref::PlainMesh& mesh, const Triangles& from, const ref::Box& region);

/// A point, or the nearest wall that is to be split at a third of its length, rounded to multiples of 1/8.
struct Wish {
  Point at;
  bool splits = false;
};

/// Fulfils wishes in order, each in two steps: the first finds the triangles to be replaced, the second replaces them.
/// A wish is passed over if its point is not in the region, if no triangle of the set may begin the walk, or if a
/// triangle of the fan is not positively oriented.
class Walker {
 public:
  Walker(ref::Box region, Triangles set, std::vector<Wish> wishes)
      : region_(region), set_(std::move(set)), wishes_(std::move(wishes)) {}

  [[nodiscard]] bool is_done() const { return next_ == wishes_.size(); }
  /// Precondition: !is_done().
  void step(ref::PlainMesh& mesh);

  /// The corners of all triangles that were removed or made.
  [[nodiscard]] const std::set<Index>& touched() const { return touched_; }
  [[nodiscard]] int inserted() const { return inserted_; }
  /// Splits at points that are not exactly on the wall.
  [[nodiscard]] int bends() const { return bends_; }

 private:
  struct Hole {
    ref::ExactPoint p;
    Triangles triangles;
    std::optional<ref::Edge> wall;    ///< the wall that p splits
    std::vector<ref::Edge> boundary;  ///< without the wall; the hole is on the left
  };
  [[nodiscard]] std::optional<Hole> found(const ref::PlainMesh& mesh, const Wish& wish) const;
  [[nodiscard]] std::optional<ref::Edge> nearest_wall(const ref::PlainMesh& mesh, Point at) const;
  void replace(ref::PlainMesh& mesh, const Hole& hole);

  ref::Box region_;
  Triangles set_;
  std::vector<Wish> wishes_;
  std::size_t next_ = 0;
  std::optional<Hole> hole_;  ///< found and not yet replaced
  std::set<Index> touched_;
  int inserted_ = 0, bends_ = 0;
};

}  // namespace pardel::properties
