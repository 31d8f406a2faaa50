// Chains of segments that do not meet, or meet elsewhere, share vertices and edges. Each chain lies within two units of
// its segment.
#include "families.hpp"

namespace pardel::wrong_meshes {
namespace pinched_chains {
namespace {

using generators::Random;
using enum ViolationKind;

/// A square from 0 to 16 with lines of y = 8 and of a few units more.
struct Strip {
  explicit Strip(Random& random) : drawing(some_place(random)), unit(unit_at_the_middle()) {
    units = random.between(1, 4);
  }

  /// A point of the lattice with y = 8, a number of units off.
  [[nodiscard]] Point beside(double x, int units_off) const {
    Point p = drawing.place.at(x, 8);
    (drawing.place.swapped ? p.x : p.y) += units_off * unit;
    return p;
  }
  /// A vertex within two units of both lines.
  [[nodiscard]] Point shared(double x) const { return beside(x, units / 2); }
  void outline() {
    drawing.ring({drawing.point(0, 0), drawing.point(16, 0), drawing.point(16, 16), drawing.point(0, 16)});
  }
  /// The border of a hole above the upper line. Returns the chain on this line.
  Index border_of_hole() {
    return drawing.ring({drawing.point(beside(4, units)), drawing.point(beside(12, units)), drawing.point(12, 12),
                         drawing.point(4, 12)});
  }

  Drawing drawing;
  double unit;
  int units;  ///< how far the two lines are apart

 private:
  [[nodiscard]] double unit_at_the_middle() const {
    const Point p = drawing.place.at(8, 8);
    return spacing(drawing.place.swapped ? p.x : p.y);
  }
};

template <int vertices>
std::optional<WrongMesh> two_segments(std::uint64_t seed) {
  Random random(seed);
  Strip strip(random);
  Drawing& drawing = strip.drawing;
  strip.outline();
  const Index low = drawing.segment(drawing.point(strip.beside(4, 0)), drawing.point(strip.beside(12, 0)));
  const Index high =
      drawing.segment(drawing.point(strip.beside(4.5, strip.units)), drawing.point(strip.beside(11.5, strip.units)));
  for (int i = 0; i < vertices; ++i) drawing.pass(high, drawing.on(low, strip.shared(6 + 2 * i)));
  drawing.fault({strip.shared(8)}, 4.5);
  return finished(drawing, random);
}

/// The two segments and two short ones bound a face, with a region. In the mesh the face exists at its ends only.
std::optional<WrongMesh> closed_strip(std::uint64_t seed) {
  Random random(seed);
  Strip strip(random);
  Drawing& drawing = strip.drawing;
  strip.outline();
  const Index a = drawing.point(strip.beside(4, 0)), b = drawing.point(strip.beside(12, 0));
  const Index c = drawing.point(strip.beside(12, strip.units)), d = drawing.point(strip.beside(4, strip.units));
  const Index low = drawing.ring({a, b, c, d});
  drawing.region(2, 2, 1);
  const Index v = drawing.on(low, strip.shared(6)), w = drawing.on(low, strip.shared(10));
  drawing.pass(low + 2, w);
  drawing.pass(low + 2, v);
  drawing.fault({strip.shared(8)}, 4.5);
  return finished(drawing, random);
}

/// A hole lies a few units from the outline, and both pass the same inserted vertex.
template <bool edge>
std::optional<WrongMesh> hole_at_the_outline(std::uint64_t seed) {
  Random random(seed);
  Strip strip(random);
  Drawing& drawing = strip.drawing;
  const Index low = drawing.ring({drawing.point(strip.beside(0, 0)), drawing.point(strip.beside(16, 0)),
                                  drawing.point(16, 24), drawing.point(0, 24)});
  const Index high = strip.border_of_hole();
  drawing.hole(8, 10);
  drawing.pass(high, drawing.on(low, strip.shared(6)));
  if (edge) drawing.pass(high, drawing.on(low, strip.shared(10)));
  drawing.fault({strip.shared(8)}, 4.5);
  return finished(drawing, random);
}

std::optional<WrongMesh> two_holes(std::uint64_t seed) {
  Random random(seed);
  Strip strip(random);
  Drawing& drawing = strip.drawing;
  strip.outline();
  const Index low = drawing.ring({drawing.point(strip.beside(4, 0)), drawing.point(strip.beside(12, 0)),
                                  drawing.point(12, 4), drawing.point(4, 4)});
  const Index high = strip.border_of_hole();
  drawing.hole(8, 6);
  drawing.hole(8, 10);
  for (int i = random.between(1, 2); i > 0; --i) drawing.pass(high, drawing.on(low, strip.shared(12 - 3 * i)));
  drawing.fault({strip.shared(8)}, 4.5);
  return finished(drawing, random);
}

std::optional<WrongMesh> segment_at_a_hole(std::uint64_t seed) {
  Random random(seed);
  Strip strip(random);
  Drawing& drawing = strip.drawing;
  strip.outline();
  const Index low = drawing.segment(drawing.point(strip.beside(3, 0)), drawing.point(strip.beside(13, 0)));
  const Index high = strip.border_of_hole();
  drawing.hole(8, 10);
  for (int i = random.between(1, 2); i > 0; --i) drawing.pass(high, drawing.on(low, strip.shared(12 - 3 * i)));
  drawing.fault({strip.shared(8)}, 5.5);
  return finished(drawing, random);
}

/// Two segments with a common end nearly coincide.
std::optional<WrongMesh> segments_with_a_common_end(std::uint64_t seed) {
  Random random(seed);
  Strip strip(random);
  Drawing& drawing = strip.drawing;
  strip.outline();
  const Index apex = drawing.point(strip.beside(4, 0));
  const Index low = drawing.segment(apex, drawing.point(strip.beside(12, 0)));
  const Index high = drawing.segment(apex, drawing.point(strip.beside(12, strip.units)));
  drawing.pass(high, drawing.on(low, strip.shared(10)));
  drawing.fault({strip.shared(8)}, 4.5);
  return finished(drawing, random);
}

std::optional<WrongMesh> three_segments(std::uint64_t seed) {
  Random random(seed);
  Strip strip(random);
  Drawing& drawing = strip.drawing;
  strip.outline();
  std::vector<Index> chains;
  for (int i = 0; i < 3; ++i)
    chains.push_back(
        drawing.segment(drawing.point(strip.beside(4 + i * 0.5, i)), drawing.point(strip.beside(12 - i * 0.5, i))));
  const Index v = drawing.on(chains[0], strip.beside(8, 1));
  drawing.pass(chains[1], v);
  drawing.pass(chains[2], v);
  drawing.fault({strip.shared(8)}, 4.5);
  return finished(drawing, random);
}

/// The chain of a segment passes an input point a unit or two beside it, where it does not end.
std::optional<WrongMesh> through_an_input_point(std::uint64_t seed) {
  Random random(seed);
  Strip strip(random);
  Drawing& drawing = strip.drawing;
  strip.outline();
  const int off = random.between(1, 2) * (random.chance(2) ? 1 : -1);
  const Index v = drawing.point(strip.beside(8, off));
  const Index chain = drawing.segment(drawing.point(strip.beside(4, 0)), drawing.point(strip.beside(12, 0)));
  drawing.pass(chain, v);
  drawing.fault({drawing.at(v)}, 4.5);
  return finished(drawing, random);
}

/// The end of another segment, a unit or two beside the outline, lies on the chain of the outline.
std::optional<WrongMesh> outline_through_the_end_of_a_segment(std::uint64_t seed) {
  Random random(seed);
  Strip strip(random);
  Drawing& drawing = strip.drawing;
  const Index low = drawing.ring({drawing.point(strip.beside(0, 0)), drawing.point(strip.beside(16, 0)),
                                  drawing.point(16, 24), drawing.point(0, 24)});
  const Index v = drawing.point(strip.beside(8, random.between(1, 2)));
  drawing.segment(v, drawing.point(8, 16));
  drawing.pass(low, v);
  drawing.fault({drawing.at(v), drawing.start(low)}, 2);
  return finished(drawing, random);
}

const std::vector<ViolationKind> pinched{chains_meet, chain_off_segment, broken_segment};
const std::vector<ViolationKind> passes{chains_meet, chain_off_segment, broken_segment, wrong_face};

const Kind kinds[] = {
    {"pinched chains", "two segments that do not meet share a vertex", pinched, two_segments<1>},
    {"pinched chains", "two segments that do not meet share an edge", pinched, two_segments<2>},
    {"pinched chains", "the two sides of a thin face share an edge", pinched, closed_strip},
    {"pinched chains", "a hole is glued to the outline at a vertex", pinched, hole_at_the_outline<false>},
    {"pinched chains", "a hole is glued to the outline at an edge", pinched, hole_at_the_outline<true>},
    {"pinched chains", "two holes are glued", pinched, two_holes},
    {"pinched chains", "a segment inside is glued to a hole", pinched, segment_at_a_hole},
    {"pinched chains", "two segments with a common end meet again", pinched, segments_with_a_common_end},
    {"pinched chains", "three segments share a vertex", pinched, three_segments},
    {"pinched chains", "a chain passes an input point beside its segment", passes, through_an_input_point},
    {"pinched chains", "the outline passes the end of a segment inside", passes, outline_through_the_end_of_a_segment},
};

}  // namespace
}  // namespace pinched_chains

std::span<const Kind> kinds_of_pinched_chains() { return pinched_chains::kinds; }

}  // namespace pardel::wrong_meshes
