// Vertices of chains that lie off their segments: far, but by few units of the largest coordinate of the input; and by
// few units of the segment itself.
#include <functional>

#include "families.hpp"

namespace pardel::wrong_meshes {
namespace moved_chains {
namespace {

using generators::Random;
using enum ViolationKind;

enum class Where { outline, hole, inside, hull };

/// A slanted quadrilateral with a hole and a segment inside. Returns the chain on which vertices are moved.
Index draw_domain(Drawing& drawing, Where where) {
  const std::vector<Index> outline{drawing.point(0, 0), drawing.point(16, 1), drawing.point(15, 16),
                                   drawing.point(1, 15)};
  if (where == Where::hull) {
    drawing.of.goal.convex_hull = true;
    for (std::size_t i = 0; i < 4; ++i) drawing.hull_side(outline[i], outline[(i + 1) % 4]);
    return 0;
  }
  const Index first = drawing.ring(outline);
  const Index of_hole =
      drawing.ring({drawing.point(6, 7), drawing.point(11, 8), drawing.point(10, 12), drawing.point(5, 11)});
  drawing.hole(8, 9);
  const Index inside = drawing.segment(drawing.point(3, 3), drawing.point(13, 5));
  return where == Where::outline ? first : where == Where::hole ? of_hole : inside;
}

/// Inserts vertices into the chain. `move(p, a, b, side)` is where one is put that belongs at p.
template <class Move>
void insert_vertices(Drawing& drawing, Index chain, bool all, Random& random, const Move& move) {
  const Point a = drawing.start(chain), b = drawing.end(chain);
  const std::size_t count = 1 + random.below(4), chosen = random.below(count);
  int side = random.chance(2) ? 1 : -1;
  for (std::size_t i = 0; i < count; ++i) {
    const Point p = between(a, b, double(i + 1) / double(count + 1));
    if (!all && i != chosen) {
      drawing.on(chain, p);
      continue;
    }
    const Index v = drawing.on(chain, move(p, a, b, side));
    drawing.of.fault.push_back(drawing.at(v));
    side = -side;
  }
  drawing.of.fault.insert(drawing.of.fault.end(), {a, b});
}

/// A chain that has a shortcut lies where its segment does, for the checker, unless there is a list of constrained
/// edges.
std::optional<WrongMesh> finished(Drawing& drawing, Index chain, Random& random) {
  auto made = drawing.draw();
  if (made && drawing.has_shortcut(made->mesh, chain)) return std::nullopt;
  if (made && random.chance(3)) make_foreign(*made, random);
  return made;
}

template <Where where, bool all>
std::optional<WrongMesh> far(std::uint64_t seed) {
  Random random(seed);
  const double distance = some_magnitude(random, 0x1p-26, 0.5);
  Drawing drawing(some_place(random, 20));
  const Index chain = draw_domain(drawing, where);
  if (where != Where::hull) add_stray(drawing, some_stray(random), std::max(256.0, far_for(distance, random)));
  drawing.fault({}, 0.5);
  insert_vertices(drawing, chain, all, random, [&](Point p, Point a, Point b, int side) {
    return off_by(p, a, b, drawing.place.length(distance), side);
  });
  return finished(drawing, chain, random);
}

template <Where where>
std::optional<WrongMesh> by_units(std::uint64_t seed) {
  Random random(seed);
  const double units = random.between(3, 16);
  Drawing drawing(some_place(random));
  const Index chain = draw_domain(drawing, where);
  if (where != Where::hull) add_stray(drawing, some_stray(random), some_magnitude(random, 256, 0x1p66));
  drawing.fault({}, 0.5);
  insert_vertices(drawing, chain, random.chance(2), random,
                  [&](Point p, Point a, Point b, int side) { return off_by_units(p, a, b, units, side); });
  return finished(drawing, chain, random);
}

template <Where where>
std::optional<WrongMesh> within(std::uint64_t seed) {
  Random random(seed);
  Drawing drawing(some_place(random, 36));
  const Index chain = draw_domain(drawing, where);
  drawing.fault({}, 0.5);
  insert_vertices(drawing, chain, true, random,
                  [&](Point p, Point a, Point b, int side) { return within_two_units(p, a, b, side); });
  return finished(drawing, chain, random);
}

/// A segment with y = 0 at both ends: its unit in y is the least positive double.
std::optional<WrongMesh> beside_the_axis(std::uint64_t seed) {
  Random random(seed);
  Place place;
  place.exponent = random.between(-60, 100);
  place.swapped = random.chance(2);
  Drawing drawing(place);
  const Index chain =
      drawing.ring({drawing.point(1, 0), drawing.point(17, 0), drawing.point(17, 16), drawing.point(1, 16)});
  const Point a = drawing.start(chain), b = drawing.end(chain), p = place.at(9, 0);
  const double distance = place.length(some_magnitude(random, 0x1p-100, 0x1p-20));
  const Index v = drawing.on(chain, off_by(p, a, b, distance, random.chance(2) ? 1 : -1));
  drawing.fault({drawing.at(v), a, b}, 0.5);
  return finished(drawing, chain, random);
}

/// All coordinates are tiny, so that a fixed least unit would allow everything.
template <bool of_hole>
std::optional<WrongMesh> at_tiny_coordinates(std::uint64_t seed) {
  Random random(seed);
  Place place{.exponent = random.between(-150, -138), .right = 65, .up = 70};
  place.swapped = random.chance(2);
  Drawing drawing(place);
  const Index chain = draw_domain(drawing, of_hole ? Where::hole : Where::outline);
  const double distance = place.length(some_magnitude(random, 0x1p-20, 1));
  drawing.fault({}, 0.5);
  insert_vertices(drawing, chain, true, random,
                  [&](Point p, Point a, Point b, int side) { return off_by(p, a, b, distance, side); });
  return finished(drawing, chain, random);
}

const std::vector<ViolationKind> off{chain_off_segment, broken_segment};

const Kind kinds[] = {
    {"moved chains", "a vertex of the outline lies off by units of a far coordinate", off, far<Where::outline, false>},
    {"moved chains", "all vertices of a side of the outline lie off by units of a far coordinate", off,
     far<Where::outline, true>},
    {"moved chains", "a vertex of a hole lies off by units of a far coordinate", off, far<Where::hole, false>},
    {"moved chains", "all vertices of a side of a hole lie off by units of a far coordinate", off,
     far<Where::hole, true>},
    {"moved chains", "a vertex of a segment inside lies off by units of a far coordinate", off,
     far<Where::inside, false>},
    {"moved chains", "all vertices of a segment inside lie off by units of a far coordinate", off,
     far<Where::inside, true>},
    {"moved chains", "a vertex of the hull lies far off", off, far<Where::hull, false>},
    {"moved chains", "vertices of the outline lie off by 3 to 16 units", off, by_units<Where::outline>},
    {"moved chains", "vertices of a hole lie off by 3 to 16 units", off, by_units<Where::hole>},
    {"moved chains", "vertices of a segment inside lie off by 3 to 16 units", off, by_units<Where::inside>},
    {"moved chains", "vertices of the hull lie off by 3 to 16 units", off, by_units<Where::hull>},
    {"moved chains", "a vertex lies beside a segment on an axis", off, beside_the_axis},
    {"moved chains", "vertices of the outline lie off at tiny coordinates", off, at_tiny_coordinates<false>},
    {"moved chains", "vertices of a hole lie off at tiny coordinates", off, at_tiny_coordinates<true>},
    {"right", "vertices of the outline lie off by at most two units", {}, within<Where::outline>},
    {"right", "vertices of a hole lie off by at most two units", {}, within<Where::hole>},
    {"right", "vertices of a segment inside lie off by at most two units", {}, within<Where::inside>},
    {"right", "vertices of the hull lie off by at most two units", {}, within<Where::hull>},
};

}  // namespace
}  // namespace moved_chains

std::span<const Kind> kinds_of_moved_chains() { return moved_chains::kinds; }

}  // namespace pardel::wrong_meshes
