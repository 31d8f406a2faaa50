// pardel generate: writes one of the named domains that examples, tests and benchmarks share.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "../core/formats.hpp"
#include "../properties/domains/domains.hpp"
#include "command.hpp"
#include "distinct_files.hpp"
#include "goal_options.hpp"
#include "output.hpp"
#include "whole_number.hpp"

namespace pardel::cli {
namespace {

struct GenerateArguments {
  std::string name;
  std::uint64_t n = 0;
  std::uint64_t seed = 1;
  std::filesystem::path output, sizes;
  std::optional<double> ratio;
};

constexpr double default_ratio = 0.02;

Error usage(const char* message) { return {ErrorKind::usage, message}; }

Status check_arguments(const GenerateArguments& arguments) {
  if (!arguments.sizes.empty() && arguments.name != "radial")
    return usage("--sizes can be used with the domain 'radial' only");
  if (arguments.ratio && arguments.sizes.empty()) return usage("--ratio needs --sizes FILE");
  const std::array outputs = {arguments.output, arguments.sizes};
  if (Status fine = check_standard_output(outputs); !fine) return fine;
  if (Status fine = check_poly_output(arguments.output); !fine) return fine;
  if (Status fine = check_folder(arguments.sizes); !fine) return fine;
  return check_distinct(
      std::array{NamedFile{"-o", arguments.output, false}, NamedFile{"--sizes", arguments.sizes, false}}, {});
}

Result<ExitCode> run(const GenerateArguments& arguments) {
  if (Status fine = check_arguments(arguments); !fine) return fine.error();
  const Result<Pslg> pslg = domains::generate(arguments.name, arguments.n, arguments.seed);
  if (!pslg) return pslg.error();
  const Status written = write_poly(*pslg, arguments.output);
  if (!written) return written.error();
  if (arguments.sizes.empty()) return ExitCode::done;
  // The file of --sizes has the format of a .area file.
  const Status sizes =
      write_area(arguments.sizes, domains::radial_sizes(*pslg, arguments.ratio.value_or(default_ratio)),
                 static_cast<int>(pslg->first_id.value));
  if (!sizes) return sizes.error();
  return ExitCode::done;
}

std::string list_of_names() {
  std::string list = "Names:";
  for (const std::string& name : domains::names()) list += ' ' + name;
  return list;
}

std::string list_of_sizes() {
  std::string list = "Numbers that -n takes, and the default:";
  for (const domains::SizeRange& range : domains::size_ranges())
    list += fmt::format("\n  {:12} {} to {} ({})", range.name, range.least, range.most, range.usual);
  return list;
}

}  // namespace

Run generate_command(CLI::App& app) {
  const auto arguments = std::make_shared<GenerateArguments>();
  app.add_option("NAME", arguments->name, "The name of the domain")->required()->type_name("");
  app.add_option("-n,--size", arguments->n,
                 "The size of the domain, if it has one: how many points, teeth of a comb, cells, or decades of radii "
                 "(0: the\ndefault)")
      ->type_name("N");
  app.add_option("--seed", arguments->seed,
                 "Seed of a random domain (default 1); a seed gives the same file on every machine")
      ->check(whole_number())
      ->type_name("S");
  app.add_option("-o,--output", arguments->output, "The file to write (required)")->required()->type_name("FILE.poly");
  app.add_option("--sizes", arguments->sizes,
                 "For radial: also write edge lengths that grow with the distance from the centre")
      ->type_name("FILE");
  app.add_option("--ratio", arguments->ratio, "For --sizes: edge length divided by distance (default 0.02)")
      ->check(positive_number("a ratio"))
      ->type_name("R");
  app.footer(list_of_names() + "\n" + list_of_sizes() +
             "\n\nExample:\n  pardel generate points -n 100000 --seed 7 -o points.poly");
  return [arguments] { return run(*arguments); };
}

}  // namespace pardel::cli
