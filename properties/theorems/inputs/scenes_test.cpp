// Tests the generator of random scenes. The theorem suites need scenes of every family, so each must be frequent
// enough.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

#include "../framework/property.hpp"
#include "../framework/scene_carving.hpp"
#include "../framework/shares.hpp"

namespace pardel::properties {
namespace {

constexpr SceneSpec two_apart{.walls = true, .least = 2, .encroaching = false};

/// The number of scenes of each family among 500 scenes.
std::map<std::string, int> shares(const SceneSpec& spec) {
  std::map<std::string, int> count;
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    generators::Random random(seed);
    const MeshedScene scene = random_scene(random, spec);
    if (scene.scene.insertions.size() < static_cast<std::size_t>(spec.insertions)) ++count["refused"];
    const std::set<std::string> families(scene.families.begin(), scene.families.end());
    for (const std::string& family : families) ++count[family];
  }
  return count;
}

TEST(Scenes, of_every_family_have_their_share) {
  for (const double separation : {0.0, 2.0, 4.0}) {
    const auto count = shares({.walls = true, .least = separation, .on_walls = true});
    const auto expect_share = [&](const char* family, int least) {
      const auto found = count.find(family);
      EXPECT_GE(found == count.end() ? 0 : found->second, least) << family << " at a separation of " << separation;
    };
    for (const char* layout : {"points: jittered grid", "points: exact grid", "points: collinear runs",
                               "points: near-duplicates", "points: some removed", "points: far away"})
      expect_share(layout, 30);
    if (separation == 0) expect_share("points: scattered", 30);
    for (const char* walls : {"walls: crack", "walls: closed loop", "walls: long"}) expect_share(walls, 50);
    for (const char* position : {"inserted: on an edge", "inserted: on a wall", "inserted: near a wall",
                                 "inserted: above a vertex", "inserted: next to a vertex", "inserted: anywhere"})
      expect_share(position, 40);
    expect_share("inserted: on a circumcircle", 25);
    expect_share("inserted: on a circle through an edge and an earlier insertion", separation == 0 ? 25 : 0);
    const auto refused = count.find("refused");
    EXPECT_LE(refused == count.end() ? 0 : refused->second, 25) << "at a separation of " << separation;
  }
}

PARDEL_PROPERTY(
    Scenes, are_valid_and_satisfy_the_specification,
    {.statement = "A random scene has a conformal constrained Delaunay mesh in which every wall is an edge. "
                  "Its insertions satisfy the specification (SceneSpec).",
     .source = "properties/theorems/framework/scenes.hpp",
     .families = "all layouts, walls, positions"}) {
  const MeshedScene scene = *scenes(two_apart);
  exhibit.show(scene.scene);
  tag_families(scene);
  RC_ASSERT(satisfies(scene, two_apart));
  RC_ASSERT(ref::is_conformal(scene.mesh));
  RC_ASSERT(ref::is_constrained_delaunay(scene.mesh));
  std::set<ref::Edge> edges;
  for (const ref::Corners& t : scene.mesh.triangles)
    for (int i = 0; i < 3; ++i) edges.insert(ref::edge_of(t, i));
  for (const ref::Edge& wall : scene.scene.walls) RC_ASSERT(edges.contains(wall));
}

TEST(Scenes, that_are_carved_have_every_kind_of_part) {
  for (const double separation : {0.0, 4.0}) {
    const auto count = shares({.carved = true, .least = separation});
    for (const char* part : {"carved: a pocket", "carved: a hole", "carved: a slit"})
      EXPECT_GE(count.contains(part) ? count.at(part) : 0, 150) << part << " at a separation of " << separation;
    EXPECT_GE(count.at("inserted: near a pocket or a hole"), 150) << "at a separation of " << separation;
    EXPECT_LE(count.contains("refused") ? count.at("refused") : 0, 25) << "at a separation of " << separation;
  }
}

PARDEL_PROPERTY(
    Scenes, that_are_carved_have_a_wall_on_every_edge_of_their_border,
    {.statement = "A carved scene has a conformal constrained Delaunay mesh. Every edge of its border is a wall, and "
                  "every wall is an edge of the mesh. The insertions lie in the mesh.",
     .source = "properties/THEORY.md, Conventions, (B); properties/theorems/framework/scene_carving.hpp",
     .families = "all layouts, walls, pockets, holes, slits, positions"}) {
  const MeshedScene scene = *scenes({.carved = true, .on_walls = true});
  exhibit.show(scene.scene);
  tag_families(scene);
  RC_ASSERT(ref::is_conformal(scene.mesh));
  RC_ASSERT(ref::is_constrained_delaunay(scene.mesh));
  const Outline outline = outline_of(scene.mesh);
  classify(!scene.scene.holes.empty(), "carved", 95);
  RC_ASSERT(scene.scene.holes.empty() || outline.is_walled);
  for (const ref::Edge& wall : scene.scene.walls) RC_ASSERT(scene.mesh.constraints.contains(wall));
  for (const Point& p : scene.scene.insertions) RC_ASSERT(lies_in(scene.mesh, ref::exact(p)));
  classify(outline.has_reflex, "a border that is not convex", 80);
  classify(outline.has_hole, "a mesh with a hole", 40);
  classify(outline.has_slit, "a mesh with a slit", 30);
}

PARDEL_PROPERTY(
    Scenes, shrink_to_smaller_valid_scenes,
    {.statement =
         "A scene with at least two insertions shrinks to scenes with a smaller total of insertions, walls and points, "
         "or with the same total and a smaller sum of absolute coordinates. A randomly chosen one of them has at least "
         "two insertions and a conformal constrained Delaunay mesh.",
     .source = "properties/theorems/framework/scenes.hpp",
     .families = "all layouts, walls, positions"}) {
  const SceneSpec spec{.walls = true, .insertions = 3, .least = 2};
  const MeshedScene large = *scenes(spec);
  exhibit.show(large.scene);
  const std::vector<Scene> candidates = simpler(large.scene);
  RC_ASSERT(!candidates.empty());
  const auto extent = [](const Scene& scene) {
    double sum = 0;
    for (const Point& p : scene.points) sum += std::abs(p.x) + std::abs(p.y);
    return sum;
  };
  const auto count = [](const Scene& scene) {
    return scene.points.size() + scene.walls.size() + scene.insertions.size();
  };
  for (const Scene& scene : candidates)
    RC_ASSERT(count(scene) < count(large.scene) ||
              (count(scene) == count(large.scene) && extent(scene) < extent(large.scene)));
  // Test the mesh of one candidate only; testing all would take too long.
  const MeshedScene small = meshed(candidates[*rc::gen::inRange<std::size_t>(0, candidates.size())]);
  classify(satisfies(small, spec), "satisfies the specification", 25);
  RC_ASSERT(small.scene.insertions.size() >= 2);
  RC_ASSERT(ref::is_conformal(small.mesh));
  RC_ASSERT(ref::is_constrained_delaunay(small.mesh));
}

TEST(Scenes, shrink_to_a_handful_of_points) {
  // Shrink as long as a simpler scene still satisfies the specification and has at least two triangles.
  generators::Random random(1);
  Scene scene = random_scene(random, {.walls = true, .insertions = 4}).scene;
  const auto still_fails = [](const Scene& candidate) {
    const MeshedScene small = meshed(candidate);
    return satisfies(small, {.walls = true}) && small.mesh.triangles.size() >= 2;
  };
  for (bool shrunk = true; shrunk;) {
    shrunk = false;
    for (const Scene& candidate : simpler(scene))
      if (still_fails(candidate)) {
        scene = candidate;
        shrunk = true;
        break;
      }
  }
  EXPECT_EQ(scene.insertions.size(), 2U);
  EXPECT_TRUE(scene.walls.empty());
  EXPECT_EQ(scene.points.size(), 4U);
}

}  // namespace
}  // namespace pardel::properties
