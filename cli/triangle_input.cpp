#include "triangle_input.hpp"

#include <fmt/core.h>

#include <filesystem>
#include <utility>

#include "../core/formats.hpp"
#include "domain_of_mesh.hpp"
#include "exit_code.hpp"
#include "follow_edges.hpp"

namespace pardel::cli {
namespace fs = std::filesystem;
namespace {

void announce(const TriangleSwitches& switches, const std::string& files) {
  if (!switches.quiet) fmt::print("Opening {}.\n", files);
}

Result<TriangleInput> read_domain_of(const TriangleSwitches& switches) {
  const fs::path file = switches.name + (switches.poly ? ".poly" : ".node");
  announce(switches, file.string());
  Result<Domain> domain = read_domain(file);
  if (!domain) return domain.error();
  // As in Triangle: without A and a, the regions are not even read.
  if (!switches.region_attributes && !switches.area_caps) domain->pslg.regions.clear();
  std::vector<Point> holes = domain->pslg.holes;
  std::vector<Region> regions = domain->pslg.regions;
  if (switches.no_holes) domain->pslg.holes.clear();

  const bool convex_hull = switches.convex_hull || !switches.poly;
  Result<MaybeRepaired, Refusal> valid =
      validated_or_repaired(std::move(*domain), {.snap = 0, .convex_hull = convex_hull}, 1, "the switch c");
  if (!valid) return valid.error().error;
  for (const std::string& line : valid->log) {
    if (!switches.quiet) warn(line);
  }
  if (!switches.quiet) print_warnings(valid->domain, file.string());
  return TriangleInput{.source = std::move(valid->domain),
                       .original = std::move(valid->original),
                       .point_map = std::move(valid->point_map),
                       .node_was_read = !switches.poly || !has_own_points(file),
                       .holes = std::move(holes),
                       .regions = std::move(regions)};
}

/// Sets the constrained edges of the mesh to the segments of the .poly, and returns the .poly's holes. A note says
/// which segments were taken as several edges.
Result<std::vector<Point>> take_segments(const TriangleSwitches& switches, Mesh& mesh) {
  const fs::path poly = switches.name + ".poly", ele = switches.name + ".ele";
  Result<Pslg> pslg = read_pslg(poly);
  if (!pslg) return pslg.error();
  if (pslg->points.size() == mesh.points.size()) {
    mesh.constrained_edges = segments_as_edges(*pslg);
  } else if (has_own_points(poly)) {  // otherwise read_mesh() has read the segments
    return Error{ErrorKind::invalid_input, fmt::format("{}: {} points for a mesh with {} vertices", poly.string(),
                                                       pslg->points.size(), mesh.points.size())};
  }
  const Result<FollowedEdges> followed = follow_edges(mesh, &*pslg);
  if (!followed) return with_name(followed.error(), ele.string());
  if (const std::string note = note_about(*followed); !note.empty() && !switches.quiet)
    warn(fmt::format("{}: {}", ele.string(), note));
  return std::move(pslg->holes);
}

/// The domain is always made of the mesh itself: the holes of a .poly need not be holes of the mesh, because it may
/// have been made with the switch O.
Result<TriangleInput> read_mesh_of(const TriangleSwitches& switches) {
  announce(switches, fmt::format("{0}.node and {0}.ele", switches.name));
  const std::string ele = switches.name + ".ele";
  Result<Mesh> mesh = read_mesh(ele);
  if (!mesh) return mesh.error();
  // Without p only the outline of the mesh is constrained.
  if (!switches.poly) mesh->constrained_edges.clear();
  Result<std::vector<Point>> holes = std::vector<Point>();
  if (switches.poly) holes = take_segments(switches, *mesh);
  if (!holes) return holes.error();
  Result<Pslg> pslg = domain_of(*mesh);
  if (!pslg) return with_name(pslg.error(), ele);
  CoarseMesh coarse{std::move(*mesh), {}, {std::move(*pslg), ele, {}, true}};
  coarse.domain.points = coarse.mesh.numbers;
  adopt_segments(coarse);
  if (switches.area_caps) {
    if (Status read = read_caps(coarse, switches.name + ".area"); !read) return read.error();
  }
  return TriangleInput{.source = std::move(coarse),
                       .original = std::nullopt,
                       .point_map = {},
                       .node_was_read = true,
                       .holes = std::move(*holes),
                       .regions = {}};
}

}  // namespace

Result<TriangleInput> read_triangle_input(const TriangleSwitches& switches) {
  return switches.refine ? read_mesh_of(switches) : read_domain_of(switches);
}

}  // namespace pardel::cli
