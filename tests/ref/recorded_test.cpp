// The reference does today what it did when these fingerprints were recorded: the same points, triangles, cells and
// steps, in the same order. After a change that is meant to change one of them, take over the value that the test
// shows.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "../../properties/domains/domains.hpp"
#include "../../properties/domains/generators/random.hpp"
#include "../../ref/constrained.hpp"
#include "../../ref/decomposition/cell_refiner.hpp"
#include "../../ref/faces.hpp"
#include "../../ref/independent.hpp"
#include "../../ref/insertion.hpp"
#include "../../ref/region.hpp"
#include "../../ref/ruppert.hpp"
#include "../../ref/wanted_length.hpp"
#include "../fingerprint.hpp"

namespace pardel::ref {

static void add_to(testing::Fingerprint& to, const Cell& c) { to.add_all(c.i, c.j, c.level); }
static void add_to(testing::Fingerprint& to, const PlainMesh& m) {
  for (const ExactPoint& p : m.points) to.add(rounded(p));
  to.add_all(m.triangles, m.constraints);
}
static void add_to(testing::Fingerprint& to, const HandedOn& h) { to.add_all(h.from, h.to, rounded(h.point)); }
static void add_to(testing::Fingerprint& to, const Insertion& i) { to.add_all(i.cell, rounded(i.point)); }
static void add_to(testing::Fingerprint& to, const Touched& t) {
  for (const ExactPoint& p : t.vertices) to.add(rounded(p));
  to.add(t.triangles);
}
static void add_to(testing::Fingerprint& to, const Phase& p) {
  to.add_all(p.colour, p.insertions, p.handed_on, p.touched, p.after);
}
static void add_to(testing::Fingerprint& to, const Lattice& l) {
  to.add_all(rounded(l.corner), CGAL::to_double(l.side));
}
static void add_to(testing::Fingerprint& to, const Quadtree& q) { to.add_all(q.corner, q.side, q.colour_of_leaf); }

namespace {

using generators::Random;
using testing::Fingerprint;
using testing::fingerprint;

template <class Cells>
std::string text(const Result<CellRefinement<Cells>>& refined) {
  if (!refined) return refined.error().message;
  Fingerprint all(refined->mesh, refined->preprocessed);
  for (const Sweep<Cells>& sweep : refined->sweeps) all.add_all(sweep.cells, sweep.phases);
  return std::to_string(refined->sweeps.size()) + " sweeps " + all.text();
}

std::string text(const Result<Mesh>& mesh) {
  if (!mesh) return mesh.error().message;
  return std::to_string(mesh->triangles.size()) + " triangles " + fingerprint(*mesh);
}

/// A square with a square hole and a crack, in which all angles are right, and a region.
Pslg ring(double x = 0, double y = 0) {
  Pslg pslg;
  pslg.points = {{x, y},         {x + 8, y},     {x + 8, y + 8}, {x, y + 8},     {x + 3, y + 2},
                 {x + 5, y + 2}, {x + 5, y + 4}, {x + 3, y + 4}, {x + 6, y + 6}, {x + 7, y + 6}};
  pslg.segments = {{0, 1, 2}, {1, 2}, {2, 3, 7}, {3, 0}, {4, 5}, {5, 6}, {6, 7}, {7, 4, 3}, {8, 9}};
  pslg.point_markers = {0, 5, 0, 0, 0, 0, 6, 0, 0, 0};
  pslg.holes = {{x + 4, y + 3}};
  pslg.regions = {{{x + 1, y + 1}, 4, 1.5}};
  return pslg;
}

TEST(Reference, refines_sequentially_as_recorded) {
  EXPECT_EQ(text(ruppert(domains::square(), {.max_area = 0.02})), "74 triangles 7c2748c160a8ab2e");
  EXPECT_EQ(text(ruppert(domains::square(), {.max_edge = 0.3})), "65 triangles 591d8faa090811b1");
  EXPECT_EQ(text(ruppert(domains::square(), {.size = [](Point p) { return 0.1 + p.x / 2; }})),
            "100 triangles b9394f423bf048a8");
  EXPECT_EQ(text(ruppert(ring(), {})), "20 triangles 380ea93cfd4fba06");
  EXPECT_EQ(text(ruppert(ring(), {.min_angle_deg = 12, .region_caps = true})), "62 triangles 3322edc20e269970");
  EXPECT_EQ(text(ruppert(ring(-3, 1000), {.max_area = 1})), "107 triangles da0056bbea086861");
  EXPECT_EQ(text(ruppert(domains::touching_holes(), {.max_area = 0.1})), "211 triangles 6d1ebfd7a4161975");
  EXPECT_EQ(text(ruppert(domains::regions(), {.region_caps = true})), "1079 triangles bf30b42ca94dde4d");
}

/// The refinement of several domains on lattices and on quadtrees.
std::vector<std::string> on_cells(const Turns& turns) {
  const Goal coarse{.max_area = 0.1}, fine{.max_area = 0.01};
  const Goal growing{.size = [](Point p) { return 0.5 + p.y / 4; }};
  return {
      text(refine_on_lattice(domains::square(), fine, coarse, turns)),
      text(refine_on_lattice(ring(5, -2), {.max_area = 0.6}, {.max_area = 2}, turns)),
      text(refine_on_lattice_sized_by(RadiusTheorem::t3, domains::square(), {.max_area = 0.003}, fine, turns)),
      text(refine_on_lattice_sized_by(RadiusTheorem::t3_sharp, domains::square(), {.max_area = 0.004}, fine, turns)),
      text(refine_on_quadtree(domains::square(), {.max_area = 0.005}, {.max_area = 0.02}, turns)),
      text(refine_on_quadtree(ring(1, 1), growing, {}, turns))};
}

TEST(Reference, refines_cells_in_rounds_as_recorded) {
  EXPECT_EQ(on_cells(in_rounds), (std::vector<std::string>{"2 sweeps be90d441c3cdba0c", "2 sweeps b7a9b77bf5686d57",
                                                           "2 sweeps f250060571364914", "3 sweeps 58ca34ae88247a47",
                                                           "3 sweeps a04cf6955699cad3", "3 sweeps 690777710cc0c7b0"}));
}

TEST(Reference, refines_one_cell_after_the_other_as_recorded) {
  EXPECT_EQ(on_cells(one_after_the_other),
            (std::vector<std::string>{"2 sweeps be90d441c3cdba0c", "2 sweeps b7a9b77bf5686d57",
                                      "2 sweeps f250060571364914", "3 sweeps 58ca34ae88247a47",
                                      "3 sweeps a04cf6955699cad3", "3 sweeps 690777710cc0c7b0"}));
}

/// A constrained Delaunay triangulation of points of a small lattice, with walls between random points.
PlainMesh random_mesh(std::uint64_t seed) {
  Random random(seed);
  const int side = seed % 2 == 0 ? 4 : 20;
  std::vector<Point> points;
  for (int i = 0; i < 14; ++i) {
    const Point p{double(random.between(0, side)), double(random.between(0, side))};
    if (std::ranges::find(points, p) == points.end()) points.push_back(p);
  }
  PlainMesh mesh = delaunay(points);
  for (int i = 0; i < 12; ++i) {
    const auto a = static_cast<Index>(random.below(points.size())), b = static_cast<Index>(random.below(points.size()));
    if (a == b) continue;
    const Kernel::Segment_2 wall(mesh.points[a], mesh.points[b]);
    bool free = true;
    for (Index v = 0; v < points.size(); ++v) free = free && (v == a || v == b || !wall.has_on(mesh.points[v]));
    for (const Edge& e : mesh.constraints) {
      const Kernel::Segment_2 other(mesh.points[e[0]], mesh.points[e[1]]);
      const bool joined = e[0] == a || e[0] == b || e[1] == a || e[1] == b;
      free = free && (joined || !CGAL::do_intersect(wall, other));
    }
    if (free) force_edge(mesh, a, b);
  }
  flip_to_delaunay(mesh);
  return mesh;
}

std::vector<ExactPoint> places(const PlainMesh& mesh) {
  std::vector<ExactPoint> all;
  for (const Corners& t : mesh.triangles) {
    all.push_back(CGAL::centroid(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]));
    all.push_back(CGAL::midpoint(mesh.points[t[0]], mesh.points[t[1]]));
  }
  return all;
}

TEST(Reference, applies_the_definitions_as_recorded) {
  Fingerprint meshes, sight, cavities, regions, pairs, changed;
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    const PlainMesh mesh = random_mesh(seed);
    meshes.add_all(mesh, is_delaunay(mesh), is_constrained_delaunay(mesh), is_conformal(mesh));
    for (const ExactPoint& p : mesh.points)
      for (const Corners& t : mesh.triangles) sight.add_all(sees(mesh, p, t), circumdisk_contains(mesh, t, p));
    const std::vector<ExactPoint> all = places(mesh);
    for (const ExactPoint& p : all) {
      const std::vector<Index> hole = cavity(mesh, p);
      cavities.add_all(hole, closure(mesh, hole), boundary(mesh, hole), free_edges(mesh, hole), encroached_by(mesh, p));
      for (const Corners& t : mesh.triangles) sight.add(sees(mesh, p, t));
    }
    for (const Edge& e : mesh.constraints) cavities.add(is_encroached(mesh, e));
    Random random(seed);
    for (int i = 0; i < 6; ++i) {
      const double x = random.between(-2, 20), y = random.between(-2, 20);
      const Box box{{x, y}, {x + random.between(0, 4), y + random.between(0, 4)}};
      const std::vector<Index> reached = in_reach_and_sight_of(mesh, box);
      regions.add_all(in_reach_of(mesh, box), reached, owns(mesh, box, reached));
    }
    for (std::size_t i = 0; i + 5 < all.size(); i += 3) {
      const ExactPoint &p = all[i], &q = all[i + 5];
      if (p == q || cavity(mesh, p).empty() || cavity(mesh, q).empty()) continue;
      pairs.add_all(closures_are_disjoint(mesh, p, q), are_independent(mesh, p, q), insert_independently(mesh, {p, q}));
    }
    // Meshes with mistakes.
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      PlainMesh wrong = mesh;
      std::swap(wrong.triangles[t][0], wrong.triangles[t][t % 2 + 1]);
      changed.add(is_conformal(wrong));
      wrong = mesh;
      wrong.triangles[t][t % 3] = static_cast<Index>((t * 5) % wrong.points.size());
      changed.add(is_conformal(wrong));
      wrong = mesh;
      wrong.triangles.push_back(mesh.triangles[t]);
      changed.add(is_conformal(wrong));
      wrong.triangles.back() = {mesh.triangles[t][1], mesh.triangles[t][2], mesh.triangles[t][0]};
      changed.add(is_conformal(wrong));
    }
  }
  EXPECT_EQ(meshes.text(), "16aeb206491f1a26");
  EXPECT_EQ(sight.text(), "31f8896bca572c56");
  EXPECT_EQ(cavities.text(), "16c3de6970371698");
  EXPECT_EQ(regions.text(), "2ce8b3834a735dc5");
  EXPECT_EQ(pairs.text(), "ba6a2afb42fff854");
  EXPECT_EQ(changed.text(), "040a72db3c3ce93c");
}

TEST(Reference, finds_faces_and_carves_them_as_recorded) {
  Fingerprint all;
  for (const Pslg& pslg : {ring(), ring(100, -7), domains::touching_holes(), domains::regions()}) {
    const Refinement state = conforming_delaunay(pslg);
    all.add_all(state.mesh, state.provenance.origin, state.provenance.segment_of_edge);
    for (const ExactPoint& p : places(state.mesh)) all.add(face_of(state.mesh, p));
    all.add(to_plain_mesh(to_mesh(state.mesh, state.provenance, pslg)));
  }
  EXPECT_EQ(all.text(), "88ef4439a4e34feb");
}

TEST(Reference, divides_the_plane_into_cells_as_recorded) {
  Fingerprint lattices, trees;
  for (const double far : {0.0, -17.0, 1e6}) {
    const PlainMesh mesh = to_plain_mesh(*ruppert(ring(far, 2 * far), {.max_area = 2}));
    const Lattice lattice = lattice_over(mesh);
    lattices.add_all(lattice, allows(lattice, mesh));
    for (const ExactPoint& p : mesh.points) lattices.add(cell_of(lattice, p));
    for (int i = -9; i <= 9; ++i)
      for (int j = -9; j <= 9; ++j) {
        const ExactPoint p(lattice.corner.x() + lattice.side * i / 3, lattice.corner.y() + lattice.side * j / 3);
        const Cell cell = cell_of(lattice, p);
        lattices.add_all(cell, colour_of(lattice, cell));
        EXPECT_EQ(cell.i, std::floor(i / 3.0));
        EXPECT_EQ(cell.j, std::floor(j / 3.0));
      }
    const Quadtree tree = quadtree_over(mesh);
    trees.add_all(tree, allows(tree, mesh), colours(tree));
    for (const ExactPoint& p : mesh.points) trees.add(cell_of(tree, p));
    for (const auto& [leaf, colour] : tree.colour_of_leaf) {
      trees.add_all(buffer_zone(tree, leaf), may_be_refined(tree, leaf, mesh), may_be_refined(tree, leaf, mesh, 0.05));
      for (const auto& [other, of_other] : tree.colour_of_leaf) trees.add(touch(leaf, other));
      const Box box = box_of(tree, leaf);
      EXPECT_EQ(cell_of(tree, exact(box.low)), leaf) << "the lower left corner belongs to the leaf";
    }
  }
  trees.add(uniform_quadtree({1, 2}, 8, 2));
  EXPECT_EQ(lattices.text(), "3edb0ac457978088");
  EXPECT_EQ(trees.text(), "a9236a10738afd1f");
}

TEST(Reference, reaches_all_triangles_in_a_box_around_them_and_none_in_a_box_far_away) {
  for (std::uint64_t seed = 0; seed < 4; ++seed) {
    const PlainMesh mesh = random_mesh(seed);
    const Box all{{-1e6, -1e6}, {1e6, 1e6}};
    EXPECT_EQ(in_reach_of(mesh, all).size(), mesh.triangles.size());
    EXPECT_EQ(in_reach_and_sight_of(mesh, all).size(), mesh.triangles.size());
    EXPECT_TRUE(in_reach_of(mesh, {{1e9, 1e9}, {1e9 + 1, 1e9 + 1}}).empty());
    EXPECT_TRUE(owns(mesh, all, in_reach_of(mesh, all)));
    EXPECT_FALSE(owns(mesh, {{1, 1}, {2, 2}}, in_reach_of(mesh, all)));
  }
}

TEST(Reference, needs_one_colour_for_one_leaf) {
  EXPECT_EQ(colours(uniform_quadtree({0, 0}, 4, 0)), 1);
  EXPECT_GE(colours(uniform_quadtree({0, 0}, 4, 1)), 2);
}

/// The least length of a piece is that of its nearest point, if the lengths along it change little.
TEST(Reference, lets_lengths_grow_from_the_best_place_of_a_piece) {
  Pslg pslg;
  pslg.points = {{-1e3, -1e3}, {1e3, -1e3}, {1e3, 1e3}, {-1e3, 1e3}};
  pslg.segments = {{0, 1}, {1, 2}, {2, 3}, {3, 0}};
  Goal goal{.grading = 0.5};
  goal.sources = {{{0, 0}, {4, 0}, 1, 1}, {{0, 50}, {8, 50}, 1, 3}, {{50, 0}, {50, 0}, 2, 2}};
  const WantedLength wanted(pslg, goal);
  EXPECT_NEAR(wanted.at({2, 1}), 1.5, 1e-9);
  EXPECT_NEAR(wanted.at({-3, 4}), 3.5, 1e-9);
  EXPECT_NEAR(wanted.at({50, 6}), 5, 1e-9);
  for (const Point p : {Point{4, 53}, {1, 47}, {7, 50}, {9, 54}, {-2, 51}}) {
    double least = 1e9;
    for (int i = 0; i <= 100'000; ++i) {
      const double f = i / 1e5, x = p.x - 8 * f, y = p.y - 50;
      least = std::min(least, 1 + 2 * f + 0.5 * std::sqrt(x * x + y * y));
    }
    EXPECT_NEAR(wanted.at(p), least, 1e-6);
  }
}

/// A polygon with corners on a circle, which turns by 22.5 degrees at each: no point is a corner, and the opposite side
/// is far away.
TEST(Reference, takes_the_radius_of_the_turn_as_the_width_at_every_point_of_a_round_outline) {
  Pslg pslg;
  for (Index v = 0; v < 16; ++v) {
    const double angle = v * std::numbers::pi / 8;
    pslg.points.push_back({10 * std::cos(angle), 10 * std::sin(angle)});
    pslg.segments.push_back({v, (v + 1) % 16});
  }
  const WantedLength wanted(pslg, {.feature_edges = 2});
  for (const Point p : pslg.points) EXPECT_NEAR(wanted.at(p), 10 * std::cos(std::numbers::pi / 16) / 2, 1e-9);
}

TEST(Reference, lets_lengths_of_features_grow_by_one_edge_per_edge_if_the_gradation_has_no_limit) {
  Pslg pslg;
  pslg.points = {{0, 0}, {8, 0}, {8, 2}, {0, 2}};
  pslg.segments = {{0, 1}, {1, 2}, {2, 3}, {3, 0}};
  const WantedLength wanted(pslg, {.feature_edges = 2}, 4);
  EXPECT_EQ(wanted.slope(), 0.5);
  EXPECT_EQ(wanted.at({4, 0}), 1) << "half of the distance to the opposite side";
  EXPECT_EQ(wanted.at({4, -2}), 2);
  EXPECT_EQ(wanted.error(), 1) << "half of the distance of two places, where width and length change by a half each";
}

}  // namespace
}  // namespace pardel::ref
