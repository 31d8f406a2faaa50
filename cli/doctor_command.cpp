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
#include "../parallel/gaps.hpp"
#include "../parallel/mesher.hpp"
#include "../parallel/repair.hpp"
#include "../parallel/validate.hpp"
#include "command.hpp"
#include "distinct_files.hpp"
#include "exit_code.hpp"
#include "gaps_text.hpp"
#include "input.hpp"
#include "json_text.hpp"
#include "output.hpp"
#include "plural.hpp"
#include "points_outside.hpp"
#include "problems_text.hpp"
#include "progress_bar.hpp"
#include "refusal.hpp"
#include "snap_option.hpp"
#include "warnings_json.hpp"

namespace pardel::cli {
namespace {

struct DoctorArguments {
  std::filesystem::path input;
  std::filesystem::path repaired;
  std::optional<double> snap;
  bool convex_hull = false;
  std::filesystem::path json;
  bool quiet = false;
};

/// What the command found out. The warnings, the gaps and the points outside are those of the repaired domain; without
/// repair, those of the domain if it has no problems.
struct Findings {
  std::vector<Problem> problems;
  std::vector<Warning> warnings{};
  std::optional<Repaired> repaired{};
  std::vector<Gap> gaps{};
  std::optional<PointsOutside> outside{};
};

nlohmann::ordered_json to_json(const Domain& domain, const Findings& findings) {
  const auto& [problems, warnings, repaired, gaps, outside] = findings;
  nlohmann::ordered_json json = {{"schema", "pardel.doctor/1"},
                                 {"file", domain.name},
                                 {"input",
                                  {{"points", domain.pslg.points.size()},
                                   {"segments", domain.pslg.segments.size()},
                                   {"holes", domain.pslg.holes.size()},
                                   {"regions", domain.pslg.regions.size()}}},
                                 {"valid", problems.empty()},
                                 {"problems", nlohmann::ordered_json::array()},
                                 {"warnings", warnings_json(warnings, domain.pslg.first_id.value)},
                                 {"points_outside", nullptr},
                                 {"repaired", nullptr},
                                 {"gaps", gaps_json(gaps, domain.pslg.first_id.value)}};
  for (const Problem& problem : problems) json["problems"].push_back(problem_json({problem, numbers_of(domain)}));
  if (outside) json["points_outside"] = outside->count;
  if (repaired) {
    const Pslg& pslg = repaired->domain.pslg();
    json["repaired"] = {{"points", pslg.points.size()}, {"segments", pslg.segments.size()},
                        {"holes", pslg.holes.size()},   {"regions", pslg.regions.size()},
                        {"snap", repaired->snap},       {"log", repaired->log}};
  }
  return json;
}

void print(const DoctorArguments& arguments, const Domain& domain, const Findings& findings) {
  const auto& [problems, warnings, repaired, gaps, outside] = findings;
  const bool asked_for_repair = !arguments.repaired.empty();
  const Pslg& pslg = domain.pslg;
  fmt::print("{}: {}, {}, {}, {}: ", domain.name, plural(pslg.points.size(), "point"),
             plural(pslg.segments.size(), "segment"), plural(pslg.holes.size(), "hole"),
             plural(pslg.regions.size(), "region"));
  fmt::print("{}\n", problems.empty() ? "no problem" : plural(problems.size(), "problem"));
  for (const Problem& problem : problems)
    fmt::print("  {}: {}\n", name(problem.kind), problem.message(numbers_of(domain)));
  const std::string help = repaired || problems.empty() ? "" : advice(pslg, problems, domain.name, asked_for_repair);
  if (!help.empty()) fmt::print("{}\n", help.substr(1));
  if (!repaired) return;
  for (const std::string& line : repaired->log) fmt::print("  repaired: {}\n", line);
  fmt::print("wrote   {}\n", arguments.repaired.string());
}

Status check_outputs(const DoctorArguments& arguments) {
  const std::array outputs = {arguments.repaired, arguments.json};
  if (Status fine = check_standard_output(outputs); !fine) return fine;
  if (!arguments.repaired.empty()) {
    if (Status fine = check_poly_output(arguments.repaired); !fine) return fine;
  }
  const std::array named = {NamedFile{"--repair", arguments.repaired, false}, NamedFile{"--json", arguments.json}};
  if (Status fine = check_distinct(named, std::array{domain_input(arguments.input)}); !fine) return fine;
  return check_folder(arguments.json);
}

/// Repairs the domain and writes the result. Returns the error that prevents this.
Status repair(const DoctorArguments& arguments, const Domain& domain, Findings& findings) {
  Result<Repaired> result = repair(domain.pslg, {.snap = arguments.snap, .convex_hull = arguments.convex_hull});
  if (result) {
    findings.repaired.emplace(std::move(*result));
    return write_poly(findings.repaired->domain.pslg(), arguments.repaired, domain.pslg.first_id.value);
  }
  if (result.error().kind == ErrorKind::invalid_input && !findings.problems.empty())
    return refusal_of(domain, findings.problems, result.error()).error;
  return with_name(result.error(), domain.name);
}

Status report(const DoctorArguments& arguments, const Domain& domain, const Findings& findings) {
  const std::array outputs = {arguments.repaired, arguments.json};
  if (!arguments.quiet && !has_standard_output(outputs)) print(arguments, domain, findings);
  if (arguments.json.empty()) return Done{};
  return write_text(json_text(to_json(domain, findings)), arguments.json);
}

Result<ExitCode> run(const DoctorArguments& arguments) {
  if (Status fine = check_outputs(arguments); !fine) return fine.error();
  ProgressBar bar(ShowProgress::automatic);
  bar.begin("reading " + arguments.input.string());
  const Result<Domain> domain = read_domain(arguments.input);
  if (!domain) return refused(domain.error(), arguments.input, arguments.json);
  bar.begin("validating " + arguments.input.string());
  const Result<ValidPslg, std::vector<Problem>> valid = validate(domain->pslg, {.convex_hull = arguments.convex_hull});
  Findings findings{.problems = valid ? std::vector<Problem>() : valid.error()};
  Status repaired = Done{};
  if (!arguments.repaired.empty()) repaired = repair(arguments, *domain, findings);
  if (!repaired && repaired.error().kind == ErrorKind::io) return repaired.error();
  const ValidPslg* examined = findings.repaired ? &findings.repaired->domain : valid ? &*valid : nullptr;
  if (examined != nullptr) {
    Result<std::vector<Gap>> found = find_gaps(*examined);
    if (!found) return found.error();
    findings.gaps = std::move(*found);
    const Result<Meshed> triangulation = triangulate(*examined);
    if (!triangulation) return triangulation.error();
    findings.outside = points_outside(triangulation->mesh);
  }
  bar.finish();
  if (examined != nullptr) {
    const std::string name = findings.repaired ? arguments.repaired.string() : domain->name;
    findings.warnings = print_warnings(*examined, name);
    if (!findings.gaps.empty()) warn(gaps_text(findings.gaps, name, *examined));
    if (findings.outside->count > 0)
      warn(fmt::format("{}: {}", name,
                       note_about(*findings.outside, true, "'pardel mesh --drop-unused' writes a mesh without them")));
  }
  if (Status reported = report(arguments, *domain, findings); !reported) return reported.error();
  if (!repaired) return repaired.error();
  return findings.problems.empty() || findings.repaired ? ExitCode::done : ExitCode::invalid_input;
}

}  // namespace

Run doctor_command(CLI::App& app) {
  const auto arguments = std::make_shared<DoctorArguments>();
  app.add_option("IN.poly", arguments->input, "The domain: .poly, .node or .geojson; - is standard input")
      ->required()
      ->type_name("");
  CLI::Option* repaired =
      app.add_option("--repair", arguments->repaired,
                     "Write a domain with points merged, segments split where they meet, and tiny gaps closed")
          ->type_name("OUT.poly");
  add_snap_option(app, arguments->snap, repaired);
  app.add_flag("--convex-hull", arguments->convex_hull, "The domain is the convex hull; no outline is needed");
  app.add_option("--json", arguments->json, "Write the findings as JSON; - (or nothing) is standard output")
      ->type_name("FILE|-")
      ->expected(0, 1)
      ->default_str("-");
  app.add_flag("-q,--quiet", arguments->quiet, "Print nothing on standard output except the findings of --json");
  app.footer(
      "Exit status 0: there is no problem (warnings do not count), or the repaired domain is written; 3: there are "
      "problems.\n\n"
      "Examples:\n  pardel doctor survey.poly\n  pardel doctor survey.poly --repair fixed.poly --snap 0.001");
  return [arguments] { return run(*arguments); };
}

}  // namespace pardel::cli
