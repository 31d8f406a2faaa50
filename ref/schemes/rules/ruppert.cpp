#include "ruppert.hpp"

#include <algorithm>

#include "../mesh/predicates.hpp"

namespace pardel::schemes {
namespace {

double squared_length(const LinkedMesh& mesh, Side side) {
  const auto [a, b] = ends(mesh, side);
  const double dx = mesh.points[a].x - mesh.points[b].x, dy = mesh.points[a].y - mesh.points[b].y;
  return dx * dx + dy * dy;
}

}  // namespace

std::optional<Side> blocking_side(const LinkedMesh& mesh, const Cavity& cavity, Point p) {
  std::optional<Side> longest;
  for (const Side side : cavity.boundary) {
    if (!is_constrained(mesh, side)) continue;
    const auto [a, b] = ends(mesh, side);
    const bool blocks =
        encroaches(p, mesh.points[a], mesh.points[b]) || orientation(mesh.points[a], mesh.points[b], p) <= 0;
    if (blocks && (!longest || squared_length(mesh, side) > squared_length(mesh, *longest))) longest = side;
  }
  return longest;
}

std::optional<Side> encroached_side(const LinkedMesh& mesh, Index t) {
  for (int i = 0; i < 3; ++i) {
    const auto [a, b] = ends(mesh, {t, i});
    if (is_constrained(mesh, {t, i}) && encroaches(mesh.corner(t, i), mesh.points[a], mesh.points[b]))
      return Side{t, i};
  }
  return std::nullopt;
}

Point circumcentre(const LinkedMesh& mesh, Index t) {
  const Point a = mesh.corner(t, 0), b = mesh.corner(t, 1), c = mesh.corner(t, 2);
  const double bx = b.x - a.x, by = b.y - a.y, cx = c.x - a.x, cy = c.y - a.y;
  const double b2 = bx * bx + by * by, c2 = cx * cx + cy * cy, d = 2 * (bx * cy - by * cx);
  return {a.x + (cy * b2 - by * c2) / d, a.y + (bx * c2 - cx * b2) / d};
}

std::optional<Insertion> split_of(const LinkedMesh& mesh, Side side, const SmallAngles& angles) {
  Insertion found{side.triangle, angles.split_point(mesh, side), side, {}};
  found.cavity = cavity_of(mesh, found.point, triangles_at(mesh, side));
  const auto [a, b] = ends(mesh, side);
  if (found.point == mesh.points[a] || found.point == mesh.points[b]) return std::nullopt;
  if (!can_be_connected(mesh, found.cavity, found.point, side)) return std::nullopt;
  return found;
}

bool needs_work(const LinkedMesh& mesh, Index t, const Bounds& bounds) {
  return encroached_side(mesh, t) || bounds.is_large(mesh, t) || bounds.is_thin(mesh, t);
}

std::optional<Insertion> insertion_for(const LinkedMesh& mesh, Index t, const Bounds& bounds) {
  if (const auto side = encroached_side(mesh, t)) return split_of(mesh, *side, bounds.small_angles());
  if (!bounds.is_large(mesh, t) && !bounds.is_thin(mesh, t)) return std::nullopt;
  return circumcentre_insertion(mesh, t, bounds);
}

std::optional<Insertion> circumcentre_insertion(const LinkedMesh& mesh, Index t, const Bounds& bounds) {
  Insertion found{t, circumcentre(mesh, t), {}, {}};
  if (!circumdisk_contains(mesh, t, found.point)) return std::nullopt;
  found.cavity = cavity_of(mesh, found.point, {t});
  if (const auto side = blocking_side(mesh, found.cavity, found.point)) {
    std::optional<Insertion> split = split_of(mesh, *side, bounds.small_angles());
    if (split) split->triangle = t;
    return split;
  }
  if (!can_be_connected(mesh, found.cavity, found.point)) return std::nullopt;
  return found;
}

std::vector<Index> carry_out(LinkedMesh& mesh, const Insertion& insertion) {
  const auto vertex = static_cast<Index>(mesh.points.size());
  mesh.points.push_back(insertion.point);
  const Side split = insertion.split;
  mesh.segment_of.push_back(insertion.splits_segment() ? mesh.faces[split.triangle].segment[split.i] : no_segment);
  return replace(mesh, insertion.cavity, vertex, split);
}

std::uint64_t refine_where(LinkedMesh& mesh, const Bounds& bounds, std::deque<Index> waiting,
                           const std::function<bool(Index)>& is_due, std::size_t most_points) {
  std::uint64_t work = 0;
  while (!waiting.empty() && mesh.points.size() < most_points) {
    const Index t = waiting.front();
    waiting.pop_front();
    if (!mesh.in_use(t) || !is_due(t)) continue;
    const auto insertion = insertion_for(mesh, t, bounds);
    if (!insertion) continue;
    work += insertion->work();
    const std::vector<Index> made = carry_out(mesh, *insertion);
    waiting.insert(waiting.end(), made.begin(), made.end());
    // A triangle whose circumcentre was rejected is still there.
    if (!insertion->cavity.contains(t)) waiting.push_back(t);
  }
  return work;
}

std::deque<Index> all_triangles(const LinkedMesh& mesh) {
  std::deque<Index> all;
  for (Index t = 0; t < mesh.faces.size(); ++t)
    if (mesh.in_use(t)) all.push_back(t);
  return all;
}

std::uint64_t refine_sequentially(LinkedMesh& mesh, const Bounds& bounds, std::size_t most_points) {
  const auto always = [](Index) { return true; };
  return refine_where(mesh, bounds, all_triangles(mesh), always, most_points);
}

}  // namespace pardel::schemes
