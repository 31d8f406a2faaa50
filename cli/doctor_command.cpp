// pardel doctor: lists every problem of a domain and repairs it.
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <array>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "../core/formats.hpp"
#include "../parallel/repair.hpp"
#include "../parallel/validate.hpp"
#include "command.hpp"
#include "input.hpp"
#include "output.hpp"
#include "plural.hpp"
#include "problems_text.hpp"
#include "progress_bar.hpp"
#include "refusal.hpp"
#include "snap_option.hpp"

namespace pardel::cli {
namespace {

struct Arguments {
  std::filesystem::path input;
  std::filesystem::path repaired;
  std::optional<double> snap;
  bool convex_hull = false;
  std::filesystem::path json;
  bool quiet = false;
};

nlohmann::ordered_json to_json(const Domain& domain, const std::vector<Problem>& problems,
                               const std::optional<Repaired>& repaired) {
  nlohmann::ordered_json json = {{"schema", "pardel.doctor/1"},
                                 {"file", domain.name},
                                 {"input",
                                  {{"points", domain.pslg.points.size()},
                                   {"segments", domain.pslg.segments.size()},
                                   {"holes", domain.pslg.holes.size()},
                                   {"regions", domain.pslg.regions.size()}}},
                                 {"valid", problems.empty()},
                                 {"problems", nlohmann::ordered_json::array()},
                                 {"repaired", nullptr}};
  for (const Problem& problem : problems) json["problems"].push_back(problem_json(problem, domain.pslg.first_id.value));
  if (repaired) {
    const Pslg& pslg = repaired->domain.pslg();
    json["repaired"] = {{"points", pslg.points.size()}, {"segments", pslg.segments.size()},
                        {"holes", pslg.holes.size()},   {"regions", pslg.regions.size()},
                        {"snap", repaired->snap},       {"log", repaired->log}};
  }
  return json;
}

void print(const Domain& domain, const std::vector<Problem>& problems, const std::optional<Repaired>& repaired) {
  const Pslg& pslg = domain.pslg;
  fmt::print("{}: {}, {}, {}, {}: ", domain.name, plural(pslg.points.size(), "point"),
             plural(pslg.segments.size(), "segment"), plural(pslg.holes.size(), "hole"),
             plural(pslg.regions.size(), "region"));
  fmt::print("{}\n", problems.empty() ? "no problem" : plural(problems.size(), "problem"));
  for (const Problem& problem : problems)
    fmt::print("  {}: {}\n", name(problem.kind), problem.message(domain.pslg.first_id.value));
  const std::string help = repaired || problems.empty() ? "" : advice(problems, domain.name, false);
  if (!help.empty()) fmt::print("{}\n", help.substr(1));
  if (!repaired) return;
  for (const std::string& line : repaired->log) fmt::print("  repaired: {}\n", line);
}

Result<ExitCode> run(const Arguments& arguments) {
  const std::array outputs = {arguments.repaired, arguments.json};
  if (Status fine = check_standard_output(outputs); !fine) return fine.error();
  if (!arguments.repaired.empty()) {
    if (Status fine = check_poly_output(arguments.repaired); !fine) return fine.error();
  }
  if (Status folder = check_folder(arguments.json); !folder) return folder.error();
  ProgressBar bar(ShowProgress::automatic);
  bar.begin("reading " + arguments.input.string());
  const Result<Domain> domain = read_domain(arguments.input);
  if (!domain) return refused(domain.error(), arguments.input, arguments.json);
  const Pslg& pslg = domain->pslg;
  bar.begin("validating " + arguments.input.string());
  const Result<ValidPslg, std::vector<Problem>> valid = validate(pslg, {.convex_hull = arguments.convex_hull});
  const std::vector<Problem> problems = valid ? std::vector<Problem>() : valid.error();

  std::optional<Repaired> repaired;
  std::optional<Error> failure;
  if (!arguments.repaired.empty()) {
    Result<Repaired> result = repair(pslg, {.snap = arguments.snap, .convex_hull = arguments.convex_hull});
    if (result) {
      repaired.emplace(std::move(*result));
      if (Status written = write_poly(repaired->domain.pslg(), arguments.repaired, pslg.first_id.value); !written) {
        return written.error();
      }
    } else if (result.error().kind == ErrorKind::invalid_input && !problems.empty()) {
      failure = refusal_of(*domain, problems, true).error;
    } else {
      failure = with_name(result.error(), domain->name);
    }
  }
  bar.finish();
  if (valid) print_warnings(*valid, domain->name);
  if (!arguments.quiet && !has_standard_output(outputs)) print(*domain, problems, repaired);
  if (!arguments.json.empty()) {
    const std::string text = to_json(*domain, problems, repaired).dump(2) + "\n";
    if (Status written = write_text(text, arguments.json); !written) return written.error();
  }
  if (failure) return *failure;
  return problems.empty() || repaired ? ExitCode::done : ExitCode::invalid_input;
}

}  // namespace

Command add_doctor(CLI::App& program) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* app = program.add_subcommand("doctor", "List what is wrong with a domain, and repair it");
  app->add_option("IN.poly", arguments->input, "The domain: .poly or .node")->required()->type_name("");
  CLI::Option* repaired =
      app->add_option("--repair", arguments->repaired,
                      "Write a domain with points merged, segments split where they meet, and tiny gaps closed")
          ->type_name("OUT.poly");
  add_snap_option(*app, arguments->snap, repaired);
  app->add_flag("--convex-hull", arguments->convex_hull, "The domain is the convex hull; no outline is needed");
  app->add_option("--json", arguments->json, "Write the findings as JSON; - (or nothing) is standard output")
      ->type_name("FILE|-")
      ->expected(0, 1)
      ->default_str("-");
  app->add_flag("-q,--quiet", arguments->quiet, "Print nothing on standard output except the findings of --json");
  app->footer(
      "Exit status 0: there is no problem (warnings do not count), or the repaired domain is written; 3: there are "
      "problems.\n\n"
      "Examples:\n  pardel doctor survey.poly\n  pardel doctor survey.poly --repair fixed.poly --snap 0.001");
  return {app, [arguments] { return run(*arguments); }};
}

}  // namespace pardel::cli
