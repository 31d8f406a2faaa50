// T-region: tasks whose regions reach no common vertex never meet, however their steps interleave; and the rule that
// the engine makes of it, a box for each task.
//
// M is a constrained Delaunay mesh; W are its walls, as a set of points, which inserting points on them does not
// change. D(t) is the open circumdisk of t, and S(t) the part of it from which t is seen.
//
// Lemma 1. A point of D(t) that sees one inner point of t sees all of them. Else, let x see y but not z. Some wall
// enters the triangle xyz through xz alone and so ends inside of it, in D(t). Of those ends, one at the least angle
// from xy, and of these the one farthest from x, sees y: an end in D(t) that sees t, in a constrained Delaunay mesh.
// (So S(t) is D(t) cut off by the walls that cross all of it, a convex set; ref/region.cpp computes it so.)
//
// Lemma 2. Let inserting p make the triangle t = abp, and let t1 be the cavity's triangle at ab and t2 the one beyond.
// Then S(t) ⊂ S(t1) ∪ S(t2); and S(t) ⊂ S(t1) where ab is a wall. On the side of ab where p lies, D(t) ⊂ D(t1), and
// beyond, D(t) ⊂ D(t2), since the three circles are of one pencil (circumradius_test.cpp). Let x in D(t) see t, hence,
// by Lemma 1, a point z of t close to ab, which is one of t1, too. From the side of p or from ab, x sees t1 in z. From
// beyond, xz runs through ab inside the disk, so ab is no wall, and just before ab it runs through t2.
//
// Theorem. K(L) are the triangles t for which S(t) meets the region L of the domain: the union of the cavities of
// all points of L. Let K(L) and K(L') have neither a triangle nor an edge that is no wall in common. Inserting p in L
// removes triangles of K(L) alone and leaves K(L') as it is: by Lemma 2, if S(t) of a new triangle t met L', then so
// did S(t1) or S(t2); but t1 is in K(L), and t2 shares the edge ab, no wall, with it. And what the two sets share does
// not grow: K(L) gains triangles on edges of K(L), and p. So for ever after, a task in L finds the cavities and makes
// the triangles that it would if it were alone. No hypothesis on angles, radii or positions is used; and it does not
// matter when a cavity is found and when it is replaced.
//
// That V(L) and V(L'), the corners of those triangles, are disjoint is more than enough. It also keeps the two
// tasks from writing to one triangle: one beside a cavity of either task has two of its corners in V(L). With whole
// disks D(t) instead of S(t), K(L) is larger, so the theorem holds all the more. But it asks for more than is needed
// near walls, and a whole disk may come to meet L' later: close to a wall, new disks bulge far beyond it, unseen.
//
// Boxes. Let a task that owns the box B change only triangles with all three corners in B, and hand on every point
// whose cavity has others. It finds cavities from the triangle that holds the point by going from neighbour to
// neighbour, and it can stop at the first triangle that is not its own. All that it looks at has two corners in B, at
// least, but for the triangle that it starts from; and what has two corners in B has not three in a disjoint box, so
// nobody else changes it. Neither does anybody make or remove triangles of B. (Where the first triangle is not its own,
// then none that will ever hold the point is.) So what a task does, and what it hands on, does not depend on the
// others.
#include "../../../ref/region.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>

#include "../../../ref/insertion.hpp"
#include "../framework/property.hpp"
#include "../framework/scenes.hpp"
#include "point_regions.hpp"
#include "tasks.hpp"

namespace pardel::properties {
namespace {
using generators::Random;
using ref::Box;
using ref::ExactPoint;

bool is_in_hull(const ref::PlainMesh& mesh, const std::vector<ref::Edge>& hull, const ExactPoint& p) {
  return std::ranges::none_of(
      hull, [&](const ref::Edge& e) { return CGAL::right_turn(mesh.points[e[0]], mesh.points[e[1]], p); });
}

bool box_is_in_hull(const ref::PlainMesh& mesh, const std::vector<ref::Edge>& hull, const Box& box) {
  const std::vector<Point> corners = {box.low, box.high, {box.low.x, box.high.y}, {box.high.x, box.low.y}};
  return std::ranges::all_of(corners, [&](Point p) { return is_in_hull(mesh, hull, ref::exact(p)); });
}

/// A box with sides of at most `side`, around a random point of the scene's bounding box.
Box some_box(Random& random, const Scene& scene, int side) {
  const auto [left, right] = std::ranges::minmax(scene.points, {}, &Point::x);
  const auto [below, above] = std::ranges::minmax(scene.points, {}, &Point::y);
  const auto low = [&](double from, double to) { return from + random.between(0, static_cast<int>(to - from)); };
  const Point corner{low(left.x, right.x), low(below.y, above.y)};
  return {corner, {corner.x + random.between(0, side), corner.y + random.between(0, side)}};
}

/// Up to `count` positions in the box, on halves and on walls; no point of the scene and not in `taken`.
std::vector<Point> some_points(Random& random, const Scene& scene, const Box& box, int count,
                               std::vector<Point>& taken) {
  std::vector<Point> on_walls;
  for (const ref::Edge& wall : scene.walls)
    for (int k = 1; k < 8; ++k) {
      const Point a = scene.points[wall[0]], b = scene.points[wall[1]];
      const Point p{a.x + (b.x - a.x) * k / 8, a.y + (b.y - a.y) * k / 8};
      if (ref::contains(box, ref::exact(p))) on_walls.push_back(p);
    }
  std::vector<Point> points;
  for (; count > 0; --count) {
    const auto between = [&](double low, double high) {
      return low + random.between(0, static_cast<int>(2 * (high - low))) / 2.0;
    };
    const double x = between(box.low.x, box.high.x), y = between(box.low.y, box.high.y);
    const Point p = !on_walls.empty() && random.chance(3) ? random.one_of(on_walls) : Point{x, y};
    if (std::ranges::count(taken, p) != 0 || std::ranges::count(scene.points, p) != 0) continue;
    taken.push_back(p);
    points.push_back(p);
  }
  return points;
}

using Regions = std::array<Box, 2>;

/// Two boxes in the hull that are apart, large ones first; none where none are found.
std::optional<Regions> regions_apart(Random& random, const MeshedScene& given, Apart how) {
  const ref::PlainMesh& mesh = given.mesh;
  const std::vector<ref::Edge> hull = hull_of(mesh);
  int side = 16;
  const auto box_in_hull = [&]() -> std::optional<Box> {
    for (int trial = 0; trial < 40; ++trial)
      if (const Box box = some_box(random, given.scene, side); box_is_in_hull(mesh, hull, box)) return box;
    return std::nullopt;
  };
  for (int trial = 0; trial < 4; ++trial, side /= 2) {
    const std::optional<Box> first = box_in_hull();
    if (!first) continue;
    const std::vector<Index> reach_of_first = reach(mesh, *first, how);
    for (int other = 0; other < 4; ++other)
      if (const auto second = box_in_hull(); second && are_apart(mesh, reach_of_first, reach(mesh, *second, how), how))
        return Regions{*first, *second};
  }
  return std::nullopt;
}

/// What a case of these properties is made of: a scene, and numbers to choose everything else by.
struct Given {
  MeshedScene meshed;
  Random random;
  int insertions;  ///< per task, at most
};

Given some_scene(bool walls) {
  MeshedScene scene = *scenes({.walls = walls, .insertions = 0}).as("scene");
  tag_families(scene);
  const auto seed = *rc::gen::noShrink(rc::gen::arbitrary<std::uint64_t>()).as("what chooses regions and points");
  const int most = *rc::gen::inRange(1, 13).as("insertions per task");
  return {std::move(scene), Random(seed), most};
}

void tasks_apart_give_one_mesh(Exhibit& exhibit, bool walls, Apart how) {
  Given given = some_scene(walls);
  const ref::PlainMesh& mesh = given.meshed.mesh;
  Scene shown = given.meshed.scene;
  exhibit.show(shown);
  const std::optional<Regions> regions = regions_apart(given.random, given.meshed, how);
  RC_CLASSIFY(!regions, "no regions found");
  if (!regions) return;
  const std::array<std::vector<Point>, 2> points = {
      some_points(given.random, shown, (*regions)[0], given.insertions, shown.insertions),
      some_points(given.random, shown, (*regions)[1], given.insertions, shown.insertions)};
  exhibit.show(shown);

  const Tasks tasks = {Task(points[0]), Task(points[1])};
  const Outcome expected = one_after_the_other(mesh, tasks, 0);
  RC_ASSERT(one_after_the_other(mesh, tasks, 1) == expected);
  Tasks at_once = tasks;
  RC_ASSERT(interleaved(mesh, at_once, given.random) == expected);
  if (how != Apart::free_edges_in_sight) RC_ASSERT(are_disjoint(at_once[0].touched(), at_once[1].touched()));

  RC_CLASSIFY(points[0].size() > 4 && points[1].size() > 4, "at least five insertions each");
  RC_CLASSIFY(
      how != Apart::vertices_of_disks && !are_apart(mesh, ref::in_reach_of(mesh, (*regions)[0]),
                                                    ref::in_reach_of(mesh, (*regions)[1]), Apart::vertices_of_disks),
      "V(L) and V(L') of whole disks meet");
}

constexpr const char* region_kinds =
    "all layouts of random scenes; two random boxes; up to 12 points each on halves of the lattice and on walls; "
    "finding a cavity and replacing it are steps of their own";

PARDEL_PROPERTY(
    TRegion, any_interleaving_of_tasks_whose_disks_reach_no_common_vertex_gives_one_mesh,
    {.statement = "M is Delaunay; K(L) are the triangles whose open circumdisk meets the region L within the "
                  "domain, V(L) their vertices. If V(L) and V(L') are disjoint when two tasks start, any "
                  "interleaving of any insertions in L by one task and in L' by the other, in which "
                  "a cavity may be found long before it is replaced, gives the mesh of either sequential "
                  "order, and no vertex is touched by both.",
     .source = "THEORY.md, T-region",
     .families = region_kinds}) {
  tasks_apart_give_one_mesh(exhibit, false, Apart::vertices_of_disks);
}

PARDEL_PROPERTY(TRegion, and_so_it_does_in_a_constrained_mesh_with_whole_disks,
                {.statement = "T-region holds in constrained Delaunay meshes, insertions on constrained edges "
                              "included, when K(L) counts whole circumdisks, hidden parts and all.",
                 .source = "THEORY.md, T-region",
                 .families = region_kinds}) {
  tasks_apart_give_one_mesh(exhibit, true, Apart::vertices_of_disks);
}

PARDEL_PROPERTY(TRegion, the_part_of_a_disk_that_sees_its_triangle_is_enough,
                {.statement = "T-region holds in constrained Delaunay meshes when K(L) counts of each circumdisk only "
                              "the part from which its triangle is seen: K(L) is the union of the cavities of all "
                              "points of L.",
                 .source = "THEORY.md, T-region",
                 .families = region_kinds}) {
  tasks_apart_give_one_mesh(exhibit, true, Apart::vertices_in_sight);
}

PARDEL_PROPERTY(TRegion, for_the_mesh_alone_no_common_unconstrained_edge_is_enough,
                {.statement = "For the mesh to be the same it is enough that the triangles in K(L) and K(L') are "
                              "different ones and share no unconstrained edge; common vertices, and constrained edges "
                              "with the regions on either side of them, do no harm.",
                 .source = "THEORY.md, T-region",
                 .families = region_kinds}) {
  tasks_apart_give_one_mesh(exhibit, true, Apart::free_edges_in_sight);
}

PARDEL_PROPERTY(TRegion, what_a_new_triangle_can_reach_one_of_two_old_ones_reached,
                {.statement = "Inserting p makes a triangle abp on an edge ab of its cavity's boundary. A point in its "
                              "open circumdisk that sees it lies in the open circumdisk of, and sees, the cavity's "
                              "triangle at ab or, where ab is no constraint, the one beyond.",
                 .source = "THEORY.md, T-region",
                 .families = "all layouts, walls and positions of random scenes"}) {
  const MeshedScene given = *scenes({.walls = true, .insertions = 2}).as("scene");
  exhibit.show(given.scene);
  tag_families(given);
  const ref::PlainMesh& before = given.mesh;
  const ExactPoint q = ref::exact(given.scene.insertions[1]);
  ref::PlainMesh after = before;
  const Index p = ref::insert(after, ref::exact(given.scene.insertions[0]));
  std::set<ref::Edge> allowed;  // directed edges of what q reached: of a triangle in the cavity of q, on either side
  for (const Index i : ref::cavity(before, q))
    for (int k = 0; k < 3; ++k) {
      const ref::Corners& t = before.triangles[i];
      allowed.insert({t[k], t[(k + 1) % 3]});
      if (!before.constraints.contains(ref::edge(t[k], t[(k + 1) % 3]))) allowed.insert({t[(k + 1) % 3], t[k]});
    }
  bool is_reached = false;
  for (const Index i : ref::cavity(after, q)) {
    const ref::Corners& t = after.triangles[i];
    const auto at = std::ranges::find(t, p) - t.begin();
    if (at == 3) continue;
    is_reached = true;
    RC_ASSERT(allowed.contains({t[(at + 1) % 3], t[(at + 2) % 3]}));
  }
  RC_CLASSIFY(is_reached, "q reaches a new triangle");
}

PARDEL_PROPERTY(TRegion, what_is_in_reach_and_sight_of_a_point_is_its_cavity,
                {.statement = "In a constrained Delaunay mesh, the part of a circumdisk from which its triangle is "
                              "seen is what the constraints that cross all of the disk leave of it; hence what is in "
                              "reach and sight of a single point is its cavity.",
                 .source = "THEORY.md, T-region",
                 .families = "all layouts, walls and positions of random scenes, and points on walls"}) {
  const MeshedScene given = *scenes({.walls = true, .insertions = 2}).as("scene");
  exhibit.show(given.scene);
  tag_families(given);
  std::vector<Point> points = given.scene.insertions;
  for (const ref::Edge& wall : given.scene.walls) {
    const Point a = given.scene.points[wall[0]], b = given.scene.points[wall[1]];
    points.push_back({(a.x + b.x) / 2, (a.y + b.y) / 2});
  }
  for (const Point& p : points)
    RC_ASSERT(ref::in_reach_and_sight_of(given.mesh, {p, p}) == cavity(given.mesh, ref::exact(p)));
}

/// The scene's bounding box, cut in two by a line that belongs to neither, and one of its parts perhaps cut again.
Regions some_disjoint_boxes(Random& random, const Scene& scene) {
  const auto [left, right] = std::ranges::minmax(scene.points, {}, &Point::x);
  const auto [below, above] = std::ranges::minmax(scene.points, {}, &Point::y);
  Regions boxes = {Box{{left.x, below.y}, {right.x, above.y}}, {}};
  for (int cuts = random.between(1, 2); cuts > 0; --cuts) {
    boxes[1] = boxes[0];
    const auto axis = random.chance(2) ? &Point::x : &Point::y;
    const double low = boxes[0].low.*axis, extent = boxes[0].high.*axis - low;
    const double at = low + std::floor(extent * random.between(3, 7) / 10);
    boxes[0].high.*axis = at - 0.5;
    boxes[1].low.*axis = at + 0.5;
    if (random.chance(2)) std::swap(boxes[0], boxes[1]);
  }
  return boxes;
}

/// Up to `count` points in the hull, most of them in the box.
std::vector<Point> some_work(Random& random, const MeshedScene& given, const Box& box, int count,
                             std::vector<Point>& taken) {
  const std::vector<ref::Edge> hull = hull_of(given.mesh);
  std::vector<Point> work = some_points(random, given.scene, box, count, taken);
  for (const Point& p : some_points(random, given.scene, some_box(random, given.scene, 60), 2, taken))
    work.push_back(p);
  std::erase_if(work, [&](const Point& p) { return !is_in_hull(given.mesh, hull, ref::exact(p)); });
  random.shuffle(work);
  return work;
}

void tasks_that_own_boxes_do_not_meet(Exhibit& exhibit, bool walls) {
  Given given = some_scene(walls);
  Scene shown = given.meshed.scene;
  const Regions boxes = some_disjoint_boxes(given.random, shown);
  const auto task = [&](const Box& box) {
    return Task(some_work(given.random, given.meshed, box, given.insertions, shown.insertions), box);
  };
  const Tasks tasks = {task(boxes[0]), task(boxes[1])};
  exhibit.show(shown);

  const Outcome expected = one_after_the_other(given.meshed.mesh, tasks, 0);
  RC_ASSERT(one_after_the_other(given.meshed.mesh, tasks, 1) == expected);
  Tasks at_once = tasks;
  RC_ASSERT(interleaved(given.meshed.mesh, at_once, given.random) == expected);
  RC_ASSERT(are_disjoint(at_once[0].touched(), at_once[1].touched()));
  RC_CLASSIFY(!at_once[0].touched().empty() && !at_once[1].touched().empty(), "both tasks insert");
  RC_CLASSIFY(std::ranges::count(expected.handed_on[0], true) + std::ranges::count(expected.handed_on[1], true) > 0,
              "some points are handed on");
}

PARDEL_PROPERTY(
    TRegion, tasks_that_own_disjoint_boxes_give_one_mesh_and_hand_on_the_same_points,
    {.statement = "Two tasks own disjoint boxes. Each changes only triangles whose three corners lie in its "
                  "box and hands on every point whose cavity has others. Any interleaving gives one mesh, "
                  "each task hands on the same points, and no vertex is touched by both; on every "
                  "Delaunay mesh.",
     .source = "THEORY.md, T-region, practical form",
     .families = "all layouts of random scenes; random disjoint boxes; points in the boxes and outside"}) {
  tasks_that_own_boxes_do_not_meet(exhibit, false);
}

PARDEL_PROPERTY(
    TRegion, and_so_do_they_in_a_constrained_mesh,
    {.statement = "Two tasks own disjoint boxes. Each changes only triangles whose three corners lie in its "
                  "box and hands on every point whose cavity has others. Any interleaving gives one mesh, "
                  "each task hands on the same points, and no vertex is touched by both; on every "
                  "constrained Delaunay mesh, points on constrained edges included.",
     .source = "THEORY.md, T-region, practical form",
     .families = "all layouts and walls of random scenes; random disjoint boxes; points in the boxes, on "
                 "walls and outside"}) {
  tasks_that_own_boxes_do_not_meet(exhibit, true);
}

/// The first random scene with two points to insert that shows something, made as small as it gets.
template <class Shows>
std::optional<Scene> search(Facts& facts, const SceneWish& wish, Shows shows) {
  for (std::uint64_t seed = 0; seed < 2000; ++seed) {
    Random random(seed);
    MeshedScene given = random_scene(random, wish);
    if (given.scene.insertions.size() != 2) continue;
    ++facts.cases;
    if (!shows(given)) continue;
    for (bool is_smaller = true; is_smaller;) {
      is_smaller = false;
      for (const Scene& scene : simpler(given.scene)) {
        MeshedScene small = meshed(scene);
        if (!grants(small, wish) || !shows(small)) continue;
        given = std::move(small);
        is_smaller = true;
        break;
      }
    }
    std::ostringstream note;
    note << "after " << facts.cases << " scenes: " << given.scene;
    facts.notes.push_back(note.str());
    return given.scene;
  }
  return std::nullopt;
}

PARDEL_FACT(TRegion, fails_for_regions_that_reach_a_common_triangle,
            {.statement = "Fails when K(L) and K(L') have a triangle in common: two tasks that find their cavities "
                          "before either is replaced make something else than one after the other.",
             .source = "THEORY.md, T-region",
             .families = "random scenes until one is found"}) {
  EXPECT_TRUE(search(facts, {.walls = true}, fails_at_a_common_triangle));
}

PARDEL_FACT(TRegion, fails_for_regions_that_reach_both_sides_of_an_unconstrained_edge,
            {.statement = "Fails when K(L) and K(L') have no triangle but an unconstrained edge in common: two tasks "
                          "that find their cavities before either is replaced make something else than one after the "
                          "other.",
             .source = "THEORY.md, T-region",
             .families = "random scenes until one is found"}) {
  EXPECT_TRUE(search(facts, {.walls = true}, fails_at_a_common_edge));
}

PARDEL_FACT(TRegion, with_cocircular_points_even_whole_insertions_depend_on_their_order,
            {.statement = "Fails when K(L) and K(L') meet: among cocircular points even the two sequential orders may "
                          "give two different Delaunay meshes.",
             .source = "THEORY.md, T-region",
             .families = "random scenes until one is found"}) {
  EXPECT_TRUE(search(facts, {.walls = false}, depends_on_the_order));
}

PARDEL_FACT(TRegion, what_is_hidden_and_vertices_in_common_do_no_harm,
            {.statement = "That V(L) and V(L') of whole disks are disjoint is not necessary: there are regions on two "
                          "sides of a constrained edge whose whole disks reach a common triangle though what they "
                          "reach in sight has no vertex in common, and regions that reach a common vertex but no "
                          "common edge.",
             .source = "THEORY.md, T-region",
             .families = "random scenes until one of each is found"}) {
  EXPECT_TRUE(search(facts, {.walls = true, .encroaching = false}, is_kept_apart_by_a_wall));
  EXPECT_TRUE(search(facts, {.walls = false}, holds_at_a_common_vertex));
}

PARDEL_FACT(TRegion, whole_disks_grow_beyond_walls_but_not_what_they_see,
            {.statement = "Inserting a point close to a constrained edge may make a disk that meets a region beyond, "
                          "where no disk of the task's was before. From there it does not see its triangle; so V(L) "
                          "counted by whole disks may grow into V(L'), and T-region holds all the same.",
             .source = "THEORY.md, T-region",
             .families = "random scenes until one is found"}) {
  EXPECT_TRUE(search(facts, {.walls = true}, grows_beyond_a_wall));
}

PARDEL_FACT(TRegion, fails_for_boxes_that_overlap,
            {.statement = "Fails when the boxes overlap: two tasks that own the same box make something else at once "
                          "than one after the other.",
             .source = "THEORY.md, T-region, practical form",
             .families = "random scenes until one is found"}) {
  EXPECT_TRUE(search(facts, {.walls = true}, fails_for_one_box));
}

}  // namespace
}  // namespace pardel::properties
