#include "run_tasks.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "../../core/support/stopwatch.hpp"
#include "../../parallel/threads/parallel_for.hpp"
#include "../../parallel/triangulation/limits.hpp"
#include "glue.hpp"
#include "share_attempts.hpp"

namespace pardel::engine {
namespace {

/// The goal and the limits of a part.
void set_bounds(const MesherRun& run, std::uint64_t most_new_points, Part& part) {
  // A mesh has twice as many triangles as vertices. The rest is for the bound on angles.
  constexpr double points_per_triangle = 2, points_per_old_triangle = 10, spare = 1000;
  const Triangulation& t = run.mesh.t;
  Subdomain& subdomain = part.subdomain;
  subdomain.goal = run.goal;
  subdomain.min_edge = run.options.min_edge;
  subdomain.seconds = run.how.seconds_per_task;
  double wanted = 0;
  LocalHints hints;
  for (const TriangleId id : part.triangles) {
    const Index region = run.mesh.assessor.region_of(id);
    if (run.criteria.has_size()) wanted += run.criteria.triangles_wanted(Shape(t, t.slots[id]), region, hints);
    if (!run.region_caps.empty())
      subdomain.max_areas.push_back(
          region < run.region_caps.size() ? std::min(run.goal.max_area, run.region_caps[region]) : run.goal.max_area);
  }
  const double limit =
      points_per_triangle * wanted + points_per_old_triangle * static_cast<double>(part.triangles.size()) + spare;
  subdomain.most_new_points =
      std::min(static_cast<std::size_t>(std::min(limit, 1.0 * max_engine_triangles)), most_new_points);
}

/// Takes the part of a portion out of the mesh. Lets the mesher refine it, unless another rank does this task.
Attempt attempt(MesherRun& run, PartMaker& maker, const Portion& portion, std::uint64_t most_new_points, bool is_here,
                bool twice) {
  Attempt result;
  Stopwatch watch;
  result.part = maker.take_out(portion, run.mesher.abilities().splits_segments);
  if (!is_here) return result;
  set_bounds(run, most_new_points, result.part);
  result.extraction_seconds = watch.lap();
  refine_part(run.mesher, twice, run.options.min_edge, result);
  return result;
}

/// How many points each task may insert: an equal part of what Options::max_vertices leaves.
std::uint64_t most_points_per_task(const MesherRun& run, std::size_t tasks) {
  const std::uint64_t most = run.options.max_vertices, present = run.mesh.t.points.size();
  if (most == 0) return max_engine_triangles;
  return most > present ? (most - present) / tasks : 0;
}

/// Takes the triangles that small input angles exempt from the goal out of the portions.
void leave_out_exempt(const MesherRun& run, Portions& portions) {
  parallel_for(run.threads, portions.all.size(), [&](std::size_t i, int) {
    LocalHints hints;
    std::erase_if(portions.all[i].triangles, [&](TriangleId id) {
      const bool is_exempt = run.mesh.assessor.assess(id, hints).left_alone;
      if (is_exempt) portions.portion_of[id] = no_index;
      return is_exempt;
    });
  });
  // The numbers in portion_of still tell portions apart.
  std::erase_if(portions.all, [](const Portion& portion) { return portion.triangles.empty(); });
}

/// Throws Stopped if the mesh with these answers would have too many triangles, or take too much memory.
void require_room(const MesherRun& run, const std::vector<Replacement>& replacements) {
  std::uint64_t vertices = run.mesh.t.points.size(), triangles = run.mesh.t.slots.size();
  for (const Replacement& r : replacements) {
    vertices += r.answer.points.size() - r.part.vertices.size();
    triangles += r.answer.triangles.size() - r.part.triangles.size();
  }
  if (triangles > max_engine_triangles) throw Stopped{too_many_triangles()};
  if (outgrows_memory(vertices, run.options)) throw Stopped{too_much_memory(run.options)};
}

}  // namespace

void show(const MesherRun& run, std::uint64_t made) {
  if (!run.watcher) return;
  Triangulation copy = run.mesh.t;
  const Status fine = run.watcher(std::move(copy), Sweep{.inserted = made});
  if (!fine) throw Stopped{fine.error()};
}

std::uint64_t run_tasks(MesherRun& run, Portions given) {
  if (!run.mesher.abilities().exempts_small_angles) leave_out_exempt(run, given);
  const std::vector<Portion>& portions = given.all;
  if (portions.empty()) return 0;
  const Stopwatch in_tasks;
  const std::uint64_t most_new_points = most_points_per_task(run, portions.size());
  if (most_new_points == 0) return 0;
  // The smallest portion is refined twice, unless it is all.
  const auto smallest =
      std::ranges::min_element(portions, {}, [](const Portion& portion) { return portion.triangles.size(); });
  const std::size_t twice =
      portions.size() > 1 ? static_cast<std::size_t>(smallest - portions.begin()) : portions.size();
  std::vector<Attempt> attempts(portions.size());
  std::vector<PartMaker> makers(static_cast<std::size_t>(run.threads.count), PartMaker(run.mesh, given.portion_of));
  parallel_for(run.threads, portions.size(), [&](std::size_t i, int thread) {
    const bool is_here = run.ranks == nullptr || does_task(i, *run.ranks);
    attempts[i] =
        attempt(run, makers[static_cast<std::size_t>(thread)], portions[i], most_new_points, is_here, i == twice);
  });
  if (run.ranks != nullptr) share_attempts(attempts, *run.ranks);

  std::vector<Replacement> replacements;
  std::uint64_t made = 0;
  for (Attempt& each : attempts) {
    MesherReport& report = run.report;
    ++report.tasks;
    report.extraction_seconds += each.extraction_seconds;
    report.mesher_seconds += each.mesher_seconds;
    report.verification_seconds += each.verification_seconds;
    if (each.at_limit) ++report.at_limit;
    if (each.breach) report.breaches.add(*each.breach);
    if (!each.answer) continue;
    made += each.answer->points.size() - each.part.vertices.size();
    replacements.push_back({std::move(each.part), *std::move(each.answer)});
  }
  require_room(run, replacements);
  const Stopwatch watch;
  run.report.flipped += glue(run.mesh, replacements, run.threads);
  run.report.gluing_seconds += watch.seconds();
  run.report.inserted += made;
  ++run.report.phases;
  run.seconds_in_tasks += in_tasks.seconds();
  return made;
}

}  // namespace pardel::engine
