#include "triangle_input.hpp"

#include <fmt/core.h>

#include <filesystem>
#include <utility>

#include "../core/formats.hpp"
#include "domain_of_mesh.hpp"
#include "exit_code.hpp"

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

/// Sets the constrained edges of the mesh to the segments of the .poly, and returns the .poly's holes.
Result<std::vector<Point>> take_segments(const fs::path& poly, Mesh& mesh) {
  Result<Pslg> pslg = read_pslg(poly);
  if (!pslg) return pslg.error();
  if (!has_own_points(poly)) return std::move(pslg->holes);  // read_mesh() has read the segments already
  if (pslg->points.size() != mesh.points.size()) {
    return Error{ErrorKind::invalid_input, fmt::format("{}: {} points for a mesh with {} vertices", poly.string(),
                                                       pslg->points.size(), mesh.points.size())};
  }
  mesh.constrained_edges.clear();
  for (const Segment& segment : pslg->segments) {
    mesh.constrained_edges.push_back({segment.a, segment.b, no_index, segment.marker});
  }
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
  if (switches.poly) holes = take_segments(switches.name + ".poly", *mesh);
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
