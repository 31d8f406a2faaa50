// paper_tables: repeats the workload of Tables 1 and 2 of [CC] (Chernikov and Chrisochoides 2004) on this machine. The
// area bound is inversely proportional to the number of threads. So every thread has the same amount of work, and with
// ideal scaling the time is constant. Prints the results of the paper beside those of this machine. Exit code 1: a run
// failed. See --help.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "../cli/choice.hpp"
#include "../cli/names.hpp"
#include "../core/digest.hpp"
#include "../core/support/stopwatch.hpp"
#include "../off_the_shelf/mesh_with_mesher.hpp"
#include "../parallel/mesher.hpp"
#include "../properties/domains/domains.hpp"
#include "meshers/meshers.hpp"
#include "run_in_child.hpp"
#include "table_as_json.hpp"
#include "tool.hpp"
#include "warm_memory.hpp"

namespace pardel::bench {
namespace {

/// A row of [CC].
struct TheirRun {
  int table, processors;
  double millions;           ///< triangles
  const char *mpi, *openmp;  ///< seconds
};
struct Table {
  const char* title;
  const char* domain;
  double area;
  std::vector<TheirRun> theirs;
};
const Table tables[] = {
    {"The pipe cross-section (Tables 1 and 2)",
     "pipe",
     2.486,
     {{1, 4, 14.6, "179.1", ""},
      {1, 64, 233.3, "273.6", ""},
      {1, 121, 441.1, "212.7", ""},
      {2, 4, 14.6, "220.3", "214.1"}}},
    {"The unit square (Table 1)",
     "square",
     1,
     {{1, 4, 23.8, "293.7", ""}, {1, 64, 470.7, "300.1", ""}, {1, 121, 873.5, "293.7", ""}}},
};

struct Timed {
  double seconds = 0;  ///< time of validation, triangulation and refinement
  std::uint64_t triangles = 0;
  std::uint64_t peak_rss_bytes = 0;
  std::uint32_t cells = 0;  ///< or tasks of the mesher
  Digest digest{};
};

struct Settings {
  std::vector<int> threads = {1, 2};
  double per_thread = 5e6;
  int runs = 3;
  Decomposition decomposition = Decomposition::automatic;
  std::string mesher, scheme = "frozen";  ///< a sequential mesher for the tasks; empty: pardel works in its own way
  std::string mpirun;                     ///< empty: no ranks are measured

  [[nodiscard]] double max_area(const Table& table, int processors) const {
    return triangles_per_cap * table.area / (per_thread * processors);
  }
};

Timed run_with_mesher(const Pslg& pslg, const Goal& goal, const Settings& settings, int threads) {
  const std::unique_ptr<SubdomainMesher> mesher = mesher_for(settings.mesher, threads, goal);
  const std::optional<Scheme> scheme = scheme_named(settings.scheme);
  if (mesher == nullptr || !scheme) return {};
  const Stopwatch watch;
  const Result<MeshedWithMesher> made =
      mesh_with_mesher(*validate(pslg), goal, *mesher, {.scheme = *scheme}, {.threads = threads});
  if (!made) return {};
  const double seconds = watch.seconds();
  return {seconds, made->mesh.triangles.size(), peak_rss_bytes(), static_cast<std::uint32_t>(made->mesher.tasks),
          digest(made->mesh)};
}

std::optional<Timed> run(const Table& table, const Settings& settings, int threads) {
  return run_in_child<Timed>([&] {
    const Pslg pslg = *domains::generate(table.domain, 0, 1);
    const Goal goal{.max_area = settings.max_area(table, threads)};
    if (!settings.mesher.empty()) return run_with_mesher(pslg, goal, settings, threads);
    const Stopwatch watch;
    const Result<Meshed> meshed = mesh(pslg, goal, {.threads = threads, .decomposition = settings.decomposition});
    if (!meshed) return Timed{};
    const double seconds = watch.seconds();
    const Tiling& tiling = meshed->report.tiling;
    return Timed{seconds, meshed->mesh.triangles.size(), peak_rss_bytes(), tiling.columns * tiling.rows,
                 digest(meshed->mesh)};
  });
}

/// Returns the run with the median time; nothing if a run failed.
std::optional<Timed> median_run(const Table& table, const Settings& settings, int threads) {
  std::vector<Timed> all;
  for (int i = 0; i < settings.runs; ++i) {
    warm_memory(all.empty() ? 0 : all.back().peak_rss_bytes);
    const std::optional<Timed> one = run(table, settings, threads);
    if (!one || one->triangles == 0) return std::nullopt;
    all.push_back(*one);
  }
  std::sort(all.begin(), all.end(), [](const Timed& a, const Timed& b) { return a.seconds < b.seconds; });
  return all[all.size() / 2];
}

constexpr const char* failed = "failed";

/// The median time of ranks of one thread, as text, or `failed`; empty if no ranks are measured. `like`: the run with
/// threads.
std::string seconds_of_ranks(const Table& table, const Settings& settings, int ranks, const Timed& like) {
  if (settings.mpirun.empty()) return "";
  const std::filesystem::path here = std::filesystem::read_symlink("/proc/self/exe").parent_path();
  std::vector<std::string> command = {settings.mpirun,
                                      "--oversubscribe",
                                      "--bind-to",
                                      "none",
                                      "-n",
                                      std::to_string(ranks),
                                      (here / "paper_ranks").string(),
                                      table.domain,
                                      fmt::format("{}", settings.max_area(table, ranks)),
                                      std::to_string(like.peak_rss_bytes)};
  if (!settings.mesher.empty()) command.insert(command.end(), {settings.mesher, settings.scheme});
  std::vector<double> all;
  for (int i = 0; i < settings.runs; ++i) {
    const std::string output = run_program(command).output;
    double seconds = 0;
    unsigned long long triangles = 0;
    const std::size_t line = output.find("ranks ");
    if (line == std::string::npos || std::sscanf(&output[line], "ranks %lf %llu", &seconds, &triangles) != 2 ||
        triangles != like.triangles) {
      fmt::print(stderr, "paper_tables: {} failed:\n{}\n", fmt::join(command, " "), output);
      return failed;
    }
    all.push_back(seconds);
  }
  return fmt::format("{:.2f}", median(all));
}

/// What was measured on this machine.
struct Measured {
  std::vector<MeasuredRow> rows;
  bool failed = false;  ///< some rows are missing
};

/// Measures a table, prints it, and adds its rows.
void add(const Table& table, const Settings& settings, Measured& measured) {
  fmt::print("### {}\n\n", table.title);
  fmt::print(
      "| | threads or ranks | {} | triangles, millions | seconds, MPI | seconds, OpenMP | millions/s | "
      "millions/s/thread | bytes/triangle |\n|---|---:|---:|---:|---:|---:|---:|---:|---:|\n",
      settings.mesher.empty() ? "cells" : "tasks");
  for (const TheirRun& run : table.theirs)
    fmt::print("| the paper, Table {} | {} | | {:.1f} | {} | {} | | | |\n", run.table, run.processors, run.millions,
               run.mpi, run.openmp);
  for (const int threads : settings.threads) {
    const std::optional<Timed> one = median_run(table, settings, threads);
    if (!one) {
      fmt::print("| here | {} | | | | failed | | | |\n", threads);
      measured.failed = true;
      continue;
    }
    const double millions = static_cast<double>(one->triangles) / 1e6;
    const std::string seconds = seconds_of_ranks(table, settings, threads, *one);
    measured.failed = measured.failed || seconds == failed;
    fmt::print("| here | {} | {} | {:.1f} | {} | {:.2f} | {:.2f} | {:.2f} | {:.1f} |\n", threads, one->cells, millions,
               seconds, one->seconds, millions / one->seconds, millions / one->seconds / threads,
               static_cast<double>(one->peak_rss_bytes) / static_cast<double>(one->triangles));
    std::fflush(stdout);
    measured.rows.push_back({fmt::format("paper_tables/{}", table.domain), threads, one->seconds, one->triangles,
                             one->peak_rss_bytes, to_string(one->digest)});
  }
  fmt::print("\n");
}

}  // namespace
}  // namespace pardel::bench

int main(int argc, char** argv) {
  using namespace pardel;
  bench::Settings settings;
  CLI::App app("The workload of the paper's Tables 1 and 2: work proportional to the number of threads");
  app.add_option("--threads", settings.threads, "Numbers of threads, one row each")
      ->delimiter(',')
      ->capture_default_str();
  app.add_option("--per-thread", settings.per_thread, "Triangles for each thread")->capture_default_str();
  app.add_option("--runs", settings.runs, "Runs a row; the median is shown")->check(CLI::PositiveNumber);
  app.add_option("--decomposition", settings.decomposition, "auto, paper or none")
      ->transform(cli::choice(cli::decomposition_names));
  app.add_option("--mesher", settings.mesher, "A sequential mesher that does the tasks, as off_the_shelf names it")
      ->check(CLI::IsMember(bench::names_of_meshers()));
  app.add_option("--scheme", settings.scheme, "frozen (default), cells or decoupled: how its tasks are made");
  app.add_option("--mpirun", settings.mpirun, "Also measure ranks of one thread, started by this program (Open MPI)");
  std::string json;
  app.add_option("--json", json, "Also write the rows of this machine to this file, in the format of Google Benchmark");
  CLI11_PARSE(app, argc, argv);
  bench::Measured measured;
  for (const bench::Table& table : bench::tables) bench::add(table, settings, measured);
  if (!json.empty() && !bench::write_json(json, argv[0], measured.rows)) {
    fmt::print(stderr, "paper_tables: {}: cannot be written\n", json);
    return 1;
  }
  return measured.failed ? 1 : 0;
}
