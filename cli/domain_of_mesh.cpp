#include "domain_of_mesh.hpp"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "../core/support/name_of_triangle.hpp"
#include "../parallel/mesher.hpp"
#include "../parallel/validate.hpp"
#include "centroid.hpp"
#include "faces.hpp"

namespace pardel::cli {
namespace {

/// The edges that belong to exactly one triangle. Each is directed so that this triangle lies to its left.
std::vector<Segment> boundary(const Mesh& mesh) {
  std::vector<Segment> edges;
  for (const Triangle& t : mesh.triangles) {
    for (int i = 0; i < 3; ++i) {
      if (t.n[i] == no_index) edges.push_back({side(t, i).from, side(t, i).to, 1});
    }
  }
  return edges;
}

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

/// The boundary edges and their vertices, renumbered.
Pslg outline_of(const Mesh& mesh) {
  Pslg outline;
  std::vector<Index> number(mesh.points.size(), no_index);
  const auto renumbered = [&](Index v) {
    if (number[v] == no_index) {
      number[v] = static_cast<Index>(outline.points.size());
      outline.points.push_back(mesh.points[v]);
    }
    return number[v];
  };
  for (const Segment& edge : boundary(mesh)) {
    const Index a = renumbered(edge.a);
    outline.segments.push_back({a, renumbered(edge.b)});
  }
  return outline;
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

/// A point in each hole. Triangulates the convex hull of the outline. A face that lies to the right of an outline edge
/// is not covered by the mesh. Such a face is a hole, unless it reaches the hull: then it belongs to the exterior.
Result<std::vector<Point>> hole_seeds(const Mesh& mesh) {
  const Pslg outline = outline_of(mesh);
  if (outline.segments.empty()) return std::vector<Point>();
  const Result<Meshed> hull = triangulate(outline, true);
  if (!hull) return with_numbers_of(mesh, hull.error());
  const Mesh& around = hull.value().mesh;
  EdgeSet walls{outline.segments};
  walls.finish();
  const std::vector<Index> face = faces(around, walls);
  const std::vector<Index> best = largest(around, face);

  const std::vector<char> is_open = open_faces(around, walls, face, best.size());
  std::vector<char> uncovered(best.size(), 0);
  const auto directed = [](const Segment& s, const Segment& t) { return std::pair(s.a, s.b) < std::pair(t.a, t.b); };
  std::vector<Segment> forwards = outline.segments;
  std::sort(forwards.begin(), forwards.end(), directed);
  for (Index t = 0; t < face.size(); ++t) {
    for (int i = 0; i < 3; ++i) {
      const auto [from, to] = side(around.triangles[t], i);
      if (std::binary_search(forwards.begin(), forwards.end(), Segment{to, from}, directed)) uncovered[face[t]] = 1;
    }
  }
  std::vector<Point> seeds;
  for (std::size_t f = 0; f < best.size(); ++f) {
    if (uncovered[f] != 0 && is_open[f] == 0) seeds.push_back(centroid(around, around.triangles[best[f]]));
  }
  return seeds;
}

}  // namespace

Status check_nodes_of_boundary(const Mesh& mesh) {
  std::vector<Point> points = outline_of(mesh).points;
  std::ranges::sort(points, {}, [](Point p) { return std::pair(p.x, p.y); });
  if (std::ranges::adjacent_find(points) == points.end()) return Done{};
  return with_numbers_of(mesh, {ErrorKind::invalid_input, "two nodes of the boundary are at one place"});
}

Result<Pslg> domain_of(const Mesh& mesh) {
  Pslg pslg;
  pslg.points.assign(mesh.points.begin(), mesh.points.end());
  pslg.attributes_per_point = mesh.attributes_per_point;
  pslg.point_attributes.assign(mesh.point_attributes.begin(), mesh.point_attributes.end());
  pslg.point_markers.assign(mesh.point_markers.begin(), mesh.point_markers.end());
  EdgeSet walls;
  for (const ConstrainedEdge& edge : mesh.constrained_edges) walls.edges.push_back({edge.a, edge.b, edge.marker});
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
