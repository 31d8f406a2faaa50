// pardel triangle: reads Triangle's switches and files, and writes the files that Triangle writes.
#include <fmt/core.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "../core/formats.hpp"
#include "../parallel/mesher.hpp"
#include "../properties/checker/check.hpp"
#include "../properties/checker/statistics.hpp"
#include "command.hpp"
#include "domain_of_mesh.hpp"
#include "goal_options.hpp"
#include "input.hpp"
#include "renumber.hpp"
#include "report.hpp"
#include "supervise.hpp"
#include "triangle_files.hpp"
#include "triangle_switches.hpp"
#include "verdict.hpp"

namespace pardel::cli {
namespace fs = std::filesystem;
namespace {

constexpr const char* help = R"(pardel triangle [-switches] FILE

Takes Triangle's switches and file names, so scripts written for Triangle run unchanged. Switches and their numbers are
written without spaces: pardel triangle -pq30a0.1 key. The suffix of FILE may be omitted.
Without p, r, q or a: the Delaunay triangulation of FILE.node.

  p   reads FILE.poly              r   refines the mesh FILE.node, FILE.ele (with a: FILE.area; with p: FILE.poly)
  q   smallest angle in degrees (default 20, at most 33)
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
  Q   quiet                        V   prints more              h   this text
  i F l s X   accepted, without effect: they choose among Triangle's own algorithms; predicates are always exact
  u v w W     refused: user test, Voronoi diagram, weighted points

Writes FILE.1.node and so on, or FILE.2.* from FILE.1.*. Input vertices come first, in their order. Like Triangle, it
repairs duplicate points and segments that cross, overlap or contain points; each repair is a line on standard error.
Exit status as for every subcommand (pardel --help). A bound that is missed only because of S or Y is not a failure.
)";

/// The input: a valid domain, or with r a mesh.
struct Input {
  Source source;
  std::optional<Pslg> original;  ///< the domain as read, if it had to be repaired
  std::vector<Index> point_map;  ///< if repaired: maps points of the original to points of the domain
  bool node_was_read = true;

  [[nodiscard]] const Pslg& pslg() const { return pslg_of(source); }
};

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

/// Triangle accepts coinciding points and crossing segments. Therefore this function repairs an invalid domain.
Result<Input> read_points(const TriangleSwitches& switches) {
  const fs::path file = switches.name + (switches.poly ? ".poly" : ".node");
  say(switches, fmt::format("Opening {}.", file.string()));
  Result<Domain> domain = read_domain(file);
  if (!domain) return domain.error();
  if (switches.no_holes) domain->pslg.holes.clear();
  if (switches.quality) {
    if (Status in_range = check_goal(goal_of(switches)); !in_range) return in_range.error();
  }
  const bool convex_hull = switches.convex_hull || !switches.poly;
  Result<MaybeRepaired> valid = validated_or_repaired(std::move(*domain), {.convex_hull = convex_hull});
  if (!valid) return valid.error();
  return Input{std::move(valid->domain), std::move(valid->original), std::move(valid->point_map),
               !switches.poly || !has_own_points(file)};
}

Result<Input> read_mesh_to_refine(const TriangleSwitches& switches) {
  say(switches, fmt::format("Opening {0}.node and {0}.ele.", switches.name));
  Result<Mesh> mesh = read_mesh(switches.name + ".ele");
  if (!mesh) return mesh.error();
  // Without the switch p only the outline of the mesh is constrained; the .poly or .edge file is ignored.
  if (!switches.poly) mesh->constrained_edges.clear();
  Result<Pslg> pslg = switches.poly ? read_pslg(switches.name + ".poly") : domain_of(*mesh);
  if (!pslg) return pslg.error();
  pslg->first_id = mesh->first_id;
  CoarseMesh coarse{std::move(*mesh), {}, {std::move(*pslg), switches.name + ".ele"}};
  adopt_segments(coarse);
  if (switches.area_caps) {
    if (Status read = read_caps(coarse, switches.name + ".area"); !read) return read.error();
  }
  return Input{std::move(coarse), std::nullopt, {}, true};
}

Options options_of(const TriangleSwitches& switches, const Input& input) {
  Options options;
  options.no_boundary_splits = switches.no_splits == 1;
  options.no_segment_splits = switches.no_splits > 1;
  if (switches.max_steiner_points) {
    options.max_vertices = input.pslg().points.size() + *switches.max_steiner_points;
  }
  return options;
}

Result<Meshed> make_mesh(const TriangleSwitches& switches, const Input& input, const Interrupt& interrupt) {
  const Goal goal = goal_of(switches);
  const ShowProgress show = switches.quiet ? ShowProgress::never : ShowProgress::automatic;
  return supervise(interrupt, show, options_of(switches, input), [&](const Options& options) -> Result<Meshed> {
    if (const auto* coarse = std::get_if<CoarseMesh>(&input.source)) {
      Result<Meshed> meshed = refine(coarse->mesh, coarse->max_areas, goal, options);
      if (!meshed) return with_name(meshed.error(), coarse->domain.name);
      return meshed;
    }
    const ValidPslg& domain = std::get<ValidPslg>(input.source);
    return switches.quality ? mesh(domain, goal, options) : triangulate(domain, options);
  });
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

Status write(const TriangleSwitches& switches, const Input& input, const Mesh& mesh) {
  const std::string stem = next_name(switches.name, switches.no_iteration);
  const TriangleFiles files = files_to_write(switches, input.pslg().first_id.value, input.node_was_read);
  const std::pair<bool, const char*> written[] = {{files.write_node, ".node"},   {files.write_ele, ".ele"},
                                                  {files.write_poly, ".poly"},   {files.write_edge, ".edge"},
                                                  {files.write_neigh, ".neigh"}, {switches.off, ".off"}};
  for (const auto& [wanted, suffix] : written) {
    if (wanted) say(switches, fmt::format("Writing {}{}.", stem, suffix));
  }
  if (Status done = write_triangle_files(mesh, input.pslg(), stem, files); !done) return done;
  return switches.off ? write_off(mesh, stem + ".off") : Status(Done{});
}

void print_statistics(const TriangleSwitches& switches, const Meshed& meshed) {
  const MeshStatistics mesh = statistics(meshed.mesh);
  say(switches, fmt::format("Mesh vertices: {}\nMesh triangles: {}\nSmallest angle: {:.4g}\nLargest angle: {:.4g}",
                            mesh.vertices, mesh.triangles, mesh.min_angle_deg, mesh.max_angle_deg));
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

Result<ExitCode> run(const TriangleSwitches& switches) {
  if (switches.verbose > 0) {
    for (const char letter : switches.without_effect)
      say(switches, fmt::format("Switch {} has no effect here.", letter));
  }
  const Interrupt interrupt;
  Result<Input> input = switches.refine ? read_mesh_to_refine(switches) : read_points(switches);
  if (!input) return input.error();
  Result<Meshed> meshed = make_mesh(switches, *input, interrupt);
  if (!meshed) return meshed.error();

  bool right = true;
  if (switches.check) {
    const Certificate certificate = check(input->pslg(), meshed->mesh, goal_of(switches), {.foreign = switches.refine});
    right = certificate.valid || (!meshed->report.goal_met() && only_bounds_missed(certificate));
    if (!certificate.valid) warn(violations_text(certificate, most_listed));
    if (certificate.valid) say(switches, "Checked: the mesh is right.");
  }

  Mesh& mesh = meshed->mesh;
  if (input->original) restore_numbering(mesh, *input->original, input->point_map);
  if (switches.jettison) remove_unused_vertices(mesh);
  set_regions(switches, mesh);
  if (interrupt.requested()) return interrupted();
  if (Status written = write(switches, *input, mesh); !written) return written.error();
  print_statistics(switches, *meshed);
  if (!meshed->report.goal_met()) warn(missed_bounds(meshed->report, mesh, most_listed));
  if (!right) return ExitCode::violations;
  return meshed->report.goal_met() || missed_by_request(switches, meshed->report) ? ExitCode::done
                                                                                  : ExitCode::goal_missed;
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
