#include "values.hpp"

#include <bit>
#include <cmath>
#include <iterator>
#include <set>
#include <vector>

#include "../../core/neighbours.hpp"

namespace pardel::fuzz {

using generators::Random;

double any_number(Random& random) {
  if (random.chance(2)) return random.between(-9, 9);
  const double bits = std::bit_cast<double>(random.next());
  return random.chance(2) && std::isfinite(bits) ? bits : random.uniform(-1, 1);
}

double any_positive_number(Random& random) {
  const double x = std::abs(any_number(random));
  return x > 0 ? x : 1;
}

namespace {

Point any_point(Random& random) {
  const double x = any_number(random);
  return {x, any_number(random)};
}

int any_marker(Random& random) {
  return random.chance(8) ? static_cast<int>(static_cast<std::uint32_t>(random.next())) : random.between(-2, 9);
}

}  // namespace

Pslg any_pslg(Random& random) {
  Pslg pslg;
  const int n = random.between(3, 6);
  pslg.attributes_per_point = random.below(3);
  pslg.has_segment_markers = random.chance(2);
  const bool has_markers = random.chance(2);
  for (int i = 0; i < n; ++i) {
    pslg.points.push_back(any_point(random));
    if (has_markers) pslg.point_markers.push_back(any_marker(random));
    for (std::size_t k = 0; k < pslg.attributes_per_point; ++k) pslg.point_attributes.push_back(any_number(random));
    const auto a = static_cast<Index>(i), b = static_cast<Index>((i + 1) % n);
    pslg.segments.push_back({a, b, pslg.has_segment_markers ? any_marker(random) : 0});
  }
  for (int i = random.between(0, 2); i > 0; --i) pslg.holes.push_back(any_point(random));
  for (int i = random.between(0, 2); i > 0; --i) {
    const Point seed = any_point(random);
    const double attribute = any_number(random);
    pslg.regions.push_back({seed, attribute, random.chance(2) ? any_positive_number(random) : Region{}.max_area});
  }
  return pslg;
}

namespace {

/// The points and the constrained edges of a mesh.
Mesh without_triangles(const Pslg& pslg) {
  Mesh mesh;
  for (const Point p : pslg.points) mesh.points.push_back(p);
  mesh.attributes_per_point = pslg.attributes_per_point;
  for (const double a : pslg.point_attributes) mesh.point_attributes.push_back(a);
  for (const int marker : pslg.point_markers) mesh.point_markers.push_back(marker);
  for (const Segment& s : pslg.segments) mesh.constrained_edges.push_back({s.a, s.b, no_index, s.marker});
  return mesh;
}

/// Links the triangles, and gives them regions in half of the cases. As readers do it, the regions are in the order of
/// their attributes, and each has a triangle.
void finish(Mesh& mesh, Random& random) {
  rebuild_neighbours(mesh.triangles, mesh.points.size());
  if (random.chance(2)) return;
  const double choice[] = {any_number(random), any_number(random)};
  std::vector<double> attributes;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) attributes.push_back(choice[random.below(2)]);
  const std::set<double> distinct(attributes.begin(), attributes.end());
  mesh.region_attributes.assign(distinct.begin(), distinct.end());
  for (const double a : attributes)
    mesh.region.push_back(static_cast<Index>(std::distance(distinct.begin(), distinct.find(a))));
}

}  // namespace

Mesh any_fan(Random& random) {
  Mesh mesh = without_triangles(any_pslg(random));
  for (Index i = 0; i + 2 < mesh.points.size(); ++i) mesh.triangles.push_back({{0, i + 1, i + 2}, {}});
  finish(mesh, random);
  return mesh;
}

Mesh any_mesh(Random& random) {
  if (random.chance(2)) return any_fan(random);
  Mesh mesh = without_triangles(any_pslg(random));
  const std::size_t n = mesh.points.size();
  for (int i = random.between(1, 4); i > 0; --i) {
    const std::size_t a = random.below(n), b = (a + 1 + random.below(n - 1)) % n;
    std::size_t c = random.below(n);
    while (c == a || c == b) c = (c + 1) % n;
    mesh.triangles.push_back({{static_cast<Index>(a), static_cast<Index>(b), static_cast<Index>(c)}, {}});
  }
  finish(mesh, random);
  return mesh;
}

void add_fields_and_names(Mesh& mesh, Random& random) {
  const auto add = [&](const char* name, Field::Place place, std::size_t places) {
    if (random.chance(2)) return;
    const auto components = static_cast<std::size_t>(random.between(1, 3));
    Array<double> values(places * components);
    for (double& value : values) value = random.chance(4) ? std::nan("") : any_number(random);
    mesh.fields.push_back({name, place, components, std::move(values), 0});
  };
  add("T", Field::Place::points, mesh.points.size());
  add("speed & <more>", Field::Place::points, mesh.points.size());
  add("heat", Field::Place::triangles, mesh.triangles.size());
  if (random.chance(2)) mesh.names.push_back({GroupName::Of::marker, random.between(1, 3), "wall # of \"it\""});
  if (random.chance(2)) mesh.names.push_back({GroupName::Of::region, random.between(1, 3), "water"});
}

}  // namespace pardel::fuzz
