// many_domains: meshes many generated domains and judges each mesh exactly.
#include <fmt/format.h>
#include <omp.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <iterator>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "../../cli/whole_number.hpp"
#include "../../core/support/output_file.hpp"
#include "generated_case.hpp"
#include "judge_case.hpp"
#include "log.hpp"
#include "record.hpp"
#include "watched_cases.hpp"

namespace pardel::fuzz {
namespace {

namespace fs = std::filesystem;

struct Arguments {
  std::uint64_t seed = 1, first = 0, cases = 1'000;
  std::size_t slowest = 10;
  std::string log, json;
  Watch watch;
};

std::string joined(const std::vector<std::string>& kinds) {
  std::string text;
  for (const std::string& kind : kinds) text += (text.empty() ? "" : ",") + kind;
  return text;
}

Record run_case(std::uint64_t seed, std::uint64_t number, const std::function<void(const std::string&)>& announce) {
  omp_set_num_threads(1);  // the engine has its own number of threads
  const GeneratedCase drawn = generated_case(seed, number);
  Record record;
  record.kinds = joined(drawn.kinds);
  announce(record.kinds);
  const Verdict verdict = judge(drawn);
  record.fault = verdict.fault;
  record.verdict = verdict.fault.empty() ? Record::Verdict::right : Record::Verdict::wrong;
  record.triangles = verdict.triangles;
  record.listed = verdict.listed;
  if (verdict.listed > 0) record.kinds += ",missed";
  return record;
}

/// The records of the log with numbers in the range.
std::vector<Record> records_of(const Log& log, const Arguments& arguments) {
  std::vector<Record> records;
  std::ranges::copy_if(log.records(), std::back_inserter(records),
                       [&](const Record& record) { return record.number - arguments.first < arguments.cases; });
  return records;
}

void throw_unless(const Status& fine) {
  if (!fine) throw std::runtime_error(fine.error().message);
}

/// What CLI11 does not notice, and what a long run should not tell at its end only.
void check(const Arguments& arguments) {
  if (std::isnan(arguments.watch.seconds)) throw CLI::ValidationError("--seconds", "this is not a number");
  if (arguments.json.empty()) return;
  if (!arguments.log.empty() && fs::weakly_canonical(arguments.log) == fs::weakly_canonical(arguments.json))
    throw CLI::ValidationError("--report", "this is the log");
  OutputFile trial(arguments.json);
  if (!trial.ok()) throw_unless(trial.close());
}

int run(const Arguments& arguments) {
  check(arguments);
  std::optional<Log> log;
  if (!arguments.log.empty()) log.emplace(arguments.log, arguments.seed);
  std::vector<Record> records = log ? records_of(*log, arguments) : std::vector<Record>{};
  std::set<std::uint64_t> known;
  for (const Record& record : records) known.insert(record.number);
  std::vector<std::uint64_t> numbers;
  for (std::uint64_t number = arguments.first; number - arguments.first < arguments.cases; ++number)
    if (!known.contains(number)) numbers.push_back(number);

  const auto run = [&](std::uint64_t number, const auto& announce) {
    return run_case(arguments.seed, number, announce);
  };
  run_watched(numbers, arguments.watch, run, [&](const Record& record) {
    records.push_back(record);
    if (log) log->append(record);
  });

  const std::string replay = fmt::format("many_domains --seed {}", arguments.seed);
  fmt::print("{}", summary_text(records, arguments.slowest, replay));
  if (std::fflush(stdout) != 0) throw std::runtime_error("standard output cannot be written");
  if (!arguments.json.empty()) {
    OutputFile report(arguments.json);
    report.write(summary_json(records, arguments.slowest, replay));
    throw_unless(report.commit());
  }
  return std::ranges::all_of(records, [](const Record& r) { return r.verdict == Record::Verdict::right; }) ? 0 : 1;
}

}  // namespace
}  // namespace pardel::fuzz

int main(int argc, char** argv) {
  pardel::fuzz::Arguments arguments;
  CLI::App app{
      "Meshes generated domains with random goals and options, on several threads and ranks, and judges every mesh "
      "with the exact checker and by its report. A case is determined by the seed and its number. Exit code 1: a case "
      "has a fault, crashes or takes too long; 2: the command line is wrong; 5: a file cannot be read or written."};
  app.add_option("--seed", arguments.seed, "The seed of all cases")
      ->check(pardel::cli::whole_number())
      ->capture_default_str();
  app.add_option("--first", arguments.first, "The number of the first case")
      ->check(pardel::cli::whole_number())
      ->capture_default_str();
  app.add_option("--cases", arguments.cases, "The number of cases")
      ->check(CLI::Range(0, 1'000'000'000))
      ->capture_default_str();
  app.add_option("--jobs", arguments.watch.jobs, "Processes at the same time")
      ->check(CLI::Range(1, 1'000))
      ->capture_default_str();
  app.add_option("--seconds", arguments.watch.seconds, "The processor time that a case may take")
      ->check(CLI::Range(0.01, 1e6))
      ->capture_default_str();
  app.add_option("--log", arguments.log,
                 "A line per case goes to this file. If it exists, its cases are not run again, and count");
  app.add_option("--report", arguments.json, "The summary goes to this file, as JSON");
  app.add_option("--slowest", arguments.slowest, "How many of the slowest cases are listed")
      ->check(CLI::Range(0, 1'000'000))
      ->capture_default_str();
  try {
    app.parse(argc, argv);
    return pardel::fuzz::run(arguments);
  } catch (const CLI::Error& error) {
    return app.exit(error) == 0 ? 0 : 2;
  } catch (const std::exception& error) {
    fmt::print(stderr, "many_domains: {}\n", error.what());
    return 5;
  }
}
