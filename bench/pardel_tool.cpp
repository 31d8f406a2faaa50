#include <cmath>

#include "../core/support/stopwatch.hpp"
#include "../parallel/mesher.hpp"
#include "run_in_child.hpp"
#include "tool.hpp"

namespace pardel::bench {
namespace {

Run mesh_once(const Task& task, Interior interior) {
  Run run;
  const Pslg pslg = make_domain(task);
  const Stopwatch watch;
  const Options one_thread{.interior = interior, .threads = 1};
  const Result<Meshed> meshed =
      task.delaunay_only ? triangulate(pslg, true, one_thread) : mesh(pslg, task.goal, one_thread);
  run.seconds = watch.seconds();
  run.peak_rss_bytes = peak_rss_bytes();
  if (!meshed) {
    run.set_verdict(meshed.error().message);
    return run;
  }
  judge(task, meshed->mesh, false, run);
  return run;
}

Run run_in_process(const Task& task, Interior interior) {
  return run_in_child<Run>([&] { return mesh_once(task, interior); }).value_or(Run{});
}

}  // namespace

Tool pardel_tool() {
  return {"pardel", [](const Task&) { return true; },
          [](const Task& task, const std::filesystem::path&) { return run_in_process(task, Interior::refine); }};
}

Tool pardel_fill_tool() {
  return {"pardel-fill", [](const Task& task) { return std::isfinite(task.goal.max_area); },
          [](const Task& task, const std::filesystem::path&) { return run_in_process(task, Interior::fill); }};
}

}  // namespace pardel::bench
