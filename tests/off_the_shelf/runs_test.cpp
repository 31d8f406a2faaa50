// Whole runs with a sequential mesher: every run ends with a certified mesh, whatever the mesher does.
#include <algorithm>
#include <cmath>

#include "../../core/digest.hpp"
#include "../../properties/comparison/all_arrays.hpp"
#include "bad_meshers.hpp"
#include "some_run.hpp"

namespace pardel::properties {
namespace {

constexpr const char* source_of_floor =
    "off_the_shelf/subdomain_mesher.hpp, Subdomain::min_edge; THEORY.md, Refinement";

PARDEL_PROPERTY(
    OffTheShelf, runs_make_a_mesh_that_the_checker_certifies,
    {.statement = "In each scheme, with pardel's own refiner as the mesher, the mesh conforms to the domain, "
                  "is constrained Delaunay and meets the goal as far as mesh() does; no answer breaks the "
                  "contract.",
     .source = shelf_source,
     .families = shelf_families}) {
  const Problem problem = some_fine_problem(exhibit);
  const auto mesher = own_mesher();
  const MeshedWithMesher made = run(problem, *mesher, small_tasks(some_scheme()));
  exhibit.show(problem.pslg, made.mesh);
  for (std::size_t kind = 0; kind < breach_kinds; ++kind)
    if (made.mesher.breaches.count[kind] > 0) RC_FAIL(made.mesher.breaches.first[kind].what);
  require_valid(check(problem.pslg, made.mesh, problem.goal));
}

PARDEL_PROPERTY(OffTheShelf, runs_do_not_depend_on_threads,
                {.statement = "The mesh, with all its data, and what is reported about the mesher are the same on any "
                              "number of threads.",
                 .source = shelf_source,
                 .families = shelf_families}) {
  const Problem problem = some_fine_problem(exhibit);
  const MesherOptions how = small_tasks(some_scheme());
  const auto mesher = own_mesher();
  const MeshedWithMesher one = run(problem, *mesher, how),
                         many = run(problem, *mesher, how, {.threads = *rc::gen::inRange(2, 9)});
  const std::string differs = difference(one.mesh, many.mesh);
  if (!differs.empty()) RC_FAIL(differs);
  RC_ASSERT(one.mesher.tasks == many.mesher.tasks);
  RC_ASSERT(one.mesher.inserted == many.mesher.inserted);
  RC_ASSERT(one.mesher.phases == many.mesher.phases);
}

PARDEL_PROPERTY(
    OffTheShelf, runs_with_any_breach_end_certified,
    {.statement = "With a mesher that breaks the contract in one way, in all or in some of its answers, the "
                  "run ends with a certified mesh and reports the breaches.",
     .source = shelf_source,
     .families = shelf_families}) {
  const Problem problem = some_fine_problem(exhibit);
  const auto mistake = static_cast<BreachKind>(*rc::gen::inRange(0, breach_kinds));
  RC_TAG(std::string(name(mistake)));
  const MesherOptions how = small_tasks(some_scheme());
  BadMesher mesher(mistake, *rc::gen::inRange(1U, 4U));
  const MeshedWithMesher made = run(problem, mesher, how, {.threads = *rc::gen::inRange(1, 4)});
  exhibit.show(problem.pslg, made.mesh);
  require_valid(check(problem.pslg, made.mesh, problem.goal));
  const Breaches& found = made.mesher.breaches;
  RC_ASSERT(found.total() > 0U || mesher.is_harmless());
}

PARDEL_PROPERTY(OffTheShelf, runs_with_a_mesher_that_does_nothing_end_as_without_one,
                {.statement = "If the mesher does nothing and there is one task, the mesh is that of mesh().",
                 .source = shelf_source,
                 .families = shelf_families}) {
  const Problem problem = some_fine_problem(exhibit);
  LazyMesher mesher;
  const MeshedWithMesher made = run(problem, mesher, {.scheme = some_scheme(), .triangles_per_task = 1'000'000'000});
  RC_ASSERT(made.mesher.inserted == 0U);
  RC_ASSERT(digest(made.mesh) == digest(meshed(problem, exhibit, {.threads = 1}).mesh));
}

PARDEL_PROPERTY(OffTheShelf, runs_split_no_segment_that_is_kept,
                {.statement = "With no_segment_splits, no vertex of the mesh lies on a segment but those of the input.",
                 .source = shelf_source,
                 .families = shelf_families}) {
  const Problem problem = some_fine_problem(exhibit);
  const auto mesher = own_mesher();
  const MeshedWithMesher made = run(problem, *mesher, small_tasks(some_scheme()),
                                    {.threads = 1, .max_vertices = 5000, .no_segment_splits = true});
  for (const Index origin : made.mesh.origin) RC_ASSERT(origin == interior_vertex || origin == input_vertex);
}

PARDEL_PROPERTY(
    OffTheShelf, runs_make_no_edge_below_the_floor,
    {.statement = "With cells, no edge at a new vertex is shorter than min_edge. With frozen borders, edges across "
                  "them are not much shorter.",
     .source = source_of_floor,
     .families = shelf_families}) {
  const Problem problem = some_fine_problem(exhibit);
  const auto mesher = own_mesher();
  const Scheme scheme = some_scheme();
  const double least_part = scheme == Scheme::cells ? 1 - 1e-9 : 0.1;
  const double min_edge = extent_of(problem.pslg) / *rc::gen::inRange(10, 100);
  const MeshedWithMesher made = run(problem, *mesher, small_tasks(scheme), {.threads = 1, .min_edge = min_edge});
  const Mesh& mesh = made.mesh;
  for (const Triangle& t : mesh.triangles)
    for (unsigned i = 0; i < 3; ++i) {
      const Index a = t.v[i], b = t.v[(i + 1) % 3];
      if (std::max(a, b) < problem.pslg.points.size()) continue;
      const Point p = mesh.points[a], q = mesh.points[b];
      RC_ASSERT(std::hypot(p.x - q.x, p.y - q.y) >= least_part * min_edge);
    }
}

PARDEL_PROPERTY(OffTheShelf, runs_keep_a_limit_on_vertices,
                {.statement = "The mesh has at most max_vertices vertices, or those of the input.",
                 .source = shelf_source,
                 .families = shelf_families}) {
  const Problem problem = some_fine_problem(exhibit);
  const auto mesher = own_mesher();
  const auto most = *rc::gen::inRange<std::uint64_t>(1, 200);
  const MeshedWithMesher made = run(problem, *mesher, small_tasks(some_scheme()), {.threads = 1, .max_vertices = most});
  RC_ASSERT(made.mesh.points.size() <= std::max<std::size_t>(most, problem.pslg.points.size()));
  require_valid(check(problem.pslg, made.mesh, {.min_angle_deg = 0}));
}

PARDEL_PROPERTY(OffTheShelf, meshes_conform_after_each_phase,
                {.statement = "After each phase the mesh conforms to the domain and is constrained Delaunay, also with "
                              "a mesher that breaks the contract now and then.",
                 .source = shelf_source,
                 .families = shelf_families}) {
  const Problem problem = some_fine_problem(exhibit);
  BadMesher mesher(static_cast<BreachKind>(*rc::gen::inRange(0, breach_kinds)), 3);
  int seen = 0;
  const Options options{.threads = 1, .after_sweep = [&](const Mesh& mesh, const Sweep&) -> Status {
                          ++seen;
                          const Certificate certificate = check(problem.pslg, mesh, {.min_angle_deg = 0});
                          if (certificate.valid) return Done{};
                          return Error{ErrorKind::internal, to_text(certificate)};
                        }};
  const MeshedWithMesher made = run(problem, mesher, small_tasks(some_scheme()), options);
  RC_ASSERT(seen >= static_cast<int>(made.mesher.sweeps));
}

}  // namespace
}  // namespace pardel::properties
