// peers: runs pardel and other meshers on the same domain and goal. The runs take turns, and each has its own process.
// The result is one table of medians. See --help.
#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "tool.hpp"
#include "warm_memory.hpp"

namespace pardel::bench {
namespace {

namespace fs = std::filesystem;

struct Settings {
  Task task;
  int runs = 3;
  std::vector<std::string> tools;
  std::string json_file;
};

/// A row of the table: the medians of the runs of one tool. Its column "per cap" is the number of triangles per area
/// bound that fits into the domain: 1 if all triangles were as large as allowed.
struct Row {
  std::string tool;
  double seconds = 0;
  std::uint64_t triangles = 0;
  double bytes_per_triangle = 0;
  Shapes shapes{};
  std::string verdict;
  std::vector<double> all_seconds;

  [[nodiscard]] bool failed() const { return triangles == 0; }
  [[nodiscard]] double rate() const { return failed() ? 0 : static_cast<double>(triangles) / seconds; }
};

Row summarise(const std::string& tool, const std::vector<Run>& runs) {
  Row row{.tool = tool, .shapes = runs.front().shapes, .verdict = runs.front().verdict.data(), .all_seconds = {}};
  std::vector<std::uint64_t> triangles;
  std::vector<double> bytes;
  for (const Run& run : runs) {
    row.all_seconds.push_back(run.seconds);
    triangles.push_back(run.triangles);
    if (run.triangles > 0)
      bytes.push_back(static_cast<double>(run.peak_rss_bytes) / static_cast<double>(run.triangles));
    if (run.verdict != runs.front().verdict) row.verdict = "differs from run to run";
  }
  row.seconds = median(row.all_seconds);
  row.triangles = *std::min_element(triangles.begin(), triangles.end());  // 0 if a run failed
  if (!bytes.empty()) row.bytes_per_triangle = median(bytes);
  if (row.failed() && row.verdict.empty()) row.verdict = "the process died";
  return row;
}

/// Runs a tool until its runs add up to a second. A shorter time is not reliable on a machine with other load.
void run_for_a_second(const Tool& tool, const Task& task, const fs::path& scratch, std::vector<Run>& runs) {
  for (double spent = 0; spent < 1;) {
    warm_memory(runs.empty() ? 0 : runs.back().peak_rss_bytes);
    runs.push_back(tool.run(task, scratch));
    if (runs.back().triangles == 0) return;
    spent += runs.back().seconds;
  }
}

std::vector<Row> compare(const Settings& settings, const std::vector<Tool>& tools) {
  const fs::path scratch = fs::temp_directory_path() / fmt::format("pardel-peers-{}", getpid());
  fs::create_directories(scratch);
  std::map<std::string, std::vector<Run>> runs;
  for (int round = 0; round < settings.runs; ++round)
    for (const Tool& tool : tools) run_for_a_second(tool, settings.task, scratch, runs[tool.name]);
  fs::remove_all(scratch);
  std::vector<Row> rows;
  for (const Tool& tool : tools) rows.push_back(summarise(tool.name, runs[tool.name]));
  return rows;
}

void print(const std::vector<Row>& rows, const Settings& settings) {
  const Task& task = settings.task;
  fmt::print("{}", task.domain);
  if (is_point_set(task)) fmt::print(" ({} points, seed {})", task.points, task.seed);
  if (task.delaunay_only)
    fmt::print(", Delaunay triangulation alone");
  else
    fmt::print(", angles of at least {}°", task.goal.min_angle_deg);
  if (is_graded(task))
    fmt::print(", edges of at most {:.4g} times the distance from the centre ({} decades)", grading(task).ratio,
               task.points);
  if (std::isfinite(task.goal.max_area)) fmt::print(", areas of at most {:.4g}", task.goal.max_area);
  fmt::print("; one thread; {} rounds, in each of which every tool runs for at least a second; medians of all runs\n\n",
             settings.runs);
  const auto print_row = [](const auto&... cells) {
    fmt::print("| {:13} | {:>8} | {:>9} | {:>10} | {:>7} | {:>8} | {:>5} | {:>5} | {:>5} | {:>5} | {} |\n", cells...);
  };
  print_row("tool", "time, s", "time / pardel's time", "triangles", "per cap", "M tri/s", "B/tri", "mean", "least",
            "> 0.9", "the checker's verdict");
  fmt::print("|---|---|---|---|---|---|---|---|---|---|---|\n");
  const auto own = std::find_if(rows.begin(), rows.end(), [](const Row& row) { return row.tool == "pardel"; });
  for (const Row& row : rows) {
    if (row.failed()) {
      print_row(row.tool, "–", "–", "–", "–", "–", "–", "–", "–", "–", row.verdict);
      continue;
    }
    const auto n = static_cast<double>(row.triangles);
    print_row(
        row.tool, fmt::format("{:.3f}", row.seconds),
        own == rows.end() || own->failed() ? "–" : fmt::format("{:.2f}", row.seconds / own->seconds), row.triangles,
        std::isfinite(task.goal.max_area) ? fmt::format("{:.3f}", n * task.goal.max_area / domain_area(task)) : "–",
        fmt::format("{:.2f}", row.rate() / 1e6), fmt::format("{:.0f}", row.bytes_per_triangle),
        fmt::format("{:.3f}", row.shapes.mean), fmt::format("{:.3f}", row.shapes.least),
        fmt::format("{:.0f} %", 100 * row.shapes.good), row.verdict);
  }
  fmt::print("\nmean, least, > 0.9: the shapes of the triangles, 4 √3 area / (sum of the squares of the sides)\n");
}

bool write_json(const std::vector<Row>& rows, const Settings& settings) {
  nlohmann::json report;
  report["schema"] = "pardel.peers/1";
  report["domain"] = settings.task.domain;
  if (is_point_set(settings.task)) report["points"] = settings.task.points;
  report["seed"] = settings.task.seed;
  report["delaunay_only"] = settings.task.delaunay_only;
  report["min_angle_deg"] = settings.task.goal.min_angle_deg;
  if (is_graded(settings.task)) report["edge_over_distance"] = grading(settings.task).ratio;
  if (std::isfinite(settings.task.goal.max_area)) report["max_area"] = settings.task.goal.max_area;
  report["runs"] = settings.runs;
  for (const Row& row : rows) {
    report["tools"][row.tool] = {{"seconds", row.all_seconds},
                                 {"median_seconds", row.seconds},
                                 {"triangles", row.triangles},
                                 {"bytes_per_triangle", row.bytes_per_triangle},
                                 {"mean_shape", row.shapes.mean},
                                 {"least_shape", row.shapes.least},
                                 {"share_of_shapes_above_0.9", row.shapes.good},
                                 {"verdict", row.verdict}};
  }
  std::ofstream out(settings.json_file);
  out << report.dump(2) << '\n';
  return static_cast<bool>(out.flush());
}

std::vector<Tool> chosen_tools(const Settings& settings) {
  std::vector<Tool> tools;
  for (const Tool& tool : {pardel_tool(), pardel_fill_tool(), cgal_mesh_tool(), cgal_size_tool(), cgal_delaunay_tool(),
                           gmsh_tool(), triangle_tool()}) {
    const bool wanted = settings.tools.empty() ||
                        std::find(settings.tools.begin(), settings.tools.end(), tool.name) != settings.tools.end();
    if (wanted && tool.applies(settings.task)) tools.push_back(tool);
  }
  return tools;
}

}  // namespace

int main_of_peers(int argc, char** argv) {
  Settings settings;
  Task& task = settings.task;
  bool no_check = false;
  std::uint64_t decades = 4;
  CLI::App app{"Runs pardel and other meshers on the same domain and goal; prints one table of medians."};
  app.add_option("--domain", task.domain, "The domain")
      ->check(CLI::IsMember(
          {"square", "pipe", "key", "star", "comb", "points", "kuzmin", "line", "clusters", "grid-points", "radial"}))
      ->capture_default_str();
  app.add_option("--triangles", task.triangles,
                 "Approximate number of triangles, which determines the area cap, or the sizes of radial; 0: no cap")
      ->capture_default_str();
  app.add_option("--points", task.points,
                 "Number of points (for --domain points, kuzmin, line, clusters, grid-points)");
  app.add_option("--decades", decades, "Decades of radii (for --domain radial)")
      ->check(CLI::Range(1, 6))
      ->capture_default_str();
  app.add_option("--seed", task.seed, "Seed of the random points")->capture_default_str();
  app.add_option("--min-angle", task.goal.min_angle_deg, "Minimum angle in degrees")
      ->check(CLI::Range(0.0, 33.0))
      ->capture_default_str();
  app.add_option("--runs", settings.runs, "Rounds; in each round, every tool runs for at least a second")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  app.add_flag("--delaunay-only", task.delaunay_only, "Only triangulate the points; no refinement");
  app.add_option("--tools", settings.tools,
                 "Tools: pardel, pardel-fill (with --interior fill), cgal-mesh (Mesh_2 with a bound on areas), "
                 "cgal-size (Mesh_2 with a bound on edge lengths), "
                 "cgal-delaunay, gmsh, triangle (default: all that are installed and can do the task)")
      ->delimiter(',');
  app.add_flag("--no-check", no_check, "Do not check the meshes (checking a large mesh takes long)");
  app.add_option("--json", settings.json_file, "Write all runs to this file");
  CLI11_PARSE(app, argc, argv);
  task.check = !no_check;
  if (is_graded(task)) task.points = decades;
  if (is_point_set(task) && task.domain != "points" && !task.delaunay_only) {
    fmt::print(stderr, "peers: --domain {} needs --delaunay-only\n", task.domain);
    return 2;
  }
  set_size(task);

  const std::vector<Row> rows = compare(settings, chosen_tools(settings));
  print(rows, settings);
  if (!settings.json_file.empty() && !write_json(rows, settings)) {
    fmt::print(stderr, "{}: cannot be written\n", settings.json_file);
    return 5;
  }
  return std::any_of(rows.begin(), rows.end(), [](const Row& row) { return row.tool == "pardel" && row.failed(); });
}

}  // namespace pardel::bench

int main(int argc, char** argv) { return pardel::bench::main_of_peers(argc, argv); }
