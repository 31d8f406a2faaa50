// T-region-walks: cavities are found by walks, and walls may bend. Proof: properties/THEORY.md, T-region-walks.
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>

#include "../../domains/generators/random.hpp"
#include "../framework/property.hpp"
#include "../framework/scene_carving.hpp"
#include "../framework/shares.hpp"
#include "tasks.hpp"
#include "walker.hpp"

namespace pardel::properties {
namespace {
using generators::Random;
using ref::Box;
using ref::PlainMesh;
using Walkers = std::array<Walker, 2>;

/// Runs both tasks on the mesh; `turn` says which of them takes the next step.
MeshAsPoints made_by(PlainMesh& mesh, Walkers& walkers, const std::function<int()>& turn) {
  run(mesh, walkers, turn);
  return as_points(mesh);
}

/// Is no apex of two triangles with a common free edge in the circumdisk of the other one?
bool is_locally_delaunay(const PlainMesh& mesh) {
  std::map<ref::Edge, ref::Corners> left_of;
  for (const ref::Corners& t : mesh.triangles)
    for (int k = 0; k < 3; ++k) left_of[{t[k], t[(k + 1) % 3]}] = t;
  return std::ranges::all_of(left_of, [&](const auto& entry) {
    const ref::Edge& e = entry.first;
    const ref::Corners& t = entry.second;
    const auto other = left_of.find({e[1], e[0]});
    if (other == left_of.end() || mesh.constraints.contains(ref::edge(e[0], e[1]))) return true;
    return std::ranges::none_of(other->second, [&](Index v) { return circumdisk_contains(mesh, t, mesh.points[v]); });
  });
}

/// Are the triangles positively oriented, and does no edge have two triangles on one side?
bool is_oriented(const PlainMesh& mesh) {
  std::set<ref::Edge> directed;
  return std::ranges::all_of(mesh.triangles, [&](const ref::Corners& t) {
    for (int k = 0; k < 3; ++k)
      if (!directed.insert({t[k], t[(k + 1) % 3]}).second) return false;
    return CGAL::orientation(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]) == CGAL::POSITIVE;
  });
}

/// A box of 2 to 12 units around a point of the scene, and what a task wishes there.
struct Plot {
  Box region;
  std::vector<Wish> wishes;
};

Plot some_plot(Random& random, const Scene& scene) {
  // Around the end of a wall, mostly.
  const Point at = scene.walls.empty() || random.chance(4) ? random.one_of(scene.points)
                                                           : scene.points[random.one_of(scene.walls)[0]];
  const int reach = random.between(1, 6);
  Plot plot{{{at.x - reach, at.y - reach}, {at.x + reach, at.y + reach}}, {}};
  for (int wishes = random.between(3, 8); wishes > 0; --wishes) {
    const auto near = [&](double middle) { return middle + random.between(-2 * reach, 2 * reach) / 2.0; };
    plot.wishes.push_back({{near(at.x), near(at.y)}, !random.chance(3)});
  }
  return plot;
}

/// The triangles at the vertex in the middle of the box.
Triangles at_the_middle(const PlainMesh& mesh, const Box& box) {
  const ref::ExactPoint middle((box.low.x + box.high.x) / 2, (box.low.y + box.high.y) / 2);
  Triangles found;
  for (const ref::Corners& t : mesh.triangles)
    if (std::ranges::any_of(t, [&](Index v) { return mesh.points[v] == middle; })) found.insert(t);
  return found;
}

std::set<Index> corners_of(const Triangles& triangles) {
  std::set<Index> corners;
  for (const ref::Corners& t : triangles) corners.insert(t.begin(), t.end());
  return corners;
}

PARDEL_PROPERTY(TRegionWalks, tasks_that_walk_in_closed_sets_give_one_mesh_though_walls_bend,
                {.statement = "Two tasks have sets of triangles without a common vertex, each closed for the region of "
                              "its task: walks for points of the region do not leave it. They insert points and split "
                              "walls at points that are rounded to multiples of 1/8, so that walls bend. Every "
                              "interleaving of their steps gives the mesh of both sequential orders, and no vertex is "
                              "touched by both tasks. All triangles stay positive, and all free edges locally "
                              "Delaunay.",
                 .source = "properties/THEORY.md, T-region-walks",
                 .families = "all layouts and walls of random scenes, on hulls and on carved domains; two boxes around "
                             "vertices; up to 8 points and splits each"}) {
  const MeshedScene given = *scenes(in_any_walled_domain({.insertions = 0})).as("scene");
  exhibit.show(given.scene);
  tag_families(given);
  Random random(*rc::gen::noShrink(rc::gen::arbitrary<std::uint64_t>()).as("seed of regions and wishes"));
  std::array<Plot, 2> plots;
  std::array<Triangles, 2> sets;
  bool are_apart = false;
  for (int trial = 0; trial < 20 && !are_apart; ++trial) {
    for (int task = 0; task < 2; ++task) {
      plots[task] = some_plot(random, given.scene);
      sets[task] = closed_set(given.mesh, at_the_middle(given.mesh, plots[task].region), plots[task].region);
    }
    are_apart = !sets[0].empty() && !sets[1].empty() && are_disjoint(corners_of(sets[0]), corners_of(sets[1]));
  }
  classify(are_apart, "sets without a common vertex", 80);
  if (!are_apart) return;
  const Walkers walkers = {Walker(plots[0].region, sets[0], plots[0].wishes),
                           Walker(plots[1].region, sets[1], plots[1].wishes)};
  Walkers first = walkers, second = walkers, at_once = walkers;
  PlainMesh mesh = given.mesh, again = given.mesh, mixed = given.mesh;
  const MeshAsPoints expected = made_by(mesh, first, [] { return 0; });
  RC_ASSERT(made_by(again, second, [] { return 1; }) == expected);
  RC_ASSERT(made_by(mixed, at_once, [&] { return static_cast<int>(random.below(2)); }) == expected);
  RC_ASSERT(are_disjoint(at_once[0].touched(), at_once[1].touched()));
  RC_ASSERT(is_oriented(mesh));
  RC_ASSERT(is_locally_delaunay(mesh));
  const bool disks_meet = !are_disjoint(ref::closure(given.mesh, ref::in_reach_of(given.mesh, plots[0].region)),
                                        ref::closure(given.mesh, ref::in_reach_of(given.mesh, plots[1].region)));
  classify(first[0].inserted() > 0 && first[1].inserted() > 0, "both tasks insert", 35);
  classify(first[0].bends() + first[1].bends() > 0, "a wall bends", 12);
  classify(disks_meet, "whole disks of both regions reach a common vertex", 13);
}

}  // namespace
}  // namespace pardel::properties
