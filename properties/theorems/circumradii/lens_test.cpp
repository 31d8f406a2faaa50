// T2 with a lens in place of the diametral circle: the variant that the engine uses. Proof: properties/THEORY.md, T2.
#include "lens.hpp"

#include <algorithm>
#include <cmath>

#include "../../../ref/insertion.hpp"
#include "../framework/on_walls.hpp"
#include "../framework/property.hpp"
#include "../framework/scene_carving.hpp"
#include "../framework/shares.hpp"
#include "left_triangle.hpp"

namespace pardel::properties {
namespace {
using ref::Number;

Lens some_lens() { return Lens(Number(*rc::gen::inRange(24, 41).as("64 times the tangent of the bound")) / 64); }

/// An edge of the boundary of the cavity of p that is a wall or on the hull, and the triangle of p on it.
struct Border {
  ref::ExactPoint a, b;
  Number inside, made;  ///< r² of the triangle of the cavity, and of the new triangle
};

std::vector<Border> borders(const ref::PlainMesh& mesh, const ref::ExactPoint& p) {
  ref::PlainMesh with_p = mesh;
  with_p.points.push_back(p);
  std::vector<Border> result;
  for (const ref::Corners& t :
       ref::retriangulation(with_p, ref::cavity(mesh, p), static_cast<Index>(mesh.points.size())))
    if (mesh.constraints.contains(ref::edge(t[0], t[1])) || !squared_circumradius_left_of(mesh, t[1], t[0]))
      result.push_back({mesh.points[t[0]], mesh.points[t[1]], *squared_circumradius_left_of(mesh, t[0], t[1]),
                        squared_circumradius(with_p, t)});
  return result;
}

MeshedScene some_scene(Exhibit& exhibit) {
  MeshedScene meshed =
      *scenes(in_any_walled_domain({.insertions = 3, .on_walls = true, .mostly_on_walls = true})).as("scene");
  exhibit.show(meshed.scene);
  tag_families(meshed);
  classify_outline(meshed, meshed.scene.insertions, 1);
  return meshed;
}

/// A triangle whose longest side is a wall of the length 128, at little more than 90 degrees to its apex, so that the
/// wall is nearly a diameter of the largest circumcircle; and up to three points at the edge of the lens of the wall.
MeshedScene wall_with_points_at_its_lens(Exhibit& exhibit, const Lens& lens) {
  const bool turned = *rc::gen::arbitrary<bool>().as("turned by a right angle");
  const auto placed = [&](double x, double y) { return turned ? Point{-y, x} : Point{x, y}; };
  const double above = 64 + *rc::gen::inRange(0, 9);
  Scene scene{{placed(0, 0), placed(128, 0), placed(64, above)}, {{0, 1}}, {}};
  const double tangent = std::sqrt((1 - std::sqrt(CGAL::to_double(lens.squared_cosine))) /
                                   (1 + std::sqrt(CGAL::to_double(lens.squared_cosine))));  // of alpha
  for (int k = *rc::gen::inRange(1, 4); k > 0; --k) {
    const double x = 6.0 * k - 12 + *rc::gen::inRange(-2, 3), height = 64 * tangent + *rc::gen::inRange(-4, 17) / 4.0;
    scene.insertions.push_back(placed(64 + x, std::round(8 * height) / 8));
  }
  exhibit.show(scene);
  return meshed(std::move(scene));
}

constexpr const char* families =
    "all layouts, walls, carved domains and positions of random scenes; walls that are nearly diameters, with points "
    "at the edge of their lenses; lenses of angle bounds from 20.6 to 32 degrees";

PARDEL_PROPERTY(T2Lens, a_point_outside_the_lens_of_a_wall_bounds_the_new_circumradius_by_the_length_of_the_wall,
                {.statement = "Let p lie outside the lens of the wall or hull edge mn on the boundary of its cavity: "
                              "the angle mpn is less than 180° - 2 alpha. Then the circumradius of the new triangle "
                              "mnp is at most the larger of that of the old triangle at mn, and |mn| / (2 sin 2 "
                              "alpha).",
                 .source = "THEORY.md, T2, with a lens in place of the circle",
                 .families = families}) {
  const MeshedScene meshed = some_scene(exhibit);
  const Lens lens = some_lens();
  bool between = false;
  for (const Point& at : meshed.scene.insertions) {
    const ref::ExactPoint p = ref::exact(at);
    for (const Border& e : borders(meshed.mesh, p)) {
      if (lens.contains(p, e.a, e.b)) continue;
      between |= ref::encroaches(p, e.a, e.b);
      RC_ASSERT(e.made <= std::max(e.inside, Number(CGAL::squared_distance(e.a, e.b) / (4 * lens.squared_sine))));
    }
  }
  classify(between, "outside the lens, but inside the diametral circle", 1);
}

PARDEL_PROPERTY(T2Lens, while_no_point_lies_in_a_lens_circumradii_stay_below_one_multiple_of_the_bound,
                {.statement = "Insert points into a constrained Delaunay mesh one after the other, each outside the "
                              "lenses of all walls and hull edges on the boundary of its cavity. Then no circumradius "
                              "exceeds r / sin 2 alpha, where r is the largest circumradius at the start, however many "
                              "points are inserted.",
                 .source = "THEORY.md, T2, with a lens in place of the circle",
                 .families = families}) {
  const Lens lens = some_lens();
  const bool is_made = *rc::gen::weightedElement<bool>({{2, false}, {1, true}});
  const MeshedScene meshed = is_made ? wall_with_points_at_its_lens(exhibit, lens) : some_scene(exhibit);
  ref::PlainMesh mesh = meshed.mesh;
  bool grew = false, is_near = false;
  for (const Point& at : meshed.scene.insertions) {
    const ref::ExactPoint p = ref::exact(at);
    const std::vector<Border> edges = borders(mesh, p);
    if (std::ranges::any_of(edges, [&](const Border& e) { return lens.contains(p, e.a, e.b); })) continue;
    ref::insert(mesh, p);
    const Number bound = squared_circumradius_bound(mesh);
    grew |= bound > meshed.squared_bound;
    RC_ASSERT(bound * lens.squared_sine <= meshed.squared_bound);
    is_near |= bound > meshed.squared_bound && bound * lens.squared_sine > Number(0.81) * meshed.squared_bound;
  }
  classify(grew, "the largest circumradius grew", 10);
  classify(is_near, "the largest circumradius exceeds 0.9 of the bound", 8);
}

}  // namespace
}  // namespace pardel::properties
