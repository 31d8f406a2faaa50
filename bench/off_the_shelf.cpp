// off_the_shelf: makes one mesh with several sequential meshers through the schemes of off_the_shelf/, and with the
// same meshers alone. The result is one table of medians; the runs are interleaved. See --help.
#include <fmt/format.h>
#include <omp.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "../core/digest.hpp"
#include "../core/support/stopwatch.hpp"
#include "../core/support/work_folder.hpp"
#include "../off_the_shelf/mesh_with_mesher.hpp"
#include "../parallel/mesher.hpp"
#include "../properties/checker/check.hpp"
#include "meshers/meshers.hpp"
#include "tool.hpp"

namespace pardel::bench {
namespace {

constexpr const char *valid = "valid", *cannot_serve = "cannot serve this scheme";

struct Settings {
  Task task;
  std::vector<std::string> meshers;
  std::vector<std::string> schemes = {"frozen", "cells", "decoupled"};
  std::vector<int> threads = {1, 2};
  std::uint32_t triangles_per_task = MesherOptions{}.triangles_per_task;
  int runs = 3;
};

/// A mesher with a scheme and a number of threads.
struct Row {
  std::string mesher;
  Scheme scheme;
  int threads;
  std::unique_ptr<SubdomainMesher> worker{};
  std::vector<double> seconds{};
  MeshedWithMesher made{};  ///< of the last run
  std::size_t triangles = 0;
  std::string digest{}, verdict{};
};

void run(Row& row, const ValidPslg& domain, const Settings& settings) {
  if (row.worker == nullptr) {
    row.verdict = "no such mesher here";
    return;
  }
  const MesherOptions how{.scheme = row.scheme, .triangles_per_task = settings.triangles_per_task};
  const Stopwatch watch;
  Result<MeshedWithMesher> made =
      mesh_with_mesher(domain, settings.task.goal, *row.worker, how, {.threads = row.threads});
  const double seconds = watch.seconds();
  if (!made) {
    row.verdict = made.error().kind == ErrorKind::usage ? cannot_serve : made.error().message;
    return;
  }
  row.seconds.push_back(seconds);
  row.digest = to_string(digest(made->mesh)).substr(0, 8);
  if (row.seconds.size() == 1)
    row.verdict = check(domain.pslg(), made->mesh, settings.task.goal).valid ? valid : "NOT VALID";
  row.triangles = made->mesh.triangles.size();
  made->mesh = {};
  row.made = std::move(*made);
  row.made.report.tiling = {};
}

std::string text_of(const Row& row) {
  if (row.seconds.empty())
    return fmt::format("| {} | {} | {} | | | | | | | | | {} | |\n", row.mesher, name(row.scheme), row.threads,
                       row.verdict);
  const MesherReport& r = row.made.mesher;
  return fmt::format(
      "| {} | {} | {} | {} | {} | {} | {:.1f} / {:.1f} / {:.1f} % | {} | {:.3f} | {:.3f} | {:.3f} | {} | {} |\n",
      row.mesher, name(row.scheme), row.threads, row.triangles, r.tasks, r.sweeps,
      100.0 * static_cast<double>(r.prepared) / static_cast<double>(row.made.report.inserted),
      100.0 * static_cast<double>(r.inserted) / static_cast<double>(row.made.report.inserted),
      100.0 * static_cast<double>(r.completed) / static_cast<double>(row.made.report.inserted), r.breaches.total(),
      r.mesher_seconds, r.extraction_seconds + r.verification_seconds + r.gluing_seconds, median(row.seconds),
      row.verdict, row.digest);
}

/// False if the run failed, if its mesh is not valid, or if another number of threads gives another mesh.
bool is_fine(const Row& row, const std::vector<Row>& all) {
  return (row.seconds.empty() ? row.verdict == cannot_serve : row.verdict == valid) &&
         std::ranges::all_of(all, [&](const Row& other) {
           return other.mesher != row.mesher || other.scheme != row.scheme || other.digest == row.digest;
         });
}

/// The tools alone on the whole domain, with their own timers.
std::string alone(const Settings& settings) {
  std::string text = "| alone | triangles | s |\n|---|---|---|\n";
  WorkFolder scratch;
  if (!scratch.make("pardel-bench")) return text;
  for (const Tool& tool : {pardel_tool(), triangle_tool(), cgal_mesh_tool()}) {
    if (!tool.applies(settings.task)) continue;
    std::vector<double> seconds;
    Run last;
    for (int i = 0; i < settings.runs; ++i) {
      last = tool.run(settings.task, scratch.path());
      seconds.push_back(last.seconds);
    }
    if (last.triangles == 0) continue;  // it is not here
    text += fmt::format("| {} | {} | {:.3f} |\n", tool.name, last.triangles, median(seconds));
  }
  return text;
}

int run_all(Settings& settings) {
  if (settings.task.goal.feature_edges > 0) settings.task.triangles = 0;
  set_size(settings.task);
  // Workers are copies of this process, so they are made while it is small.
  std::vector<Row> rows;
  for (const std::string& mesher : settings.meshers.empty() ? names_of_meshers() : settings.meshers)
    for (const std::string& scheme : settings.schemes)
      if (const std::optional<Scheme> known = scheme_named(scheme))
        for (const int threads : settings.threads)
          rows.push_back({mesher, *known, threads, mesher_for(mesher, threads, settings.task.goal)});
  // They run in copies of this process, which must not have used threads yet.
  const std::string tools = alone(settings);
  const auto domain = validate(make_domain(settings.task));
  if (!domain) return 1;
  for (int i = 0; i < settings.runs; ++i)
    for (Row& row : rows)
      if (i == 0 || !row.seconds.empty()) run(row, *domain, settings);
  fmt::print("{}, about {} triangles, {} degrees, area {:.3g}\n\n{}\n", settings.task.domain, settings.task.triangles,
             settings.task.goal.min_angle_deg, settings.task.goal.max_area, tools);
  fmt::print(
      "| mesher | scheme | threads | triangles | tasks | sweeps | vertices before / by mesher / after | breaches | "
      "mesher s | "
      "around it s | total s | | digest |\n|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
  for (const Row& row : rows) fmt::print("{}", text_of(row));
  return std::ranges::all_of(rows, [&](const Row& row) { return is_fine(row, rows); }) ? 0 : 1;
}

}  // namespace
}  // namespace pardel::bench

int main(int argc, char** argv) {
  using namespace pardel::bench;
  Settings settings;
  settings.task.triangles = 100'000;
  settings.task.domain = "pipe";
  CLI::App app("Makes one mesh with sequential meshers through the schemes of off_the_shelf/");
  app.add_option("--domain", settings.task.domain, "A named domain (default pipe)");
  app.add_option("--triangles", settings.task.triangles, "About how many triangles (default 100000)");
  app.add_option("--min-angle", settings.task.goal.min_angle_deg, "The least angle in degrees (default 20.7)");
  app.add_option("--feature-size", settings.task.goal.feature_edges,
                 "As for pardel mesh; then --triangles has no effect");
  app.add_option("--grading", settings.task.goal.grading, "As for pardel mesh");
  app.add_option("--meshers", settings.meshers, "The meshers (default: all)")
      ->delimiter(',')
      ->check(CLI::IsMember(names_of_meshers()));
  app.add_option("--schemes", settings.schemes, "The schemes (default: all)")
      ->delimiter(',')
      ->check(CLI::IsMember({"frozen", "cells", "decoupled"}));
  app.add_option("--threads", settings.threads, "Numbers of threads (default 1,2)")->delimiter(',');
  app.add_option("--triangles-per-task", settings.triangles_per_task, "As for pardel mesh --mesher");
  app.add_option("--runs", settings.runs, "Runs of each row; medians are printed (default 3)");
  CLI11_PARSE(app, argc, argv);
  return run_all(settings);
}
