#include "domain_of_mesh.hpp"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "../core/support/name_of_triangle.hpp"
#include "../parallel/validate.hpp"
#include "around_mesh.hpp"
#include "centroid.hpp"
#include "faces.hpp"

namespace pardel::cli {
namespace {

/// One region per face whose triangles have an attribute. None at all if the triangles of a face have different
/// attributes: then attributes do not describe faces.
std::vector<Region> region_seeds(const Mesh& mesh, const EdgeSet& walls) {
  std::vector<Region> regions;
  if (mesh.region.empty()) return regions;
  const std::vector<Index> face = faces(mesh, walls);
  const std::vector<Index> best = largest(mesh, face);
  for (Index t = 0; t < face.size(); ++t) {
    if (mesh.region[t] != mesh.region[best[face[t]]]) return regions;
  }
  for (const Index t : best) {
    if (mesh.region[t] == no_index) continue;
    regions.push_back({.seed = centroid(mesh, mesh.triangles[t]), .attribute = mesh.region_attributes[mesh.region[t]]});
  }
  return regions;
}

/// The triangles at the boundary edges of a problem, one of which overlaps others, each after a line break.
std::string triangles_at(const Mesh& mesh, const Problem& problem) {
  const bool is_of_edges = problem.kind == ProblemKind::crossing_segments ||
                           problem.kind == ProblemKind::overlapping_segments ||
                           problem.kind == ProblemKind::duplicate_segments;
  std::vector<Index> edges;
  if (is_of_edges) edges = problem.ids;
  if (problem.kind == ProblemKind::point_on_segment) edges.push_back(problem.ids[1]);
  std::string text;
  Index edge = 0;
  for (Index t = 0; t < mesh.triangles.size(); ++t)
    for (int i = 0; i < 3; ++i) {
      const Triangle& triangle = mesh.triangles[t];
      if (triangle.n[i] != no_index) continue;
      if (std::ranges::find(edges, edge++) == edges.end()) continue;
      const auto number = [&](Index v) { return std::to_string(number_in_file(mesh, v)); };
      text += "\nEdge " + number(side(triangle, i).from) + "-" + number(side(triangle, i).to) + " is a side of " +
              name_of_triangle(mesh, t) + ".";
    }
  return text;
}

/// The problems of the outline, with the numbers that its points have in the file of the mesh. Edges have none.
Error with_numbers_of(const Mesh& mesh, const Error& of_outline) {
  Pslg all;
  all.points.assign(mesh.points.begin(), mesh.points.end());
  all.segments = boundary(mesh);
  const std::vector<Problem> problems = find_problems(all, {.convex_hull = true});
  if (problems.empty()) return of_outline;
  return {ErrorKind::invalid_input,
          messages(problems, NumbersInMessages{mesh.first_id.value, mesh.numbers.of_points, all.segments}) +
              triangles_at(mesh, problems.front())};
}

/// A point in each hole: in each face of the convex hull of the boundary that the mesh does not cover, unless it
/// reaches the hull. Then it belongs to the exterior.
Result<std::vector<Point>> hole_seeds(const Mesh& mesh) {
  const Pslg outline = part_of(mesh, boundary(mesh));
  if (outline.segments.empty()) return std::vector<Point>();
  const Result<AroundMesh> around = around_mesh(outline, outline.segments.size());
  if (!around) return with_numbers_of(mesh, around.error());
  std::vector<Point> seeds;
  for (std::size_t f = 0; f < around->best.size(); ++f)
    if (around->is_bare[f] != 0 && around->is_out[f] == 0)
      seeds.push_back(centroid(around->hull, around->hull.triangles[around->best[f]]));
  return seeds;
}

}  // namespace

Status check_boundary(const Mesh& mesh) {
  const Pslg outline = part_of(mesh, boundary(mesh));
  if (outline.segments.empty()) return Done{};
  const Result<ValidPslg, std::vector<Problem>> valid = validate(outline, {.convex_hull = true});
  if (!valid) return with_numbers_of(mesh, {ErrorKind::invalid_input, messages(valid.error())});
  return Done{};
}

void take_points(Pslg& pslg, const Mesh& mesh) {
  pslg.points.assign(mesh.points.begin(), mesh.points.end());
  pslg.attributes_per_point = mesh.attributes_per_point;
  pslg.point_attributes.assign(mesh.point_attributes.begin(), mesh.point_attributes.end());
  pslg.point_markers.assign(mesh.point_markers.begin(), mesh.point_markers.end());
}

Result<Pslg> domain_of(const Mesh& mesh) {
  Pslg pslg;
  take_points(pslg, mesh);
  EdgeSet walls = to_edge_set(mesh.constrained_edges);
  const std::vector<Segment> outline = boundary(mesh);
  walls.edges.insert(walls.edges.end(), outline.begin(), outline.end());
  walls.finish();
  pslg.regions = region_seeds(mesh, walls);
  Result<std::vector<Point>> holes = hole_seeds(mesh);
  if (!holes) return holes.error();
  pslg.holes = std::move(*holes);
  pslg.segments = std::move(walls.edges);
  pslg.has_segment_markers = true;
  pslg.first_id = mesh.first_id;
  return pslg;
}

}  // namespace pardel::cli
