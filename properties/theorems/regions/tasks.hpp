// Two tasks that insert points into one mesh, step by step, in any order; and the hypotheses of T-region
// (properties/THEORY.md).
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

/// A task inserts its points in order. Each insertion has two steps: the first step finds the cavity, the second step
/// replaces the cavity by the fan of the point.
class Task {
 public:
  /// If a box is given, the task hands on every point whose insertion would change a triangle that is not in the box:
  /// it skips the point, which is left to a later task.
  explicit Task(std::vector<Point> points, std::optional<ref::Box> box = {}) : points_(std::move(points)), box_(box) {}

  [[nodiscard]] bool is_done() const { return handed_on_.size() == points_.size(); }

  /// Takes the next step. Precondition: !is_done().
  void step(ref::PlainMesh& mesh);

  /// One entry for each point that was processed so far: true if the point was handed on.
  [[nodiscard]] const std::vector<bool>& handed_on() const { return handed_on_; }
  /// The corners of all triangles that the task removed or made.
  [[nodiscard]] const std::set<Index>& touched() const { return touched_; }

 private:
  void replace_hole(ref::PlainMesh& mesh, const ref::ExactPoint& p);

  std::vector<Point> points_;
  std::optional<ref::Box> box_;
  std::optional<std::vector<ref::Corners>> hole_;  ///< a cavity that was found and not yet replaced
  std::vector<bool> handed_on_;
  std::set<Index> touched_;
};

using Tasks = std::array<Task, 2>;

/// A mesh, independent of the numbering of vertices.
struct MeshAsPoints {
  std::set<std::array<ref::ExactPoint, 3>> triangles;
  std::set<std::array<ref::ExactPoint, 2>> constraints;
  friend bool operator==(const MeshAsPoints&, const MeshAsPoints&) = default;
};
[[nodiscard]] MeshAsPoints as_points(const ref::PlainMesh& mesh);

/// Runs both tasks to the end. While both have steps left, `turn()` returns which takes the next step, 0 or 1.
template <class Either>
void run(ref::PlainMesh& mesh, std::array<Either, 2>& tasks, const std::function<int()>& turn) {
  while (!tasks[0].is_done() || !tasks[1].is_done()) {
    const int wanted = turn();
    tasks[tasks[wanted].is_done() ? 1 - wanted : wanted].step(mesh);
  }
}

/// The result of two tasks.
struct Outcome {
  MeshAsPoints mesh;
  std::array<std::vector<bool>, 2> handed_on;
  friend bool operator==(const Outcome&, const Outcome&) = default;
};

/// Runs both tasks on a copy of the mesh.
[[nodiscard]] Outcome outcome(ref::PlainMesh mesh, Tasks& tasks, const std::function<int()>& turn);
[[nodiscard]] Outcome one_after_the_other(const ref::PlainMesh& mesh, Tasks tasks, int first);
/// Runs both tasks, with alternating steps. If each task has one point, both cavities are found before one is replaced.
[[nodiscard]] Outcome in_turns(const ref::PlainMesh& mesh, Tasks tasks);
/// Runs both tasks, with their steps in random order.
[[nodiscard]] Outcome interleaved(const ref::PlainMesh& mesh, Tasks& tasks, generators::Random& random);

/// Two tasks insert one point each. Do alternating steps and both sequential orders give one mesh?
[[nodiscard]] bool make_one_mesh(const ref::PlainMesh& mesh, Point p, Point q);

template <class Set>
[[nodiscard]] bool are_disjoint(const Set& a, const Set& b) {
  return std::ranges::none_of(a, [&](const auto& each) { return b.contains(each); });
}

/// Hypotheses on two regions, from the strongest to the weakest.
enum class Apart : std::uint8_t {
  vertices_of_disks,   ///< K(L) and K(L') from whole disks have no common vertex
  vertices_in_sight,   ///< K(L) and K(L') from visible parts have no common vertex
  free_edges_in_sight  ///< K(L) and K(L') from visible parts have no common triangle and no common unconstrained edge
};

/// K(L), from whole disks or from visible parts as `how` requires.
[[nodiscard]] std::vector<Index> reach(const ref::PlainMesh& mesh, const ref::Box& region, Apart how);
/// Do K(L) = k and K(L') = l satisfy the hypothesis?
[[nodiscard]] bool are_apart(const ref::PlainMesh& mesh, const std::vector<Index>& k, const std::vector<Index>& l,
                             Apart how);
/// Do two regions that are single points satisfy the hypothesis?
[[nodiscard]] bool are_apart(const ref::PlainMesh& mesh, Point p, Point q, Apart how);
/// Do the cavities of p and q have a common triangle?
[[nodiscard]] bool cavities_meet(const ref::PlainMesh& mesh, Point p, Point q);

}  // namespace pardel::properties
