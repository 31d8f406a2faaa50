// pardel-harness: tests any mesher on generated domains with the independent checker.
#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <exception>
#include <filesystem>
#include <new>
#include <system_error>

#include "../../core/support/shell_words.hpp"
#include "../../core/support/work_folder.hpp"
#include "../distinct_files.hpp"
#include "../exit_code.hpp"
#include "../output.hpp"
#include "failures.hpp"
#include "interrupt.hpp"
#include "options.hpp"
#include "progress_counter.hpp"
#include "report_card.hpp"
#include "run_cases.hpp"

namespace pardel::harness {
namespace {

using cli::ExitCode;

std::string quoted(const std::string& word) {
  return word.find_first_not_of("abcdefghijklmnopqrstuvwxyz") == std::string::npos
             ? word
             : '\'' + replaced(word, "'", R"('\'')") + '\'';
}

/// The command line that repeats a case; the caller appends the case.
std::string replay_line(const Options& options) {
  std::string line = "pardel-harness --mesher " + quoted(options.mesher);
  if (options.format != "ele") line += " --format " + options.format;
  line += fmt::format(" --min-angle {}", options.min_angle_deg);
  if (options.max_area_fraction > 0) line += fmt::format(" --max-area-fraction {}", options.max_area_fraction);
  if (options.any_triangulation) line += " --any-triangulation";
  if (options.time_limit != Options{}.time_limit) line += fmt::format(" --time-limit {}", options.time_limit);
  if (options.memory_limit_mib != Options{}.memory_limit_mib) {
    line += fmt::format(" --memory-limit {}", options.memory_limit_mib);
  }
  return line;
}

ReportCard blank_card(const Options& options, const Mesher& mesher) {
  ReportCard card;
  card.mesher = mesher.title;
  card.goal = options.min_angle_deg > 0 ? fmt::format("No angle below {} degrees", options.min_angle_deg)
                                        : std::string("No bound on angles");
  if (options.max_area_fraction > 0) {
    card.goal += fmt::format(", no triangle above {} of the bounding box", options.max_area_fraction);
  }
  if (options.any_triangulation) card.goal += ", Delaunay or not";
  card.limits = fmt::format("At most {} s", options.time_limit);
  if (options.memory_limit_mib > 0) card.limits += fmt::format(" and {} MiB", options.memory_limit_mib);
  card.limits += " a case";
  card.replay = replay_line(options);
  card.seed = options.seed;
  card.cases = options.replay.empty() ? cases_in_turn(options.seed, options.families, options.cases) : options.replay;
  return card;
}

/// Creates the folder if it does not exist. Returns an error if no files can be created in it.
Status make_folder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) return Error{ErrorKind::io, fmt::format("{}: {}", folder.string(), error.message())};
  if (access(folder.c_str(), W_OK | X_OK) != 0)
    return Error{ErrorKind::io, fmt::format("{}: {}", folder.string(), std::strerror(errno))};
  return Done{};
}

/// Reports unwritable outputs before any case runs.
Status check_outputs(const Options& options) {
  if (Status fine = cli::check_standard_output(std::array{options.report, options.json}); !fine) return fine;
  const std::array outputs = {cli::NamedFile{"--report", options.report}, cli::NamedFile{"--json", options.json}};
  if (Status fine = cli::check_distinct(outputs, {}); !fine) return fine;
  for (const auto& file : {options.report, options.json}) {
    if (Status fine = cli::check_folder(file); !fine) return fine;
  }
  for (const auto& folder : {options.failures, options.keep}) {
    if (folder.empty()) continue;
    if (Status fine = make_folder(folder); !fine) return fine;
  }
  return Done{};
}

/// Lists all violations of the cases of --replay on stderr.
void list_violations(const ReportCard& card) {
  for (std::size_t i = 0; i < card.cases.size(); ++i) {
    for (const std::string& line : card.outcomes[i].details)
      fmt::print(stderr, "{}: {}\n", to_string(card.cases[i]), line);
  }
}

Result<ExitCode> run(const Options& options) {
  const Result<Mesher> mesher = find_mesher(options.mesher, options.format, options.max_area_fraction > 0);
  if (!mesher) return mesher.error();
  if (Status fine = check_outputs(options); !fine) return fine.error();
  WorkFolder work;
  if (Status made = work.make("pardel-harness"); !made) return made.error();

  const Interrupt interrupt;
  const Trials trials{*mesher,
                      options.min_angle_deg,
                      options.max_area_fraction,
                      !options.any_triangulation,
                      {.seconds = options.time_limit, .memory_bytes = options.memory_limit_mib << 20U},
                      [&] { return interrupt.requested(); }};
  ReportCard card = blank_card(options, *mesher);
  {
    ProgressCounter counter(card.cases.size());
    const bool keep = !options.keep.empty();
    Result<std::vector<Outcome>> outcomes =
        run_cases(trials, card.cases, options.jobs, keep ? std::filesystem::absolute(options.keep) : work.path(), keep,
                  [&](std::size_t done) { counter.show(done); });
    if (!outcomes) return outcomes.error();
    card.outcomes = std::move(*outcomes);
  }
  count(card);
  if (!options.failures.empty()) {
    if (Status written = write_failures(card, trials, options.shrink_runs, options.jobs, options.failures, work.path());
        !written) {
      return written.error();
    }
  }
  if (!options.replay.empty()) list_violations(card);
  if (Status written = cli::write_text(to_markdown(card), options.report); !written) return written.error();
  if (!options.json.empty()) {
    if (Status written = cli::write_text(to_json(card), options.json); !written) return written.error();
  }
  return all_valid(card) ? ExitCode::done : ExitCode::violations;
}

ExitCode report(const Error& error) { return cli::report(error, "pardel-harness"); }

ExitCode guarded(int argc, char** argv) {
  try {
    Options options;
    switch (parse(argc, argv, options)) {
      case ParseResult::done:
        return ExitCode::done;
      case ParseResult::usage_error:
        return ExitCode::usage;
      case ParseResult::run:
        break;
    }
    const Result<ExitCode> result = run(options);
    const ExitCode code = result ? *result : report(result.error());
    if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return code;
    return report({ErrorKind::io, fmt::format("standard output: {}", std::strerror(errno))});
  } catch (const std::bad_alloc&) {
    return report({ErrorKind::resources, "out of memory"});
  } catch (const std::exception& unexpected) {
    return report({ErrorKind::resources, unexpected.what()});
  }
}

}  // namespace
}  // namespace pardel::harness

int main(int argc, char** argv) { return static_cast<int>(pardel::harness::guarded(argc, argv)); }
