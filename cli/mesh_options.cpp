#include "mesh_options.hpp"

#include <CLI/CLI.hpp>
#include <array>
#include <string>
#include <utility>

#include "../core/support/shortest.hpp"
#include "../parallel/mesher.hpp"
#include "choice.hpp"
#include "distinct_files.hpp"
#include "input.hpp"
#include "marker_value.hpp"
#include "memory.hpp"
#include "names.hpp"
#include "progress_option.hpp"
#include "snap_option.hpp"
#include "threads_option.hpp"

namespace pardel::cli {
namespace {

constexpr Index most_cells_along = 4096;

constexpr const char* footer =
    R"(The suffix of OUT sets the format: .node or .ele for Triangle's .node, .ele and .poly; .vtu for ParaView;
.msh for Gmsh; .off; .svg; .vtk; .2dm for SMS and TUFLOW; .gr3 for SCHISM; .14 for ADCIRC; .inp for Abaqus.
An output file appears under its name only when it is complete.
The report of --json numbers vertices and triangles from 0, also where IN numbers from 1.
Exit status: as 'pardel --help' lists. With status 4 (a bound could not be met) the mesh is written all the same.

Examples:
  pardel mesh key.poly -o key.vtu                                   20.7 degrees, no size bound
  pardel mesh key.poly -o mesh.node -o mesh.svg --min-angle 30 --max-area 0.001 --check
  pardel mesh bay.poly -o bay.msh --regions --sizes bay.sizes --json - | jq .mesh
  pardel mesh mesh.node --refine -o finer.node --max-area 0.0001    refines a mesh; mesh.area, if any, gives caps)";

void add_files(CLI::App& app, MeshArguments& arguments) {
  app.add_option("IN", arguments.input,
                 "The domain: .poly, .node or .geojson; with --refine a mesh: .node, .ele, .msh, .vtu, .off,\n.vtk, "
                 ".2dm, .gr3, .14")
      ->required()
      ->type_name("");
  app.add_option("-o,--output", arguments.outputs, "The file to write (required; may be given several times)")
      ->required()
      ->type_name("OUT")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

void add_interior(CLI::App& app, Options& options) {
  app.add_option(
         "--interior", options.interior,
         "What fills the interior where areas and edges have constant bounds: refine; fill: equilateral\n"
         "triangles, the fewest that keep them; auto (default): fill for angles up to 30 degrees, and for larger\n"
         "ones if only areas have bounds (and --placement is auto or search)")
      ->transform(choice(interior_names))
      ->type_name("WHAT");
}

void add_limits(CLI::App& app, MeshArguments& arguments) {
  Options& options = arguments.options;
  app.add_option("--max-vertices", options.max_vertices, "Stop at this many vertices")
      ->type_name("N")
      ->check(positive_number("a number of vertices"))
      ->group("Limits");
  add_min_edge_option(app, options);
  add_keep_option(app, options);
  add_memory_option(app, arguments.max_memory_gib);
  add_threads_option(app, arguments.threads, "the mesh")->group("Limits");
}

void add_steps(CLI::App& app, MeshArguments& arguments) {
  app.add_flag("--refine", arguments.refine, "Refine the mesh IN; its vertices stay");
  add_repair_options(app, arguments.repair, arguments.snap)->excludes("--refine");
  add_check_option(app, arguments.check);
  app.add_flag("--paranoid", arguments.paranoid,
               "Also check the mesh, except for its bounds, after every sweep; stop at the first violation (slow)");
}

void add_forms_of_output(CLI::App& app, MeshArguments& arguments) {
  add_mesh_format_options(app, arguments.format);
  add_drop_option(app, arguments.drop_unused);
  add_report_option(app, arguments.json);
  add_progress_option(app, arguments.progress);
  app.add_flag("-q,--quiet", arguments.quiet, "Print nothing on standard output except the report of --json -");
}

}  // namespace

CLI::Option* add_keep_option(CLI::App& app, Options& options) {
  return app
      .add_option("--keep", options.kept_markers,
                  "Split no segment with one of these markers in the mesh; triangles that miss a bound for this\n"
                  "reason are listed as kept_segment")
      ->delimiter(',')
      ->check(marker_value())
      ->type_name("MARKER,...")
      ->group("Limits");
}

CLI::Option* add_min_edge_option(CLI::App& app, Options& options) {
  return app
      .add_option("--min-edge", options.min_edge,
                  "Insert no point that would make a shorter edge (default: the limit of double precision)")
      ->check(positive_number("a length"))
      ->type_name("LENGTH")
      ->group("Limits");
}

CLI::Option* add_memory_option(CLI::App& app, std::optional<double>& gib) {
  return app
      .add_option("--max-memory", gib,
                  "Stop if the process needs more memory than this, in GiB (default: the memory available)")
      ->check(positive_number("an amount of memory"))
      ->type_name("GIB")
      ->group("Limits");
}

CLI::Option* add_repair_options(CLI::App& app, bool& repair, std::optional<double>& snap) {
  CLI::Option* option = app.add_flag("--repair", repair,
                                     "Repair the domain before meshing: merge points, split segments, close tiny gaps");
  add_snap_option(app, snap, option);
  return option;
}

CLI::Option* add_check_option(CLI::App& app, bool& check) {
  return app.add_flag("--check", check, "Check the mesh with exact arithmetic");
}

CLI::Option* add_report_option(CLI::App& app, std::filesystem::path& json) {
  return app.add_option("--json", json, "Write a report as JSON, also for invalid input; - is standard output")
      ->type_name("FILE|-");
}

std::uint64_t memory_limit(std::optional<double> gib, std::uint64_t otherwise) {
  return gib ? static_cast<std::uint64_t>(*gib * 0x1p30) : otherwise;
}

Status check_interior(Interior interior, const GoalOptions& goal) {
  const auto refuse = [](const std::string& why) { return Error{ErrorKind::usage, "--interior fill " + why}; };
  if (interior != Interior::fill) return Done{};
  for (const auto& [name, given] :
       {std::pair{"--sizes", !goal.sizes.empty()}, std::pair{"--grading", goal.grading.has_value()},
        std::pair{"--feature-size", goal.feature_size.has_value()}})
    if (given) return refuse(std::string("needs bounds that are the same everywhere and cannot be used with ") + name);
  if (!goal.max_area && !goal.max_edge && !goal.regions) return refuse("needs --max-area, --max-edge or --regions");
  return Done{};
}

void add_ways_to_work(CLI::App& app, Options& options, std::vector<Index>& cells) {
  app.add_option("--placement", options.placement,
                 "Where new points are placed: circumcentre; off-centre; search: the best of several points, which\n"
                 "makes fewer triangles for large angles and takes longer; auto (default): off-centre, but search\n"
                 "for angles above 30 degrees if only areas have bounds, and with --refine for 30 degrees and more")
      ->transform(choice(placement_names))
      ->type_name("WHERE");
  app.add_option("--decomposition", options.decomposition,
                 "How the plane is cut into cells: auto (the default), lattice (by work),\nquadtree (by work, for "
                 "graded meshes), "
                 "paper (sides of four circumradii),\npaper-quadtree (leaves with sides of eight circumradii) or none")
      ->transform(choice(decomposition_names))
      ->type_name("HOW");
  app.add_option("--triangles-per-tile", options.triangles_per_tile,
                 "About this number of triangles in a cell of the lattice or a leaf of the quadtree\n"
                 "(default 8000: for the cache); another number gives a slightly different mesh")
      ->check(positive_number("a number of triangles"))
      ->type_name("N");
  app.add_option(
         "--cells", cells,
         "Number of columns and rows of cells (default: by work); another number gives a slightly different mesh")
      ->delimiter(',')
      ->expected(2)
      ->check(CLI::Range(1U, most_cells_along).description(""))
      ->type_name("NX,NY");
}

void add_mesh_options(CLI::App& app, MeshArguments& arguments) {
  add_files(app, arguments);
  add_goal_options(app, arguments.goal, largest_min_angle_deg);
  add_limits(app, arguments);
  add_interior(app, arguments.options);
  add_ways_to_work(app, arguments.options, arguments.cells);
  add_mesher_options(app, arguments.mesher);
  add_steps(app, arguments);
  add_forms_of_output(app, arguments);
  app.footer(footer);
}

Status set_cells(const std::vector<Index>& cells, Options& options) {
  if (cells.empty()) return Done{};
  if (options.decomposition == Decomposition::none || options.decomposition == Decomposition::quadtree ||
      options.decomposition == Decomposition::paper_quadtree)
    return Error{ErrorKind::usage, std::string("--cells cannot be used with --decomposition ") +
                                       decomposition_names[options.decomposition]};
  options.cells = {cells[0], cells[1]};
  return Done{};
}

Status complete_options(MeshArguments& arguments) {
  Options& options = arguments.options;
  for (const auto& [name, given] :
       {std::pair{"--interior fill", options.interior == Interior::fill},
        std::pair{"--grading", arguments.goal.grading.has_value()},
        std::pair{"--feature-size", arguments.goal.feature_size.has_value()},
        std::pair{"--regions", arguments.goal.regions}, std::pair{"--convex-hull", arguments.goal.convex_hull}})
    if (given && arguments.refine)
      return Error{ErrorKind::usage, std::string(name) + " needs a domain and cannot be used with --refine"};
  if (Status fits = check_interior(options.interior, arguments.goal); !fits) return fits;
  if (!arguments.mesher.name.empty() && arguments.refine)
    return Error{ErrorKind::usage, "--mesher cannot be used with --refine"};
  if (Status fits = check_use(arguments.mesher, options, !arguments.cells.empty()); !fits) return fits;
  use_threads(arguments.threads);
  options.threads = arguments.threads;
  options.max_memory = memory_limit(arguments.max_memory_gib, available_memory());
  return set_cells(arguments.cells, options);
}

std::vector<std::filesystem::path> all_outputs(const MeshArguments& arguments) {
  std::vector<std::filesystem::path> outputs = arguments.outputs;
  outputs.push_back(arguments.json);
  return outputs;
}

Status check_outputs(const MeshArguments& arguments) {
  const std::array inputs = {NamedFile{{}, arguments.input}, NamedFile{{}, arguments.goal.sizes, false},
                             NamedFile{{}, arguments.goal.sources, false}};
  std::vector<NamedFile> outputs;
  for (const auto& output : arguments.outputs) outputs.push_back({"-o", output});
  outputs.push_back({"--json", arguments.json});
  if (Status fine = check_standard_input(std::array{arguments.input, arguments.goal.sizes, arguments.goal.sources});
      !fine)
    return fine;
  if (Status fine = check_format_options(arguments.outputs, arguments.format); !fine) return fine;
  if (Status fine = check_standard_output(all_outputs(arguments)); !fine) return fine;
  if (Status fine = check_mesh_outputs(arguments.outputs); !fine) return fine;
  if (Status fine = check_distinct(outputs, inputs); !fine) return fine;
  return check_folder(arguments.json);
}

}  // namespace pardel::cli
