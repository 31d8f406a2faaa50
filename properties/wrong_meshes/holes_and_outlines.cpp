// Holes that are filled, faces that are cut off, and outlines with teeth, by few units of the largest coordinate of the
// input.
#include "families.hpp"

namespace pardel::wrong_meshes {
namespace holes_and_outlines {
namespace {

using generators::Random;
using enum ViolationKind;

struct Ring {
  std::vector<Index> corners;
  Index first;  ///< the chain from the first corner to the second
};
Ring square(Drawing& drawing, double low, double high) {
  Ring ring{{drawing.point(low, low), drawing.point(high, low), drawing.point(high, high), drawing.point(low, high)},
            0};
  ring.first = drawing.ring(ring.corners);
  return ring;
}

void name_all_corners(Drawing& drawing, const Ring& ring) {
  for (const Index corner : ring.corners) drawing.of.fault.push_back(drawing.at(corner));
}

/// Side i of the square from low to high gets a vertex at half its length, `in` further inside.
void bend(Drawing& drawing, const Ring& ring, int i, double low, double high, double in) {
  const double middle = (low + high) / 2;
  const std::pair<double, double> at[] = {
      {middle, low + in}, {high - in, middle}, {middle, high - in}, {low + in, middle}};
  const Index v = drawing.on(ring.first + static_cast<Index>(i), drawing.place.at(at[i].first, at[i].second));
  drawing.of.fault.push_back(drawing.at(v));
}

/// The four sides of the hole are bent inwards, so that `most` of the hole is filled.
std::optional<WrongMesh> hole_filled_in_part(std::uint64_t seed) {
  Random random(seed);
  const double in = random.between(1, 15) / 4.0;
  Drawing drawing(some_place(random, 20));
  square(drawing, 0, 16);
  const Ring hole = square(drawing, 4, 12);
  // The middle of the hole is too near to its bent sides to be their seed.
  drawing.of.pslg.holes.push_back(drawing.place.at(4.5, 4.75));
  drawing.gap(drawing.place.at(8, 8));
  add_stray(drawing, some_stray(random), std::max(256.0, far_for(in, random)));
  drawing.fault({}, 2);
  name_all_corners(drawing, hole);
  for (int i = 0; i < 4; ++i) bend(drawing, hole, i, 4, 12, in);
  return finished(drawing, random);
}

/// The chains of opposite sides of the hole pass the same vertex in its middle.
std::optional<WrongMesh> hole_filled(std::uint64_t seed) {
  Random random(seed);
  Drawing drawing(some_place(random, 20));
  square(drawing, 0, 16);
  const Ring hole = square(drawing, 4, 12);
  drawing.of.pslg.holes.push_back(drawing.place.at(8, 8.5));
  add_stray(drawing, some_stray(random), std::max(256.0, far_for(4, random)));
  const Index v = drawing.on(hole.first, drawing.place.at(8, 8));
  for (Index side = 1; side < 4; ++side) drawing.pass(hole.first + side, v);
  drawing.fault({drawing.at(v)}, 8);
  name_all_corners(drawing, hole);
  return finished(drawing, random);
}

/// Something outside the outline, so that there is an outside.
Stray some_stray_outside(Random& random) {
  const Stray stray = some_stray(random);
  return stray == Stray::outline_around ? Stray::point : stray;
}

/// One side of the outline is bent: inwards it cuts off a part of the square, outwards it adds one.
template <bool inwards>
std::optional<WrongMesh> outline_bent(std::uint64_t seed) {
  Random random(seed);
  const double in = (inwards ? 1 : -1) * random.between(1, inwards ? 60 : 200) / 8.0;
  Drawing drawing(some_place(random, 20));
  const Ring outline = square(drawing, 16, 32);
  add_stray(drawing, some_stray_outside(random), std::max(256.0, far_for(std::abs(in), random)));
  drawing.fault({}, 2);
  name_all_corners(drawing, outline);
  bend(drawing, outline, random.between(0, 3), 16, 32, in);
  return finished(drawing, random);
}

/// A saw: the vertices of a side lie alternately on it and beside it.
template <bool inwards>
std::optional<WrongMesh> outline_with_teeth(std::uint64_t seed) {
  Random random(seed);
  const double in = (inwards ? 1 : -1) * some_magnitude(random, 0x1p-20, 6);
  Drawing drawing(some_place(random, 20));
  const Ring outline = square(drawing, 16, 32);
  add_stray(drawing, some_stray_outside(random), std::max(256.0, far_for(std::abs(in), random)));
  drawing.fault({}, 2);
  name_all_corners(drawing, outline);
  const int teeth = random.between(1, 4);
  for (int i = 0; i < 2 * teeth - 1; ++i) {
    const Index v =
        drawing.on(outline.first, drawing.place.at(16 + 16.0 * (i + 1) / (2 * teeth), i % 2 == 0 ? 16 + in : 16));
    drawing.of.fault.push_back(drawing.at(v));
  }
  return finished(drawing, random);
}

/// Two squares share a side. The chain of this side is bent so far that nearly all of one face belongs to the other.
std::optional<WrongMesh> face_given_away(std::uint64_t seed) {
  Random random(seed);
  const double in = random.between(1, 30) / 4.0;
  Drawing drawing(some_place(random, 20));
  const Index a = drawing.point(8, 0), b = drawing.point(8, 8);
  drawing.ring({drawing.point(0, 0), a, drawing.point(16, 0), drawing.point(16, 8), b, drawing.point(0, 8)});
  const Index shared = drawing.segment(a, b);
  drawing.region(0.25, 4, 1);
  drawing.region(15.875, 4, 2);
  add_stray(drawing, some_stray(random), std::max(256.0, far_for(in, random)));
  const Index v = drawing.on(shared, drawing.place.at(random.chance(2) ? 8 + in : 8 - in, 4));
  drawing.fault({drawing.at(v), drawing.start(shared), drawing.end(shared)}, 8);
  return finished(drawing, random);
}

// A chain that is bent outwards may leave an edge on its segment. Then what was added lies outside the domain.
const std::vector<ViolationKind> bent{chain_off_segment, broken_segment, covered_exterior};

const Kind kinds[] = {
    {"holes and outlines", "a part of a hole is filled", bent, hole_filled_in_part},
    {"holes and outlines", "a hole is filled", bent, hole_filled},
    {"holes and outlines", "a part of the domain is cut off", bent, outline_bent<true>},
    {"holes and outlines", "a part of the outside is added", bent, outline_bent<false>},
    {"holes and outlines", "an outline has dents", bent, outline_with_teeth<true>},
    {"holes and outlines", "an outline has teeth", bent, outline_with_teeth<false>},
    {"holes and outlines",
     "a face gives its triangles to its neighbour",
     {chain_off_segment, broken_segment, wrong_region},
     face_given_away},
};

}  // namespace
}  // namespace holes_and_outlines

std::span<const Kind> kinds_of_holes_and_outlines() { return holes_and_outlines::kinds; }

}  // namespace pardel::wrong_meshes
