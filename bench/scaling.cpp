// scaling: one mesh by one queue over everything, by tiles, and by tiles on several threads, in interleaved runs, each
// in a process of its own; one table of medians. The meshes of all numbers of threads must be one. See --help.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <vector>

#include "../core/digest.hpp"
#include "../parallel/mesher.hpp"
#include "run_in_child.hpp"
#include "stopwatch.hpp"
#include "tool.hpp"

namespace pardel::bench {
namespace {

struct Settings {
  Task task;
  std::vector<int> threads = {1, 2};
  int runs = 3;
  bool one_queue = true;
};

struct Timed {
  double seconds = 0;  ///< validation, triangulation and refinement
  double refine_seconds = 0;
  std::uint64_t triangles = 0, peak_rss_bytes = 0;
  Digest digest{};
};

struct Row {
  Decomposition decomposition;
  int threads;
  std::vector<Timed> runs;

  [[nodiscard]] std::string name() const {
    if (decomposition == Decomposition::none) return "one queue";
    return fmt::format("tiles, {} thread{}", threads, threads == 1 ? "" : "s");
  }
  [[nodiscard]] const Timed& median() const { return runs[runs.size() / 2]; }
};

Timed timed_run(const Task& task, Decomposition decomposition, int threads) {
  const Pslg pslg = make_domain(task);
  const Stopwatch watch;
  const Result<Meshed> meshed = mesh(pslg, task.goal, {.threads = threads, .decomposition = decomposition});
  const double seconds = watch.seconds();
  if (!meshed) return {};
  const std::uint64_t peak = peak_rss_bytes();
  return {.seconds = seconds,
          .refine_seconds = meshed->report.refine_seconds,
          .triangles = meshed->mesh.triangles.size(),
          .peak_rss_bytes = peak,
          .digest = digest(meshed->mesh)};
}

/// False, and a message, where a run failed or the number of threads changed the mesh.
bool measure(const Settings& settings, std::vector<Row>& rows) {
  std::optional<Digest> one_mesh;
  for (int i = 0; i < settings.runs; ++i)
    for (Row& row : rows) {
      const auto one = run_in_child<Timed>([&] { return timed_run(settings.task, row.decomposition, row.threads); });
      if (!one || one->triangles == 0) {
        fmt::print(stderr, "scaling: {}: no mesh\n", row.name());
        return false;
      }
      row.runs.push_back(*one);
      if (row.decomposition == Decomposition::none) continue;
      if (!one_mesh) one_mesh = one->digest;
      if (one->digest == one_mesh) continue;
      fmt::print(stderr, "scaling: {}: another mesh than in an earlier run\n", row.name());
      return false;
    }
  for (Row& row : rows)
    std::sort(row.runs.begin(), row.runs.end(), [](const Timed& a, const Timed& b) { return a.seconds < b.seconds; });
  return true;
}

void print(const std::vector<Row>& rows) {
  fmt::print(
      "| | seconds | of these refining | millions of triangles | millions/s | times the first | bytes/triangle |\n");
  fmt::print("|:---|---:|---:|---:|---:|---:|---:|\n");
  const Timed& first = rows.front().median();
  for (const Row& row : rows) {
    const Timed& run = row.median();
    const double n = static_cast<double>(run.triangles);
    const double rate = n / run.seconds;
    fmt::print("| {} | {:.3f} | {:.3f} | {:.3f} | {:.2f} | {:.2f} | {:.1f} |\n", row.name(), run.seconds,
               run.refine_seconds, n / 1e6, rate / 1e6, rate / (static_cast<double>(first.triangles) / first.seconds),
               static_cast<double>(run.peak_rss_bytes) / n);
  }
}

}  // namespace
}  // namespace pardel::bench

int main(int argc, char** argv) {
  using namespace pardel;
  bench::Settings settings;
  settings.task.goal.min_angle_deg = 20.7;
  CLI::App app("What tiles and threads are worth: one mesh in interleaved runs, medians");
  app.add_option("--domain", settings.task.domain, "square, pipe, points, ...")->capture_default_str();
  app.add_option("--points", settings.task.points, "For points: how many");
  app.add_option("--min-angle", settings.task.goal.min_angle_deg, "Degrees")->capture_default_str();
  app.add_option("--triangles", settings.task.triangles, "Wanted, roughly; 0: as the angle bound asks");
  app.add_option("--threads", settings.threads, "Numbers of threads, a row each")
      ->delimiter(',')
      ->capture_default_str();
  app.add_option("--runs", settings.runs, "Runs a row; the median is shown")->check(CLI::PositiveNumber);
  app.add_flag("!--no-queue", settings.one_queue, "Leave out the row with one queue over everything");
  CLI11_PARSE(app, argc, argv);
  settings.task.goal.max_area = bench::area_cap(settings.task);
  std::vector<bench::Row> rows;
  if (settings.one_queue) rows.push_back({Decomposition::none, 1, {}});
  for (const int threads : settings.threads) rows.push_back({Decomposition::automatic, threads, {}});
  if (!bench::measure(settings, rows)) return 1;
  bench::print(rows);
  return 0;
}
