// scaling: makes one mesh with a single queue, with tiles on one thread, and with tiles on several threads. The runs
// are interleaved, each in its own process. The result is one table of medians. All numbers of threads must make the
// same mesh. n threads are compared with n independent processes of one thread each, which run at the same time and
// share only the machine. See --help.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

#include "../cli/choice.hpp"
#include "../cli/names.hpp"
#include "../core/digest.hpp"
#include "../core/support/stopwatch.hpp"
#include "../parallel/mesher.hpp"
#include "run_in_child.hpp"
#include "table_as_json.hpp"
#include "tool.hpp"
#include "warm_memory.hpp"

namespace pardel::bench {
namespace {

struct Settings {
  Task task;
  Interior interior = Interior::refine;
  std::vector<int> threads = {1, 2};
  int runs = 3;
  bool one_queue = true;
  bool at_once = true;
};

struct Timed {
  double seconds = 0;  ///< time of validation, triangulation and refinement
  double refine_seconds = 0;
  std::uint64_t triangles = 0, peak_rss_bytes = 0;
  Digest digest{};
};

constexpr const char* one_queue_row = "one queue";
constexpr const char* one_thread_row = "tiles, 1 thread";

struct Row {
  Decomposition decomposition;
  int threads;
  int processes = 1;                 ///< number of processes that run at the same time, each with `threads` threads
  std::uint64_t peak_rss_bytes = 0;  ///< the value of the last run
  std::vector<Timed> runs{};

  [[nodiscard]] std::string name() const {
    if (decomposition == Decomposition::none) return one_queue_row;
    if (processes > 1) return fmt::format("{} runs of 1 thread at once", processes);
    return threads == 1 ? one_thread_row : fmt::format("tiles, {} threads", threads);
  }
  [[nodiscard]] const Timed& median() const { return runs[runs.size() / 2]; }
};

Timed timed_run(const Settings& settings, Decomposition decomposition, int threads) {
  const Pslg pslg = make_domain(settings.task);
  const Stopwatch watch;
  const Result<Meshed> meshed = mesh(
      pslg, settings.task.goal, {.interior = settings.interior, .threads = threads, .decomposition = decomposition});
  const double seconds = watch.seconds();
  if (!meshed) return {};
  const std::uint64_t peak = peak_rss_bytes();
  return {.seconds = seconds,
          .refine_seconds = meshed->report.refine_seconds,
          .triangles = meshed->mesh.triangles.size(),
          .peak_rss_bytes = peak,
          .digest = digest(meshed->mesh)};
}

/// Makes one run, or several processes at the same time. Several processes count as one run that has all their
/// triangles and the sum of their rates. Returns nothing if a process failed or if they made different meshes.
std::optional<Timed> run(const Settings& settings, const Row& row) {
  std::vector<Child<Timed>> children;
  for (int i = 0; i < row.processes; ++i)
    children.emplace_back([&] { return timed_run(settings, row.decomposition, row.threads); });
  std::optional<Timed> all;
  double rate = 0, refine_rate = 0;
  for (Child<Timed>& child : children) {
    const std::optional<Timed> one = child.result();
    if (!one || one->triangles == 0) return std::nullopt;
    if (!all) all = Timed{.digest = one->digest};
    if (all->digest != one->digest) return std::nullopt;
    const auto n = static_cast<double>(one->triangles);
    rate += n / one->seconds;
    refine_rate += n / one->refine_seconds;
    all->triangles += one->triangles;
    all->peak_rss_bytes += one->peak_rss_bytes;
  }
  all->seconds = static_cast<double>(all->triangles) / rate;
  all->refine_seconds = static_cast<double>(all->triangles) / refine_rate;
  return all;
}

/// Runs the rows in turn. The first run of a row is not counted; it measures the memory that warm_memory() must
/// prepare. If a run fails or makes another mesh, prints a message and returns false.
bool measure(const Settings& settings, std::vector<Row>& rows) {
  std::optional<Digest> one_mesh;
  for (int i = 0; i <= settings.runs; ++i)
    for (Row& row : rows) {
      warm_memory(row.peak_rss_bytes);
      const std::optional<Timed> one = run(settings, row);
      if (!one) {
        fmt::print(stderr, "scaling: {}: no mesh, or different meshes\n", row.name());
        return false;
      }
      row.peak_rss_bytes = one->peak_rss_bytes;
      if (i > 0) row.runs.push_back(*one);
      if (row.decomposition == Decomposition::none) continue;
      if (!one_mesh) one_mesh = one->digest;
      if (one->digest == one_mesh) continue;
      fmt::print(stderr, "scaling: {}: the mesh differs from that of an earlier run\n", row.name());
      return false;
    }
  for (Row& row : rows)
    std::sort(row.runs.begin(), row.runs.end(), [](const Timed& a, const Timed& b) { return a.seconds < b.seconds; });
  return true;
}

/// Triangles per second of the median run.
double rate(const Row& row) { return static_cast<double>(row.median().triangles) / row.median().seconds; }

/// The rate of `row` divided by the rate of the row with the name `name`; empty if there is no such row.
std::string times(const Row& row, const std::vector<Row>& rows, std::string_view name) {
  const auto base = std::find_if(rows.begin(), rows.end(), [&](const Row& r) { return r.name() == name; });
  return base == rows.end() ? "" : fmt::format("{:.2f}", rate(row) / rate(*base));
}

void print(const std::vector<Row>& rows) {
  fmt::print(
      "| | seconds | of these refining | millions of triangles | millions/s | times one queue | times 1 thread | "
      "bytes/triangle |\n");
  fmt::print("|:---|---:|---:|---:|---:|---:|---:|---:|\n");
  for (const Row& row : rows) {
    const Timed& run = row.median();
    const auto n = static_cast<double>(run.triangles);
    fmt::print("| {} | {:.3f} | {:.3f} | {:.3f} | {:.2f} | {} | {} | {:.1f} |\n", row.name(), run.seconds,
               run.refine_seconds, n / 1e6, rate(row) / 1e6, times(row, rows, one_queue_row),
               times(row, rows, one_thread_row), static_cast<double>(run.peak_rss_bytes) / n);
  }
}

std::vector<MeasuredRow> measured_rows(const std::vector<Row>& rows, const std::string& domain) {
  std::vector<MeasuredRow> found;
  for (const Row& row : rows) {
    const char* kind = row.decomposition == Decomposition::none ? "one_queue" : "tiles";
    const std::string name = row.processes > 1 ? fmt::format("scaling/{}/{}_processes", domain, row.processes)
                                               : fmt::format("scaling/{}/{}", domain, kind);
    const Timed& run = row.median();
    found.push_back({name, row.threads, run.seconds, run.triangles, run.peak_rss_bytes, to_string(run.digest)});
  }
  return found;
}

}  // namespace
}  // namespace pardel::bench

int main(int argc, char** argv) {
  using namespace pardel;
  bench::Settings settings;
  settings.task.goal.min_angle_deg = 20.7;
  CLI::App app("The speed of tiles and threads: one mesh in interleaved runs; prints one table of medians");
  app.add_option("--domain", settings.task.domain, "The domain: square, pipe, points, radial, ...")
      ->capture_default_str();
  app.add_option("--points", settings.task.points, "Number of points (for --domain points), or of decades (radial)");
  app.add_option("--min-angle", settings.task.goal.min_angle_deg, "Minimum angle in degrees")->capture_default_str();
  app.add_option("--triangles", settings.task.triangles,
                 "Approximate number of triangles; 0: the angle bound alone determines it");
  app.add_option("--interior", settings.interior, "The interior: refine, or fill with equilateral triangles")
      ->transform(cli::choice(cli::interior_names));
  app.add_option("--threads", settings.threads, "Numbers of threads, one row each")
      ->delimiter(',')
      ->capture_default_str();
  app.add_option("--runs", settings.runs, "Runs per row; the table has the medians")->check(CLI::PositiveNumber);
  app.add_flag("!--no-queue", settings.one_queue, "Leave out the row with a single queue");
  app.add_flag("!--no-at-once", settings.at_once,
               "Leave out the rows with n processes of one thread each, which take n times the memory");
  std::string json;
  app.add_option("--json", json, "Also write the table to this file, in the format of Google Benchmark");
  CLI11_PARSE(app, argc, argv);
  bench::set_size(settings.task);
  std::vector<bench::Row> rows;
  if (settings.one_queue) rows.push_back({Decomposition::none, 1});
  for (const int threads : settings.threads) {
    rows.push_back({Decomposition::automatic, threads});
    if (settings.at_once && threads > 1) rows.push_back({Decomposition::automatic, 1, threads});
  }
  if (!bench::measure(settings, rows)) return 1;
  bench::print(rows);
  if (json.empty() || bench::write_json(json, argv[0], bench::measured_rows(rows, settings.task.domain))) return 0;
  fmt::print(stderr, "scaling: {}: cannot be written\n", json);
  return 1;
}
