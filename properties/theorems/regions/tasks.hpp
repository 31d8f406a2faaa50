// Two tasks at work in one mesh, step by step, in any order; and what keeps them apart (T-region).
#pragma once

#include <algorithm>
#include <array>
#include <functional>
#include <optional>
#include <set>
#include <vector>

#include "../../../ref/region.hpp"
#include "../../domains/generators/random.hpp"
#include "../framework/scene.hpp"

namespace pardel::properties {

/// A task inserts its points in order, each in two steps: it finds the cavity, and later replaces it by triangles
/// around the point.
class Task {
 public:
  /// With a box, hands on what would change triangles that are not the box's own.
  explicit Task(std::vector<Point> points, std::optional<ref::Box> box = {}) : points_(std::move(points)), box_(box) {}

  [[nodiscard]] bool is_done() const { return handed_on_.size() == points_.size(); }

  /// Precondition: not done.
  void step(ref::PlainMesh& mesh);

  /// One for each point so far.
  [[nodiscard]] const std::vector<bool>& handed_on() const { return handed_on_; }
  /// The corners of every triangle that it removed or made.
  [[nodiscard]] const std::set<Index>& touched() const { return touched_; }

 private:
  void replace_hole(ref::PlainMesh& mesh, const ref::ExactPoint& p);

  std::vector<Point> points_;
  std::optional<ref::Box> box_;
  std::optional<std::vector<ref::Corners>> hole_;  ///< found, not yet replaced
  std::vector<bool> handed_on_;
  std::set<Index> touched_;
};

using Tasks = std::array<Task, 2>;

/// What two tasks leave behind, whatever the numbers of the vertices.
struct Outcome {
  std::set<std::array<ref::ExactPoint, 3>> triangles;
  std::set<std::array<ref::ExactPoint, 2>> constraints;
  std::array<std::vector<bool>, 2> handed_on;
  friend bool operator==(const Outcome&, const Outcome&) = default;
};

/// Runs both tasks on a copy of the mesh; `turn()` says which of the two takes the next step while both have some.
[[nodiscard]] Outcome outcome(ref::PlainMesh mesh, Tasks& tasks, const std::function<int()>& turn);
[[nodiscard]] Outcome one_after_the_other(const ref::PlainMesh& mesh, Tasks tasks, int first);
/// In turns: with a point each, both find their cavities before either replaces its own.
[[nodiscard]] Outcome in_turns(const ref::PlainMesh& mesh, Tasks tasks);
[[nodiscard]] Outcome interleaved(const ref::PlainMesh& mesh, Tasks& tasks, generators::Random& random);

/// Two tasks with a point each. Is what they make in turns what either order makes?
[[nodiscard]] bool make_one_mesh(const ref::PlainMesh& mesh, Point p, Point q);

template <class Set>
[[nodiscard]] bool are_disjoint(const Set& a, const Set& b) {
  return std::ranges::none_of(a, [&](const auto& each) { return b.contains(each); });
}

/// Hypotheses about what two regions reach, from the strongest to the weakest.
enum class Apart : std::uint8_t { vertices_of_disks, vertices_in_sight, free_edges_in_sight };

/// K(L), for one of the hypotheses.
[[nodiscard]] std::vector<Index> reach(const ref::PlainMesh& mesh, const ref::Box& region, Apart how);
[[nodiscard]] bool are_apart(const ref::PlainMesh& mesh, const std::vector<Index>& k, const std::vector<Index>& l,
                             Apart how);
/// Are two regions that are single points apart?
[[nodiscard]] bool are_apart(const ref::PlainMesh& mesh, Point p, Point q, Apart how);
/// Do the cavities of p and q have a triangle in common?
[[nodiscard]] bool cavities_meet(const ref::PlainMesh& mesh, Point p, Point q);

}  // namespace pardel::properties
