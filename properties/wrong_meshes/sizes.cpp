// Triangles that are too large, by few units of the largest coordinate of the input.
#include <algorithm>

#include "families.hpp"

namespace pardel::wrong_meshes {
namespace sizes {
namespace {

using generators::Random;
using enum ViolationKind;

/// A square with a vertex in its middle, in four triangles with a longest edge of 16.
Drawing square(const Place& place) {
  Drawing drawing(place);
  drawing.ring({drawing.point(0, 0), drawing.point(16, 0), drawing.point(16, 16), drawing.point(0, 16)});
  return drawing;
}

double longest_edge(const WrongMesh& mesh, Index t) {
  double longest = 0;
  for (int i = 0; i < 3; ++i) {
    const auto& v = mesh.mesh.triangles[t].v;
    const Point a = mesh.mesh.points[v[i]], b = mesh.mesh.points[v[(i + 1) % 3]];
    longest = std::max(longest, std::hypot(b.x - a.x, b.y - a.y));
  }
  return longest;
}

Point centroid(const WrongMesh& mesh, Index t) {
  const auto& v = mesh.mesh.triangles[t].v;
  const auto& p = mesh.mesh.points;
  return {(p[v[0]].x + p[v[1]].x + p[v[2]].x) / 3, (p[v[0]].y + p[v[1]].y + p[v[2]].y) / 3};
}

Index some_triangle(WrongMesh& mesh, Random& random) {
  const auto t = static_cast<Index>(random.below(mesh.mesh.triangles.size()));
  for (const Index v : mesh.mesh.triangles[t].v) mesh.fault.push_back(mesh.mesh.points[v]);
  return t;
}

/// A prescribed length at the centroid of a triangle is `share` less than its longest edge.
std::optional<WrongMesh> prescribed(Random& random, const Place& place, double share, double stray) {
  Drawing drawing = square(place);
  if (stray > 0) add_stray(drawing, Stray::point, stray);
  drawing.inner(place.at(8, 8));
  auto made = drawing.draw();
  if (!made) return made;
  const Index t = some_triangle(*made, random);
  const double size = longest_edge(*made, t) * (1 - share);
  // Steep, so that no other triangle is concerned.
  made->goal.grading = 1e3;
  made->goal.sources = {{centroid(*made, t), centroid(*made, t), size, size}};
  return made;
}

std::optional<WrongMesh> above_a_prescribed_length(std::uint64_t seed) {
  Random random(seed);
  const double share = some_magnitude(random, 1e-8, 0.5);
  return prescribed(random, some_place(random, 10), share, 0);
}

std::optional<WrongMesh> above_a_prescribed_length_with_a_far_point(std::uint64_t seed) {
  Random random(seed);
  const double share = some_magnitude(random, 1e-8, 0.5);
  const double far = std::max(256.0, share * 16 * 0x1p52 / random.between(1, 64));
  return prescribed(random, some_place(random, 10), share, std::exp2(std::floor(std::log2(far))));
}

/// A narrow place needs eight edges across.
std::optional<WrongMesh> above_feature_edges(std::uint64_t seed) {
  Random random(seed);
  const Place place = some_place(random, 20);
  Drawing drawing(place);
  drawing.ring({drawing.point(0, 0), drawing.point(32, 0), drawing.point(32, 4), drawing.point(0, 4)});
  if (random.chance(2)) add_stray(drawing, Stray::point, std::ldexp(1.0, random.between(40, 60)));
  drawing.fault({place.at(0, 0), place.at(32, 0), place.at(32, 4), place.at(0, 4)}, 1);
  auto made = drawing.draw();
  if (made) made->goal.feature_edges = 8;
  return made;
}

/// Edges may not be longer than the segments near by, if there is a limit on gradation.
std::optional<WrongMesh> above_the_length_of_a_segment(std::uint64_t seed) {
  Random random(seed);
  const Place place = some_place(random, 20);
  Drawing drawing = square(place);
  drawing.segment(drawing.point(8, 8), drawing.point(8.25, 8));
  if (random.chance(2)) add_stray(drawing, Stray::point, std::ldexp(1.0, random.between(40, 60)));
  drawing.fault({place.at(8, 8)}, 16);
  auto made = drawing.draw();
  if (made) made->goal.grading = 0.25;
  return made;
}

std::optional<WrongMesh> above_a_function(std::uint64_t seed) {
  Random random(seed);
  Drawing drawing = square(some_place(random));
  if (random.chance(2)) add_stray(drawing, some_stray(random), std::ldexp(1.0, random.between(10, 60)));
  drawing.inner(drawing.place.at(8, 8));
  drawing.fault({drawing.place.at(8, 8)}, 16);
  const double size = std::nextafter(drawing.place.length(16), 0);
  auto made = drawing.draw();
  if (made) made->goal.size = [=](Point) { return size; };
  return made;
}

std::optional<WrongMesh> above_the_longest_edge(std::uint64_t seed) {
  Random random(seed);
  Drawing drawing = square(some_place(random));
  if (random.chance(2)) add_stray(drawing, Stray::point, std::ldexp(1.0, random.between(10, 60)));
  drawing.inner(drawing.place.at(8, 8));
  drawing.fault({drawing.place.at(0, 0), drawing.place.at(16, 16)}, 1);
  drawing.of.goal.max_edge = std::nextafter(drawing.place.length(16), 0);
  return drawing.draw();
}

std::optional<WrongMesh> above_the_largest_area(std::uint64_t seed) {
  Random random(seed);
  Drawing drawing = square(some_place(random));
  if (random.chance(2)) add_stray(drawing, Stray::point, std::ldexp(1.0, random.between(10, 60)));
  drawing.inner(drawing.place.at(8, 8));
  drawing.fault({drawing.place.at(8, 8)}, 1);
  drawing.of.goal.max_area = std::nextafter(std::ldexp(64.0, 2 * drawing.place.exponent), 0);
  return drawing.draw();
}

std::optional<WrongMesh> above_the_cap_of_a_region(std::uint64_t seed) {
  Random random(seed);
  Drawing drawing = square(some_place(random));
  drawing.region(4, 4.5, 1);
  drawing.inner(drawing.place.at(8, 8));
  drawing.fault({drawing.place.at(8, 8)}, 1);
  drawing.of.goal.region_caps = true;
  drawing.of.pslg.regions[0].max_area = std::nextafter(std::ldexp(64.0, 2 * drawing.place.exponent), 0);
  return drawing.draw();
}

std::optional<WrongMesh> at_the_bounds(std::uint64_t seed) {
  Random random(seed);
  Drawing drawing = square(some_place(random));
  drawing.inner(drawing.place.at(8, 8));
  drawing.of.goal.max_edge = drawing.place.length(16);
  drawing.of.goal.max_area = std::ldexp(64.0, 2 * drawing.place.exponent);
  const double size = drawing.of.goal.max_edge;
  drawing.of.goal.size = [=](Point) { return size; };
  return drawing.draw();
}

const std::vector<ViolationKind> too_long{size_exceeded};

const Kind kinds[] = {
    {"sizes", "an edge is longer than a prescribed length", too_long, above_a_prescribed_length},
    {"sizes", "an edge is longer than a prescribed length by units of a far point", too_long,
     above_a_prescribed_length_with_a_far_point},
    {"sizes", "edges are longer than a narrow place allows", too_long, above_feature_edges},
    {"sizes", "edges are longer than the gradation from a short segment allows", too_long,
     above_the_length_of_a_segment},
    {"sizes", "edges are longer than the sizing function by one double", too_long, above_a_function},
    {"sizes", "edges are longer than the bound by one double", {long_edge}, above_the_longest_edge},
    {"sizes", "areas are larger than the bound by one double", {large_area}, above_the_largest_area},
    {"sizes", "areas are larger than the cap of a region by one double", {region_area}, above_the_cap_of_a_region},
    {"right", "edges and areas are as large as they may be", {}, at_the_bounds},
};

}  // namespace
}  // namespace sizes

std::span<const Kind> kinds_of_sizes() { return sizes::kinds; }

}  // namespace pardel::wrong_meshes
