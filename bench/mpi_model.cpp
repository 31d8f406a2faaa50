// mpi_model: predicts the time of `pardel-mpi mesh` on more ranks than this machine has processors, from a traced run
// of one process and a network with a latency and a bandwidth. Started by mpirun -n R, it also measures R ranks, and
// compares them with the model. See --help.
#include <fmt/format.h>
#include <mpi.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "../core/formats.hpp"
#include "measured_ranks.hpp"
#include "model/balance.hpp"
#include "model/simulation.hpp"
#include "model/thread_time.hpp"
#include "model/trace.hpp"
#include "mpi_program.hpp"
#include "tool.hpp"

namespace pardel::bench {
namespace {

using Json = nlohmann::ordered_json;

struct Settings {
  Task task{.domain = "pipe", .goal = {}};
  double triangles = 1e7;
  std::vector<int> ranks = {1, 2, 4, 8, 16, 64, 121, 1024, 16'384};
  Network network;
  double per_rank = 0;          ///< if not 0: triangles of each rank (weak scaling)
  double most_triangles = 2e7;  ///< weak scaling: larger meshes are not traced
  double most_coarse = 2e9;     ///< weak scaling: of larger meshes, not even the coarse levels are made
  bool balance = false;
  std::string json;
};

/// How much of a prediction is measured.
enum class Source : std::uint8_t {
  traced,    ///< the whole run
  coarse,    ///< the coarse levels; the ranks repeat those of a smaller run
  extended,  ///< the coarse levels take longer in proportion to the tiles
};
constexpr const char* source_names[] = {"traced", "coarse traced", "extended"};

struct Row {
  int ranks = 1;
  double triangles = 0;
  double tiles = 0, coarse_triangles = 0;
  Prediction predicted;
  std::size_t exchanges = 0;
  std::uint64_t most_bytes_out = 0;  ///< that a rank sends
  std::optional<double> margin{};    ///< triangles that ranks hold beside their own, per own triangle
  Source source = Source::traced;
};

/// Per rank: the bytes that it sends in all steps.
std::vector<std::uint64_t> bytes_out(int ranks, const std::vector<Step>& steps) {
  std::vector<std::uint64_t> sum(static_cast<std::size_t>(ranks), 0);
  for (const Step& step : steps)
    for (std::size_t rank = 0; rank < step.traffic.size(); ++rank) sum[rank] += step.traffic[rank].bytes_out;
  return sum;
}

Row row_of(int ranks, const std::vector<Step>& steps, const RankCosts& costs, const Network& network) {
  Row row;
  row.ranks = ranks;
  row.predicted = simulate(ranks, steps, costs, network);
  row.exchanges = static_cast<std::size_t>(std::ranges::count_if(steps, [](const Step& s) { return !s.is_sum(); }));
  row.most_bytes_out = std::ranges::max(bytes_out(ranks, steps));
  return row;
}

class Model {
 public:
  explicit Model(Settings settings) : settings_(std::move(settings)) {
    ThreadWatch watch;
    domain_.emplace(std::move(validate(make_domain(settings_.task))).value());
    input_seconds_ = watch.lap();
  }

  [[nodiscard]] const ValidPslg& domain() const { return *domain_; }
  [[nodiscard]] Goal goal(double triangles) const {
    Task task = settings_.task;
    task.triangles = static_cast<std::uint64_t>(triangles);
    set_size(task);
    return task.goal;
  }
  [[nodiscard]] Trace traced(double triangles, const std::vector<int>& ranks, Extent extent = Extent::whole) const {
    Result<Trace> result = trace(*domain_, goal(triangles), {}, ranks, extent);
    if (!result) throw std::runtime_error(result.error().message);
    if (result->rest > 0)
      fmt::print(stderr, "{} triangles that the first rank refines alone are not in the model\n", result->rest);
    return std::move(*result);
  }
  [[nodiscard]] RankCosts costs(const Trace& trace, const LoneRank& alone) const {
    return trace.costs(alone, input_seconds_);
  }

  [[nodiscard]] std::vector<Row> strong(const Trace& trace) const {
    std::vector<Row> rows;
    for (const ForRanks& each : trace.for_ranks) rows.push_back(traced_row(trace, each));
    return rows;
  }
  [[nodiscard]] std::vector<Row> weak() const;

 private:
  [[nodiscard]] Row traced_row(const Trace& trace, const ForRanks& each) const {
    Row row = row_of(each.replay.ranks(), each.replay.steps(), costs(trace, each.alone), settings_.network);
    row.triangles = static_cast<double>(trace.triangles);
    row.tiles = static_cast<double>(trace.promised.size());
    row.coarse_triangles = static_cast<double>(trace.coarse_triangles);
    row.margin = static_cast<double>(each.replay.held()) / row.triangles - 1;
    return row;
  }

  Settings settings_;
  std::optional<ValidPslg> domain_;
  double input_seconds_ = 0;
};

std::vector<Row> Model::weak() const {
  std::vector<Row> rows;
  std::optional<Trace> largest, coarse;
  for (const int ranks : settings_.ranks) {
    const double triangles = settings_.per_rank * ranks;
    if (triangles <= settings_.most_triangles || !largest) {
      largest = traced(triangles, {ranks});
      rows.push_back(traced_row(*largest, largest->for_ranks.front()));
      continue;
    }
    const bool is_coarse = triangles <= settings_.most_coarse;
    if (is_coarse) coarse = traced(triangles, {ranks}, Extent::coarse);
    const Replay& like = largest->for_ranks.front().replay;
    const double by_traced = static_cast<double>(ranks) / like.ranks();
    // The number of tiles, and the time for the coarse levels, grow in proportion to the mesh.
    const Trace& measured = coarse ? *coarse : *largest;
    const LoneRank& alone = measured.for_ranks.front().alone;
    const double larger = is_coarse ? 1 : static_cast<double>(ranks) / measured.for_ranks.front().replay.ranks();
    const double tiles = larger * static_cast<double>(measured.promised.size());
    RankCosts costs = this->costs(measured, {alone.divide_seconds * larger, alone.phase_seconds * larger});
    costs.before *= larger;
    costs.write_byte = largest->messages.write_byte;
    costs.read_byte = largest->messages.read_byte;
    const auto steps = repeated(like.steps(), like.ranks(), ranks, static_cast<std::uint64_t>(tiles));
    Row row = row_of(ranks, steps, costs, settings_.network);
    row.triangles = by_traced * static_cast<double>(largest->triangles);
    row.tiles = tiles;
    row.coarse_triangles = larger * static_cast<double>(measured.coarse_triangles);
    row.source = is_coarse ? Source::coarse : Source::extended;
    rows.push_back(row);
  }
  return rows;
}

/// The times, and then what is sent.
void print(const std::vector<Row>& rows, bool is_weak) {
  fmt::print(
      "| ranks | triangles, millions | seconds | efficiency | coarse levels | division | phases | work | messages "
      "| waiting | network | basis |\n|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---|\n");
  const double first = rows.front().predicted.seconds * (is_weak ? 1 : rows.front().ranks);
  for (const Row& row : rows) {
    const Prediction& p = row.predicted;
    fmt::print(
        "| {} | {:.1f} | {:.3f} | {:.0f} % | {:.3f} | {:.3f} | {:.3f} | {:.3f} | {:.3f} | {:.3f} | {:.3f} | {} |\n",
        row.ranks, row.triangles / 1e6, p.seconds, 100 * first / p.seconds / (is_weak ? 1 : row.ranks), p.before,
        p.divide, p.phases, p.work, p.messages, p.waiting, p.network(), source_names[static_cast<int>(row.source)]);
  }
  fmt::print(
      "\n| ranks | tiles | coarse triangles, thousands | exchanges | announcements, ms | sums, ms | transfer, ms | "
      "MB sent by a rank, at most | margin |\n|---:|---:|---:|---:|---:|---:|---:|---:|---:|\n");
  for (const Row& row : rows) {
    const Prediction& p = row.predicted;
    fmt::print("| {} | {:.0f} | {:.0f} | {} | {:.2f} | {:.2f} | {:.2f} | {:.1f} | {} |\n", row.ranks, row.tiles,
               row.coarse_triangles / 1e3, row.exchanges, 1e3 * p.announcements, 1e3 * p.sums, 1e3 * p.transfer,
               static_cast<double>(row.most_bytes_out) / 1e6,
               row.margin ? fmt::format("{:.0f} %", 100 * *row.margin) : "");
  }
}

Json to_json(const std::vector<Row>& rows) {
  Json list = Json::array();
  for (const Row& row : rows) {
    const Prediction& p = row.predicted;
    Json one{{"ranks", row.ranks},
             {"triangles", row.triangles},
             {"tiles", row.tiles},
             {"coarse_triangles", row.coarse_triangles},
             {"basis", source_names[static_cast<int>(row.source)]},
             {"seconds", p.seconds},
             {"parts",
              {{"coarse_levels", p.before},
               {"division", p.divide},
               {"phases", p.phases},
               {"work", p.work},
               {"messages", p.messages},
               {"waiting", p.waiting},
               {"announcements", p.announcements},
               {"sums", p.sums},
               {"transfer", p.transfer}}},
             {"exchanges", row.exchanges},
             {"most_bytes_sent", row.most_bytes_out}};
    if (row.margin) one["margin"] = *row.margin;
    list.push_back(std::move(one));
  }
  return list;
}

Json print_balance(const Trace& trace, const std::vector<int>& ranks) {
  struct Division {
    const char* by;
    std::vector<double> work;
  };
  const Division divisions[] = {
      {"promised work", trace.promised},
      {"promised work of tasks (as ranks do)", engine::work_of_tasks(*trace.tiles, trace.promised)},
      {"vertices inserted", inserted_per_cell(trace)}};
  fmt::print(
      "\nThe most of a rank, divided by the mean:\n\n"
      "| ranks | tiles divided by | promised work | vertices | processor time | vertices, phase by phase |\n"
      "|---:|---|---:|---:|---:|---:|\n");
  Json list = Json::array();
  for (const int count : ranks)
    for (const Division& division : divisions) {
      const Balance b = balance(trace, division.work, count);
      fmt::print("| {} | {} | {:.3f} | {:.3f} | {:.3f} | {:.3f} |\n", count, division.by, b.promised, b.inserted,
                 b.seconds, b.phases);
      list.push_back({{"ranks", count},
                      {"divided_by", division.by},
                      {"promised", b.promised},
                      {"vertices", b.inserted},
                      {"seconds", b.seconds},
                      {"vertices_by_phase", b.phases}});
    }
  return list;
}

/// Compares the ranks of this job with the model.
Json print_comparison(const Trace& trace, const Row& row, const std::vector<MeasuredRank>& ranks) {
  const auto sum = [&](auto member) {
    double all = 0;
    for (const MeasuredRank& rank : ranks) all += static_cast<double>(rank.*member);
    return all;
  };
  const auto most = [&](auto member) {
    double largest = 0;
    for (const MeasuredRank& rank : ranks) largest = std::max(largest, static_cast<double>(rank.*member));
    return largest;
  };
  const std::vector<Step>& steps = trace.for_ranks.front().replay.steps();
  const std::vector<std::uint64_t> predicted_out = bytes_out(row.ranks, steps);
  const Prediction& p = row.predicted;
  struct Line {
    const char* what;
    double predicted, measured;
  };
  const Line lines[] = {
      {"exchanges", static_cast<double>(row.exchanges), most(&MeasuredRank::exchanges)},
      {"sums", static_cast<double>(steps.size() - row.exchanges), most(&MeasuredRank::sums)},
      {"MB sent by all ranks", std::accumulate(predicted_out.begin(), predicted_out.end(), 0.0) / 1e6,
       sum(&MeasuredRank::bytes_out) / 1e6},
      {"MB sent by a rank, at most", static_cast<double>(row.most_bytes_out) / 1e6,
       most(&MeasuredRank::bytes_out) / 1e6},
      {"processor seconds per rank, mean", p.before + p.divide + p.phases + p.work + p.messages,
       sum(&MeasuredRank::processor_seconds) / row.ranks},
      {"seconds", p.seconds, most(&MeasuredRank::seconds)},
  };
  fmt::print("\nThe ranks of this job:\n\n| | predicted | measured |\n|---|---:|---:|\n");
  Json json;
  for (const Line& line : lines) {
    fmt::print("| {} | {:.3f} | {:.3f} |\n", line.what, line.predicted, line.measured);
    json[line.what] = {{"predicted", line.predicted}, {"measured", line.measured}};
  }
  return json;
}

void run_model(const Settings& settings, const Model& model, const std::vector<MeasuredRank>& measured) {
  fmt::print("{}, latency {} s, {} bytes per second\n\n", settings.task.domain, settings.network.latency,
             settings.network.bandwidth);
  Json json{{"domain", settings.task.domain},
            {"latency", settings.network.latency},
            {"bandwidth", settings.network.bandwidth}};
  if (measured.size() > 1) {
    const Trace trace = model.traced(settings.triangles, {static_cast<int>(measured.size())});
    const std::vector<Row> rows = model.strong(trace);
    print(rows, false);
    json["predictions"] = to_json(rows);
    json["comparison"] = print_comparison(trace, rows.front(), measured);
  } else if (settings.per_rank > 0) {
    const std::vector<Row> rows = model.weak();
    print(rows, true);
    json["predictions"] = to_json(rows);
  } else {
    const Trace trace = model.traced(settings.triangles, settings.ranks);
    const std::vector<Row> rows = model.strong(trace);
    print(rows, false);
    json["predictions"] = to_json(rows);
    if (settings.balance) json["balance"] = print_balance(trace, settings.ranks);
  }
  if (!settings.json.empty()) std::ofstream(settings.json) << json.dump(1) << '\n';
}

int run(int argc, char** argv) try {
  Settings settings;
  CLI::App app("Predicts the time of pardel-mpi on many ranks. Started by mpirun -n R, measures R ranks, too");
  app.add_option("--domain", settings.task.domain, "square, pipe, radial (graded) or points")
      ->check(CLI::IsMember({"square", "pipe", "radial", "points"}));
  app.add_option("--points", settings.task.points, "number of points, for points");
  CLI::Option* all = app.add_option("--triangles", settings.triangles, "about this number of triangles");
  app.add_option("--per-rank", settings.per_rank, "about this number of triangles for each rank (weak scaling)")
      ->excludes(all);
  app.add_option("--ranks", settings.ranks, "numbers of ranks")->delimiter(',')->capture_default_str();
  app.add_option("--latency", settings.network.latency, "of a message, in seconds")->capture_default_str();
  app.add_option("--bandwidth", settings.network.bandwidth, "of each rank, in bytes per second")->capture_default_str();
  app.add_option("--most-triangles", settings.most_triangles,
                 "weak scaling: larger meshes repeat the largest traced one")
      ->capture_default_str();
  app.add_option("--most-coarse", settings.most_coarse,
                 "weak scaling: coarse levels are made for meshes up to this size")
      ->capture_default_str();
  app.add_flag("--balance", settings.balance, "print how even the work of the ranks is");
  app.add_option("--json", settings.json, "also write the results to this file");
  CLI11_PARSE(app, argc, argv);
  mpi::MpiRanks ranks;
  const Model model(settings);
  std::vector<MeasuredRank> measured;
  if (ranks.count() > 1) measured = measure_ranks(model.domain(), model.goal(settings.triangles), ranks);
  if (ranks.rank() == 0) run_model(settings, model, measured);
  return 0;
} catch (const std::runtime_error& error) {
  fmt::print(stderr, "{}\n", error.what());
  return 1;
}

}  // namespace
}  // namespace pardel::bench

int main(int argc, char** argv) { return pardel::bench::run_in_job(argc, argv, pardel::bench::run); }
