#include "options.hpp"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "../help.hpp"
#include "../whole_number.hpp"
#include "mesher.hpp"

namespace pardel::harness {
namespace {

constexpr int most_words = 100'000;
constexpr const char* description =
    "pardel-harness: runs any mesher on generated domains and checks its meshes with an independent checker.";

std::string footer() {
  return R"(COMMAND is run once per case, without a shell. In its arguments
  {poly}       is the input file in Triangle's format, points numbered from 1
  {out}        is the file for the mesh; it may be missing for programs that, like Triangle, write domain.1.ele
               in the folder of domain.poly
  {min-angle}  is the angle bound in degrees
  {max-area}   is the area bound (with --max-area-fraction)
Parts that a mesh does not have (neighbours, markers, constrained edges) are not checked. COMMAND may also be an
adaptor:
)" + adaptors_text() +
         R"(
Examples:
  pardel-harness --mesher pardel --cases 2000 --jobs 2
  pardel-harness --mesher 'mymesher {poly} --angle {min-angle} -o {out}' --format off --failures failures
  pardel-harness --mesher gmsh --min-angle 0 --report gmsh.md --json gmsh.json
  pardel-harness --mesher 'sh -c "mymesher < {poly} > {out}"' --families cracks,nested_holes
  pardel-harness --mesher mymesher.sh\ {poly}\ {out} --replay 1:cracks:17 --keep case

Exit status:
  0    every case is valid
  1    some case is not valid; the report names it
  2    wrong command line
  5    a program is missing, a file cannot be written, or memory or processes are used up
  130  interrupted)";
}

std::string list_of_families() {
  std::string text;
  for (const Family family : generators::all_families()) text += std::string(name(family)) + '\n';
  return text;
}

/// A callback of CLI11 that parses words into `values`. If a word is invalid, the error message comes from parse_one.
template <class Value>
CLI::callback_t into(std::vector<Value>& values, Result<Value> (*parse_one)(const std::string&)) {
  return [&values, parse_one](const CLI::results_t& words) {
    for (const std::string& word : words) {
      const Result<Value> value = parse_one(word);
      if (!value) throw CLI::ValidationError(value.error().message);
      values.push_back(*value);
    }
    return true;
  };
}

Result<Family> family_named(const std::string& text) { return parse_family(text); }

void add_case_options(CLI::App& app, Options& options) {
  constexpr const char* group = "Cases";
  app.add_option("--cases", options.cases, "Number of cases (default 500), taken from the families in turn")
      ->check(CLI::Range(std::uint64_t{1}, std::uint64_t{100'000'000}).description(""))
      ->type_name("N")
      ->group(group);
  app.add_option("--seed", options.seed, "Seed of the cases (default 1); equal seeds give equal reports")
      ->check(cli::whole_number())
      ->type_name("S")
      ->group(group);
  app.add_option("--families", into<Family>(options.families, family_named),
                 "Use these families only, separated by commas")
      ->delimiter(',')
      ->expected(1, most_words)
      ->type_name("NAMES")
      ->group(group);
  app.add_option("--replay", into<CaseId>(options.replay, parse_case), "Run these cases only, named as in the report")
      ->delimiter(',')
      ->expected(1, most_words)
      ->type_name("SEED:FAMILY:INDEX")
      ->group(group);
  app.add_flag_callback(
         "--list-families",
         [] {
           fmt::print("{}", list_of_families());
           throw CLI::Success();
         },
         "List the families of domains and exit")
      ->group(group);
}

void add_limits(CLI::App& app, Options& options) {
  constexpr const char* group = "Limits";
  app.add_option("--time-limit", options.time_limit, "Seconds for one case (default 10)")
      ->check(CLI::Range(0.01, 86'400.0).description(""))
      ->type_name("SECONDS")
      ->group(group);
  app.add_option("--memory-limit", options.memory_limit_mib, "Address space for one case (default 4096; 0: no limit)")
      ->check(CLI::Range(std::uint64_t{0}, std::uint64_t{1} << 40U).description(""))
      ->type_name("MIB")
      ->group(group);
  app.add_option("--jobs", options.jobs,
                 "Cases that run at the same time (default 1); the report does not depend on it")
      ->check(CLI::Range(1, 256).description(""))
      ->type_name("N")
      ->group(group);
}

void add_outputs(CLI::App& app, Options& options) {
  constexpr const char* group = "Reports";
  app.add_option("--report", options.report,
                 "Write the report card as Markdown to this file (default: standard output)")
      ->type_name("FILE|-")
      ->group(group);
  app.add_option("--json", options.json, "Write the report card as JSON (pardel.harness/1) with every failing case")
      ->type_name("FILE|-")
      ->group(group);
  app.add_option("--failures", options.failures,
                 "Shrink the first case of each kind of failure and write it to this folder as .poly and .svg")
      ->type_name("FOLDER")
      ->group(group);
  app.add_option("--shrink-runs", options.shrink_runs, "Runs of the mesher to shrink one kind of failure (default 300)")
      ->type_name("N")
      ->group(group);
  app.add_option("--keep", options.keep, "Keep the input, output and log of every case in this folder")
      ->type_name("FOLDER")
      ->group(group);
}

}  // namespace

ParseResult parse(int argc, char** argv, Options& options) {
  CLI::App app(description, "pardel-harness");
  app.set_version_flag("--version", "pardel-harness " PARDEL_VERSION);
  app.footer(footer());
  app.formatter(std::make_shared<cli::HelpFormatter>());
  app.failure_message([](const CLI::App*, const CLI::Error& error) {
    return fmt::format("pardel-harness: {} (see 'pardel-harness --help')\n", error.what());
  });
  app.add_option("--mesher", options.mesher, "The mesher: a command or an adaptor, see below")
      ->required()
      ->type_name("COMMAND");
  app.add_option("--format", options.format, "Format that a command writes: ele (default), vtu, msh or off")
      ->check(CLI::IsMember({"ele", "vtu", "msh", "off"}).description(""))
      ->type_name("SUFFIX");
  app.add_option("--min-angle", options.min_angle_deg, "Lower bound on the angles (default 20; 0: no bound)")
      ->check(CLI::Range(0.0, 60.0).description(""))
      ->type_name("DEGREES");
  app.add_option("--max-area-fraction", options.max_area_fraction,
                 "Upper bound on areas as a fraction of the bounding box (default: no bound)")
      ->check(CLI::Range(1e-6, 1.0).description(""))
      ->type_name("F");
  app.add_flag("--any-triangulation", options.any_triangulation, "Accept meshes that are not (constrained) Delaunay");
  add_case_options(app, options);
  add_limits(app, options);
  add_outputs(app, options);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& stop) {  // also thrown by --help and --version
    return app.exit(stop) == 0 ? ParseResult::done : ParseResult::usage_error;
  }
  if (options.families.empty()) options.families = generators::all_families();
  return ParseResult::run;
}

}  // namespace pardel::harness
