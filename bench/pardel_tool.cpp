#include "../core/support/stopwatch.hpp"
#include "../parallel/mesher.hpp"
#include "run_in_child.hpp"
#include "tool.hpp"

namespace pardel::bench {
namespace {

Run mesh_once(const Task& task) {
  Run run;
  const Pslg pslg = make_domain(task);
  const Stopwatch watch;
  const Options one_thread{.threads = 1};
  const Result<Meshed> meshed =
      task.delaunay_only ? triangulate(pslg, true, one_thread) : mesh(pslg, task.goal, one_thread);
  run.seconds = watch.seconds();
  run.peak_rss_bytes = peak_rss_bytes();
  if (!meshed) {
    run.set_verdict(meshed.error().message);
    return run;
  }
  run.vertices = meshed->mesh.points.size();
  run.triangles = meshed->mesh.triangles.size();
  run.set_verdict(verdict(task, meshed->mesh, false));
  return run;
}

}  // namespace

Tool pardel_tool() {
  return {"pardel", [](const Task&) { return true; },
          [](const Task& task, const std::filesystem::path&) {
            return run_in_child<Run>([&] { return mesh_once(task); }).value_or(Run{});
          }};
}

}  // namespace pardel::bench
