#include "forced_segments.hpp"

#include <algorithm>
#include <deque>

#include "predicates.hpp"

namespace pardel::schemes {
namespace {

int corner_of(const LinkedMesh& mesh, Index t, Index v) {
  const Corners& corners = mesh.faces[t].v;
  return static_cast<int>(std::ranges::find(corners, v) - corners.begin());
}

/// The side of some triangle that runs from a to b, if there is one; else the side opposite to a through which the
/// segment ab leaves a. Precondition: a is not on the border of the mesh, and ab contains no other vertex.
Side towards(const LinkedMesh& mesh, const TriangleAt& at, Index a, Index b) {
  Index t = at[a];
  for (;;) {
    const int i = corner_of(mesh, t, a);
    const Index right = mesh.faces[t].v[(i + 1) % 3], left = mesh.faces[t].v[(i + 2) % 3];
    if (right == b) return {t, (i + 2) % 3};
    const bool is_between = orientation(mesh.points[a], mesh.points[right], mesh.points[b]) > 0 &&
                            orientation(mesh.points[a], mesh.points[left], mesh.points[b]) < 0;
    if (is_between) return {t, i};
    t = mesh.faces[t].n[(i + 1) % 3];  // counter-clockwise around a
  }
}

void constrain(LinkedMesh& mesh, Side side, Index segment) {
  mesh.faces[side.triangle].segment[side.i] = segment;
  if (mesh.faces[side.triangle].n[side.i] == no_index) return;
  const Side twin = across(mesh, side);
  mesh.faces[twin.triangle].segment[twin.i] = segment;
}

/// The ends of the sides that the segment ab crosses, from a on.
std::deque<std::array<Index, 2>> crossed_sides(const LinkedMesh& mesh, Side first, Index a, Index b) {
  std::deque<std::array<Index, 2>> crossed;
  for (Side side = first;;) {
    crossed.push_back(ends(mesh, side));
    const Side beyond = across(mesh, side);
    const Index apex = mesh.faces[beyond.triangle].v[beyond.i];
    if (apex == b) return crossed;
    // Seen from a, the side runs from right to left. If the apex lies on the left, the segment leaves between the right
    // end and the apex, opposite to the left end, which comes after the apex in the triangle beyond.
    const bool left = orientation(mesh.points[a], mesh.points[b], mesh.points[apex]) > 0;
    side = {beyond.triangle, (beyond.i + (left ? 1 : 2)) % 3};
  }
}

/// The side that joins a and b, seen from one of its triangles. The search turns around the lower number: the corners
/// of the box, which have the highest ones, are on the border.
Side side_between(const LinkedMesh& mesh, const TriangleAt& at, Index a, Index b) {
  if (b < a) std::swap(a, b);
  Index t = at[a];
  for (;;) {
    const int i = corner_of(mesh, t, a);
    if (mesh.faces[t].v[(i + 1) % 3] == b) return {t, (i + 2) % 3};
    t = mesh.faces[t].n[(i + 1) % 3];
  }
}

}  // namespace

std::uint64_t force(LinkedMesh& mesh, TriangleAt& at, Index a, Index b, Index segment) {
  const Side first = towards(mesh, at, a, b);
  if (ends(mesh, first) == std::array{a, b}) {
    constrain(mesh, first, segment);
    return 0;
  }
  std::vector<std::array<Index, 2>> made;
  std::deque<std::array<Index, 2>> crossed = crossed_sides(mesh, first, a, b);
  while (!crossed.empty()) {
    const auto [p, q] = crossed.front();
    crossed.pop_front();
    const Side side = side_between(mesh, at, p, q), twin = across(mesh, side);
    const Index c = mesh.faces[side.triangle].v[side.i], d = mesh.faces[twin.triangle].v[twin.i];
    const bool convex = orientation(mesh.points[d], mesh.points[c], mesh.points[p]) *
                            orientation(mesh.points[d], mesh.points[c], mesh.points[q]) <
                        0;
    if (!convex) {
      crossed.push_back({p, q});
      continue;
    }
    flip(mesh, side);
    at.note(mesh, side.triangle);
    at.note(mesh, twin.triangle);
    const bool still_crosses = c != a && c != b && d != a && d != b &&
                               orientation(mesh.points[a], mesh.points[b], mesh.points[c]) *
                                       orientation(mesh.points[a], mesh.points[b], mesh.points[d]) <
                                   0;
    (still_crosses ? crossed.push_back({d, c}) : made.push_back({d, c}));
  }
  constrain(mesh, side_between(mesh, at, a, b), segment);
  std::vector<Side> sides;
  for (const auto& [p, q] : made) sides.push_back(side_between(mesh, at, p, q));
  const std::vector<Index> flipped = flip_to_delaunay(mesh, sides);
  for (const Index t : flipped) at.note(mesh, t);
  return 2 * made.size() + flipped.size();
}

std::vector<Index> flip_where(LinkedMesh& mesh, std::vector<Side> sides,
                              const std::function<bool(Side, Side)>& is_wrong) {
  std::vector<Index> changed;
  while (!sides.empty()) {
    const Side side = sides.back();
    sides.pop_back();
    if (mesh.faces[side.triangle].n[side.i] == no_index || is_constrained(mesh, side)) continue;
    const Side twin = across(mesh, side);
    if (!is_wrong(side, twin)) continue;
    flip(mesh, side);
    for (const Index t : {side.triangle, twin.triangle}) {
      changed.push_back(t);
      for (const int i : {0, 2}) sides.push_back({t, i});
    }
  }
  return changed;
}

std::vector<Index> flip_to_delaunay(LinkedMesh& mesh, std::vector<Side> sides) {
  return flip_where(mesh, std::move(sides), [&](Side side, Side twin) {
    return circumdisk_contains(mesh, side.triangle, mesh.corner(twin.triangle, twin.i));
  });
}

}  // namespace pardel::schemes
