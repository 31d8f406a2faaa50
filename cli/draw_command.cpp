// pardel draw: draws a domain or a mesh as SVG.
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "../core/formats.hpp"
#include "choice.hpp"
#include "command.hpp"
#include "names.hpp"
#include "output.hpp"
#include "tile_hues.hpp"

namespace pardel::cli {
namespace fs = std::filesystem;
namespace {

struct Arguments {
  fs::path input;
  fs::path output;
  std::optional<HueBy> by;
  fs::path report;  ///< the report that `by` needs
};

/// A .node file is part of a mesh if a .ele file of the same name exists; otherwise it is a set of points.
bool is_domain(const fs::path& file) {
  std::error_code ignored;
  if (file.extension() == ".node") return !fs::exists(fs::path(file).replace_extension(".ele"), ignored);
  return file.extension() == ".poly";
}

Status draw_mesh(const Arguments& arguments) {
  const Result<Mesh> mesh = read_mesh(arguments.input);
  if (!mesh) return mesh.error();
  if (!arguments.by) return write_svg(*mesh, arguments.output);
  const Result<std::vector<std::uint16_t>> hues = tile_hues(*mesh, arguments.report, *arguments.by);
  if (!hues) return hues.error();
  return write_svg(*mesh, *hues, arguments.output);
}

Status draw_domain(const Arguments& arguments) {
  if (arguments.by)
    return Error{ErrorKind::usage,
                 fmt::format("{}: --by needs a mesh, and this is a domain", arguments.input.string())};
  const Result<Pslg> pslg = read_pslg(arguments.input);
  if (!pslg) return pslg.error();
  return write_svg(*pslg, arguments.output);
}

Result<ExitCode> run(const Arguments& arguments) {
  if (arguments.output.extension() != ".svg") {
    return Error{ErrorKind::usage, fmt::format("{}: pictures are written as .svg", arguments.output.string())};
  }
  if (Status folder = check_folder(arguments.output); !folder) return folder.error();
  const Status drawn = is_domain(arguments.input) ? draw_domain(arguments) : draw_mesh(arguments);
  if (!drawn) return drawn.error();
  return ExitCode::done;
}

}  // namespace

Command add_draw(CLI::App& program) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* app = program.add_subcommand("draw", "Draw a domain or a mesh as SVG");
  app->add_option("IN|MESH", arguments->input, "A domain (.poly, .node) or a mesh (.ele, .msh, .vtu, .off)")
      ->required()
      ->type_name("");
  app->add_option("-o,--output", arguments->output, "The picture to write (required)")
      ->required()
      ->type_name("FILE.svg");
  CLI::Option* by =
      app->add_option("--by", arguments->by, "Colour triangles by the tile, the phase or the thread that made them")
          ->transform(choice(hue_names))
          ->type_name("WHAT");
  CLI::Option* report =
      app->add_option("--report", arguments->report, "The report that pardel mesh --json wrote with the mesh")
          ->type_name("FILE.json");
  by->needs(report);
  report->needs(by);
  app->footer(R"(Examples:
  pardel draw key.1.ele -o key.svg
  pardel mesh pipe.poly -o mesh.ele --max-area 1e-5 --threads 2 --json report.json
  pardel draw mesh.ele -o mesh.svg --by thread --report report.json)");
  return {app, [arguments] { return run(*arguments); }};
}

}  // namespace pardel::cli
