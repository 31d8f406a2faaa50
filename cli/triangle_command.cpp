// pardel triangle: reads Triangle's switches and files, and writes the files that Triangle writes.
#include <fmt/core.h>

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "../core/formats.hpp"
#include "../parallel/mesher.hpp"
#include "../properties/checker/check.hpp"
#include "../properties/checker/statistics.hpp"
#include "command.hpp"
#include "exempt_triangles.hpp"
#include "input.hpp"
#include "large_angle.hpp"
#include "points_outside.hpp"
#include "renumber.hpp"
#include "report.hpp"
#include "triangle_files.hpp"
#include "triangle_input.hpp"
#include "triangle_switches.hpp"
#include "verdict.hpp"
#include "with_progress.hpp"

namespace pardel::cli {
namespace {

constexpr const char* help = R"(pardel triangle [-switches] FILE

Takes Triangle's switches and file names, so scripts written for Triangle run unchanged. Switches and their numbers are
written without spaces: pardel triangle -pq30a0.1 key. The suffix of FILE may be omitted.
Without p, r, q or a: the Delaunay triangulation of FILE.node.

  p   reads FILE.poly              r   refines the mesh FILE.node, FILE.ele (with a: FILE.area; with p: FILE.poly)
  q   smallest angle in degrees (default 20). Above 33 degrees the refinement may not end: if it needs too many
      vertices, the mesh for 33 degrees is written and the exit status is 4
  a   largest area; without a number: area caps per region, or FILE.area with r; may be given in both forms
  D   conforming Delaunay          c   triangulates the convex hull
  A   triangles carry the attribute of their region
  Y   splits no segment of the boundary; YY: splits no segment at all
  S   limit on new points          O   ignores holes
  j   removes vertices that are in no triangle
  e   writes .edge                 n   writes .neigh            g   writes .off
  B   no boundary markers          P   no .poly                 N   no .node          E   no .ele
  I   no iteration number in names (files that were read are not replaced)
  o2  triangles with six nodes     z   accepted, without effect: output is numbered like the input
  C   checks the result with this program's exact checker
  Q   prints errors only           V   prints more              h   this text
  i F l s X   accepted, without effect: they choose among Triangle's own algorithms; predicates are always exact
  u v w W     refused: user test, Voronoi diagram, weighted points

Where -a sets a bound and q is at most 33, interiors are filled with equilateral triangles: meshes have about a third
fewer triangles than Triangle's ('pardel mesh --interior refine' makes meshes by refinement alone).
Writes FILE.1.node and so on, or FILE.2.* from FILE.1.*. Input vertices come first, in their order. Like Triangle, it
repairs duplicate points and segments that cross, overlap or contain points; each repair is a line on standard error.
docs/formats.md lists the differences from Triangle.
Exit status as for every subcommand (pardel --help). A bound that is missed only because of S or Y is not a failure.
)";

void say(const TriangleSwitches& switches, const std::string& line) {
  if (!switches.quiet) fmt::print("{}\n", line);
}

Goal goal_of(const TriangleSwitches& switches) {
  Goal goal;
  goal.min_angle_deg = switches.min_angle_deg;
  if (switches.max_area) goal.max_area = *switches.max_area;
  goal.region_caps = switches.area_caps && switches.poly && !switches.refine;
  goal.conforming = switches.conforming;
  goal.convex_hull = switches.convex_hull;
  return goal;
}

Options options_of(const TriangleSwitches& switches, const TriangleInput& input) {
  Options options{.placement = Placement::automatic, .interior = Interior::automatic};
  options.no_boundary_splits = switches.no_splits == 1;
  options.no_segment_splits = switches.no_splits > 1;
  if (switches.max_steiner_points) {
    options.max_vertices = input.pslg().points.size() + *switches.max_steiner_points;
  }
  return options;
}

Result<Meshed> run_mesher(const TriangleSwitches& switches, const TriangleInput& input, const Goal& goal,
                          const Options& options) {
  if (const auto* coarse = std::get_if<CoarseMesh>(&input.source)) {
    Result<Meshed> meshed = refine(coarse->mesh, coarse->max_areas, goal, options);
    if (!meshed) return with_name(meshed.error(), coarse->domain.name);
    return meshed;
  }
  const ValidPslg& domain = std::get<ValidPslg>(input.source);
  return switches.quality ? mesh(domain, goal, options) : triangulate(domain, options);
}

Result<MeshedForAngle> make_mesh(const TriangleSwitches& switches, const TriangleInput& input) {
  const ShowProgress show = switches.quiet ? ShowProgress::never : ShowProgress::automatic;
  ProgressBar bar(show);
  return mesh_for_angle(goal_of(switches), options_of(switches, input), [&](const Goal& goal, const Options& how) {
    return run_mesher(switches, input, goal, with_progress(how, bar));
  });
}

Certificate certificate_of(const TriangleSwitches& switches, const TriangleInput& input, const Goal& goal, Mesh& mesh) {
  // The attributes of a mesh that is refined need not belong to faces. The checker skips attributes that it is not
  // given.
  Array<Index> unchecked;
  if (switches.refine && input.pslg().regions.empty()) unchecked.swap(mesh.region);
  Certificate certificate = check(input.pslg(), mesh, goal, {.foreign = switches.refine});
  if (!unchecked.empty()) unchecked.swap(mesh.region);
  return certificate;
}

/// Numbers the vertices as they are written: as in the input as read, and with j without those in no triangle. Returns
/// the new number of each vertex, where those that are left out have none; nothing if the numbers stay the same.
std::vector<std::uint64_t> number_as_written(const TriangleSwitches& switches, const TriangleInput& input, Mesh& mesh) {
  const bool restored = input.original.has_value();
  if (!restored && !switches.jettison) return {};
  std::vector<Index> numbers(mesh.points.size());
  std::iota(numbers.begin(), numbers.end(), Index{0});
  if (restored) numbers = restore_numbering(mesh, *input.original, input.point_map);
  if (switches.jettison) {
    const std::vector<Index> kept = remove_unused_vertices(mesh);
    for (Index& number : numbers) number = kept[number];
  }
  std::vector<std::uint64_t> in_files;
  in_files.reserve(numbers.size());
  for (const Index number : numbers)
    in_files.push_back(std::uint64_t{number} + static_cast<unsigned>(input.pslg().first_id.value));
  return in_files;
}

/// Prints the violations. Returns true if there are none, or if they are only bounds that the report lists as missed.
/// `vertices`: as NumbersInWitnesses.
bool is_right(const TriangleSwitches& switches, const TriangleInput& input, const Meshed& meshed,
              const Certificate& certificate, std::span<const std::uint64_t> vertices) {
  if (certificate.valid) {
    say(switches, "Checked: the mesh is right.");
    return true;
  }
  const bool only_reported = !meshed.report.goal_met() && only_bounds_missed(certificate);
  if (!only_reported || !switches.quiet) {
    const int first = input.pslg().first_id.value;
    warn(violations_text(certificate, most_listed, {first, first, first, vertices}));
  }
  return only_reported;
}

/// True if the goal is missed only because of limits that the switches set.
bool missed_by_request(const TriangleSwitches& switches, const Report& report) {
  return report.count(ExemptReason::precision) == 0 && report.count(ExemptReason::min_edge) == 0 &&
         (report.count(ExemptReason::budget) == 0 || switches.max_steiner_points) &&
         (report.count(ExemptReason::kept_segment) == 0 || switches.no_splits > 0);
}

/// Sets the attributes that Triangle writes. With A every triangle has one, 0 outside all regions. Without A there are
/// none, except those of a mesh that is refined.
void set_regions(const TriangleSwitches& switches, Mesh& mesh) {
  if (switches.refine) return;
  if (!switches.region_attributes || !switches.poly) {
    mesh.region.clear();
    mesh.region_attributes.clear();
  } else if (mesh.region.empty()) {
    mesh.region.resize(mesh.triangles.size(), no_index);
  }
}

Status write(const TriangleSwitches& switches, const TriangleInput& input, const Mesh& mesh) {
  const std::string stem = next_name(switches.name, switches.no_iteration);
  const TriangleFiles files = files_to_write(switches, input.pslg().first_id.value, input.node_was_read);
  const std::pair<bool, const char*> written[] = {{files.write_node, ".node"},   {files.write_ele, ".ele"},
                                                  {files.write_poly, ".poly"},   {files.write_edge, ".edge"},
                                                  {files.write_neigh, ".neigh"}, {switches.off, ".off"}};
  for (const auto& [wanted, suffix] : written) {
    if (wanted) say(switches, fmt::format("Writing {}{}.", stem, suffix));
  }
  Pslg seeds;
  seeds.holes = input.holes;
  seeds.regions = input.regions;
  if (Status done = write_triangle_files(mesh, seeds, stem, files); !done) return done;
  return switches.off ? write_off(mesh, stem + ".off") : Status(Done{});
}

/// The lines that Triangle prints, too.
std::string counts(const Mesh& mesh) {
  std::size_t outer = 0;
  for (const Triangle& triangle : mesh.triangles) outer += std::count(triangle.n.begin(), triangle.n.end(), no_index);
  return fmt::format(
      "Mesh vertices: {}\nMesh triangles: {}\nMesh edges: {}\nMesh exterior boundary edges: {}\n"
      "Mesh interior boundary edges: {}\nMesh subsegments (constrained edges): {}",
      mesh.points.size(), mesh.triangles.size(), (3 * mesh.triangles.size() + outer) / 2, outer,
      mesh.constrained_edges.size() - outer, mesh.constrained_edges.size());
}

void print_statistics(const TriangleSwitches& switches, const Meshed& meshed) {
  if (switches.quiet) return;
  const MeshStatistics mesh = statistics(meshed.mesh);
  say(switches, counts(meshed.mesh));
  say(switches, fmt::format("Smallest angle: {:.4g}\nLargest angle: {:.4g}", mesh.min_angle_deg, mesh.max_angle_deg));
  if (switches.verbose == 0) return;
  const Report& report = meshed.report;
  say(switches, fmt::format("Total area: {:.9g}\nInserted inside: {}\nInserted on segments: {}\nRefused: {}", mesh.area,
                            report.inserted, report.segment_splits, report.refused));
  for (int i = 0; i < exempt_reasons; ++i) {
    const auto reason = static_cast<ExemptReason>(i);
    say(switches, fmt::format("Exempt ({}): {}", name(reason), report.count(reason)));
  }
  say(switches, fmt::format("Seconds: triangulation {:.3f}, refinement {:.3f}", report.triangulate_seconds,
                            report.refine_seconds));
}

/// The exit code if the mesh is right. Prints the bounds that are missed; with the switch Q only if that is a failure.
ExitCode verdict(const TriangleSwitches& switches, const MeshedForAngle& made) {
  const Report& report = made.meshed.report;
  if (made.limit) {
    warn(
        fmt::format("{}: the smallest angle of {} degrees would need more than {} vertices; the mesh was made for {} "
                    "degrees",
                    switches.name, switches.min_angle_deg, *made.limit, made.goal.min_angle_deg));
  }
  const bool failed = !report.goal_met() && !missed_by_request(switches, report);
  if (!report.goal_met() && (failed || !switches.quiet))
    warn(switches.name + ": " + missed_bounds(exempt_triangles(report, made.meshed.mesh), "the switch S"));
  return failed || made.limit ? ExitCode::goal_missed : ExitCode::done;
}

Result<ExitCode> run(const TriangleSwitches& switches) {
  if (switches.verbose > 0) {
    for (const char letter : switches.without_effect)
      say(switches, fmt::format("Switch {} has no effect here.", letter));
  }
  if (Status in_range = check_goal(goal_of(switches), {.max_vertices = 1}); !in_range) return in_range.error();
  const Result<TriangleInput> input = read_triangle_input(switches);
  if (!input) return input.error();
  Result<MeshedForAngle> made = make_mesh(switches, *input);
  if (!made) return made.error();
  Mesh& mesh = made->meshed.mesh;
  std::optional<Certificate> certificate;
  if (switches.check) certificate = certificate_of(switches, *input, made->goal, mesh);
  if (const PointsOutside outside = points_outside(mesh); outside.count > 0 && !switches.quiet)
    warn(fmt::format("{}: {}", switches.name,
                     note_about(outside, !switches.refine,
                                switches.jettison ? "the mesh is written without them"
                                                  : "the switch j writes the mesh without them")));
  const std::vector<std::uint64_t> vertices = number_as_written(switches, *input, mesh);
  const bool right = !certificate || is_right(switches, *input, made->meshed, *certificate, vertices);
  set_regions(switches, mesh);
  if (Status written = write(switches, *input, mesh); !written) return written.error();
  print_statistics(switches, made->meshed);
  const ExitCode code = verdict(switches, *made);
  return right ? code : ExitCode::violations;
}

}  // namespace

Result<ExitCode> run_triangle(const std::vector<std::string>& arguments) {
  const Result<TriangleSwitches> switches = parse_triangle_switches(arguments);
  if (!switches) return switches.error();
  if (switches.value().help) {
    fmt::print("{}", help);
    return ExitCode::done;
  }
  return run(*switches);
}

}  // namespace pardel::cli
