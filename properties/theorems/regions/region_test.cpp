// T-region: if the regions of two tasks reach no common vertex, the tasks make the same mesh in every order of their
// steps. Tests also the practical form of this theorem, in which each task owns a box. Definitions and proofs:
// properties/THEORY.md, T-region.
//
// K(L) is the set of triangles that insertions in the region L can reach, and V(L) is the set of their vertices.
#include "../../../ref/region.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>

#include "../../../ref/insertion.hpp"
#include "../framework/property.hpp"
#include "../framework/scene_carving.hpp"
#include "../framework/shares.hpp"
#include "point_regions.hpp"
#include "tasks.hpp"

namespace pardel::properties {
namespace {
using generators::Random;
using ref::Box;
using ref::ExactPoint;

bool corners_lie_in(const ref::PlainMesh& mesh, const Box& box) {
  const std::vector<Point> corners = {box.low, box.high, {box.low.x, box.high.y}, {box.high.x, box.low.y}};
  return std::ranges::all_of(corners, [&](Point p) { return lies_in(mesh, ref::exact(p)); });
}

/// A box with sides of at most `side`, at a random point of the scene's bounding box.
Box some_box(Random& random, const Scene& scene, int side) {
  const auto [left, right] = std::ranges::minmax(scene.points, {}, &Point::x);
  const auto [below, above] = std::ranges::minmax(scene.points, {}, &Point::y);
  const auto low = [&](double from, double to) { return from + random.between(0, static_cast<int>(to - from)); };
  const Point corner{low(left.x, right.x), low(below.y, above.y)};
  return {corner, {corner.x + random.between(0, side), corner.y + random.between(0, side)}};
}

/// Up to `count` positions in the box and in the mesh: multiples of 1/2, and points on walls. They differ from the
/// points of the scene and from `taken`, and are added to `taken`.
std::vector<Point> some_points(Random& random, const MeshedScene& given, const Box& box, int count,
                               std::vector<Point>& taken) {
  const Scene& scene = given.scene;
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
    if (!lies_in(given.mesh, ref::exact(p))) continue;
    taken.push_back(p);
    points.push_back(p);
  }
  return points;
}

using Regions = std::array<Box, 2>;

/// A box beside the middle of a wall, and one on the other side.
Regions beside_a_wall(Random& random, const Scene& scene) {
  const ref::Edge wall = random.one_of(scene.walls);
  const Point a = scene.points[wall[0]], b = scene.points[wall[1]];
  const double length = std::hypot(b.x - a.x, b.y - a.y);
  const auto box = [&](int side) {
    const double away = side * random.between(2, 5), half = random.between(0, 2);
    const Point at{std::round((a.x + b.x) / 2 - away * (b.y - a.y) / length),
                   std::round((a.y + b.y) / 2 + away * (b.x - a.x) / length)};
    return Box{{at.x - half, at.y - half}, {at.x + half, at.y + half}};
  };
  const Box left = box(1), right = box(-1);
  return {left, right};
}

/// Searches for two boxes with corners in the mesh that satisfy the hypothesis `how`, from large boxes to small ones.
/// If the mesh is not convex, parts of a box may lie outside the mesh; the theorem then holds for the rest of the box.
std::optional<Regions> regions_apart(Random& random, const MeshedScene& given, Apart how) {
  const ref::PlainMesh& mesh = given.mesh;
  for (int trial = 0; how == Apart::free_edges_in_sight && trial < 6 && !given.scene.walls.empty(); ++trial) {
    if (random.chance(3)) break;
    const Regions both = beside_a_wall(random, given.scene);
    if (corners_lie_in(mesh, both[0]) && corners_lie_in(mesh, both[1]) &&
        are_apart(mesh, reach(mesh, both[0], how), reach(mesh, both[1], how), how))
      return both;
  }
  int side = 16;
  const auto box_in_mesh = [&]() -> std::optional<Box> {
    for (int trial = 0; trial < 40; ++trial)
      if (const Box box = some_box(random, given.scene, side); corners_lie_in(mesh, box)) return box;
    return std::nullopt;
  };
  for (int trial = 0; trial < 4; ++trial, side /= 2) {
    const std::optional<Box> first = box_in_mesh();
    if (!first) continue;
    const std::vector<Index> reach_of_first = reach(mesh, *first, how);
    for (int other = 0; other < 4; ++other)
      if (const auto second = box_in_mesh(); second && are_apart(mesh, reach_of_first, reach(mesh, *second, how), how))
        return Regions{*first, *second};
  }
  return std::nullopt;
}

/// The input of a case: a scene, and a generator of random numbers for all other choices.
struct Given {
  MeshedScene meshed;
  Random random;
  int insertions;  ///< the largest number of insertions per task
};

/// A convex hull, or, if `walls` is true, a hull with walls or a carved domain.
Given some_scene(bool walls) {
  SceneSpec spec{.insertions = 0};
  if (walls) spec = in_any_walled_domain(spec);
  MeshedScene scene = *scenes(spec).as("scene");
  tag_families(scene);
  const auto seed = *rc::gen::noShrink(rc::gen::arbitrary<std::uint64_t>()).as("seed of regions and points");
  const int most = *rc::gen::inRange(1, 13).as("insertions per task");
  return {std::move(scene), Random(seed), most};
}

bool have_common_vertex(const ref::PlainMesh& mesh, const std::vector<Index>& one, const std::vector<Index>& two) {
  const std::set<Index> of_one = ref::closure(mesh, one), of_two = ref::closure(mesh, two);
  return std::ranges::any_of(of_one, [&](Index v) { return of_two.contains(v); });
}

/// Is some constrained edge a side of a triangle of each of two sets without a common triangle?
bool have_common_wall(const ref::PlainMesh& mesh, const std::vector<Index>& one, const std::vector<Index>& two) {
  const auto has_side = [&](const std::vector<Index>& triangles, const ref::Edge& e) {
    return std::ranges::any_of(triangles, [&](Index t) {
      return ref::edge_of(mesh.triangles[t], 0) == e || ref::edge_of(mesh.triangles[t], 1) == e ||
             ref::edge_of(mesh.triangles[t], 2) == e;
    });
  };
  return std::ranges::any_of(mesh.constraints,
                             [&](const ref::Edge& e) { return has_side(one, e) && has_side(two, e); });
}

void tasks_apart_give_one_mesh(Exhibit& exhibit, bool walls, Apart how) {
  Given given = some_scene(walls);
  const ref::PlainMesh& mesh = given.meshed.mesh;
  Scene shown = given.meshed.scene;
  exhibit.show(shown);
  const std::optional<Regions> regions = regions_apart(given.random, given.meshed, how);
  classify(regions.has_value(), "regions found", 75);
  if (!regions) return;
  const std::array<std::vector<Point>, 2> points = {
      some_points(given.random, given.meshed, (*regions)[0], given.insertions, shown.insertions),
      some_points(given.random, given.meshed, (*regions)[1], given.insertions, shown.insertions)};
  exhibit.show(shown);

  const Tasks tasks = {Task(points[0]), Task(points[1])};
  const Outcome expected = one_after_the_other(mesh, tasks, 0);
  RC_ASSERT(one_after_the_other(mesh, tasks, 1) == expected);
  Tasks at_once = tasks;
  RC_ASSERT(interleaved(mesh, at_once, given.random) == expected);
  if (how != Apart::free_edges_in_sight) RC_ASSERT(are_disjoint(at_once[0].touched(), at_once[1].touched()));

  if (walls) classify_outline(given.meshed, shown.insertions, 1);
  classify(points[0].size() > 4 && points[1].size() > 4, "at least five insertions each", 9);
  if (how == Apart::vertices_of_disks) return;
  const bool meet = !are_apart(mesh, ref::in_reach_of(mesh, (*regions)[0]), ref::in_reach_of(mesh, (*regions)[1]),
                               Apart::vertices_of_disks);
  classify(meet, "V(L) and V(L') of whole disks meet", 12);
  if (how != Apart::free_edges_in_sight) return;
  const std::vector<Index> one = reach(mesh, (*regions)[0], how), two = reach(mesh, (*regions)[1], how);
  classify(have_common_vertex(mesh, one, two), "K(L) and K(L') have a common vertex", 15);
  classify(have_common_wall(mesh, one, two), "K(L) and K(L') lie on both sides of a constrained edge", 12);
}

constexpr const char* region_kinds =
    "all layouts of random scenes, on hulls and on carved domains with holes; two random boxes; up to 12 points each, "
    "at multiples of half a unit and on walls; "
    "finding a cavity and replacing it are separate steps";

PARDEL_PROPERTY(
    TRegion, any_interleaving_of_tasks_whose_disks_reach_no_common_vertex_gives_one_mesh,
    {.statement = "Let K(L) be the triangles of a Delaunay mesh whose open circumdisks meet the region L, and V(L) "
                  "their vertices. One task inserts points of L and another task points of L'. If V(L) and V(L') "
                  "are disjoint when the tasks start, every interleaving of their steps gives the mesh of both "
                  "sequential orders, and no vertex is touched by both tasks. A cavity may be found long before it "
                  "is replaced.",
     .source = "THEORY.md, T-region",
     .families = region_kinds}) {
  tasks_apart_give_one_mesh(exhibit, false, Apart::vertices_of_disks);
}

PARDEL_PROPERTY(TRegion, any_interleaving_gives_one_constrained_mesh_for_whole_disks,
                {.statement = "T-region holds in constrained Delaunay meshes, also for insertions on constrained "
                              "edges, if K(L) is defined by whole circumdisks, including hidden parts.",
                 .source = "THEORY.md, T-region",
                 .families = region_kinds}) {
  tasks_apart_give_one_mesh(exhibit, true, Apart::vertices_of_disks);
}

PARDEL_PROPERTY(TRegion, the_visible_part_of_each_disk_is_enough,
                {.statement = "T-region holds in constrained Delaunay meshes if K(L) is defined by the part of each "
                              "circumdisk from which its triangle is seen. Then K(L) is the union of the cavities of "
                              "all points of L.",
                 .source = "THEORY.md, T-region",
                 .families = region_kinds}) {
  tasks_apart_give_one_mesh(exhibit, true, Apart::vertices_in_sight);
}

PARDEL_PROPERTY(TRegion, regions_without_a_common_unconstrained_edge_give_one_mesh,
                {.statement = "Every interleaving gives the same mesh if K(L) and K(L') have no common triangle and "
                              "no common unconstrained edge. Common vertices and common constrained edges are "
                              "allowed.",
                 .source = "THEORY.md, T-region",
                 .families = region_kinds}) {
  tasks_apart_give_one_mesh(exhibit, true, Apart::free_edges_in_sight);
}

PARDEL_PROPERTY(TRegion, a_point_that_reaches_a_new_triangle_reached_one_of_two_old_ones,
                {.statement = "Inserting p makes a triangle abp on an edge ab of the boundary of its cavity. Suppose "
                              "that a point lies in the open circumdisk of abp and sees abp. Then it lies in the open "
                              "circumdisk of, and sees, the old triangle at ab on the side of p or, if ab is not "
                              "constrained, the triangle beyond ab.",
                 .source = "THEORY.md, T-region",
                 .families = "all layouts, walls, carved domains and positions of random scenes"}) {
  const MeshedScene given = *scenes(in_any_walled_domain({.insertions = 2})).as("scene");
  exhibit.show(given.scene);
  tag_families(given);
  classify_outline(given, given.scene.insertions, 1);
  const ref::PlainMesh& before = given.mesh;
  const ExactPoint q = ref::exact(given.scene.insertions[1]);
  ref::PlainMesh after = before;
  const Index p = ref::insert(after, ref::exact(given.scene.insertions[0]));
  std::set<ref::Edge> allowed;  // edges of the old cavity of q, in both directions unless constrained
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
  classify(is_reached, "q reaches a new triangle", 7);
}

PARDEL_PROPERTY(
    TRegion, the_triangles_in_reach_and_sight_of_a_point_are_its_cavity,
    {.statement = "In a constrained Delaunay mesh, only constraints that cross the whole circumdisk of a "
                  "triangle hide a part of it. Hence K({p}), computed in this way, is the cavity of p.",
     .source = "THEORY.md, T-region",
     .families = "all layouts, walls, carved domains and positions of random scenes, and points on walls"}) {
  const MeshedScene given = *scenes(in_any_walled_domain({.insertions = 2})).as("scene");
  exhibit.show(given.scene);
  tag_families(given);
  classify_outline(given, given.scene.insertions, 1);
  std::vector<Point> points = given.scene.insertions;
  for (const ref::Edge& wall : given.scene.walls) {
    const Point a = given.scene.points[wall[0]], b = given.scene.points[wall[1]];
    points.push_back({(a.x + b.x) / 2, (a.y + b.y) / 2});
  }
  for (const Point& p : points)
    RC_ASSERT(ref::in_reach_and_sight_of(given.mesh, {p, p}) == cavity(given.mesh, ref::exact(p)));
}

/// Two disjoint boxes: divides the scene's bounding box into two parts with a gap, and perhaps divides one part again.
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

/// Up to `count` points in the box and up to two points anywhere, all in the mesh.
std::vector<Point> some_work(Random& random, const MeshedScene& given, const Box& box, int count,
                             std::vector<Point>& taken) {
  std::vector<Point> work = some_points(random, given, box, count, taken);
  for (const Point& p : some_points(random, given, some_box(random, given.scene, 60), 2, taken)) work.push_back(p);
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
  if (walls) classify_outline(given.meshed, shown.insertions, 1);
  classify(!at_once[0].touched().empty() && !at_once[1].touched().empty(), "both tasks insert", 24);
  classify(std::ranges::count(expected.handed_on[0], true) + std::ranges::count(expected.handed_on[1], true) > 0,
           "some points are handed on", 49);
}

PARDEL_PROPERTY(
    TRegion, tasks_that_own_disjoint_boxes_give_one_mesh_and_hand_on_the_same_points,
    {.statement = "Two tasks own disjoint boxes. A task changes only triangles with all three corners in its box, and "
                  "hands on every point whose cavity has other triangles (leaves it to a later task). In every "
                  "Delaunay mesh, every interleaving gives the same mesh, each task hands on the same points, and no "
                  "vertex is touched by both.",
     .source = "THEORY.md, T-region, practical form",
     .families = "all layouts of random scenes; random disjoint boxes; points in the boxes and outside"}) {
  tasks_that_own_boxes_do_not_meet(exhibit, false);
}

PARDEL_PROPERTY(
    TRegion, tasks_that_own_disjoint_boxes_give_one_constrained_mesh,
    {.statement = "Two tasks own disjoint boxes. A task changes only triangles with all three corners in its box, and "
                  "hands on every point whose cavity has other triangles (leaves it to a later task). In every "
                  "constrained Delaunay mesh, every interleaving gives the same mesh, each task hands on the same "
                  "points, and no vertex is touched by both. Points may lie on constrained edges.",
     .source = "THEORY.md, T-region, practical form",
     .families =
         "all layouts, walls and carved domains of random scenes; random disjoint boxes; points in the boxes, on "
         "walls and outside"}) {
  tasks_that_own_boxes_do_not_meet(exhibit, true);
}

/// Searches for a random scene with two insertions for which shows(scene) is true, and shrinks this scene.
template <class Shows>
std::optional<Scene> search(Facts& facts, const SceneSpec& spec, Shows shows) {
  for (std::uint64_t seed = 0; seed < 2000; ++seed) {
    Random random(seed);
    MeshedScene given = random_scene(random, spec);
    if (given.scene.insertions.size() != 2) continue;
    ++facts.cases;
    if (!shows(given)) continue;
    for (bool is_smaller = true; is_smaller;) {
      is_smaller = false;
      for (const Scene& scene : simpler(given.scene)) {
        MeshedScene small = meshed(scene);
        if (!satisfies(small, spec) || !shows(small)) continue;
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
            {.statement = "T-region fails if K(L) and K(L') have a common triangle: if two tasks find their cavities "
                          "before either is replaced, the result differs from that of sequential insertion.",
             .source = "THEORY.md, T-region",
             .families = "random scenes until one is found"}) {
  EXPECT_TRUE(search(facts, {.walls = true}, fails_at_a_common_triangle));
}

PARDEL_FACT(TRegion, fails_for_regions_that_reach_both_sides_of_an_unconstrained_edge,
            {.statement = "T-region fails if K(L) and K(L') have a common unconstrained edge, even without a common "
                          "triangle: if two tasks find their cavities before either is replaced, the result differs "
                          "from that of sequential insertion.",
             .source = "THEORY.md, T-region",
             .families = "random scenes until one is found"}) {
  EXPECT_TRUE(search(facts, {.walls = true}, fails_at_a_common_edge));
}

PARDEL_FACT(TRegion, cocircular_points_in_common_regions_depend_on_the_order,
            {.statement = "If K(L) and K(L') meet and points are cocircular, even the two sequential orders may give "
                          "different Delaunay meshes.",
             .source = "THEORY.md, T-region",
             .families = "random scenes until one is found"}) {
  EXPECT_TRUE(search(facts, {.walls = false}, depends_on_the_order));
}

PARDEL_FACT(TRegion, holds_for_hidden_common_triangles_and_for_common_vertices,
            {.statement = "It is not necessary that V(L) and V(L'), computed from whole disks, are disjoint. There are "
                          "regions on two sides of a constrained edge whose whole disks reach a common triangle, "
                          "although the visible parts reach no common vertex. And there are regions that reach a "
                          "common vertex but no common edge. T-region holds for both.",
             .source = "THEORY.md, T-region",
             .families = "random scenes until one of each is found"}) {
  EXPECT_TRUE(search(facts, {.walls = true, .encroaching = false}, is_kept_apart_by_a_wall));
  EXPECT_TRUE(search(facts, {.walls = false}, holds_at_a_common_vertex));
}

PARDEL_FACT(TRegion, whole_disks_grow_beyond_walls_but_their_visible_parts_do_not,
            {.statement = "Inserting a point close to a constrained edge may make a triangle whose disk meets a region "
                          "beyond the edge, although no disk reached it before. The triangle is not seen from there. "
                          "So V(L), computed from whole disks, may grow into V(L'); T-region still holds.",
             .source = "THEORY.md, T-region",
             .families = "random scenes until one is found"}) {
  EXPECT_TRUE(search(facts, {.walls = true}, grows_beyond_a_wall));
}

PARDEL_FACT(TRegion, fails_for_boxes_that_overlap,
            {.statement = "The practical form fails if boxes overlap: for two tasks that own the same box, the result "
                          "of alternating steps differs from that of sequential insertion.",
             .source = "THEORY.md, T-region, practical form",
             .families = "random scenes until one is found"}) {
  EXPECT_TRUE(search(facts, {.walls = true}, fails_for_one_box));
}

}  // namespace
}  // namespace pardel::properties
