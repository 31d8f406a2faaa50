// The generator of random scenes: a property that holds on scenes that never occur proves nothing.
#include "../framework/scenes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "../../ref/insertion.hpp"
#include "../framework/property.hpp"
#include "../framework/scene_layouts.hpp"

namespace pardel::properties {
namespace {

constexpr SceneWish two_apart{.walls = true, .least = 2, .encroaching = false};

/// How many of 500 scenes are of each family, each family counted once in a scene.
std::map<std::string, int> shares(const SceneWish& wish) {
  std::map<std::string, int> count;
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    generators::Random random(seed);
    const MeshedScene scene = random_scene(random, wish);
    if (scene.scene.insertions.size() < static_cast<std::size_t>(wish.insertions)) ++count["refused"];
    const std::set<std::string> families(scene.families.begin(), scene.families.end());
    for (const std::string& family : families) ++count[family];
  }
  return count;
}

TEST(Scenes, of_every_family_have_their_share) {
  for (const double separation : {0.0, 2.0, 4.0}) {
    const auto count = shares({.walls = true, .least = separation, .encroaching = false});
    const auto expect_share = [&](const char* family, int least) {
      const auto found = count.find(family);
      EXPECT_GE(found == count.end() ? 0 : found->second, least) << family << " at a separation of " << separation;
    };
    for (const char* layout : {"points: jittered grid", "points: exact grid", "points: collinear runs",
                               "points: near-duplicates", "points: some removed", "points: far away"})
      expect_share(layout, 50);
    if (separation == 0) expect_share("points: scattered", 50);
    for (const char* walls : {"walls: crack", "walls: closed loop", "walls: long"}) expect_share(walls, 50);
    for (const char* position :
         {"inserted: on an edge", "inserted: above a vertex", "inserted: next to a vertex", "inserted: anywhere"})
      expect_share(position, 75);
    expect_share("inserted: on a circumcircle", 25);
    expect_share("inserted: on a circle through an edge and a former one", separation == 0 ? 25 : 0);
    const auto refused = count.find("refused");
    EXPECT_LE(refused == count.end() ? 0 : refused->second, 25) << "at a separation of " << separation;
    for (const auto& [family, n] : count) std::cout << separation << ' ' << family << ' ' << n << '\n';
  }
}

PARDEL_PROPERTY(Scenes, keep_their_promises_and_grant_the_wish,
                {.statement = "A random scene can be triangulated to a conformal constrained Delaunay mesh with every "
                              "wall an edge of it, and its insertions grant the wish.",
                 .source = "properties/framework/scenes.hpp",
                 .families = "all layouts, walls, positions"}) {
  const MeshedScene scene = *scenes(two_apart);
  exhibit.show(scene.scene);
  tag_families(scene);
  RC_ASSERT(grants(scene, two_apart));
  RC_ASSERT(ref::is_conformal(scene.mesh));
  RC_ASSERT(ref::is_constrained_delaunay(scene.mesh));
  std::set<ref::Edge> edges;
  for (const ref::Corners& t : scene.mesh.triangles)
    for (int i = 0; i < 3; ++i) edges.insert(ref::edge_of(t, i));
  for (const ref::Edge& wall : scene.scene.walls) RC_ASSERT(edges.contains(wall));
}

}  // namespace
}  // namespace pardel::properties
