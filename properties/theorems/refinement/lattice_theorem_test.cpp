// Lattice: the decomposition of [CC] and refinement with this decomposition. The tests run the reference refiner, which
// uses no threads.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>

#include "../../../ref/independent.hpp"
#include "../../../ref/insertion.hpp"
#include "../../checker/check.hpp"
#include "../framework/scenes.hpp"
#include "../framework/shares.hpp"
#include "refined_channels.hpp"

namespace pardel::properties {
namespace {
using generators::Random;
using ref::ExactPoint;
using ref::Kernel;
using ref::Number;
using ref::PlainMesh;

/// A point of the cell; each coordinate is on the lower side, in the middle, or just below the upper side.
ExactPoint random_point_of(const ref::Cell& cell, const ref::Lattice& lattice, Random& random) {
  const auto fraction = [&] { return random.one_of<double>({0, 0x1p-40, 0.5, 1 - 0x1p-40}); };
  return lattice.corner + Kernel::Vector_2((static_cast<double>(cell.i) + fraction()) * lattice.side,
                                           (static_cast<double>(cell.j) + fraction()) * lattice.side);
}

PARDEL_PROPERTY(
    Lattice, points_in_two_cells_of_one_colour_are_four_circumradii_apart,
    {.statement =
         "The lattice over a mesh has cells with sides of at least 4 r̄, coloured by (i mod 2, j mod 2). Points "
         "in two cells of one colour, or in any two cells that do not touch, are at least 4 r̄ apart.",
     .source = "[CC], the uniform lattice",
     .families = "random points, many cocircular; points on the sides of cells and just inside"}) {
  const auto scene = *generators::generator(
      [](Random& random, int) {
        Scene made{{{0, 0}, {4, 0}, {0, 3}}, {}, {}};
        const double x = random.between(-1000, 1000);
        for (int k = random.between(0, 9); k > 0; --k)
          made.points.push_back({x + random.between(5, 14), static_cast<double>(random.between(5, 14))});
        std::ranges::sort(made.points, {}, [](Point p) { return std::pair(p.x, p.y); });
        made.points.erase(std::unique(made.points.begin(), made.points.end()), made.points.end());
        return made;
      },
      [](const Scene& larger) {
        std::vector<Scene> smaller;
        if (larger.points.size() > 3) smaller.push_back({{larger.points.begin(), larger.points.end() - 1}, {}, {}});
        return smaller;
      });
  Random random(*rc::gen::arbitrary<std::uint64_t>());
  exhibit.show(scene);
  const PlainMesh mesh = mesh_of(scene);
  RC_PRE(!mesh.triangles.empty());
  const ref::Lattice lattice = lattice_over(mesh);
  const Number bound = 16 * squared_circumradius_bound(mesh);

  const ref::Cell cell{random.between(-5, 5), random.between(-5, 5)};
  for (std::int64_t i = cell.i - 3; i <= cell.i + 3; ++i)
    for (std::int64_t j = cell.j - 3; j <= cell.j + 3; ++j) {
      const ref::Cell other{i, j};
      const bool are_neighbours = std::abs(i - cell.i) <= 1 && std::abs(j - cell.j) <= 1;
      if (other == cell || (are_neighbours && colour_of(lattice, other) != colour_of(lattice, cell))) continue;
      const ExactPoint p = random_point_of(cell, lattice, random), q = random_point_of(other, lattice, random);
      RC_ASSERT(cell_of(lattice, p) == cell);
      RC_ASSERT(cell_of(lattice, q) == other);
      RC_ASSERT(CGAL::squared_distance(p, q) >= bound);
    }
}

PARDEL_PROPERTY(
    Lattice, cells_insert_only_their_own_points_in_phases_of_their_colour,
    {.statement = "Every point is inserted by the cell that contains it, in a phase of the colour of this cell. No "
                  "phase starts in a mesh for which 4 r̄ is more than the side of a cell.",
     .source = "[CC], the uniform lattice; properties/THEORY.md, Lattice, for the cell of a point and for measuring r̄ "
               "again",
     .families = channel_families}) {
  const RefinedChannel refined = refined_channel(exhibit);
  classify_inner_cells(refined.result);
  bool was_outgrown = false;
  for_each_phase(refined.result, [&](const LatticeSweep& sweep, const ref::Phase& phase, const PlainMesh& before) {
    was_outgrown |= sweep.phases.size() < 4;
    RC_ASSERT(sweep.cells.side * sweep.cells.side >= 16 * squared_circumradius_bound(before));
    for (const auto& [cell, point] : phase.insertions) {
      RC_ASSERT(cell_of(sweep.cells, point) == cell);
      RC_ASSERT(phase.colour % 2 == (cell.i & 1) && phase.colour / 2 == (cell.j & 1));
    }
  });
  classify(was_outgrown, "circumradii grew, and a new lattice was computed", 0.05);
}

/// By definition: what inserting p reads or writes. The triangles are the cavity and its ring, the triangles that share
/// an edge with it; the vertices are those of the cavity.
ref::Touched touched_by_definition(const PlainMesh& mesh, const ExactPoint& p) {
  ref::Touched touched;
  for (const Index t : cavity(mesh, p)) {
    const ref::Corners& inside = mesh.triangles[t];
    for (const Index v : inside) touched.vertices.insert(mesh.points[v]);
    for (const ref::Corners& other : mesh.triangles) {
      const auto common = std::ranges::count_if(other, [&](Index v) { return std::ranges::count(inside, v) != 0; });
      if (common >= 2) touched.triangles.insert(other);
    }
  }
  return touched;
}

template <class T>
bool have_common_element(const std::set<T>& a, const std::set<T>& b) {
  return std::ranges::any_of(a, [&](const T& element) { return b.contains(element); });
}

/// True if the record of the first insertion of a phase, which was found in the mesh `before`, has everything that it
/// touched.
bool is_complete(const ref::Phase& phase, const PlainMesh& before) {
  if (phase.insertions.empty()) return true;
  const auto& [cell, point] = phase.insertions.front();
  const ref::Touched expected = touched_by_definition(before, point);
  const ref::Touched& recorded = phase.touched.at(cell);
  return std::ranges::includes(recorded.vertices, expected.vertices) &&
         std::ranges::includes(recorded.triangles, expected.triangles);
}

PARDEL_PROPERTY(
    Lattice, cells_of_one_colour_touch_no_common_vertex_in_a_phase,
    {.statement = "In a phase, consider all points that the cells of its colour insert or reject. The closures of the "
                  "cavities of two different cells share no vertex. No triangle is read or written by both cells; "
                  "this includes the triangles across the boundaries of the cavities.",
     .source = "[CC], Theorem 1 and the uniform lattice",
     .families = channel_families}) {
  const RefinedChannel refined = refined_channel(exhibit);
  classify_inner_cells(refined.result);
  std::size_t cells_at_once = 0;
  for_each_phase(refined.result, [&](const LatticeSweep&, const ref::Phase& phase, const PlainMesh& before) {
    RC_ASSERT(is_complete(phase, before));
    RC_ASSERT(cells_touch_nothing_in_common(phase));
    cells_at_once = std::max(cells_at_once, phase.touched.size());
  });
  classify(cells_at_once >= 2, "two or more cells work at once", 35);
  classify(cells_at_once >= 3, "three or more cells work at once", 20);
}

/// The reference's record of one insertion.
struct Recorded {
  ref::Touched touched;
  std::set<ref::Corners> cavity;
  std::set<ref::Corners> ring;  ///< the triangles of the record that are not in the cavity
  bool is_exact;                ///< has the record what the insertion touches by definition, and nothing else?
};

Recorded recorded(const MeshedScene& scene, std::size_t insertion) {
  const ExactPoint p = ref::exact(scene.scene.insertions.at(insertion));
  Recorded made;
  for (const Index t : record_touched(made.touched, scene.mesh, p)) made.cavity.insert(scene.mesh.triangles[t]);
  made.ring = made.touched.triangles;
  for (const ref::Corners& t : made.cavity) made.ring.erase(t);
  const ref::Touched expected = touched_by_definition(scene.mesh, p);
  made.is_exact = made.touched.vertices == expected.vertices && made.touched.triangles == expected.triangles;
  return made;
}

PARDEL_FACT(
    Lattice, cavities_that_meet_may_have_a_common_triangle_in_their_rings,
    {.statement = "The reference records exactly what an insertion touches: the vertices of its cavity, the triangles "
                  "of its cavity, and the triangles across the boundary of its cavity. Two insertions can touch a "
                  "common triangle although no triangle is in both cavities: it lies across the boundaries of both. "
                  "Whenever two insertions touch a common triangle, their cavities have a common vertex.",
     .source = "properties/THEORY.md, T1-closures; ref/decomposition/cell_refiner.hpp",
     .families = "random scenes with two insertions, until 100 such pairs are found"}) {
  std::uint64_t found = 0;
  for (std::uint64_t seed = 1; found < 100 && seed <= 20'000 && !testing::Test::HasFailure(); ++seed, ++facts.cases) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const MeshedScene scene = random_scene(random, {.walls = true, .insertions = 2, .encroaching = false});
    if (scene.scene.insertions.size() < 2) continue;
    const Recorded p = recorded(scene, 0), q = recorded(scene, 1);
    EXPECT_TRUE(p.is_exact);
    EXPECT_TRUE(q.is_exact);
    const bool touch_a_common_triangle = have_common_element(p.touched.triangles, q.touched.triangles);
    EXPECT_TRUE(!touch_a_common_triangle || have_common_element(p.touched.vertices, q.touched.vertices));
    const bool cavities_meet = have_common_element(p.cavity, q.cavity);
    if (!cavities_meet && have_common_element(p.ring, q.ring)) ++found;
  }
  EXPECT_EQ(found, 100U);
}

/// The points of a phase in another order: the order within each cell is kept, and the cells alternate at random.
std::vector<ExactPoint> interleaved(const ref::Phase& phase, Random& random) {
  std::map<ref::Cell, std::vector<ExactPoint>> of_cell;
  std::vector<ref::Cell> turns;
  for (const auto& [cell, point] : phase.insertions) {
    of_cell[cell].push_back(point);
    turns.push_back(cell);
  }
  random.shuffle(turns);
  std::map<ref::Cell, std::size_t> done;
  std::vector<ExactPoint> points;
  for (const ref::Cell& cell : turns) points.push_back(of_cell[cell][done[cell]++]);
  return points;
}

PARDEL_PROPERTY(
    Lattice, sequential_insertion_in_any_order_makes_the_mesh_of_a_phase,
    {.statement = "Inserting the points of a phase one after the other, with cells alternating at random, gives the "
                  "mesh of the phase, whose points were inserted independently.",
     .source = "[CC], Theorem 1",
     .families = channel_families}) {
  const RefinedChannel refined = refined_channel(exhibit);
  classify_inner_cells(refined.result);
  Random random(*rc::gen::arbitrary<std::uint64_t>());
  for_each_phase(refined.result, [&](const LatticeSweep&, const ref::Phase& phase, const PlainMesh& before) {
    PlainMesh mesh = before;
    for (const ExactPoint& p : interleaved(phase, random)) insert(mesh, p);
    RC_ASSERT(triangles_as_points(mesh) == triangles_as_points(phase.after));
  });
}

PARDEL_PROPERTY(
    Lattice, refinement_makes_a_conformal_delaunay_mesh_that_meets_the_goal,
    {.statement =
         "The result is conformal and Delaunay by definition, and no subsegment is encroached. The independent "
         "checker finds that all bounds are met and no triangle is exempt.",
     .source = "[CC]; Ruppert 1995",
     .families = channel_families}) {
  const RefinedChannel refined = refined_channel(exhibit);
  classify_inner_cells(refined.result);
  const PlainMesh& mesh = refined.result.sweeps.back().phases.back().after;
  RC_ASSERT(is_conformal(mesh));
  RC_ASSERT(is_delaunay(mesh));
  for (const ref::Edge& e : mesh.constraints) RC_ASSERT(!is_encroached(mesh, e));
  const Certificate certificate = check(refined.pslg, refined.result.mesh, refined.goal);
  if (!certificate.valid) RC_FAIL(certificate.violations.at(0).message());
  RC_ASSERT(certificate.justified.empty());
}

PARDEL_PROPERTY(
    Lattice, sweeps_end_and_insert_every_point_that_was_handed_on,
    {.statement = "Sweeps over the four colours end. A split point that one cell needs and another cell contains is "
                  "handed on to that cell, which has another colour. Every such point is inserted in a later phase and "
                  "is a vertex of the mesh. In the mesh after the last sweep, no subsegment is encroached, and no "
                  "triangle breaks a bound.",
     .source = "[CC] has four iterations; here sweeps are repeated, and their number is measured",
     .families = channel_families}) {
  const RefinedChannel refined = refined_channel(exhibit);
  classify_inner_cells(refined.result);
  std::set<ExactPoint> waiting, handed_on;
  for_each_phase(refined.result, [&](const LatticeSweep& sweep, const ref::Phase& phase, const PlainMesh&) {
    for (const ref::HandedOn& handed : phase.handed_on) {
      RC_ASSERT(colour_of(sweep.cells, handed.from) != colour_of(sweep.cells, handed.to));
      waiting.insert(handed.point);
      handed_on.insert(handed.point);
    }
    for (const ref::Insertion& insertion : phase.insertions) waiting.erase(insertion.point);
  });
  classify(!handed_on.empty(), "handed on", 5);
  RC_ASSERT(waiting.empty());
  const PlainMesh& last = refined.result.sweeps.back().phases.back().after;
  const std::set<ExactPoint> vertices(last.points.begin(), last.points.end());
  RC_ASSERT(std::ranges::includes(vertices, handed_on));
  for (const ref::Edge& e : last.constraints) RC_ASSERT(!is_encroached(last, e));
  const Certificate certificate = check(refined.pslg, refined.result.mesh, refined.goal);
  for (const ViolationKind bound : {ViolationKind::small_angle, ViolationKind::large_area, ViolationKind::region_area})
    RC_ASSERT(certificate.violation_counts.at(static_cast<std::size_t>(bound)) == 0U);
  const auto inserts = [](const ref::Phase& phase) { return !phase.insertions.empty(); };
  const auto inserting = std::ranges::count_if(
      refined.result.sweeps, [&](const LatticeSweep& s) { return std::ranges::any_of(s.phases, inserts); });
  RC_TAG(std::to_string(inserting) + " sweeps that insert");
}

}  // namespace
}  // namespace pardel::properties
