// paper_tables: repeats the workload of Tables 1 and 2 of [CC] (Chernikov and Chrisochoides 2004) on this machine. The
// area bound is inversely proportional to the number of threads. So every thread has the same amount of work, and with
// ideal scaling the time is constant. See --help.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <vector>

#include "../cli/choice.hpp"
#include "../cli/names.hpp"
#include "../core/support/stopwatch.hpp"
#include "../parallel/mesher.hpp"
#include "../properties/domains/domains.hpp"
#include "run_in_child.hpp"
#include "tool.hpp"
#include "warm_memory.hpp"

namespace pardel::bench {
namespace {

struct Table {
  const char* title;
  const char* domain;
  double area;
  const char* theirs;  ///< the results of [CC] for this domain
};
constexpr Table tables[] = {
    {"The pipe cross-section (Tables 1 and 2)", "pipe", 2.486,
     "Table 1, MPI: 4 processors, 14.6 million triangles in 179.1 s; 64 processors, 233.3 million in 273.6 s; "
     "121 processors, 441.1 million in 212.7 s. Table 2, 4 processors, 14.6 million triangles: MPI 220.3 s, OpenMP "
     "214.1 s"},
    {"The unit square (Table 1)", "square", 1,
     "Table 1, MPI: 4 processors, 23.8 million triangles in 293.7 s; 64 processors, 470.7 million in 300.1 s; "
     "121 processors, 873.5 million in 293.7 s"},
};

struct Timed {
  double seconds = 0;  ///< time of validation, triangulation and refinement
  std::uint64_t triangles = 0;
  std::uint64_t peak_rss_bytes = 0;
  std::uint32_t cells = 0;
};

struct Settings {
  std::vector<int> threads = {1, 2};
  double per_thread = 5e6;
  int runs = 3;
  Decomposition decomposition = Decomposition::automatic;
};

std::optional<Timed> run(const Table& table, const Settings& settings, int threads) {
  return run_in_child<Timed>([&] {
    const Pslg pslg = *domains::generate(table.domain, 0, 1);
    const Goal goal{.max_area = triangles_per_cap * table.area / (settings.per_thread * threads)};
    const Stopwatch watch;
    const Result<Meshed> meshed = mesh(pslg, goal, {.threads = threads, .decomposition = settings.decomposition});
    if (!meshed) return Timed{};
    const Tiling& tiling = meshed->report.tiling;
    return Timed{watch.seconds(), meshed->mesh.triangles.size(), peak_rss_bytes(), tiling.columns * tiling.rows};
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

void print(const Table& table, const Settings& settings) {
  fmt::print("### {}\n\n", table.title);
  fmt::print("| threads | cells | triangles, millions | seconds | millions/s | millions/s/thread | bytes/triangle |\n");
  fmt::print("|---:|---:|---:|---:|---:|---:|---:|\n");
  for (const int threads : settings.threads) {
    const std::optional<Timed> one = median_run(table, settings, threads);
    if (!one) {
      fmt::print("| {} | | | failed | | | |\n", threads);
      continue;
    }
    const double millions = static_cast<double>(one->triangles) / 1e6;
    fmt::print("| {} | {} | {:.1f} | {:.2f} | {:.2f} | {:.2f} | {:.1f} |\n", threads, one->cells, millions,
               one->seconds, millions / one->seconds, millions / one->seconds / threads,
               static_cast<double>(one->peak_rss_bytes) / static_cast<double>(one->triangles));
    std::fflush(stdout);
  }
  fmt::print("\nThe paper, 2004. {}.\n\n", table.theirs);
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
  CLI11_PARSE(app, argc, argv);
  for (const bench::Table& table : bench::tables) bench::print(table, settings);
  return 0;
}
