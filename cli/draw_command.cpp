// pardel draw: draws a domain or a mesh as SVG or PNG.
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "../core/formats.hpp"
#include "choice.hpp"
#include "command.hpp"
#include "distinct_files.hpp"
#include "domain_or_mesh.hpp"
#include "drawing/canvas.hpp"
#include "drawing/colouring.hpp"
#include "drawing/draw_domain.hpp"
#include "drawing/draw_legend.hpp"
#include "drawing/draw_mesh.hpp"
#include "drawing/names.hpp"
#include "drawing/valid_utf8.hpp"
#include "output.hpp"
#include "plural.hpp"
#include "suffix.hpp"

namespace pardel::cli {
namespace fs = std::filesystem;
namespace {

/// Cairo's images have at most 32,767 rows and columns, margins and legend included.
constexpr int most_pixels = 20'000;

struct DrawArguments {
  fs::path input;
  fs::path output;
  std::optional<ColourBy> by;
  fs::path report;                         ///< the report that `by` needs
  std::optional<PictureFormat> of_stream;  ///< the format of the output -
  std::vector<double> window;
  std::optional<int> pixels;
  bool no_legend = false;
};

Error usage(const std::string& message) { return {ErrorKind::usage, message}; }

/// The format that --format sets for the output -, and the suffix for a file; empty if neither does.
std::optional<PictureFormat> format_of(const DrawArguments& arguments) {
  if (arguments.output == "-") return arguments.of_stream;
  const fs::path suffix = arguments.output.extension();
  if (suffix == ".png") return PictureFormat::png;
  if (suffix == ".svg") return PictureFormat::svg;
  return {};
}

Status check_files(const DrawArguments& arguments) {
  const bool to_stream = arguments.output == "-";
  if (to_stream && !arguments.of_stream) return usage("-: standard output has no suffix; set --format png or svg");
  if (!to_stream && arguments.of_stream)
    return usage("--format is for the output -; a suffix sets the format of a file");
  if (!format_of(arguments)) return unknown_format(arguments.output, "a picture", ".svg and .png");
  const std::array inputs = {NamedFile{{}, arguments.input}, NamedFile{{}, arguments.report}};
  return check_distinct(std::array{NamedFile{"OUT", arguments.output}}, inputs);
}

Status check_arguments(const DrawArguments& arguments) {
  if (Status fine = check_files(arguments); !fine) return fine;
  const bool of_work = arguments.by && *arguments.by >= ColourBy::tile;
  if (of_work && arguments.report.empty())
    return usage(fmt::format("--by {} needs --report FILE.json", colour_names[*arguments.by]));
  if (!of_work && !arguments.report.empty()) return usage("--report needs --by tile, --by phase or --by thread");
  const std::vector<double>& w = arguments.window;
  if (!w.empty() && !(w[0] < w[2] && w[1] < w[3]))
    return usage("--window needs X0,Y0,X1,Y1 with X0 below X1 and Y0 below Y1");
  // The picture is scaled by pixels per unit of length.
  constexpr double least = 1e-300, most = 1e300;
  const double side = w.empty() ? 1 : std::max(w[2] - w[0], w[3] - w[1]);
  if (side < least || side > most)
    return usage(fmt::format("--window: its larger side has to be between {} and {}", least, most));
  return check_folder(arguments.output);
}

Canvas canvas_for(const DrawArguments& arguments, const CairoLibrary& cairo, std::span<const Point> points) {
  const std::vector<double>& w = arguments.window;
  const Window window = w.empty() ? window_around(points) : Window{{w[0], w[1]}, {w[2], w[3]}};
  const PictureFormat format = format_of(arguments).value_or(PictureFormat::svg);
  const double pixels = arguments.pixels.value_or(format == PictureFormat::png ? 1600 : 1000);
  return {cairo,
          arguments.output,
          window,
          {.format = format, .pixels = pixels, .legend = !arguments.no_legend, .cut = !w.empty()}};
}

std::string headline(const DrawArguments& arguments) { return valid_utf8(arguments.input.filename().string()); }

Status draw(const DrawArguments& arguments, const CairoLibrary& cairo, const Mesh& mesh, ProgressBar& bar) {
  const Result<Colouring> coloured = colouring(mesh, arguments.by.value_or(ColourBy::region), arguments.report);
  if (!coloured) return coloured.error();
  bar.begin("drawing " + arguments.output.string());
  Canvas canvas = canvas_for(arguments, cairo, mesh.points.span());
  draw_mesh(canvas, mesh, *coloured);
  const std::vector<std::string> text = {headline(arguments), plural(mesh.points.size(), "vertex", "vertices"),
                                         plural(mesh.triangles.size(), "triangle")};
  if (!arguments.no_legend) draw_legend(canvas, text, coloured.value().legend);
  return canvas.finish();
}

Status draw(const DrawArguments& arguments, const CairoLibrary& cairo, const Pslg& domain, ProgressBar& bar) {
  if (arguments.by) return usage(fmt::format("{}: --by needs a mesh, and this is a domain", arguments.input.string()));
  bar.begin("drawing " + arguments.output.string());
  Canvas canvas = canvas_for(arguments, cairo, domain.points);
  draw_domain(canvas, domain);
  if (!arguments.no_legend) draw_legend(canvas, headline(arguments), domain);
  return canvas.finish();
}

Result<ExitCode> run(const DrawArguments& arguments) {
  if (Status fine = check_arguments(arguments); !fine) return fine.error();
  const Result<CairoLibrary> cairo = load_cairo();
  if (!cairo) return cairo.error();
  ProgressBar bar(ShowProgress::automatic);
  return with_domain_or_mesh(arguments.input, bar,
                             [&](const auto& input) { return draw(arguments, *cairo, input, bar); });
}

}  // namespace

Run draw_command(CLI::App& app) {
  const auto arguments = std::make_shared<DrawArguments>();
  app.add_option("IN|MESH", arguments->input,
                 "A domain (.poly, .node, .geojson) or a mesh (.node, .ele, .msh, .vtu, .pvtu, .off, .vtk,\n"
                 ".2dm, .gr3, .14); - is standard input")
      ->required()
      ->type_name("");
  app.add_option("OUT,-o,--output", arguments->output, "The picture to write: .svg or .png; - is standard output")
      ->required()
      ->type_name("OUT");
  app.add_option("--format", arguments->of_stream, "Format of the output - (standard output): png or svg")
      ->transform(choice(picture_format_names))
      ->type_name("FORMAT");
  app.add_option("--by", arguments->by,
                 "Colour triangles by quality (smallest angle), size (longest edge), region (the default), or by the "
                 "tile,\nphase or thread that made them; a tile is a cell of the lattice or a leaf of the quadtree")
      ->transform(choice(colour_names))
      ->type_name("WHAT");
  app.add_option("--report", arguments->report,
                 "The report that pardel mesh --json wrote with the mesh, for tile, phase and thread")
      ->type_name("FILE.json");
  app.add_option("--window", arguments->window, "Draw only this rectangle of the plane")
      ->delimiter(',')
      ->expected(4)
      ->type_name("X0,Y0,X1,Y1");
  app.add_option("--pixels", arguments->pixels,
                 "The longer side of the drawing (default: 1600 for .png, 1000 for .svg); lines and letters scale")
      ->check(CLI::Range(50, most_pixels).description(""))
      ->type_name("N");
  app.add_flag("--no-legend", arguments->no_legend, "Draw no legend");
  app.footer(R"(Examples:
  pardel draw key.1.ele key.svg
  pardel draw mesh.vtu mesh.png --by quality --window 0,0,1,0.5
  pardel mesh pipe.poly -o mesh.ele --max-area 1e-5 --threads 2 --json report.json
  pardel draw mesh.ele mesh.svg --by thread --report report.json)");
  return [arguments] { return run(*arguments); };
}

}  // namespace pardel::cli
