// many_domains: meshes many generated domains and judges each mesh exactly.
#include <fmt/format.h>
#include <omp.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdint>
#include <fstream>
#include <set>
#include <string>
#include <system_error>
#include <vector>

#include "generated_case.hpp"
#include "judge_case.hpp"
#include "record.hpp"
#include "watched_cases.hpp"

namespace pardel::fuzz {
namespace {

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

/// The records of the log with numbers in the range. The first line of a log is the seed.
std::vector<Record> records_of(const Arguments& arguments) {
  std::vector<Record> records;
  std::ifstream in(arguments.log);
  std::string line;
  if (!std::getline(in, line)) return records;
  if (line != fmt::format("seed {}", arguments.seed))
    throw CLI::ValidationError(arguments.log, "the log is of another seed");
  while (std::getline(in, line))
    if (const auto record = to_record(line); record && record->number - arguments.first < arguments.cases)
      records.push_back(*record);
  return records;
}

int run(const Arguments& arguments) {
  std::vector<Record> records;
  std::ofstream log;
  if (!arguments.log.empty()) {
    records = records_of(arguments);
    std::ifstream before(arguments.log, std::ios::ate);
    const bool is_new = !before || before.tellg() == 0;
    const bool is_cut_off = !is_new && before.seekg(-1, std::ios::end).peek() != '\n';
    log.open(arguments.log, std::ios::app);
    if (is_cut_off) log << '\n';
    if (is_new) log << "seed " << arguments.seed << '\n';
    if (!log.flush()) throw CLI::FileError(arguments.log + " cannot be written");
  }
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
    if (log.is_open() && !(log << to_line(record) << std::endl))
      throw CLI::FileError(arguments.log + " cannot be written");
  });

  const std::string replay = fmt::format("many_domains --seed {}", arguments.seed);
  fmt::print("{}", summary_text(records, arguments.slowest, replay));
  if (!arguments.json.empty()) {
    std::ofstream out(arguments.json);
    out << summary_json(records, arguments.slowest, replay);
    if (!out.flush()) throw CLI::FileError(arguments.json + " cannot be written");
  }
  return std::ranges::all_of(records, [](const Record& r) { return r.verdict == Record::Verdict::right; }) ? 0 : 1;
}

}  // namespace
}  // namespace pardel::fuzz

int main(int argc, char** argv) {
  pardel::fuzz::Arguments arguments;
  CLI::App app{
      "Meshes generated domains with random goals and options, on several threads and ranks, and judges every mesh "
      "with "
      "the exact checker and by its report. A case is determined by the seed and its number. The exit status is 1 if a "
      "case has a fault, crashes or takes too long."};
  app.add_option("--seed", arguments.seed, "The seed of all cases")->capture_default_str();
  app.add_option("--first", arguments.first, "The number of the first case")->capture_default_str();
  app.add_option("--cases", arguments.cases, "The number of cases")->capture_default_str();
  app.add_option("--jobs", arguments.watch.jobs, "Processes at the same time")
      ->check(CLI::Range(1, 1'000))
      ->capture_default_str();
  app.add_option("--seconds", arguments.watch.seconds, "The processor time that a case may take")
      ->check(CLI::Range(0.01, 1e6))
      ->capture_default_str();
  app.add_option("--log", arguments.log,
                 "A line per case goes to this file. If it exists, its cases are not run again, and count");
  app.add_option("--report", arguments.json, "The summary goes to this file, as JSON");
  app.add_option("--slowest", arguments.slowest, "How many of the slowest cases are listed")->capture_default_str();
  try {
    app.parse(argc, argv);
    return pardel::fuzz::run(arguments);
  } catch (const CLI::Error& error) {
    return app.exit(error);
  } catch (const std::system_error& error) {
    fmt::print(stderr, "many_domains: {}\n", error.what());
    return 5;
  }
}
