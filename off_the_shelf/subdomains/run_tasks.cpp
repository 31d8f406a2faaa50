#include "run_tasks.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
#include <optional>
#include <utility>

#include "../../core/support/stopwatch.hpp"
#include "../../parallel/threads/parallel_for.hpp"
#include "../../parallel/triangulation/limits.hpp"
#include "glue.hpp"
#include "verify.hpp"
#include "without_triangles.hpp"

namespace pardel::engine {
namespace {

/// What became of a portion.
struct Attempt {
  std::optional<Replacement> replacement;
  std::optional<Breach> breach;
  bool at_limit = false;
  double extraction_seconds = 0, mesher_seconds = 0, verification_seconds = 0;
};

bool same_answer(const RefinedSubdomain& a, const RefinedSubdomain& b) {
  return a.ending == b.ending && a.points == b.points && a.edge_of_new_point == b.edge_of_new_point &&
         a.triangles == b.triangles;
}

RefinedSubdomain ask(MesherRun& run, const Subdomain& subdomain) {
  std::unique_lock<std::mutex> alone;
  if (!run.mesher.abilities().is_thread_safe) alone = std::unique_lock(run.one_at_a_time);
  try {
    return run.mesher.refine(subdomain);
  } catch (const std::exception& e) {
    return without_triangles(RefinedSubdomain::Ending::failed, e.what());
  } catch (...) {
    return without_triangles(RefinedSubdomain::Ending::failed, "the mesher threw an exception");
  }
}

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

Attempt attempt(MesherRun& run, PartMaker& maker, const Portion& portion, std::uint64_t most_new_points, bool twice) {
  Attempt result;
  Stopwatch watch;
  Part part = maker.take_out(portion, run.mesher.abilities().splits_segments);
  set_bounds(run, most_new_points, part);
  result.extraction_seconds = watch.lap();
  RefinedSubdomain answer = ask(run, part.subdomain);
  result.mesher_seconds = watch.lap();
  if (twice && !same_answer(answer, ask(run, part.subdomain))) {
    result.breach = Breach{BreachKind::other_answer, part.subdomain.points.front(),
                           "the same subdomain got another answer the second time"};
    return result;
  }
  watch.lap();
  result.at_limit = answer.ending == RefinedSubdomain::Ending::limit;
  Result<VerifiedSubdomain, Breach> verified =
      verify(part.subdomain, std::move(answer), part.lines, Floor(run.options.min_edge));
  if (!verified) {
    result.breach = verified.error();
  } else {
    result.replacement = Replacement{std::move(part), std::move(*verified)};
  }
  result.verification_seconds = watch.lap();
  return result;
}

/// How many points each task may insert: an equal part of what Options::max_vertices leaves.
std::uint64_t most_points_per_task(const MesherRun& run, std::size_t tasks) {
  const std::uint64_t most = run.options.max_vertices, present = run.mesh.t.points.size();
  if (most == 0) return max_engine_triangles;
  return most > present ? (most - present) / tasks : 0;
}

}  // namespace

void show(const MesherRun& run, std::uint64_t made) {
  if (!run.watcher) return;
  Triangulation copy = run.mesh.t;
  const Status fine = run.watcher(std::move(copy), Sweep{.inserted = made});
  if (!fine) throw Stopped{fine.error()};
}

std::uint64_t run_tasks(MesherRun& run, const std::vector<Portion>& portions, std::span<const Index> portion_of) {
  if (portions.empty()) return 0;
  const std::uint64_t most_new_points = most_points_per_task(run, portions.size());
  if (most_new_points == 0) return 0;
  // The smallest portion is refined twice, unless it is all.
  const auto smallest =
      std::ranges::min_element(portions, {}, [](const Portion& portion) { return portion.triangles.size(); });
  const std::size_t twice =
      portions.size() > 1 ? static_cast<std::size_t>(smallest - portions.begin()) : portions.size();
  std::vector<Attempt> attempts(portions.size());
  std::vector<PartMaker> makers(static_cast<std::size_t>(run.threads.count), PartMaker(run.mesh, portion_of));
  parallel_for(run.threads, portions.size(), [&](std::size_t i, int thread) {
    attempts[i] = attempt(run, makers[static_cast<std::size_t>(thread)], portions[i], most_new_points, i == twice);
  });

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
    if (!each.replacement) continue;
    made += each.replacement->answer.points.size() - each.replacement->part.vertices.size();
    replacements.push_back(*std::move(each.replacement));
  }
  const Stopwatch watch;
  run.report.flipped += glue(run.mesh, replacements, run.threads);
  run.report.gluing_seconds += watch.seconds();
  run.report.inserted += made;
  ++run.report.phases;
  if (outgrows_memory(run.mesh.t.points.size(), run.options)) throw Stopped{too_much_memory(run.options)};
  return made;
}

}  // namespace pardel::engine
