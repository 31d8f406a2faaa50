// Quadtree: refinement of graded meshes on the leaves of a quadtree, by the reference. Leaves outside each other's
// buffer zones do not see each other if circumradii in the buffer zones are small enough.
#include <algorithm>
#include <cmath>
#include <iterator>

#include "../../../ref/independent.hpp"
#include "../../../ref/ruppert.hpp"
#include "../../checker/check.hpp"
#include "../framework/shares.hpp"
#include "graded_channels.hpp"
#include "turns.hpp"

namespace pardel::properties {
namespace {

constexpr const char* families = "channels with edge lengths that grow linearly with the distance from a random point";

using TreeSweep = ref::Sweep<ref::Quadtree>;

/// By definition: is the circumradius of each triangle whose circumdisk meets the leaf below a quarter of its side?
bool is_wide(const ref::Quadtree& tree, const ref::Cell& leaf, const ref::PlainMesh& mesh) {
  const ref::Number quarter = side_of(tree, leaf) / 4, square = quarter * quarter;
  ref::PlainMesh large{mesh.points, {}, {}};  // the few triangles that must not be in reach
  std::ranges::copy_if(mesh.triangles, std::back_inserter(large.triangles),
                       [&](const ref::Corners& t) { return squared_circumradius(mesh, t) >= square; });
  return in_reach_of(large, box_of(tree, leaf)).empty();
}

/// Do all circumdisks of the mesh lie in the square of the tree?
bool holds_all_circumdisks(const ref::Quadtree& tree, const ref::PlainMesh& mesh) {
  return std::ranges::all_of(mesh.triangles, [&](const ref::Corners& t) {
    const ref::ExactPoint centre = circumcentre(mesh, t);
    const auto is_inside = [&](const ref::Number& from_low) {
      const ref::Number margin = std::min(from_low, ref::Number(tree.side - from_low));
      return margin >= 0 && margin * margin >= squared_circumradius(mesh, t);
    };
    return is_inside(centre.x() - tree.corner.x) && is_inside(centre.y() - tree.corner.y);
  });
}

/// The mesh that Ruppert's algorithm makes of a random graded channel.
ref::PlainMesh some_graded_mesh(Exhibit& exhibit) {
  const GradedChannel graded = some_graded_channel(exhibit);
  const auto mesh = ref::ruppert(to_pslg(graded.channel), goal_of(graded));
  RC_ASSERT(mesh.ok());
  exhibit.show(to_pslg(graded.channel), *mesh);
  return ref::to_plain_mesh(*mesh);
}

PARDEL_PROPERTY(
    Quadtree, leaves_of_a_phase_touch_no_common_vertex_if_the_condition_on_circumradii_holds,
    {.statement = "Refine a graded mesh on the leaves of a balanced quadtree, in phases of leaves outside each other's "
                  "buffer zones. When a phase starts, every triangle whose circumdisk meets a leaf of the buffer zone "
                  "of a working leaf has a circumradius below a quarter of that leaf's side. Then the closures of the "
                  "cavities of two leaves of the phase have no common vertex. The checker certifies the mesh.",
     .source = "Chernikov and Chrisochoides 2006, as recalled; properties/THEORY.md, Quadtree",
     .families = families}) {
  const GradedChannel graded = some_graded_channel(exhibit);
  const ref::QuadtreeRefinement refined = refined_in_turns(graded, ref::one_after_the_other);
  exhibit.show(to_pslg(graded.channel), refined.mesh);
  std::size_t at_once = 0;
  bool is_graded = false;
  for_each_phase(refined, [&](const TreeSweep& sweep, const ref::Phase& phase, const ref::PlainMesh& before) {
    std::map<ref::ExactPoint, ref::Cell> leaf_of;
    std::set<int> levels;
    std::set<ref::Cell> zones;
    for (const auto& [leaf, touched] : phase.touched) {
      levels.insert(leaf.level);
      zones.merge(buffer_zone(sweep.cells, leaf));
      for (const ref::ExactPoint& v : touched.vertices) RC_ASSERT(leaf_of.try_emplace(v, leaf).first->second == leaf);
    }
    for (const auto& [leaf, touched] : phase.touched) RC_ASSERT(!zones.contains(leaf));
    for (const ref::Cell& leaf : zones) RC_ASSERT(is_wide(sweep.cells, leaf, before));
    at_once = std::max(at_once, phase.touched.size());
    is_graded |= levels.size() >= 2;
  });
  classify(at_once >= 2, "two or more leaves work at once", 12);
  classify(is_graded, "leaves of different sides work at once", 3);
  const Certificate certificate = check(to_pslg(graded.channel), refined.mesh, goal_of(graded));
  if (!certificate.valid) RC_FAIL(certificate.violations.at(0).message());
  RC_ASSERT(certificate.justified.empty());
}

PARDEL_PROPERTY(
    Quadtree, leaves_of_a_phase_refined_to_the_end_give_one_mesh_in_every_order,
    {.statement = "In a phase on the leaves of a quadtree, each leaf runs Ruppert's loop until it has nothing left to "
                  "insert, and decides anew in each step. The leaves run one after the other in random order, or "
                  "random leaves take each step, or all leaves do. Each order gives the same mesh after each phase.",
     .source = "Chernikov and Chrisochoides 2006, as recalled; properties/THEORY.md, Quadtree",
     .families = families}) {
  const GradedChannel graded = some_graded_channel(exhibit);
  const auto seed = *rc::gen::noShrink(rc::gen::arbitrary<std::uint64_t>()).as("seed of the order");
  const ref::Turns turns = *rc::gen::arbitrary<bool>() ? in_random_order(seed) : interleaved_at_random(seed);
  const ref::QuadtreeRefinement rounds = refined_in_turns(graded, ref::in_rounds);
  const ref::QuadtreeRefinement other = refined_in_turns(graded, turns);
  std::vector<const ref::Phase*> expected;
  for_each_phase(rounds, [&](const auto&, const ref::Phase& phase, const auto&) { expected.push_back(&phase); });
  std::size_t next = 0, at_once = 0;
  for_each_phase(other, [&](const auto&, const ref::Phase& phase, const auto&) {
    RC_ASSERT(next < expected.size());
    RC_ASSERT(triangles_as_points(phase.after) == triangles_as_points(expected[next++]->after));
    at_once = std::max(at_once, phase.touched.size());
  });
  RC_ASSERT(next == expected.size());
  classify(at_once >= 2, "two or more leaves work at once", 12);
}

PARDEL_PROPERTY(
    Quadtree, leaves_outside_each_others_buffer_zones_reach_no_common_vertex,
    {.statement = "In the quadtree over a graded mesh, take two leaves, neither in the buffer zone of the other. A "
                  "triangle whose circumdisk meets one leaf and a triangle whose circumdisk meets the other leaf have "
                  "no common vertex.",
     .source = "Chernikov and Chrisochoides 2006, as recalled; properties/THEORY.md, Quadtree",
     .families = families}) {
  const ref::PlainMesh mesh = some_graded_mesh(exhibit);
  const ref::Quadtree tree = ref::quadtree_over(mesh);
  std::map<ref::Cell, std::set<ref::Cell>> zones;
  std::map<Index, std::set<ref::Cell>> reached_from;
  for (const auto& [leaf, colour] : tree.colour_of_leaf) {
    zones[leaf] = buffer_zone(tree, leaf);
    for (Index t : in_reach_of(mesh, box_of(tree, leaf)))
      for (Index v : mesh.triangles[t]) reached_from[v].insert(leaf);
  }
  for (const auto& [v, leaves] : reached_from)
    for (const ref::Cell& leaf : leaves)
      for (const ref::Cell& other : leaves) RC_ASSERT(leaf == other || zones.at(leaf).contains(other));
  const auto has_a_distant_leaf_of_another_side = [&](const auto& entry) {
    return std::ranges::any_of(zones, [&](const auto& other) {
      return entry.first.level != other.first.level && !entry.second.contains(other.first);
    });
  };
  classify(std::ranges::any_of(zones, has_a_distant_leaf_of_another_side), "leaves of different sides apart", 20);
}

PARDEL_PROPERTY(
    Quadtree, over_a_mesh_is_balanced_and_all_its_leaves_are_wide_enough,
    {.statement = "The quadtree over a mesh covers the mesh with leaves. The sides of leaves that touch differ at most "
                  "by a factor of two. Leaves that touch are in each other's buffer zones. In a tree of several "
                  "leaves, each triangle whose circumdisk meets a leaf has a circumradius below a quarter of its side, "
                  "and all circumdisks lie in the square of the tree.",
     .source = "properties/THEORY.md, Quadtree",
     .families = families}) {
  const ref::PlainMesh plain = some_graded_mesh(exhibit);
  const ref::Quadtree tree = ref::quadtree_over(plain);
  double area = 0;
  std::set<int> levels;
  std::map<ref::Cell, std::set<ref::Cell>> zones;
  for (const auto& [leaf, colour] : tree.colour_of_leaf) zones[leaf] = buffer_zone(tree, leaf);
  for (const auto& [leaf, colour] : tree.colour_of_leaf) {
    const double side = side_of(tree, leaf);
    area += side * side;
    levels.insert(leaf.level);
    RC_ASSERT(cell_of(tree, ref::exact(box_of(tree, leaf).low)) == leaf);
    if (tree.colour_of_leaf.size() > 1) RC_ASSERT(is_wide(tree, leaf, plain));
    const std::set<ref::Cell>& zone = zones.at(leaf);
    for (const auto& [other, of_other] : tree.colour_of_leaf) {
      if (touch(leaf, other)) RC_ASSERT(std::abs(leaf.level - other.level) <= 1 && zone.contains(other));
      RC_ASSERT(!zone.contains(other) || (colour != of_other && zones.at(other).contains(leaf)));
    }
  }
  RC_ASSERT(area == tree.side * tree.side);
  if (tree.colour_of_leaf.size() > 1) RC_ASSERT(holds_all_circumdisks(tree, plain));
  for (const ref::ExactPoint& v : plain.points) RC_ASSERT(contains(box_of(tree, cell_of(tree, v)), v));
  classify(levels.size() >= 2, "leaves of different sides", 20);
  classify(levels.size() >= 3, "leaves of three or more different sides", 5);
}

}  // namespace
}  // namespace pardel::properties
