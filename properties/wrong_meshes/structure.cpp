// Gaps and overlaps of one unit, tiny triangles, edges that are not Delaunay by one unit.
#include <algorithm>
#include <array>
#include <initializer_list>

#include "../defects/edit.hpp"
#include "families.hpp"

namespace pardel::wrong_meshes {
namespace structure {
namespace {

using generators::Random;
using enum ViolationKind;
namespace edit = defects::edit;

/// A square in four triangles around the vertex 4 in its middle.
WrongMesh square(const Place& place) {
  Drawing drawing(place);
  drawing.ring({drawing.point(0, 0), drawing.point(16, 0), drawing.point(16, 16), drawing.point(0, 16)});
  const Index v = drawing.inner(place.at(8, 8));
  drawing.fault({drawing.at(v)}, 16);
  return *drawing.draw();
}

/// The point at a number of units of the largest coordinate from p, in direction (x, y), of the lattice.
Point moved(const Place& place, Point p, double x, double y, int units) {
  if (place.mirrored) x = -x;
  if (place.swapped) std::swap(x, y);
  return {p.x + units * x * spacing(p.x), p.y + units * y * spacing(p.y)};
}

/// The triangle beside this side of the square; (x, y) is the direction to it.
Index triangle_at(const WrongMesh& mesh, Index a, Index b) {
  for (Index t = 0; t < mesh.mesh.triangles.size(); ++t) {
    const auto& v = mesh.mesh.triangles[t].v;
    if (std::ranges::count(v, a) == 1 && std::ranges::count(v, b) == 1) return t;
  }
  return no_index;
}

/// The triangle at the upper side has its own copy of the vertex in the middle, `up` units further up.
std::optional<WrongMesh> split(Random& random, int up) {
  const Place place = some_place(random);
  WrongMesh made = square(place);
  Mesh& mesh = made.mesh;
  const Index copy = edit::append_point(mesh, moved(place, mesh.points[4], 0, 1, up));
  std::ranges::replace(mesh.triangles[triangle_at(made, 2, 3)].v, Index{4}, copy);
  edit::relink(mesh);
  return made;
}

std::optional<WrongMesh> gap(std::uint64_t seed) {
  Random random(seed);
  return split(random, random.between(1, 16));
}
std::optional<WrongMesh> overlap_of_units(std::uint64_t seed) {
  Random random(seed);
  return split(random, -random.between(1, 16));
}
std::optional<WrongMesh> crack(std::uint64_t seed) {
  Random random(seed);
  return split(random, 0);
}

/// A triangle of one unit, at a point.
std::optional<WrongMesh> tiny_triangle(Random& random, double x, double y) {
  const Place place = some_place(random);
  WrongMesh made = square(place);
  const Point p = place.at(x, y);
  std::array<Index, 3> v{};
  v[0] = edit::append_point(made.mesh, p);
  v[1] = edit::append_point(made.mesh, {p.x + spacing(p.x), p.y});
  v[2] = edit::append_point(made.mesh, {p.x, p.y + spacing(p.y)});
  edit::append_triangle(made.mesh, v);
  edit::relink(made.mesh);
  made.fault = {p};
  made.reach = place.length(16);
  return made;
}
std::optional<WrongMesh> tiny_triangle_inside(std::uint64_t seed) {
  Random random(seed);
  return tiny_triangle(random, 8, random.between(2, 6));
}
std::optional<WrongMesh> tiny_triangle_outside(std::uint64_t seed) {
  Random random(seed);
  return tiny_triangle(random, 8, random.between(17, 30));
}

std::optional<WrongMesh> triangle_again(std::uint64_t seed) {
  Random random(seed);
  WrongMesh made = square(some_place(random));
  const Triangle copy = made.mesh.triangles[random.below(4)];
  edit::append_triangle(made.mesh, copy.v);
  return made;
}

/// The vertex in the middle lies on a side or beyond it.
std::optional<WrongMesh> vertex_beyond_an_edge(std::uint64_t seed) {
  Random random(seed);
  const Place place = some_place(random);
  WrongMesh made = square(place);
  made.mesh.points[4] = moved(place, place.at(8, 0), 0, -1, random.between(0, 4));
  return made;
}

std::optional<WrongMesh> corner_moved(std::uint64_t seed) {
  Random random(seed);
  const Place place = some_place(random);
  WrongMesh made = square(place);
  const auto v = static_cast<Index>(random.below(4));
  made.mesh.points[v] = moved(place, made.mesh.points[v], random.chance(2) ? 1 : -1, 0, 1);
  made.fault = {made.mesh.points[v]};
  made.reach = place.length(1);
  return made;
}

/// Three corners of a square, and a fourth one that is a few units off.
std::optional<WrongMesh> wrong_diagonal(std::uint64_t seed) {
  Random random(seed);
  const Place place = some_place(random);
  Drawing drawing(place);
  const Index a = drawing.point(0, 0), b = drawing.point(16, 0);
  const Index c =
      drawing.point(moved(place, place.at(16, 16), 1, 0, random.between(1, 4) * (random.chance(2) ? 1 : -1)));
  drawing.ring({a, b, c, drawing.point(0, 16)});
  drawing.fault({drawing.at(c), drawing.at(a), drawing.at(b)}, 17);
  auto made = drawing.draw();
  if (!made) return made;
  for (int i = 0; i < 3; ++i)
    if (edit::across(made->mesh, {0, i}) != no_index && edit::flip(made->mesh, {0, i})) return made;
  return std::nullopt;
}

/// The upper half of a square is a hole. Its seed lies a number of units above the middle. The vertices of the chain
/// at `bent` lie two units higher; if there are some, the hole has no triangles.
std::optional<WrongMesh> seed_near_the_edge(Random& random, int units, std::initializer_list<double> bent) {
  Drawing drawing(some_place(random));
  const Place& place = drawing.place;
  const Index a = drawing.point(0, 8), b = drawing.point(16, 8);
  const std::vector<Index> around{b, drawing.point(16, 16), drawing.point(0, 16),
                                  a, drawing.point(0, 0),   drawing.point(16, 0)};
  for (std::size_t i = 0; i < 6; ++i) {
    const Index from = around[i], to = around[(i + 1) % 6];
    bent.size() > 0 && i < 3 ? drawing.absent_segment(from, to) : drawing.segment(from, to);
  }
  const Index chain = drawing.segment(a, b);
  const Point middle = place.at(8, 8);
  drawing.of.pslg.holes.push_back(moved(place, middle, 0, 1, units));
  drawing.fault({middle}, 16);
  if (bent.size() > 0) drawing.gap(place.at(8, 12));
  for (const double x : bent) drawing.on(chain, moved(place, place.at(x, 8), 0, 1, 2));
  return drawing.draw();
}

std::optional<WrongMesh> hole_covered(std::uint64_t seed) {
  Random random(seed);
  return seed_near_the_edge(random, random.between(1, 16), {});
}

/// The upper half has the triangles, and the lower one, with the domain, has none.
std::optional<WrongMesh> hole_on_the_wrong_side(std::uint64_t seed) {
  Random random(seed);
  Drawing drawing(some_place(random));
  const Place& place = drawing.place;
  const Index a = drawing.point(0, 8), b = drawing.point(16, 8);
  drawing.ring({drawing.point(0, 0), drawing.point(16, 0), b, drawing.point(16, 16), drawing.point(0, 16), a});
  drawing.segment(a, b);
  drawing.of.pslg.holes.push_back(moved(place, place.at(8, 8), 0, 1, random.between(3, 16)));
  drawing.gap(place.at(8, 4));
  drawing.fault({place.at(8, 8)}, 16);
  return drawing.draw();
}

std::optional<WrongMesh> seed_within_rounding(std::uint64_t seed) {
  Random random(seed);
  return seed_near_the_edge(random, 1, {7, 9});
}

/// The triangle around the seed has only a corner on the chain.
std::optional<WrongMesh> seed_below_a_vertex(std::uint64_t seed) {
  Random random(seed);
  return seed_near_the_edge(random, 1, {8});
}

/// Cocircular points have two Delaunay diagonals.
std::optional<WrongMesh> either_diagonal(std::uint64_t seed) {
  Random random(seed);
  Drawing drawing(some_place(random));
  drawing.ring({drawing.point(0, 0), drawing.point(16, 0), drawing.point(16, 16), drawing.point(0, 16)});
  auto made = drawing.draw();
  if (made && random.chance(2))
    for (int i = 0; i < 3; ++i)
      if (edit::across(made->mesh, {0, i}) != no_index && edit::flip(made->mesh, {0, i})) break;
  return made;
}

const Kind kinds[] = {
    {"structure", "two edges leave a gap of a few units", {uncovered_domain, non_manifold_vertex}, gap},
    {"structure", "two triangles overlap by a few units", {overlap}, overlap_of_units},
    {"structure", "two edges lie on each other", {uncovered_domain, overlap, non_manifold_vertex}, crack},
    {"structure", "a triangle of one unit lies on another", {overlap}, tiny_triangle_inside},
    {"structure", "a triangle of one unit lies outside the domain", {covered_exterior}, tiny_triangle_outside},
    {"structure", "a triangle is there twice", {duplicate_triangle}, triangle_again},
    {"structure", "a vertex lies on an edge or a few units beyond it", {degenerate_triangle}, vertex_beyond_an_edge},
    {"structure", "an input point has moved by one unit", {missing_input_vertex}, corner_moved},
    {"structure", "an edge is not Delaunay by a few units", {not_delaunay}, wrong_diagonal},
    {"structure", "a hole is covered, and its seed is near an edge", {covered_exterior}, hole_covered},
    {"structure", "the wrong side of an edge is covered", {covered_exterior, uncovered_domain}, hole_on_the_wrong_side},
    {"right", "the seed of a hole lies in a triangle within rounding", {}, seed_within_rounding},
    {"right", "the seed of a hole lies below a vertex of the chain within rounding", {}, seed_below_a_vertex},
    {"right", "cocircular points have either diagonal", {}, either_diagonal},
};

}  // namespace
}  // namespace structure

std::span<const Kind> kinds_of_structure() { return structure::kinds; }

}  // namespace pardel::wrong_meshes
