// Refinement in parts that are divided by projected paths, with a dedicated processor for potential conflicts.
#include "../../../ref/schemes/kadow.hpp"

#include "../../../ref/schemes/kadow/parted_mesh.hpp"
#include "../../domains/domains.hpp"
#include "some_points.hpp"

namespace pardel::properties {
namespace {

using schemes::KadowOptions;
using schemes::KadowRun;
using schemes::LinkedMesh;

KadowOptions some_kadow_options() {
  KadowOptions options;
  options.division.cuts = *rc::gen::element(schemes::CutOrder::alternating, schemes::CutOrder::longer_extent);
  options.per_round = *rc::gen::inRange<std::size_t>(1, 20);
  options.least_to_divide = *rc::gen::inRange<std::size_t>(1, 20);
  return options;
}

schemes::PartedStart some_parted_start(const SchemeCase& c, const schemes::GivenPointsOptions& options = {}) {
  return required(schemes::parted_start(c.problem(), options));
}

PARDEL_PROPERTY(Kadow, meshes_are_certified,
                {.statement = "Whatever the number of workers and the open choices are, the mesh is certified.",
                 .source = "Kadow 2004; Ruppert 1995",
                 .families = scheme_families}) {
  const SchemeCase c = some_scheme_case(exhibit);
  const KadowRun run = required(schemes::kadow_in_detail(c.problem(), some_kadow_options()));
  classify(run.destroyed > 0, "an interface edge is destroyed", 20);
  classify(run.parts_divided > 0, "a part is divided during refinement", 10);
  certify(run.outcome.mesh, c, exhibit);
}

PARDEL_PROPERTY(
    Kadow, start_conforms_to_the_domain,
    {.statement = "The start is a Delaunay triangulation of the domain in which every segment is a union "
                  "of edges that are locally Delaunay, too. It is the same for any number of workers and any "
                  "order of cuts.",
     .source = "Ruppert 1995, Section 2",
     .families = scheme_families}) {
  SchemeCase c = some_scheme_case(exhibit);
  c.goal = {.min_angle_deg = 0, .conforming = true};
  const schemes::PartedStart start = some_parted_start(c, some_kadow_options().division);
  classify(start.account.insertions > 0, "a segment is split", 10);
  certify(start.mesh, c, exhibit);
  classify(c.workers > 1, "several workers", 50);
  c.workers = 1;
  RC_ASSERT(placed_triangles(some_parted_start(c).mesh) == placed_triangles(start.mesh));
}

PARDEL_PROPERTY(Kadow, workers_of_a_round_work_in_any_order,
                {.statement = "Neither the mesh nor the account depends on the order in which the workers of a round "
                              "are simulated: they read and write only what is their own.",
                 .source = "Kadow 2004 (potential conflicts are left to a dedicated processor)",
                 .families = scheme_families}) {
  const SchemeCase c = some_scheme_case(exhibit);
  const KadowOptions options = some_kadow_options();
  const KadowRun run = required(schemes::kadow_in_detail(c.problem(), options));
  classify(run.by_dedicated > 0 && run.by_workers > 0, "workers and the dedicated processor insert", 20);
  SchemeCase in_other_order = c;
  ++in_other_order.seed;
  const KadowRun other = required(schemes::kadow_in_detail(in_other_order.problem(), options));
  RC_ASSERT(placed_triangles(run.outcome.mesh) == placed_triangles(other.outcome.mesh));
  RC_ASSERT(run.outcome.account == other.outcome.account);
}

PARDEL_PROPERTY(Kadow, one_worker_is_rupperts_algorithm,
                {.statement = "One worker makes the mesh of Ruppert's algorithm from the same start, in rounds of any "
                              "length, without a message, a conflict or waste.",
                 .source = "Ruppert 1995",
                 .families = scheme_families}) {
  SchemeCase c = some_scheme_case(exhibit);
  c.workers = 1;
  schemes::PartedStart start = some_parted_start(c);
  schemes::refine_sequentially(start.mesh, start.bounds, 1'000'000);
  schemes::compact(start.mesh);
  const KadowRun run = required(schemes::kadow_in_detail(c.problem(), some_kadow_options()));
  classify(run.by_workers > 0, "something is inserted", 50);
  RC_ASSERT(placed_triangles(run.outcome.mesh) == placed_triangles(start.mesh));
  const schemes::Account& a = run.outcome.account;
  RC_ASSERT(a.messages + a.set_backs + a.wasted + a.sequential + run.by_dedicated == 0U);
  RC_ASSERT(a.critical == a.work);
}

PARDEL_PROPERTY(Kadow, every_insertion_is_counted,
                {.statement = "Insertions are those of the start, of workers and of the dedicated processor. It does "
                              "at most what was set back. Each insertion that was set back wasted at least four reads "
                              "(a triangle and three sides), "
                              "and each that the dedicated processor did took one message in and one out at least.",
                 .source = "ref/schemes/kadow.hpp",
                 .families = scheme_families}) {
  const SchemeCase c = some_scheme_case(exhibit);
  const schemes::PartedStart start = some_parted_start(c);
  KadowOptions options = some_kadow_options();
  options.division = {};
  const KadowRun run = required(schemes::kadow_in_detail(c.problem(), options));
  const schemes::Account& a = run.outcome.account;
  RC_ASSERT(a.insertions == run.outcome.mesh.points.size() - c.pslg.points.size());
  RC_ASSERT(a.insertions == start.account.insertions + run.by_workers + run.by_dedicated);
  RC_ASSERT(a.set_backs >= run.by_dedicated);
  RC_ASSERT(a.wasted >= 4 * a.set_backs);
  RC_ASSERT((a.wasted == 0U) == (a.set_backs == 0U));
  RC_ASSERT(a.work >= a.wasted);
  RC_ASSERT(a.critical >= a.sequential);
  RC_ASSERT(a.messages - start.account.messages >= run.by_dedicated + run.parts_divided + (run.destroyed > 0 ? 1 : 0));
  RC_ASSERT(a.most_held * static_cast<std::uint64_t>(c.workers) >= run.outcome.mesh.faces.size());
  classify(a.set_backs > run.by_dedicated, "an insertion that was set back is no longer needed", 2);
}

PARDEL_PROPERTY(Kadow, new_triangles_belong_to_the_owners_of_the_cavity,
                {.statement = "Each new triangle belongs to the owner of the old triangle at the same side of the "
                              "cavity, and waits there; all owners of new triangles were owners of the cavity.",
                 .source = "Kadow 2004 (an interface that an insertion destroys is replaced)",
                 .families = scheme_families}) {
  const SchemeCase c = some_scheme_case(exhibit);
  schemes::PartedStart start = some_parted_start(c);
  const schemes::Bounds bounds = start.bounds;
  schemes::PartedMesh parted = schemes::parted_mesh(std::move(start));
  bool crosses = false;
  for (Index t = 0; t < parted.mesh.faces.size() && parted.mesh.faces.size() < 200; ++t) {
    if (!parted.mesh.in_use(t)) continue;
    const auto insertion = schemes::insertion_for(parted.mesh, t, bounds);
    if (!insertion) continue;
    const schemes::PartedMesh before = parted;
    const std::vector<int> owners = schemes::owners_of(before, insertion->cavity);
    crosses = crosses || owners.size() > 1;
    schemes::carry_out(parted, *insertion);
    std::vector<std::uint64_t> held(before.held.size(), 0);
    for (Index u = 0; u < parted.mesh.faces.size(); ++u)
      if (parted.mesh.in_use(u)) ++held.at(static_cast<std::size_t>(parted.owner[u]));
    RC_ASSERT(held == parted.held);
    for (const schemes::Side side : insertion->cavity.boundary) {
      const auto edge = schemes::ends(before.mesh, side);
      const int owner = before.owner[side.triangle];
      for (Index u = 0; u < parted.mesh.faces.size(); ++u)
        if (parted.mesh.in_use(u) && schemes::ends(parted.mesh, {u, 0}) == edge &&
            parted.mesh.faces[u].v[0] + 1 == parted.mesh.points.size()) {
          RC_ASSERT(parted.owner[u] == owner);
          const auto& waiting = parted.waiting.at(static_cast<std::size_t>(owner));
          RC_ASSERT(std::ranges::find(waiting, u) != waiting.end());
        }
    }
  }
  classify(crosses, "a cavity has several owners", 20);
}

PARDEL_FACT(Kadow, divides_the_start_and_grown_parts_among_all_workers,
            {.statement = "Of n random points, no worker holds more than 3 n / workers triangles of the start. In the "
                          "unit square, which has no point to divide it, every worker gets a part during refinement.",
             .source = "Kadow, Walkington 2004 (dynamic partitioning)",
             .families = "5,000 random points, 1 to 64 workers; the unit square, 1 to 32 workers"}) {
  const Pslg points = domains::random_points(5000, 1), square = domains::square();
  Goal goal;
  for (int workers = 1; workers <= 64; workers *= 2, ++facts.cases) {
    const auto start = schemes::parted_start({points, goal, workers}, {});
    ASSERT_TRUE(start);
    EXPECT_LE(start->account.most_held * static_cast<std::uint64_t>(workers), 3 * points.points.size()) << workers;
  }
  goal.max_area = 1e-4;
  for (int workers = 1; workers <= 32; workers *= 2, ++facts.cases) {
    KadowOptions options;
    options.least_to_divide = 16;
    const auto run = schemes::kadow_in_detail({square, goal, workers}, options);
    ASSERT_TRUE(run);
    EXPECT_EQ(run->parts_divided, static_cast<std::uint64_t>(workers) - 1);
    EXPECT_EQ(std::set<int>(run->owner.begin(), run->owner.end()).size(), static_cast<std::size_t>(workers));
  }
}

/// A rectangle with one point inside, through which a path divides it.
Pslg rectangle_with_a_point() {
  Pslg pslg;
  pslg.points = {{0, 0}, {14, 0}, {14, 23}, {0, 23}, {6, 16}};
  pslg.segments = {{0, 1, 0}, {1, 2, 0}, {2, 3, 0}, {3, 0, 0}};
  return pslg;
}

// The mesh depends on the number of workers, though each of them is certified: in a rectangle with one point inside,
// insertions that are set back come later.
TEST(Kadow, two_workers_make_another_mesh_than_one) {
  const Pslg pslg = rectangle_with_a_point();
  const Goal goal;
  const auto one = schemes::kadow({pslg, goal, 1}), two = schemes::kadow({pslg, goal, 2});
  ASSERT_TRUE(one && two);
  EXPECT_NE(placed_triangles(one->mesh), placed_triangles(two->mesh));
  for (const auto* outcome : {&*one, &*two}) {
    EXPECT_TRUE(check(pslg, schemes::to_mesh(outcome->mesh, pslg), goal).valid);
  }
}

PARDEL_FACT(Kadow, path_edges_may_disappear,
            {.statement = "An edge of the path between two parts is no constraint: an insertion destroys it in a "
                          "rectangle with one point inside.",
             .source = "Kadow 2004 (path edges stay interfaces)",
             .families = "a stored rectangle, 2 workers"}) {
  const Pslg pslg = rectangle_with_a_point();
  const Goal goal;
  const auto start = schemes::parted_start({pslg, goal, 2}, {});
  const auto run = schemes::kadow_in_detail({pslg, goal, 2});
  ASSERT_TRUE(start && run);
  EXPECT_EQ(run->destroyed, 1U);
  const auto at_end = edges_of(run->outcome.mesh);
  int interfaces = 0, gone = 0;
  for (Index t = 0; t < start->mesh.faces.size(); ++t)
    for (int i = 0; i < 3; ++i) {
      const Index other = start->mesh.faces[t].n[i];
      if (other == no_index || other < t || start->owner[other] == start->owner[t]) continue;
      const auto [a, b] = schemes::ends(start->mesh, {t, i});
      ++interfaces;
      ++facts.cases;
      if (!at_end.contains({std::min(a, b), std::max(a, b)})) ++gone;
    }
  EXPECT_EQ(interfaces, 2);
  EXPECT_EQ(gone, 1);
}

/// Their missing edges were split for ever.
TEST(Kadow, points_on_one_line_have_no_triangle) {
  Pslg pslg;
  pslg.points = {{0, 4}, {3, 4}, {2, 4}};
  const Goal goal;
  for (const int workers : {1, 2, 64}) {
    const auto outcome = schemes::kadow({pslg, goal, workers});
    ASSERT_FALSE(outcome);
    EXPECT_EQ(outcome.error().kind, ErrorKind::invalid_input);
  }
}

}  // namespace
}  // namespace pardel::properties
