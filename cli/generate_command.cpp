// pardel generate: writes one of the named domains that examples, tests and benchmarks share.
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

#include "../core/formats.hpp"
#include "../properties/domains/domains.hpp"
#include "command.hpp"
#include "output.hpp"

namespace pardel::cli {
namespace {

struct GenerateArguments {
  std::string name;
  std::uint64_t n = 0;
  std::uint64_t seed = 1;
  std::filesystem::path output;
};

Result<ExitCode> run(const GenerateArguments& arguments) {
  if (Status fine = check_poly_output(arguments.output); !fine) return fine.error();
  const Result<Pslg> pslg = domains::generate(arguments.name, arguments.n, arguments.seed);
  if (!pslg) return pslg.error();
  const Status written = write_poly(*pslg, arguments.output);
  if (!written) return written.error();
  return ExitCode::done;
}

std::string list_of_names() {
  std::string list = "Names:";
  for (const std::string& name : domains::names()) list += ' ' + name;
  return list;
}

}  // namespace

Command add_generate(CLI::App& program) {
  const auto arguments = std::make_shared<GenerateArguments>();
  CLI::App* app = program.add_subcommand("generate", "Write a named domain as a .poly file");
  app->add_option("NAME", arguments->name, "The name of the domain")->required()->type_name("");
  app->add_option("-n,--size", arguments->n,
                  "The size of the domain, if it has one: how many points, teeth of a comb, or cells (0: the default)")
      ->type_name("N");
  app->add_option("--seed", arguments->seed,
                  "Seed of a random domain (default 1); a seed gives the same file on every machine")
      ->type_name("S");
  app->add_option("-o,--output", arguments->output, "The file to write (required)")->required()->type_name("FILE.poly");
  app->footer(list_of_names() + "\n\nExample:\n  pardel generate points -n 100000 --seed 7 -o points.poly");
  return {app, [arguments] { return run(*arguments); }};
}

}  // namespace pardel::cli
