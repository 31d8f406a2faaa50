// pardel convert: writes a mesh or a domain in another format, without changing it.
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "../core/formats.hpp"
#include "../core/support/open_file.hpp"
#include "beside_mesh.hpp"
#include "command.hpp"
#include "distinct_files.hpp"
#include "domain_or_mesh.hpp"
#include "input.hpp"
#include "mesh_format_options.hpp"
#include "output.hpp"
#include "plural.hpp"
#include "renumber.hpp"
#include "suffix.hpp"

namespace pardel::cli {
namespace fs = std::filesystem;
namespace {

struct ConvertArguments {
  fs::path input;
  fs::path output;
  MeshFormatOptions format;
  bool drop_unused = false;
  bool quiet = false;
};

Error wrong_output(const ConvertArguments& arguments, const std::string& why) {
  return {ErrorKind::usage, fmt::format("{}: {}", arguments.output.string(), why)};
}

Status check_output_of(const ConvertArguments& arguments, const Pslg& /*domain*/) {
  const std::string in = arguments.input.string(), out = arguments.output.string();
  if (mesh_format(arguments.output))
    return wrong_output(arguments, fmt::format("{0} is a domain, which has no triangles; 'pardel mesh {0} -o {1}' "
                                               "makes a mesh",
                                               in, out));
  if (arguments.format.of_stream) return wrong_output(arguments, "--format is for meshes; " + in + " is a domain");
  if (arguments.drop_unused) return wrong_output(arguments, "--drop-unused is for meshes; " + in + " is a domain");
  const std::array outputs = {NamedFile{"OUT", arguments.output, false}};
  if (Status fine = check_distinct(outputs, std::array{domain_input(arguments.input)}); !fine) return fine;
  return check_poly_output(arguments.output);
}

Status check_output_of(const ConvertArguments& arguments, const Mesh& /*mesh*/) {
  const std::array outputs = {arguments.output};
  if (Status fine = check_format_options(outputs, arguments.format); !fine) return fine;
  if (arguments.output.extension() == ".poly")
    return wrong_output(arguments, fmt::format("{} is a mesh; the output .node writes .node, .ele and .poly",
                                               arguments.input.string()));
  if (Status fine = check_mesh_outputs(outputs); !fine) return fine;
  return check_distinct(std::array{NamedFile{"OUT", arguments.output}}, std::array{NamedFile{{}, arguments.input}});
}

void print(const ConvertArguments& arguments, ProgressBar& bar, const std::string& content) {
  bar.finish();
  if (arguments.quiet || is_standard_output(arguments.output)) return;
  fmt::print("{}: {}\n", arguments.input.string(), content);
  fmt::print("wrote   {}\n", arguments.output.string());
}

Status convert(const ConvertArguments& arguments, const Pslg& domain, ProgressBar& bar) {
  if (Status written = write_poly(domain, arguments.output, domain.first_id.value); !written) return written;
  print(arguments, bar, plural(domain.points.size(), "point") + ", " + plural(domain.segments.size(), "segment"));
  return Done{};
}

/// Writes `mesh`, which is the mesh `as_read` or has fewer vertices.
/// Returns why the .poly has neither holes nor regions: the boundary of the mesh is no domain, as where nodes are
/// doubled. Nothing if it has them, or if there is no .poly.
Result<std::string> write(const ConvertArguments& arguments, const Mesh& as_read, const Mesh& mesh) {
  const auto done = [](Status written, std::string why) -> Result<std::string> {
    if (!written) return written.error();
    return why;
  };
  if (mesh_format(arguments.output) != MeshFormat::triangle)
    return done(write_mesh(mesh, {}, arguments.output, arguments.format.for_file(arguments.output)), {});
  // The .poly contains the holes and the regions, too.
  const Result<Pslg> domain = domain_with(arguments.input, as_read);
  if (!domain && domain.error().kind != ErrorKind::invalid_input) return domain.error();
  const fs::path stem = fs::path(arguments.output).replace_extension();
  return done(write_triangle_files(mesh, domain ? *domain : Pslg{}, stem,
                                   {.base = mesh.first_id.value, .second_order = arguments.format.order == 2}),
              domain ? "" : domain.error().message);
}

Status convert(const ConvertArguments& arguments, const Mesh& as_read, ProgressBar& bar) {
  Mesh used_only;
  if (arguments.drop_unused) {
    used_only = as_read;
    remove_unused_vertices(used_only);
  }
  const Mesh& mesh = arguments.drop_unused ? used_only : as_read;
  const Result<std::string> no_domain = write(arguments, as_read, mesh);
  if (!no_domain) return no_domain.error();
  print(arguments, bar,
        plural(mesh.points.size(), "vertex", "vertices") + ", " + plural(mesh.triangles.size(), "triangle"));
  note_beside_mesh(mesh, arguments.input);
  const MeshFormat format = format_of_output(arguments.output, arguments.format.of_stream);
  note_losses(losses(mesh, format, PointMarkers::file), arguments.output, arguments.format.of_stream);
  if (!no_domain->empty() && !arguments.quiet) {
    fmt::print("note    the .poly has no holes and regions, because the boundary of the mesh is no domain:\n{}\n",
               *no_domain);
  }
  return Done{};
}

Result<ExitCode> run(const ConvertArguments& arguments) {
  const std::string in = arguments.input.string(), out = arguments.output.string();
  if (arguments.output.extension() == ".svg" || arguments.output.extension() == ".png")
    return wrong_output(arguments, fmt::format("'pardel draw {} {}' draws pictures", in, out));
  ProgressBar bar(ShowProgress::automatic);
  return with_domain_or_mesh(arguments.input, bar, [&](const auto& input) -> Status {
    if (Status fine = check_output_of(arguments, input); !fine) return fine;
    bar.begin("writing " + out);
    return convert(arguments, input, bar);
  });
}

}  // namespace

Run convert_command(CLI::App& app) {
  const auto arguments = std::make_shared<ConvertArguments>();
  app.add_option("IN", arguments->input,
                 "A mesh (.node, .ele, .msh, .vtu, .pvtu, .off, .vtk, .2dm, .gr3, .14)\nor a domain (.poly, .node, "
                 ".geojson); - "
                 "is standard input")
      ->required()
      ->type_name("");
  app.add_option("OUT", arguments->output,
                 "The file to write: .node, .ele, .msh, .vtu, .off, .vtk, .2dm, .gr3, .14 or .inp;\nfor a domain .poly")
      ->required()
      ->type_name("");
  add_mesh_format_options(app, arguments->format);
  add_drop_option(app, arguments->drop_unused);
  app.add_flag("-q,--quiet", arguments->quiet, "Print nothing on standard output");
  app.footer(
      R"(The numbering of the vertices (without --drop-unused), coordinates, regions, markers and constrained edges stay the same, and
so do fields (values at points and in triangles) and names of regions and markers. A note on standard error names
what the format of OUT cannot store. --open-boundary needs the markers that IN has.

Examples:
  pardel convert key.msh key.vtu
  pardel convert mesh.ele mesh.msh
  pardel convert key.msh hgrid.gr3 --open-boundary 2,3)");
  return [arguments] { return run(*arguments); };
}

}  // namespace pardel::cli
