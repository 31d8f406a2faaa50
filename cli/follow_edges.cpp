#include "follow_edges.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "../core/support/mesh_edges.hpp"
#include "../core/support/used_vertices.hpp"
#include "../parallel/validate.hpp"
#include "faces.hpp"
#include "lines_in_holes.hpp"
#include "plural.hpp"

namespace pardel::cli {
namespace {

EdgeSet edges_of_triangles(const Mesh& mesh) {
  EdgeSet all;
  all.edges.reserve(mesh.triangles.size() * 3 / 2);
  for (Index t = 0; t < mesh.triangles.size(); ++t)
    for (int i = 0; i < 3; ++i) {
      if (mesh.triangles[t].n[i] < t) continue;  // listed by the neighbour; no_index is larger
      const auto [from, to] = side(mesh.triangles[t], i);
      all.edges.push_back({from, to});
    }
  all.finish();
  return all;
}

/// The constrained edges that are no edges of triangles.
std::vector<ConstrainedEdge> lines_apart(const Mesh& mesh) {
  const ConstrainedEdgeIndex index(mesh);
  const auto place = [&](Index a, Index b) { return index.find(a, b) - mesh.constrained_edges.data(); };
  std::vector<char> is_edge(mesh.constrained_edges.size(), 0);
  for (const Triangle& triangle : mesh.triangles)
    for (int i = 0; i < 3; ++i) {
      const auto [from, to] = side(triangle, i);
      if (index.find(from, to) != nullptr) is_edge[place(from, to)] = 1;
    }
  std::vector<ConstrainedEdge> lines;
  for (const ConstrainedEdge& edge : mesh.constrained_edges)
    if (is_edge[place(edge.a, edge.b)] == 0) lines.push_back(edge);
  return lines;
}

/// The nodes of triangles strictly inside each line, in their order from its first end on.
std::vector<std::vector<Index>> nodes_inside(const Mesh& mesh, const std::vector<ConstrainedEdge>& lines) {
  Pslg pslg;
  pslg.points.assign(mesh.points.begin(), mesh.points.end());
  for (const ConstrainedEdge& line : lines) pslg.segments.push_back({line.a, line.b});
  const std::vector<char> is_used = used_vertices(mesh);
  // Lines along edges cross at nodes only, so there are about as many crossings as nodes.
  const std::size_t enough = 10 * mesh.points.size() + 10'000;
  std::vector<std::vector<Index>> inside(lines.size());
  for (const Problem& problem : find_problems(pslg, {.convex_hull = true, .max_problems = enough}))
    if (problem.kind == ProblemKind::point_on_segment && is_used[problem.ids[0]] != 0)
      inside[problem.ids[1]].push_back(problem.ids[0]);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const Point a = mesh.points[lines[i].a], b = mesh.points[lines[i].b];
    const bool is_steep = std::abs(b.y - a.y) > std::abs(b.x - a.x);
    const double sign = (is_steep ? b.y < a.y : b.x < a.x) ? -1 : 1;
    std::ranges::sort(inside[i], {}, [&](Index v) { return sign * (is_steep ? mesh.points[v].y : mesh.points[v].x); });
  }
  return inside;
}

/// The line, cut at the nodes inside it.
std::vector<ConstrainedEdge> pieces_of(const ConstrainedEdge& line, const std::vector<Index>& inside) {
  std::vector<ConstrainedEdge> pieces;
  Index from = line.a;
  for (const Index to : inside) {
    pieces.push_back({from, to, line.segment, line.marker});
    from = to;
  }
  pieces.push_back({from, line.b, line.segment, line.marker});
  return pieces;
}

Error no_edges(const Mesh& mesh, const std::vector<ConstrainedEdge>& lines) {
  constexpr std::size_t most_named = 10;
  std::string names;
  for (std::size_t i = 0; i < std::min(lines.size(), most_named); ++i)
    names += fmt::format("{}{}-{}", names.empty() ? "" : ", ", number_in_file(mesh, lines[i].a),
                         number_in_file(mesh, lines[i].b));
  if (lines.size() > most_named) names += fmt::format(" and {} more", lines.size() - most_named);
  return {ErrorKind::invalid_input,
          fmt::format("constrained edge{} between nodes that no edges of triangles join along a straight line: {}",
                      lines.size() == 1 ? "" : "s", names)};
}

}  // namespace

Result<FollowedEdges> follow_edges(Mesh& mesh, const Pslg* domain) {
  const std::vector<ConstrainedEdge> lines = lines_apart(mesh);
  if (lines.empty()) return FollowedEdges{};
  const EdgeSet edges = edges_of_triangles(mesh);
  const std::vector<std::vector<Index>> inside = nodes_inside(mesh, lines);
  std::vector<ConstrainedEdge> cut = mesh.constrained_edges;
  std::erase_if(cut, [&](const ConstrainedEdge& edge) { return !edges.contains(edge.a, edge.b); });
  FollowedEdges followed;
  std::vector<std::vector<ConstrainedEdge>> pieces;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    pieces.push_back(pieces_of(lines[i], inside[i]));
    cut.insert(cut.end(), pieces[i].begin(), pieces[i].end());
    if (pieces[i].size() == 1) continue;
    ++followed.lines;
    followed.edges += pieces[i].size();
  }
  const EdgeSet in_holes = domain != nullptr ? lines_in_holes(mesh, cut, domain->holes) : EdgeSet{};
  std::vector<ConstrainedEdge> wrong;
  for (std::size_t i = 0; i < lines.size(); ++i)
    if (!std::ranges::all_of(pieces[i], [&](const ConstrainedEdge& piece) {
          return edges.contains(piece.a, piece.b) || in_holes.contains(piece.a, piece.b);
        }))
      wrong.push_back(lines[i]);
  if (!wrong.empty()) return no_edges(mesh, wrong);
  mesh.constrained_edges = std::move(cut);
  return followed;
}

std::string note_about(const FollowedEdges& followed) {
  const auto [lines, edges] = followed;
  if (lines == 0) return {};
  return fmt::format("note: {} through further nodes {} taken as {} edges", plural(lines, "constrained edge"),
                     lines == 1 ? "is" : "are", edges);
}

}  // namespace pardel::cli
