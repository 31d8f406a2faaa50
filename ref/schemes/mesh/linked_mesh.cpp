#include "linked_mesh.hpp"

#include <algorithm>
#include <utility>

#include "predicates.hpp"

namespace pardel::schemes {
namespace {

/// A cavity has few triangles, so a search is faster than a table.
bool contains(const std::vector<Index>& values, Index value) {
  return std::ranges::find(values, value) != values.end();
}

/// Makes the triangle on the other side of `side` point to it. No effect on the border.
void link_back(LinkedMesh& mesh, Side side, Side from) {
  if (from.triangle != no_index) mesh.faces[from.triangle].n[from.i] = side.triangle;
}

}  // namespace

Side across(const LinkedMesh& mesh, Side side) {
  const Index other = mesh.faces[side.triangle].n[side.i];
  const Index first = ends(mesh, side)[0];
  const Corners& v = mesh.faces[other].v;
  // The side ends in its first end there, so the corner after that end is opposite to it.
  for (int i = 0; i < 3; ++i)
    if (v[(i + 2) % 3] == first) return {other, i};
  return {};
}

std::vector<Index> triangles_at(const LinkedMesh& mesh, Side side) {
  std::vector<Index> found = {side.triangle};
  if (const Index other = mesh.faces[side.triangle].n[side.i]; other != no_index) found.push_back(other);
  return found;
}

bool circumdisk_contains(const LinkedMesh& mesh, Index t, Point p) {
  return in_circumdisk(mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2), p);
}

Cavity cavity_of(const LinkedMesh& mesh, Point p, const std::vector<Index>& starts) {
  Cavity cavity{starts, {}};
  std::vector<Index> rejected;
  for (std::size_t k = 0; k < cavity.triangles.size(); ++k) {
    const Index t = cavity.triangles[k];
    for (int i = 0; i < 3; ++i) {
      const Index other = mesh.faces[t].n[i];
      if (other == no_index || is_constrained(mesh, {t, i}) || contains(cavity.triangles, other) ||
          contains(rejected, other))
        continue;
      (circumdisk_contains(mesh, other, p) ? cavity.triangles : rejected).push_back(other);
    }
  }
  cavity.boundary = boundary_of(mesh, cavity.triangles);
  return cavity;
}

std::vector<Side> boundary_of(const LinkedMesh& mesh, const std::vector<Index>& triangles) {
  std::vector<Side> boundary;
  for (const Index t : triangles)
    for (int i = 0; i < 3; ++i)
      if (is_constrained(mesh, {t, i}) || !contains(triangles, mesh.faces[t].n[i])) boundary.push_back({t, i});
  return boundary;
}

bool can_be_connected(const LinkedMesh& mesh, const Cavity& cavity, Point p, Side split) {
  const bool splits = split.triangle != no_index;
  const Side twin = splits && mesh.faces[split.triangle].n[split.i] != no_index ? across(mesh, split) : Side{};
  return std::ranges::all_of(cavity.boundary, [&](Side side) {
    if (splits && (side == split || side == twin)) return true;
    const auto [a, b] = ends(mesh, side);
    return orientation(mesh.points[a], mesh.points[b], p) > 0;
  });
}

std::vector<Index> replace(LinkedMesh& mesh, const Cavity& cavity, Index vertex, Side split) {
  const bool splits = split.triangle != no_index;
  const Index segment = splits ? mesh.faces[split.triangle].segment[split.i] : no_segment;
  const std::array<Index, 2> halves = splits ? ends(mesh, split) : std::array{no_index, no_index};
  // What lies beyond each side of the boundary is read before the triangles of the cavity are overwritten.
  struct Rim {
    std::array<Index, 2> ends;
    Index segment, region;
    Side beyond;
  };
  std::vector<Rim> rim;
  for (const Side side : cavity.boundary) {
    const std::array<Index, 2> e = schemes::ends(mesh, side);
    if (splits && (e == halves || e == std::array{halves[1], halves[0]})) continue;
    const Face& face = mesh.faces[side.triangle];
    const Side beyond = face.n[side.i] == no_index ? Side{} : across(mesh, side);
    rim.push_back({e, face.segment[side.i], face.region, beyond});
  }

  std::vector<Index> made = cavity.triangles;
  while (made.size() < rim.size()) {
    made.push_back(static_cast<Index>(mesh.faces.size()));
    mesh.faces.emplace_back();
  }
  while (made.size() > rim.size()) {
    mesh.faces[made.back()] = {};
    made.pop_back();
  }
  // Triangle k is (vertex, a, b) for side ab of the rim. It meets the triangle whose side begins at b across the side
  // from b to the vertex, opposite to a.
  const auto half = [&](Index end) { return splits && (end == halves[0] || end == halves[1]) ? segment : no_segment; };
  for (std::size_t k = 0; k < rim.size(); ++k) {
    const auto [a, b] = rim[k].ends;
    Face face{{vertex, a, b},
              {rim[k].beyond.triangle, no_index, no_index},
              {rim[k].segment, half(b), half(a)},
              rim[k].region};
    for (std::size_t other = 0; other < rim.size(); ++other) {
      if (rim[other].ends[0] == b) face.n[1] = made[other];
      if (rim[other].ends[1] == a) face.n[2] = made[other];
    }
    mesh.faces[made[k]] = face;
    link_back(mesh, {made[k], 0}, rim[k].beyond);
  }
  return made;
}

void flip(LinkedMesh& mesh, Side side) {
  const Side twin = across(mesh, side);
  const Face left = mesh.faces[side.triangle], right = mesh.faces[twin.triangle];
  const auto turn = [](int i, int by) { return (i + by) % 3; };
  // The side runs from a to b, with the apex c on its left and d on its right. The new side runs from d to c.
  const Index a = left.v[turn(side.i, 1)], b = left.v[turn(side.i, 2)];
  const Index c = left.v[side.i], d = right.v[twin.i];
  const auto beyond = [&](Index t, int i) { return mesh.faces[t].n[i] == no_index ? Side{} : across(mesh, {t, i}); };
  const Side bc = beyond(side.triangle, turn(side.i, 1)), ca = beyond(side.triangle, turn(side.i, 2));
  const Side ad = beyond(twin.triangle, turn(twin.i, 1)), db = beyond(twin.triangle, turn(twin.i, 2));
  mesh.faces[side.triangle] = {{c, a, d},
                               {ad.triangle, twin.triangle, ca.triangle},
                               {right.segment[turn(twin.i, 1)], no_segment, left.segment[turn(side.i, 2)]},
                               left.region};
  mesh.faces[twin.triangle] = {{d, b, c},
                               {bc.triangle, side.triangle, db.triangle},
                               {left.segment[turn(side.i, 1)], no_segment, right.segment[turn(twin.i, 2)]},
                               right.region};
  link_back(mesh, side, ca);
  link_back(mesh, side, ad);
  link_back(mesh, twin, bc);
  link_back(mesh, twin, db);
}

void compact(LinkedMesh& mesh) {
  std::vector<Index> number(mesh.faces.size(), no_index);
  Index used = 0;
  for (Index t = 0; t < mesh.faces.size(); ++t)
    if (mesh.in_use(t)) number[t] = used++;
  for (Index t = 0; t < mesh.faces.size(); ++t) {
    if (number[t] == no_index) continue;
    Face face = mesh.faces[t];
    for (Index& n : face.n)
      if (n != no_index) n = number[n];
    mesh.faces[number[t]] = face;
  }
  mesh.faces.resize(used);
}

}  // namespace pardel::schemes
