// scale: meshes one domain at increasing sizes. Each mesh is made and checked in its own process. The result is one
// table, and an extrapolation of its last row to the largest mesh in [CC] (Chernikov and Chrisochoides 2004). See
// --help.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <optional>
#include <vector>

#include "../cli/memory.hpp"
#include "../core/support/stopwatch.hpp"
#include "../parallel/mesher.hpp"
#include "run_in_child.hpp"
#include "tool.hpp"

namespace pardel::bench {
namespace {

/// The largest mesh of the pipe cross-section in [CC] (Chernikov and Chrisochoides 2004), Table 1.
constexpr double paper_triangles = 441.1e6;
constexpr double paper_seconds = 212.7;
constexpr int paper_processors = 121;

constexpr double gibibyte = 0x1p30;

struct Settings {
  Task task;
  std::vector<double> triangles = {10e6, 100e6, 250e6};  ///< approximate numbers, ascending
  int threads = 2;
};

struct Row {
  Run mesh;  ///< `verdict` is the checker's verdict on the whole mesh, or the reason why there is no mesh
  double check_seconds = 0;
  std::uint64_t peak_with_check = 0;  ///< bytes

  [[nodiscard]] bool failed() const { return mesh.triangles == 0; }
  [[nodiscard]] double triangles() const { return static_cast<double>(mesh.triangles); }
  [[nodiscard]] double nanoseconds_per_triangle() const { return mesh.seconds / triangles() * 1e9; }
  [[nodiscard]] double bytes_per_triangle() const { return static_cast<double>(mesh.peak_rss_bytes) / triangles(); }
  [[nodiscard]] double bytes_with_check() const { return static_cast<double>(peak_with_check) / triangles(); }
};

Row make_and_check(const Task& task, int threads) {
  Row row;
  const Pslg pslg = make_domain(task);
  const Stopwatch watch;
  const Result<Meshed> meshed = mesh(pslg, task.goal, {.threads = threads, .max_memory = cli::available_memory()});
  row.mesh.seconds = watch.seconds();
  row.mesh.peak_rss_bytes = peak_rss_bytes();
  if (!meshed) {
    row.mesh.set_verdict(meshed.error().message);
    return row;
  }
  const Stopwatch check_watch;
  judge(task, meshed->mesh, false, row.mesh);
  row.check_seconds = check_watch.seconds();
  row.peak_with_check = peak_rss_bytes();
  return row;
}

/// The row for one size. The run is skipped if, judging from the last row, it would need more memory than is available.
Row row_for(const Settings& settings, double triangles, const std::optional<Row>& last) {
  Row row;
  const auto available = static_cast<double>(cli::available_memory());
  if (last && available > 0 && last->bytes_with_check() * triangles > available) {
    row.mesh.set_verdict(fmt::format("skipped: it needs {:.1f} GiB, but only {:.1f} GiB are available",
                                     last->bytes_with_check() * triangles / gibibyte, available / gibibyte));
    return row;
  }
  Task task = settings.task;
  task.triangles = static_cast<std::uint64_t>(triangles);
  set_size(task);
  const std::optional<Row> run = run_in_child<Row>([&] { return make_and_check(task, settings.threads); });
  if (!run) row.mesh.set_verdict("the process died");
  return run.value_or(row);
}

void print_head(const Settings& settings) {
  fmt::print("{}, angles of at least {}°, {} thread{}{}\n\n", settings.task.domain, settings.task.goal.min_angle_deg,
             settings.threads, settings.threads == 1 ? "" : "s",
             settings.task.check ? "; every triangle checked with exact arithmetic" : "");
  fmt::print(
      "| triangles | seconds | millions/s | ns/triangle | peak GiB | bytes/triangle | verdict of the checker | ");
  fmt::print("seconds of the check | peak GiB with the check | bytes/triangle with the check |\n");
  fmt::print("|---:|---:|---:|---:|---:|---:|:---|---:|---:|---:|\n");
}

void print(const Row& row, double wanted) {
  if (row.failed())
    fmt::print("| {:.1f} million | | | | | | {} | | | |\n", wanted / 1e6, row.mesh.verdict.data());
  else
    fmt::print("| {} | {:.2f} | {:.2f} | {:.1f} | {:.2f} | {:.1f} | {} | {:.1f} | {:.2f} | {:.1f} |\n",
               row.mesh.triangles, row.mesh.seconds, row.triangles() / row.mesh.seconds / 1e6,
               row.nanoseconds_per_triangle(), static_cast<double>(row.mesh.peak_rss_bytes) / gibibyte,
               row.bytes_per_triangle(), row.mesh.verdict.data(), row.check_seconds,
               static_cast<double>(row.peak_with_check) / gibibyte, row.bytes_with_check());
  std::fflush(stdout);
}

void print_extrapolation(const Row& last) {
  const auto available = static_cast<double>(cli::available_memory());
  const auto gibibytes = [](double bytes_per_triangle) { return bytes_per_triangle * paper_triangles / gibibyte; };
  const double with_check = gibibytes(last.bytes_with_check());
  fmt::print("\nExtrapolated from the last row to the paper's {:.1f} million triangles: {:.1f} s and {:.1f} GiB, ",
             paper_triangles / 1e6, last.nanoseconds_per_triangle() * paper_triangles / 1e9,
             gibibytes(last.bytes_per_triangle()));
  fmt::print("{:.1f} GiB with the check, which takes {:.0f} s more.\n", with_check,
             last.check_seconds / last.triangles() * paper_triangles);
  fmt::print(
      "{:.1f} GiB are available: the mesh with its check {}. The paper (2004) reports {:.1f} s on {} processors.\n",
      available / gibibyte, with_check * gibibyte <= available ? "fits" : "does not fit", paper_seconds,
      paper_processors);
}

/// False if a mesh was not made or is not valid.
bool run(const Settings& settings) {
  print_head(settings);
  std::optional<Row> last;
  bool all_good = true;
  for (const double triangles : settings.triangles) {
    const Row row = row_for(settings, triangles, last);
    print(row, triangles);
    all_good =
        all_good && !row.failed() && (!settings.task.check || std::string_view(row.mesh.verdict.data()) == "valid");
    if (!row.failed()) last = row;
  }
  if (last) print_extrapolation(*last);
  return all_good;
}

}  // namespace
}  // namespace pardel::bench

int main(int argc, char** argv) {
  using namespace pardel;
  bench::Settings settings;
  settings.task.domain = "pipe";
  bool no_check = false;
  CLI::App app("Meshes one domain at increasing sizes and extrapolates to the largest mesh of the paper");
  app.add_option("--domain", settings.task.domain, "The domain: square, pipe, key, ...")->capture_default_str();
  app.add_option("--triangles", settings.triangles,
                 "Approximate numbers of triangles, separated by commas; each gives one row")
      ->delimiter(',')
      ->check(CLI::Range(1e3, 536e6))
      ->capture_default_str();
  app.add_option("--threads", settings.threads, "Threads of the mesher")
      ->check(CLI::Range(1, 4096))
      ->capture_default_str();
  app.add_option("--min-angle", settings.task.goal.min_angle_deg, "Minimum angle in degrees")->capture_default_str();
  app.add_flag("--no-check", no_check, "Do not check the meshes");
  CLI11_PARSE(app, argc, argv);
  settings.task.check = !no_check;
  std::sort(settings.triangles.begin(), settings.triangles.end());
  return bench::run(settings) ? 0 : 1;
}
