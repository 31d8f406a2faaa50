// Metamorphic: how the mesh changes when the input changes. The laws and their reasons are in properties/THEORY.md,
// Metamorphic.
//
// There are no exact laws for isometries of refined meshes. New points are rounded, and a translation changes how they
// are rounded. A turn or a reflection changes the space-filling curve and with it the order of insertions. The
// guarantees stay the same, and the size nearly always changes by less than a tenth. The change can be larger if
// rounding decides whether a segment at a small angle is split: then the whole segment may be split, shell by shell.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <set>
#include <vector>

#include "../../../core/digest.hpp"
#include "../../../ref/faces.hpp"
#include "../framework/shares.hpp"
#include "cocircular_neighbours.hpp"
#include "meshing.hpp"

namespace pardel::properties {
namespace {

using generators::Random;

constexpr const char* metamorphic_source = "properties/THEORY.md, Metamorphic";

/// The image of a domain under a map of the plane.
template <class Map>
Pslg mapped(Pslg pslg, const Map& map) {
  for (Point& p : pslg.points) p = map(p);
  for (Point& p : pslg.holes) p = map(p);
  for (Region& r : pslg.regions) r.seed = map(r.seed);
  return pslg;
}
template <class Map>
Mesh mapped(Mesh mesh, const Map& map, bool turns_over = false) {
  for (Point& p : mesh.points) p = map(p);
  if (turns_over)
    for (Triangle& t : mesh.triangles) {
      std::swap(t.v[1], t.v[2]);
      std::swap(t.n[1], t.n[2]);
    }
  return mesh;
}

/// Fails the case unless the engine makes the expected mesh; the numbering may differ.
void require_mesh(const Problem& problem, const Options& options, const Mesh& expected) {
  RC_ASSERT(digest(value_of(mesh(problem.pslg, problem.goal, options)).mesh) == digest(expected));
}

Random some_random() { return Random(*rc::gen::noShrink(rc::gen::arbitrary<std::uint64_t>())); }

PARDEL_PROPERTY(Metamorphic, scaling_by_a_power_of_two_scales_the_mesh,
                {.statement = "If the coordinates of a domain are multiplied by 2^k and its area bounds by 4^k, the "
                              "mesh is multiplied by 2^k.",
                 .source = metamorphic_source,
                 .families = every_family}) {
  Problem problem = some_problem(exhibit);
  const Options options = some_options();
  const Mesh expected = meshed(problem, exhibit, options).mesh;
  const double scale = std::ldexp(1, *rc::gen::inRange(-40, 41));
  const auto map = [&](Point p) { return Point{p.x * scale, p.y * scale}; };
  problem.pslg = mapped(problem.pslg, map);
  for (Region& region : problem.pslg.regions) region.max_area *= scale * scale;
  problem.goal.max_area *= scale * scale;
  require_mesh(problem, options, mapped(expected, map));
}

PARDEL_PROPERTY(Metamorphic, the_mesh_does_not_depend_on_the_numbering_of_points,
                {.statement = "Listing the points in another order gives the same mesh.",
                 .source = metamorphic_source,
                 .families = every_family}) {
  Problem problem = some_problem(exhibit);
  const Options options = some_options();
  const Mesh expected = meshed(problem, exhibit, options).mesh;
  Random random = some_random();
  std::vector<Index> place(problem.pslg.points.size());
  std::iota(place.begin(), place.end(), Index{0});
  random.shuffle(place);
  const Pslg original = problem.pslg;
  for (std::size_t i = 0; i < place.size(); ++i) problem.pslg.points[place[i]] = original.points[i];
  for (Segment& s : problem.pslg.segments) s = {place[s.a], place[s.b], s.marker};
  require_mesh(problem, options, expected);
}

PARDEL_PROPERTY(Metamorphic, the_mesh_does_not_depend_on_the_order_of_segments_holes_and_regions,
                {.statement = "Listing segments, holes and regions in another order gives the same mesh.",
                 .source = metamorphic_source,
                 .families = every_family}) {
  Problem problem = some_problem(exhibit);
  const Options options = some_options();
  const Mesh expected = meshed(problem, exhibit, options).mesh;
  Random random = some_random();
  random.shuffle(problem.pslg.segments);
  random.shuffle(problem.pslg.holes);
  random.shuffle(problem.pslg.regions);
  require_mesh(problem, options, expected);
}

PARDEL_PROPERTY(Metamorphic, the_mesh_does_not_depend_on_the_direction_of_segments,
                {.statement = "Reversing the direction of segments gives the same mesh.",
                 .source = metamorphic_source,
                 .families = every_family}) {
  Problem problem = some_problem(exhibit);
  const Options options = some_options();
  const Mesh expected = meshed(problem, exhibit, options).mesh;
  Random random = some_random();
  for (Segment& s : problem.pslg.segments)
    if (random.chance(2)) std::swap(s.a, s.b);
  require_mesh(problem, options, expected);
}

/// One of the eight symmetries of the square, followed by a translation by whole units of the lattice.
struct Isometry {
  bool swaps = false, flips_x = false, flips_y = false;
  Point by{};

  [[nodiscard]] bool turns_over() const { return swaps ^ flips_x ^ flips_y; }
  Point operator()(Point p) const {
    if (swaps) std::swap(p.x, p.y);
    return {(flips_x ? -p.x : p.x) + by.x, (flips_y ? -p.y : p.y) + by.y};
  }
};

/// An isometry that maps the points of the domain without rounding.
Isometry some_isometry(const generators::LatticeDomain& domain) {
  const auto either = rc::gen::arbitrary<bool>();
  const auto units =
      rc::gen::map(rc::gen::inRange(-100'000, 100'001), [&](int k) { return std::ldexp(double(k), -domain.exponent); });
  return {*either, *either, *either, {*units, *units}};
}

PARDEL_PROPERTY(Metamorphic, isometries_of_the_lattice_keep_the_triangulation,
                {.statement = "Translations by lattice vectors, quarter turns and reflections map the triangulation of "
                              "a domain to the triangulation of its image, if no two neighbouring triangles are "
                              "cocircular.",
                 .source = metamorphic_source,
                 .families = every_family}) {
  const generators::Case c = some_case(exhibit);
  const Pslg pslg = to_pslg(c.domain);
  const Isometry map = some_isometry(c.domain);
  const Mesh here = value_of(triangulate(pslg)).mesh;
  const Mesh there = value_of(triangulate(mapped(pslg, map))).mesh;
  const bool unique = !has_cocircular_neighbours(ref::to_plain_mesh(here));
  classify(unique, "only one Delaunay triangulation", 35);
  RC_ASSERT(there.triangles.size() == here.triangles.size());
  if (unique) RC_ASSERT(digest(there) == digest(mapped(here, map, map.turns_over())));
}

PARDEL_PROPERTY(
    Metamorphic, isometries_of_the_lattice_keep_the_guarantees_and_roughly_the_size,
    {.statement = "If a domain is translated by a lattice vector, turned by 90 degrees or reflected, its "
                  "mesh is certified, and the number of triangles changes by a factor of at most 4 (the most in "
                  "10,000 cases: 2.8; in 99.7 % of them at most 1.25).",
     .source = metamorphic_source,
     .families = "lattice domains of every family, random goals; meshes of 16 triangles or more"}) {
  const generators::Case c = some_case(exhibit);
  const Problem problem = to_problem(c);
  const Isometry map = some_isometry(c.domain);
  const std::size_t here = meshed(problem, exhibit).mesh.triangles.size();
  RC_PRE(here >= 16U);
  const Problem image{mapped(problem.pslg, map), problem.goal};
  const Mesh there = meshed(image, exhibit).mesh;
  require_valid(check(image.pslg, there, image.goal));
  const auto [fewer, more] = std::minmax({here, there.triangles.size()});
  classify(4 * more <= 5 * fewer, "changed by a factor of at most 1.25", 97);
  RC_ASSERT(more <= 4 * fewer);
}

/// The corners of each triangle, the least index first.
std::set<ref::Corners> corners(const ref::PlainMesh& mesh) {
  std::set<ref::Corners> result;
  for (ref::Corners t : mesh.triangles) {
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    result.insert(t);
  }
  return result;
}

PARDEL_PROPERTY(
    Metamorphic, a_hole_removes_its_face_and_nothing_else,
    {.statement = "One more hole removes the triangles that can be reached from the hole's triangle without "
                  "crossing a segment, and keeps all others.",
     .source = metamorphic_source,
     .families = every_family}) {
  const generators::Case c = some_case(exhibit);
  Pslg pslg = to_pslg(c.domain);
  pslg.regions.clear();
  const Mesh before = value_of(triangulate(pslg)).mesh;
  const Index start = *rc::gen::inRange(Index{0}, static_cast<Index>(before.triangles.size()));
  const auto& v = before.triangles[start].v;
  const Point a = before.points[v[0]], b = before.points[v[1]], d = before.points[v[2]];
  const auto middle = [&](double Point::*x) { return (2 * (a.*x) + b.*x + d.*x) / 4; };
  const Point hole{middle(&Point::x), middle(&Point::y)};
  pslg.holes.push_back(hole);
  ref::PlainMesh rest = ref::to_plain_mesh(before);
  ref::carve(rest, ref::exact(hole), {});
  const Result<Meshed> after = triangulate(pslg);
  RC_ASSERT(after.ok() == !rest.triangles.empty());
  if (after.ok()) RC_ASSERT(corners(ref::to_plain_mesh(after->mesh)) == corners(rest));
}

}  // namespace
}  // namespace pardel::properties
