// Points and parts of the domain that have changed to the other side of a chain, within two units.
#include "families.hpp"

namespace pardel::wrong_meshes {
namespace changed_sides {
namespace {

using generators::Random;
using enum ViolationKind;

/// A square, divided at y = 8. Returns the chain that divides it.
Index divided_square(Drawing& drawing) {
  const Index a = drawing.point(0, 8), b = drawing.point(16, 8);
  drawing.ring({drawing.point(0, 0), drawing.point(16, 0), b, drawing.point(16, 16), drawing.point(0, 16), a});
  return drawing.segment(a, b);
}

/// An input point lies a unit beside the segment that divides the square. The chain passes on its other side.
std::optional<WrongMesh> point_beside_a_segment(std::uint64_t seed) {
  Random random(seed);
  Drawing drawing(some_place(random));
  const Beside beside(drawing.place);
  const int side = random.chance(2) ? 1 : -1;
  const Index chain = divided_square(drawing);
  const double x = random.between(2, 14);
  const Index v = drawing.point(beside(x, side));
  drawing.on(chain, beside(x, 2 * side));
  drawing.fault({drawing.at(v)}, 1);
  return finished(drawing, random);
}

/// The segment ends inside the square, so no side is another face.
std::optional<WrongMesh> point_beside_a_segment_with_free_ends(std::uint64_t seed) {
  Random random(seed);
  Drawing drawing(some_place(random));
  const Beside beside(drawing.place);
  const int side = random.chance(2) ? 1 : -1;
  drawing.ring({drawing.point(0, 0), drawing.point(16, 0), drawing.point(16, 16), drawing.point(0, 16)});
  const double x = random.between(5, 11);
  drawing.point(beside(x, side));
  const Index chain = drawing.segment(drawing.point(4, 8), drawing.point(12, 8));
  drawing.on(chain, beside(x, 2 * side));
  return finished(drawing, random);
}

/// A segment of any length, a unit beside the one that divides the square.
std::optional<WrongMesh> segment_beside_a_segment(std::uint64_t seed) {
  Random random(seed);
  Drawing drawing(some_place(random));
  const Beside beside(drawing.place);
  const int side = random.chance(2) ? 1 : -1;
  const Index chain = divided_square(drawing);
  const Index a = drawing.point(beside(5, side)), b = drawing.point(beside(11, side));
  drawing.segment(a, b);
  drawing.on(chain, beside(5, 2 * side));
  drawing.on(chain, beside(11, 2 * side));
  drawing.fault({drawing.at(a), drawing.at(b), drawing.start(chain), drawing.end(chain)}, 1);
  return finished(drawing, random);
}

/// A thin triangle of three segments below a segment whose y is a power of two, so that doubles are denser there.
std::optional<WrongMesh> ring_beside_a_segment(std::uint64_t seed) {
  Random random(seed);
  Place place = some_place(random);
  place.right = place.up = 0;
  place.mirrored = false;
  Drawing drawing(place);
  const Beside beside(drawing.place);
  const Index chain = divided_square(drawing);
  // Two doubles below 8 make one unit of the segment.
  const Index a = drawing.point(beside(5, -1)), b = drawing.point(beside(11, -1)), c = drawing.point(beside(8, -0.5));
  drawing.ring({a, b, c});
  drawing.region(8, 4, 1);
  drawing.on(chain, beside(4.5, -2));
  drawing.on(chain, beside(11.5, -2));
  drawing.fault({drawing.at(a), drawing.at(b), drawing.start(chain), drawing.end(chain)}, 1);
  return finished(drawing, random);
}

/// A square from y = 8 upwards: the domain, or a hole in a larger square. Returns the chain of its lower side.
Index border_at_eight(Drawing& drawing, bool of_hole) {
  const Index chain =
      drawing.ring({drawing.point(0, 8), drawing.point(16, 8), drawing.point(16, 24), drawing.point(0, 24)});
  if (!of_hole) return chain;
  drawing.hole(8, 16);
  drawing.ring({drawing.point(-8, 0), drawing.point(24, 0), drawing.point(24, 32), drawing.point(-8, 32)});
  return chain;
}

/// An input point inside the domain, a unit beside its border, is outside the chain of the border.
template <bool of_hole>
std::optional<WrongMesh> point_lost(std::uint64_t seed) {
  Random random(seed);
  Drawing drawing(some_place(random));
  const Beside beside(drawing.place);
  const Index chain = border_at_eight(drawing, of_hole);
  const int in = of_hole ? -1 : 1;  // the side of the domain
  const double x = random.between(2, 14);
  const Index v = drawing.point(beside(x, in));
  drawing.on(chain, beside(x, 2 * in));
  drawing.fault({drawing.at(v)}, 1);
  return finished(drawing, random);
}

/// A segment a unit beside the border has changed to the outside.
template <bool of_hole>
std::optional<WrongMesh> segment_lost(std::uint64_t seed) {
  Random random(seed);
  Drawing drawing(some_place(random));
  const Beside beside(drawing.place);
  const Index chain = border_at_eight(drawing, of_hole);
  const int in = of_hole ? -1 : 1;  // the side of the domain
  const Index a = drawing.point(beside(5, in)), b = drawing.point(beside(11, in));
  drawing.segment(a, b);
  drawing.on(chain, beside(5, 2 * in));
  drawing.on(chain, beside(11, 2 * in));
  drawing.fault({drawing.at(a), drawing.at(b)}, 1);
  return finished(drawing, random);
}

const std::vector<ViolationKind> face{wrong_face};
const std::vector<ViolationKind> lost{missing_input_vertex, broken_segment, wrong_face};

const Kind kinds[] = {
    {"changed sides", "a point has changed to the other side of a segment", face, point_beside_a_segment},
    {"changed sides", "a segment has changed to the other side of a segment", face, segment_beside_a_segment},
    {"changed sides",
     "a thin face has changed to the other side of a segment",
     {wrong_face, broken_segment},
     ring_beside_a_segment},
    {"changed sides", "a point of the domain lies outside the outline", lost, point_lost<false>},
    {"changed sides", "a point of the domain lies in a hole", lost, point_lost<true>},
    {"changed sides", "a segment of the domain lies outside the outline", lost, segment_lost<false>},
    {"changed sides", "a segment of the domain lies in a hole", lost, segment_lost<true>},
    {"right", "a point lies on the other side of a chain with free ends", {}, point_beside_a_segment_with_free_ends},
};

}  // namespace
}  // namespace changed_sides

std::span<const Kind> kinds_of_changed_sides() { return changed_sides::kinds; }

}  // namespace pardel::wrong_meshes
