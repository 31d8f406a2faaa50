// Regions and attributes that belong elsewhere.
#include <algorithm>
#include <limits>

#include "families.hpp"

namespace pardel::wrong_meshes {
namespace labels {
namespace {

using generators::Random;
using enum ViolationKind;

/// Two squares beside each other, with inserted vertices on the common side and inside. The first `seeds` of them have
/// a region.
Drawing two_squares(Random& random, int seeds) {
  Drawing drawing(some_place(random));
  const Index a = drawing.point(16, 0), b = drawing.point(16, 16);
  drawing.ring({drawing.point(0, 0), a, drawing.point(32, 0), drawing.point(32, 16), b, drawing.point(0, 16)});
  const Index shared = drawing.segment(a, b);
  if (seeds > 0) drawing.region(7, 9, random.between(1, 9));
  if (seeds > 1) drawing.region(23, 9, 10);
  if (random.chance(2)) drawing.on_at(shared, 0.5);
  if (random.chance(2)) drawing.inner(drawing.place.at(8, 8));
  if (random.chance(2)) drawing.inner(drawing.place.at(24, 8));
  return drawing;
}

bool is_in_region(const WrongMesh& mesh, Index t, Index region) { return mesh.mesh.region[t] == region; }

void name_triangle(WrongMesh& mesh, Index t) {
  for (const Index v : mesh.mesh.triangles[t].v) mesh.fault.push_back(mesh.mesh.points[v]);
}

/// Gives `to` to a triangle of region `from`, or to all. False if there is none.
bool change_region(WrongMesh& mesh, Index from, Index to, bool all, Random& random) {
  const std::size_t n = mesh.mesh.triangles.size(), start = random.below(n);
  bool changed = false;
  for (std::size_t i = 0; i < n && (all || !changed); ++i) {
    const auto t = static_cast<Index>((start + i) % n);
    if (!is_in_region(mesh, t, from)) continue;
    mesh.mesh.region[t] = to;
    name_triangle(mesh, t);
    changed = true;
  }
  return changed;
}

template <bool all>
std::optional<WrongMesh> unseeded_face_takes_the_region(std::uint64_t seed) {
  Random random(seed);
  auto made = two_squares(random, 1).draw();
  if (!made || !change_region(*made, no_index, 0, all, random)) return std::nullopt;
  if (random.chance(3)) make_foreign(*made, random);
  return made;
}

std::optional<WrongMesh> seeded_face_lost_it(std::uint64_t seed) {
  Random random(seed);
  auto made = two_squares(random, random.between(1, 2)).draw();
  if (!made || !change_region(*made, 0, no_index, random.chance(2), random)) return std::nullopt;
  if (random.chance(3)) make_foreign(*made, random);
  return made;
}

std::optional<WrongMesh> taken_across(std::uint64_t seed) {
  Random random(seed);
  auto made = two_squares(random, 2).draw();
  const Index from = static_cast<Index>(random.below(2));
  if (!made || !change_region(*made, from, 1 - from, false, random)) return std::nullopt;
  if (random.chance(3)) make_foreign(*made, random);
  return made;
}

std::optional<WrongMesh> swapped(std::uint64_t seed) {
  Random random(seed);
  auto made = two_squares(random, 2).draw();
  if (!made) return std::nullopt;
  for (Index t = 0; t < made->mesh.triangles.size(); ++t) {
    made->mesh.region[t] = 1 - made->mesh.region[t];
    name_triangle(*made, t);
  }
  if (random.chance(3)) make_foreign(*made, random);
  return made;
}

std::optional<WrongMesh> regions_without_seeds(std::uint64_t seed) {
  Random random(seed);
  auto made = two_squares(random, 0).draw();
  if (!made) return std::nullopt;
  made->mesh.region_attributes = {7};
  made->mesh.region.resize(made->mesh.triangles.size(), no_index);
  const auto t = static_cast<Index>(random.below(made->mesh.triangles.size()));
  made->mesh.region[t] = 0;
  name_triangle(*made, t);
  return made;
}

/// Per vertex, an input point with values that it may have: on a segment one of its ends.
std::vector<Index> points_with_values(const WrongMesh& made) {
  const std::size_t inputs = made.pslg.points.size();
  std::vector<Index> source(made.mesh.points.size(), 0);
  for (Index v = 0; v < inputs; ++v) source[v] = v;
  for (const ConstrainedEdge& e : made.mesh.constrained_edges)
    for (const Index v : {e.a, e.b})
      if (v >= inputs) source[v] = made.pslg.segments[e.segment].a;
  return source;
}

/// Two attributes per point. Those of inserted vertices lie between the others.
std::optional<WrongMesh> with_attributes(Random& random) {
  Drawing drawing = two_squares(random, 0);
  drawing.inner(drawing.place.at(9, 11));
  auto made = drawing.draw();
  if (!made) return made;
  Pslg& pslg = made->pslg;
  Mesh& mesh = made->mesh;
  pslg.attributes_per_point = mesh.attributes_per_point = 2;
  const double base[] = {random.chance(2) ? 0.0 : 1000.0, random.chance(2) ? 0.0 : -1000.0};
  const double width[] = {random.chance(4) ? 0.0 : 10.0, 1.0};
  for (std::size_t i = 0; i < pslg.points.size(); ++i)
    for (int k = 0; k < 2; ++k) pslg.point_attributes.push_back(base[k] + width[k] * random.uniform());
  for (const Index source : points_with_values(*made))
    for (std::size_t k = 0; k < 2; ++k) mesh.point_attributes.push_back(pslg.point_attributes[2 * source + k]);
  return made;
}

/// The least and the greatest value of attribute k.
std::pair<double, double> range_of(const Pslg& pslg, std::size_t k) {
  double least = pslg.point_attributes[k], greatest = least;
  for (std::size_t i = k; i < pslg.point_attributes.size(); i += 2) {
    least = std::min(least, pslg.point_attributes[i]);
    greatest = std::max(greatest, pslg.point_attributes[i]);
  }
  return {least, greatest};
}

bool is_on_segment(const Mesh& mesh, Index v) {
  return std::ranges::any_of(mesh.constrained_edges, [&](const ConstrainedEdge& e) { return e.a == v || e.b == v; });
}

enum class Where : std::uint8_t { anywhere, off_segments };

/// Attribute k of an inserted vertex becomes change(least, greatest).
template <class Change>
std::optional<WrongMesh> change_attribute(Random& random, std::size_t k, Where where, const Change& change) {
  auto made = with_attributes(random);
  if (!made) return made;
  const std::size_t inputs = made->pslg.points.size(), inserted = made->mesh.points.size() - inputs;
  auto v = static_cast<Index>(inputs + random.below(inserted));
  if (where == Where::off_segments && is_on_segment(made->mesh, v)) return std::nullopt;
  const auto [least, greatest] = range_of(made->pslg, k);
  made->mesh.point_attributes[2 * v + k] = change(least, greatest);
  made->fault = {made->mesh.points[v]};
  if (random.chance(3)) make_foreign(*made, random);
  return made;
}

template <std::size_t k>
std::optional<WrongMesh> outside_the_range(std::uint64_t seed) {
  Random random(seed);
  return change_attribute(random, k, Where::anywhere, [&](double least, double greatest) {
    const double largest = std::max(std::abs(least), std::abs(greatest));
    const double by = (largest > 0 ? largest : 1) * some_magnitude(random, 2e-9, 1e6);
    return random.chance(2) ? least - by : greatest + by;
  });
}

std::optional<WrongMesh> not_a_number(std::uint64_t seed) {
  Random random(seed);
  return change_attribute(random, random.below(2), Where::anywhere, [](double, double) { return std::nan(""); });
}

std::optional<WrongMesh> infinite(std::uint64_t seed) {
  Random random(seed);
  return change_attribute(random, random.below(2), Where::anywhere, [&](double, double) {
    const double infinity = std::numeric_limits<double>::infinity();
    return random.chance(2) ? infinity : -infinity;
  });
}

std::optional<WrongMesh> of_an_input_point(std::uint64_t seed) {
  Random random(seed);
  auto made = with_attributes(random);
  if (!made) return made;
  const std::size_t v = random.below(made->pslg.points.size());
  double& value = made->mesh.point_attributes[2 * v + random.below(2)];
  value = std::nextafter(value, random.chance(2) ? 1e9 : -1e9);
  made->fault = {made->mesh.points[v]};
  return made;
}

/// The vertex on the side that two squares share has a value of the input that its ends do not allow. Only pardel's own
/// meshes promise more than the range of the input.
template <bool foreign>
std::optional<WrongMesh> beyond_the_ends(std::uint64_t seed) {
  Random random(seed);
  Drawing drawing(some_place(random));
  const Index a = drawing.point(16, 0), b = drawing.point(16, 16);
  const Index left = drawing.point(0, 0), right = drawing.point(32, 0);
  drawing.ring({left, a, right, drawing.point(32, 16), b, drawing.point(0, 16)});
  const Index middle = drawing.on_at(drawing.segment(a, b), 0.5);
  auto made = drawing.draw();
  if (!made) return made;
  const double base = random.chance(2) ? 0.0 : -1000.0;
  made->pslg.attributes_per_point = made->mesh.attributes_per_point = 1;
  for (Index i = 0; i < made->pslg.points.size(); ++i)
    made->pslg.point_attributes.push_back(base + (i == a ? 2 : i == b ? 3 : random.between(0, 5)));
  made->pslg.point_attributes[right] = base;
  made->pslg.point_attributes[left] = base + 5;
  for (const Index source : points_with_values(*made))
    made->mesh.point_attributes.push_back(made->pslg.point_attributes[source]);
  const double beyond = some_magnitude(random, 1e-5, 2);
  made->mesh.point_attributes[middle] = base + (random.chance(2) ? 2 - beyond : 3 + beyond);
  made->fault = {made->mesh.points[middle]};
  if (foreign) make_foreign(*made, random);
  return made;
}

std::optional<WrongMesh> at_the_end_of_the_range(std::uint64_t seed) {
  Random random(seed);
  return change_attribute(random, random.below(2), Where::off_segments, [&](double least, double greatest) {
    const double by = std::max(std::abs(least), std::abs(greatest)) * 5e-10;
    return random.chance(2) ? least - by : greatest + by;
  });
}

const std::vector<ViolationKind> region{wrong_region};
const std::vector<ViolationKind> attribute{wrong_attribute};

const Kind kinds[] = {
    {"labels", "a face without a seed has the region of its neighbour", region, unseeded_face_takes_the_region<true>},
    {"labels", "a triangle of a face without a seed has a region", region, unseeded_face_takes_the_region<false>},
    {"labels", "triangles of a region have none", region, seeded_face_lost_it},
    {"labels", "a triangle has the region across a segment", region, taken_across},
    {"labels", "two regions are exchanged", region, swapped},
    {"labels", "a triangle has a region, and the domain has none", region, regions_without_seeds},
    {"labels", "the first attribute of an inserted vertex leaves the range", attribute, outside_the_range<0>},
    {"labels", "the second attribute of an inserted vertex leaves the range", attribute, outside_the_range<1>},
    {"labels", "an attribute of an inserted vertex is no number", attribute, not_a_number},
    {"labels", "an attribute of an inserted vertex is infinite", attribute, infinite},
    {"labels", "an attribute of an input point is the next double", attribute, of_an_input_point},
    {"labels", "an attribute on a segment is not between those of the ends", attribute, beyond_the_ends<false>},
    {"right", "an attribute of an inserted vertex is at the end of the range", {}, at_the_end_of_the_range},
    {"right", "in a mesh of others, an attribute on a segment is not between its ends", {}, beyond_the_ends<true>},
};

}  // namespace
}  // namespace labels

std::span<const Kind> kinds_of_labels() { return labels::kinds; }

}  // namespace pardel::wrong_meshes
