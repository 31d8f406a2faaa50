// Cells of four colours, leaves of quadtrees, and tasks that own boxes, on simulated workers.
#include <algorithm>
#include <map>
#include <set>

#include "../../../ref/schemes/cells/circumradius.hpp"
#include "../../../ref/schemes/cells/quadtree_cells.hpp"
#include "../../../ref/schemes/lattice.hpp"
#include "../../../ref/schemes/quadtree.hpp"
#include "../../../ref/schemes/region_boxes.hpp"
#include "../../domains/domains.hpp"
#include "same_triangles.hpp"
#include "some_problem.hpp"

namespace pardel::properties {
namespace {

using schemes::Account;
using schemes::LinkedMesh;
using schemes::Outcome;
using schemes::cells::Assignment;
using schemes::cells::PhaseRecord;
using schemes::cells::Turns;

enum class Kind { lattice, sharp, quadtree, boxes };

struct How {
  Kind kind = Kind::lattice;
  int cells = 16;
  Assignment assignment = Assignment::blocks;
  Turns turns = Turns::one_after_the_other;
  schemes::cells::Watch watch{};
};

template <class Options>
Options filled(const How& how) {
  Options o;
  o.cells = how.cells;
  o.assignment = how.assignment;
  o.turns = how.turns;
  o.watch = how.watch;
  return o;
}

Outcome refined_in_cells(const SchemeCase& c, const How& how) {
  const schemes::Problem problem = c.problem();
  if (how.kind == Kind::quadtree) return required(schemes::quadtree(problem, filled<schemes::QuadtreeOptions>(how)));
  if (how.kind == Kind::boxes)
    return required(schemes::region_boxes(problem, filled<schemes::RegionBoxesOptions>(how)));
  auto options = filled<schemes::LatticeOptions>(how);
  if (how.kind == Kind::sharp) options.side = schemes::CellSide::two_radii;
  return required(schemes::lattice(problem, options));
}

/// A case that often needs so many triangles that there is work for several cells.
SchemeCase some_fine_case(Exhibit& exhibit) {
  SchemeCase c = some_scheme_case(exhibit);
  if (*rc::gen::inRange(0, 4) == 0) return c;
  const auto [left, right] = std::ranges::minmax(c.pslg.points, {}, &Point::x);
  const auto [low, high] = std::ranges::minmax(c.pslg.points, {}, &Point::y);
  c.goal.max_area = std::min(c.goal.max_area, (right.x - left.x) * (high.y - low.y) / *rc::gen::inRange(50, 250));
  return c;
}

How some_cells(Kind kind) {
  How how{kind};
  how.cells = *rc::gen::element(4, 16, 40, 100);
  how.assignment = *rc::gen::element(Assignment::blocks, Assignment::round_robin);
  how.turns = *rc::gen::element(Turns::one_after_the_other, Turns::in_rounds);
  return how;
}
Kind any_kind() { return *rc::gen::element(Kind::lattice, Kind::quadtree, Kind::boxes); }

/// How many vertices and triangles two cells of the phase touched.
struct Meetings {
  int vertices = 0, triangles = 0;
};
int common(const PhaseRecord& record, std::vector<Index> schemes::cells::Touched::*what) {
  std::map<Index, Index> first;
  std::set<Index> met;
  for (const auto& [cell, touched] : record.touched)
    for (const Index x : touched.*what)
      if (first.emplace(x, cell).first->second != cell) met.insert(x);
  return static_cast<int>(met.size());
}
Meetings meetings(const PhaseRecord& record) {
  return {common(record, &schemes::cells::Touched::vertices), common(record, &schemes::cells::Touched::triangles)};
}

/// What a run showed of its phases.
struct Seen {
  int phases = 0, busy = 0;  ///< busy: at least two cells inserted or read something
  std::size_t sweeps = 0;
  int cells = 0, vertices = 0, triangles = 0, handed_on = 0, far = 0;
  bool outgrown = false;
  std::uint64_t insertions = 0, first_sweep = 0;
  void operator()(const PhaseRecord& record) {
    ++phases;
    sweeps = record.sweep + 1;
    cells = std::max(cells, static_cast<int>(record.division.colour.size()));
    busy += record.touched.size() >= 2 ? 1 : 0;
    const Meetings met = meetings(record);
    vertices += met.vertices;
    triangles += met.triangles;
    outgrown = outgrown || record.ends_sweep;
    insertions += record.insertions;
    if (record.sweep == 0) first_sweep += record.insertions;
    for (const auto& [from, to] : record.handed_on) {
      ++handed_on;
      const std::vector<Index> near = record.division.touching(from);
      far += to != from && std::ranges::find(near, to) == near.end() ? 1 : 0;
    }
  }
};
Outcome watched(const SchemeCase& c, How how, Seen& seen) {
  how.watch = [&](const PhaseRecord& record) { seen(record); };
  return refined_in_cells(c, how);
}

PARDEL_PROPERTY(CellSchemes, end_with_a_certified_mesh,
                {.statement = "Lattices of sides 4 r and 2 r, quadtrees and boxes end with a mesh that the checker "
                              "certifies, whatever is chosen.",
                 .source = "[CC]; properties/THEORY.md, Lattice, Quadtree, T-region",
                 .families = scheme_families}) {
  const SchemeCase c = some_fine_case(exhibit);
  const Kind kind = *rc::gen::element(Kind::lattice, Kind::sharp, Kind::quadtree, Kind::boxes);
  const Outcome o = refined_in_cells(c, some_cells(kind));
  classify(o.account.work > 0, "cells work", 40);
  certify(o.mesh, c, exhibit);
}

PARDEL_PROPERTY(CellSchemes, depend_neither_on_workers_nor_on_the_order_of_the_cells,
                {.statement = "The mesh depends neither on the number of workers, nor on which worker has which cell, "
                              "nor on the order in which the cells of a phase take their steps.",
                 .source = "properties/THEORY.md, Lattice (e), Quadtree, T-region",
                 .families = scheme_families}) {
  SchemeCase c = some_fine_case(exhibit);
  const Kind kind = any_kind();
  How how = some_cells(kind);
  Seen seen;
  const std::vector<PlacedTriangle> first = placed_triangles(watched(c, how, seen).mesh);
  c.workers = *rc::gen::inRange(1, 10);
  c.seed += 1;
  how.turns = how.turns == Turns::in_rounds ? Turns::one_after_the_other : Turns::in_rounds;
  how.assignment = Assignment::round_robin;
  classify(seen.busy > 0, "two cells work in one phase", 10);
  RC_ASSERT(first == placed_triangles(refined_in_cells(c, how).mesh));
}

PARDEL_PROPERTY(CellSchemes, touch_no_common_vertex_or_triangle_in_a_phase,
                {.statement = "If cells have the side 4 r, or if leaves are wide enough, two cells of a phase touch "
                              "neither a common vertex nor a common triangle, rings included.",
                 .source = "[CC] Theorem 1; properties/THEORY.md, Lattice (b), Quadtree",
                 .families = scheme_families}) {
  const SchemeCase c = some_fine_case(exhibit);
  Seen seen;
  static_cast<void>(watched(c, some_cells(*rc::gen::element(Kind::lattice, Kind::quadtree)), seen));
  classify(seen.busy > 0, "two cells work in one phase", 10);
  RC_ASSERT(seen.vertices == 0);
  RC_ASSERT(seen.triangles == 0);
}

PARDEL_PROPERTY(
    CellSchemes, discard_nothing,
    {.statement = "No insertion is set back and no work is discarded: it is the work of the cells, phase by "
                  "phase, and every insertion stays.",
     .source = "[CC] Theorem 1",
     .families = scheme_families}) {
  const SchemeCase c = some_fine_case(exhibit);
  Seen seen;
  const Kind kind = any_kind();
  const Outcome o = watched(c, some_cells(kind), seen);
  const Account& a = o.account;
  RC_ASSERT(a.set_backs == 0U);
  RC_ASSERT(a.wasted == 0U);
  RC_ASSERT(a.insertions == o.mesh.points.size() - c.pslg.points.size());
  RC_ASSERT(a.rounds == static_cast<std::uint64_t>(seen.phases));
  RC_ASSERT(a.barriers == a.rounds);
  RC_ASSERT(seen.insertions <= a.insertions);
  RC_ASSERT(a.before == a.sequential || a.work == 0);
  RC_ASSERT(a.critical <= a.sequential + a.work);
  RC_ASSERT(a.critical >= a.sequential + a.work / static_cast<std::uint64_t>(c.workers));
  if (c.workers == 1) RC_ASSERT(a.messages == 0U);
  if (c.workers == 1) RC_ASSERT(a.critical == a.sequential + a.work);
  classify(seen.insertions > 0 && c.workers > 1, "several workers insert", 20);
}

PARDEL_PROPERTY(CellSchemes, do_the_same_work_with_any_number_of_workers,
                {.statement = "Sequential work, the work of cells, phases and insertions do not depend on the number "
                              "of workers; only who does it does.",
                 .source = "properties/THEORY.md, Lattice (e)",
                 .families = scheme_families}) {
  SchemeCase c = some_fine_case(exhibit);
  const How how = some_cells(any_kind());
  const Account first = refined_in_cells(c, how).account;
  c.workers = c.workers % 9 + 1;
  const Account second = refined_in_cells(c, how).account;
  RC_ASSERT(first.work == second.work);
  RC_ASSERT(first.sequential == second.sequential);
  RC_ASSERT(first.rounds == second.rounds);
  RC_ASSERT(first.insertions == second.insertions);
  classify(first.messages > 0 || second.messages > 0, "messages are sent", 15);
}

PARDEL_PROPERTY(CellSchemes, send_only_to_workers_of_touching_cells,
                {.statement = "As long as no circumradius outgrows the cells, a cell hands on to touching cells only. "
                              "The messages of a phase are at most the pairs of workers of touching cells.",
                 .source = "[CC], structured communication; properties/THEORY.md, Lattice (c)",
                 .families = scheme_families}) {
  const SchemeCase c = some_fine_case(exhibit);
  How how = some_cells(Kind::lattice);
  Seen seen;
  std::uint64_t most = 0;
  how.watch = [&](const PhaseRecord& record) {
    seen(record);
    std::set<std::pair<int, int>> pairs;
    for (const auto& [cell, touched] : record.touched)
      for (const Index other : record.division.touching(cell))
        if (record.division.worker[cell] != record.division.worker[other])
          pairs.insert({record.division.worker[cell], record.division.worker[other]});
    most += pairs.size();
  };
  const Outcome o = refined_in_cells(c, how);
  classify(seen.handed_on > 0, "something is handed on", 10);
  if (seen.outgrown) return;
  RC_ASSERT(seen.far == 0);
  RC_ASSERT(o.account.messages <= most);
}

PARDEL_PROPERTY(CellSchemes, leave_no_border_in_the_mesh,
                {.statement = "No line between cells is in the mesh: every new vertex is a circumcentre inside a face "
                              "or splits a segment, and only segments are constrained.",
                 .source = "[CC], decomposition independence",
                 .families = scheme_families}) {
  const SchemeCase c = some_fine_case(exhibit);
  const std::size_t segments = some_start(c).mesh.segments.size();
  const Outcome o = refined_in_cells(c, some_cells(any_kind()));
  RC_ASSERT(o.mesh.segments.size() == segments);
  RC_ASSERT(o.mesh.segment_of.size() == o.mesh.points.size());
  bool splits = false;
  for (const schemes::Face& face : o.mesh.faces)
    for (std::size_t i = 0; i < 3; ++i) {
      const Index s = face.segment[i];
      if (s == schemes::no_segment) continue;
      for (const std::size_t k : {i + 1, i + 2}) {
        const Index v = face.v[k % 3];
        if (v < c.pslg.points.size()) continue;
        splits = true;
        RC_ASSERT(o.mesh.segment_of[v] == s);
      }
    }
  classify(splits, "a segment is split", 30);
}

PARDEL_PROPERTY(CellSchemes, of_two_radii_do_not_depend_on_the_order_if_no_circumradius_grows,
                {.statement = "Cells of side 2 r give one mesh in any order of their steps if no circumradius outgrows "
                              "them in a phase, though two of them may touch a common triangle.",
                 .source = "properties/THEORY.md, T1-sharp",
                 .families = scheme_families}) {
  SchemeCase c = some_fine_case(exhibit);
  How how = some_cells(Kind::sharp);
  Seen seen;
  const std::vector<PlacedTriangle> first = placed_triangles(watched(c, how, seen).mesh);
  classify(!seen.outgrown && seen.busy > 0, "two cells work, no circumradius grows", 10);
  if (seen.outgrown) return;
  c.seed += 1;
  how.turns = how.turns == Turns::in_rounds ? Turns::one_after_the_other : Turns::in_rounds;
  RC_ASSERT(first == placed_triangles(refined_in_cells(c, how).mesh));
}

PARDEL_PROPERTY(
    CellSchemes, give_each_leaf_a_buffer_zone_of_other_colours,
    {.statement = "No leaf of a quadtree over a mesh has the colour of a leaf of its buffer zone, a leaf is in "
                  "the buffer zones of those in its own, and all circumdisks of the mesh are allowed.",
     .source = "properties/THEORY.md, Quadtree (1)",
     .families = scheme_families}) {
  const SchemeCase c = some_scheme_case(exhibit);
  schemes::Start start = some_start(c);
  schemes::refine_sequentially(start.mesh, start.bounds, 1'000'000);
  const schemes::Territory territory(start.mesh, start.bounds, c.workers);
  const schemes::cells::Division leaves =
      schemes::cells::quadtree_cells(start.mesh, start.bounds, 200, 0.25, Assignment::blocks, territory);
  classify(leaves.colour.size() > 20, "more than 20 leaves", 20);
  for (Index leaf = 0; leaf < leaves.colour.size(); ++leaf)
    for (const Index other : leaves.touching(leaf)) {
      RC_ASSERT(leaves.colour[leaf] != leaves.colour[other]);
      const std::vector<Index> back = leaves.touching(other);
      RC_ASSERT(std::ranges::find(back, leaf) != back.end());
    }
  for (Index t = 0; t < start.mesh.faces.size(); ++t)
    if (start.mesh.in_use(t))
      RC_ASSERT(leaves.allows(schemes::circumcentre(start.mesh, t), schemes::cells::circumradius(start.mesh, t)));
}

PARDEL_PROPERTY(CellSchemes, that_own_boxes_write_only_in_them,
                {.statement = "All vertices of the cavities of a task that owns a box lie in its box, and boxes of one "
                              "phase are disjoint: no vertex is touched by two tasks.",
                 .source = "properties/THEORY.md, T-region",
                 .families = scheme_families}) {
  const SchemeCase c = some_fine_case(exhibit);
  How how = some_cells(Kind::boxes);
  bool inside = true;
  Seen seen;
  how.watch = [&](const PhaseRecord& record) {
    seen(record);
    for (const auto& [cell, touched] : record.touched)
      for (const Index v : touched.vertices) inside = inside && record.division.in_box(cell, record.mesh.points[v]);
  };
  static_cast<void>(refined_in_cells(c, how));
  classify(seen.busy > 0, "two cells work in one phase", 10);
  RC_ASSERT(inside);
  RC_ASSERT(seen.vertices == 0);
}

SchemeCase square_case(int workers, double max_area) {
  SchemeCase c{domains::square(), {}, workers};
  c.goal.max_area = max_area;
  return c;
}

PARDEL_FACT(CellSchemes, give_one_mesh_in_many_orders,
            {.statement = "Over a square with thousands of triangles, eight orders of the cells give one mesh.",
             .source = "properties/THEORY.md, Lattice (e), Quadtree, T-region",
             .families = "the unit square, areas up to 1e-4, lattice, quadtree and boxes"}) {
  for (const Kind kind : {Kind::lattice, Kind::quadtree, Kind::boxes}) {
    SchemeCase c = square_case(4, 1e-4);
    How how{kind, 64};
    const std::vector<PlacedTriangle> first = placed_triangles(refined_in_cells(c, how).mesh);
    for (c.seed = 2; c.seed < 9; ++c.seed, ++facts.cases) {
      how.turns = c.seed % 2 == 0 ? Turns::in_rounds : Turns::one_after_the_other;
      EXPECT_TRUE(first == placed_triangles(refined_in_cells(c, how).mesh)) << static_cast<int>(kind) << " " << c.seed;
    }
  }
}

PARDEL_FACT(CellSchemes, insert_nearly_all_points_in_the_first_sweep,
            {.statement = "One sweep of four phases inserts more than nine tenths of the points, but it is not the "
                          "last sweep: phases of the first colours leave triangles for those of later sweeps.",
             .source = "[CC], four phases",
             .families = "the unit square, areas up to 1e-4, 4 and 16 workers"}) {
  for (const int workers : {4, 16}) {
    Seen seen;
    const Outcome o = watched(square_case(workers, 1e-4), {Kind::lattice, 4 * workers}, seen);
    ++facts.cases;
    EXPECT_GT(static_cast<double>(seen.first_sweep), 0.9 * static_cast<double>(seen.insertions));
    EXPECT_GT(seen.sweeps, 1U);
    EXPECT_LE(seen.sweeps, 10U);
    facts.notes.push_back(std::to_string(workers) + " workers: " + std::to_string(seen.first_sweep) + " of " +
                          std::to_string(seen.insertions) + " points in the first of " + std::to_string(seen.sweeps) +
                          " sweeps.");
  }
}

PARDEL_FACT(CellSchemes, of_two_radii_are_four_times_as_many_and_meet_in_triangles,
            {.statement = "Over one mesh, cells of side 2 r are about four times as many as cells of side 4 r; two "
                          "tasks of a phase then touch common triangles, which they never do with 4 r.",
             .source = "properties/THEORY.md, T1, T1-sharp",
             .families = "the unit square, areas up to 1e-4"}) {
  const SchemeCase c = square_case(16, 1e-4);
  schemes::Start start = some_start(c);
  schemes::refine_sequentially(start.mesh, start.bounds, 1'000'000);
  const schemes::Territory territory(start.mesh, start.bounds, c.workers);
  const auto cells = [&](double radii) {
    const double radius = schemes::cells::largest_circumradius(start.mesh);
    return schemes::lattice_over(start.mesh, radius, radii, Assignment::blocks, territory).colour.size();
  };
  EXPECT_GT(static_cast<double>(cells(2)), 3.5 * static_cast<double>(cells(4)));
  EXPECT_LT(static_cast<double>(cells(2)), 4.5 * static_cast<double>(cells(4)));
  Seen sharp, wide;
  static_cast<void>(watched(c, {Kind::sharp, 256}, sharp));
  static_cast<void>(watched(c, {Kind::lattice, 256}, wide));
  EXPECT_GT(sharp.triangles, 0);
  EXPECT_EQ(wide.triangles, 0);
  EXPECT_EQ(wide.vertices, 0);
  facts.cases = 2;
  facts.notes.push_back("2 r: " + std::to_string(cells(2)) + " cells, 4 r: " + std::to_string(cells(4)) +
                        " cells; tasks met in " + std::to_string(sharp.triangles) + " triangles.");
}

PARDEL_FACT(CellSchemes, boxes_need_no_preprocessing_and_quadtrees_follow_the_size,
            {.statement = "Tasks that own boxes begin with the triangulation of the domain, and 16 workers work at the "
                          "same time. Over a graded mesh a "
                          "quadtree has a shorter critical path than a lattice with as many workers.",
             .source = "properties/THEORY.md, T-region, Quadtree",
             .families = "the unit square, uniform areas and edges that grow from a corner, 16 workers"}) {
  const SchemeCase uniform = square_case(16, 1e-4);
  const Account boxes = refined_in_cells(uniform, {Kind::boxes, 64}).account,
                cells = refined_in_cells(uniform, {Kind::lattice, 64}).account;
  EXPECT_EQ(boxes.sequential, some_start(uniform).account.sequential);
  EXPECT_GT(cells.sequential, 10 * boxes.sequential);
  EXPECT_GT(schemes::parallelism(boxes), 4);
  SchemeCase graded = square_case(16, 1);
  graded.goal.size = [](Point p) { return 1e-3 * (1 + 60 * std::hypot(p.x, p.y)); };
  const Account leaves = refined_in_cells(graded, {Kind::quadtree, 64}).account,
                flat = refined_in_cells(graded, {Kind::lattice, 64}).account;
  EXPECT_LT(leaves.critical, flat.critical);
  facts.cases = 2;
  facts.notes.push_back("Critical paths over the graded square: " + std::to_string(leaves.critical) + " (quadtree), " +
                        std::to_string(flat.critical) + " (lattice).");
}

}  // namespace
}  // namespace pardel::properties
