// pardel draw: a domain or a mesh as SVG.
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>

#include "../core/formats.hpp"
#include "command.hpp"
#include "output.hpp"

namespace pardel::cli {
namespace fs = std::filesystem;
namespace {

struct Arguments {
  fs::path input;
  fs::path output;
};

/// A .node file is half a mesh where its .ele lies beside it, and a set of points otherwise.
bool is_domain(const fs::path& file) {
  std::error_code ignored;
  if (file.extension() == ".node") return !fs::exists(fs::path(file).replace_extension(".ele"), ignored);
  return file.extension() == ".poly";
}

Result<ExitCode> run(const Arguments& arguments) {
  if (arguments.output.extension() != ".svg") {
    return Error{ErrorKind::usage, fmt::format("{}: pictures are written as .svg", arguments.output.string())};
  }
  if (Status folder = check_folder(arguments.output); !folder) return folder.error();
  Status written = Done{};
  if (is_domain(arguments.input)) {
    const Result<Pslg> pslg = read_pslg(arguments.input);
    if (!pslg) return pslg.error();
    written = write_svg(*pslg, arguments.output);
  } else {
    const Result<Mesh> mesh = read_mesh(arguments.input);
    if (!mesh) return mesh.error();
    written = write_svg(*mesh, arguments.output);
  }
  if (!written) return written.error();
  return ExitCode::done;
}

}  // namespace

Command add_draw(CLI::App& program) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* app = program.add_subcommand("draw", "Draw a domain or a mesh as SVG");
  app->add_option("IN|MESH", arguments->input, "A domain (.poly, .node) or a mesh (.ele, .msh, .vtu, .off)")
      ->required()
      ->type_name("");
  app->add_option("-o,--output", arguments->output, "The picture (required)")->required()->type_name("FILE.svg");
  app->footer("Example:\n  pardel draw key.1.ele -o key.svg");
  return {app, [arguments] { return run(*arguments); }};
}

}  // namespace pardel::cli
