// Small angles that seem to have a cause: on something like a shell, beside something like a small input angle.
#include "families.hpp"

namespace pardel::wrong_meshes {
namespace excuses {
namespace {

using generators::Random;
using enum ViolationKind;

/// A wedge with its apex in the origin. Its legs have the directions (radius, 0) and (x, y), of the same length.
struct Wedge {
  double radius, x, y;
  double min_angle;  ///< a bound a little above the least angle across a shell, arctan(sin θ / (2 - cos θ))
};
constexpr Wedge acute[] = {{5, 3, 4, 33}, {5, 4, 3, 33}, {13, 12, 5, 20.7}, {25, 24, 7, 15.5}};
constexpr Wedge wide[] = {{13, 5, 12, 33}, {25, 7, 24, 33}, {5, 0, 5, 33}};

template <std::size_t n>
const Wedge& one_of(const Wedge (&wedges)[n], Random& random) {
  return wedges[random.below(n)];
}

/// How the vertices on the shell belong to the legs.
enum class Ends { none, one, both };

/// The wedge with legs that are `first` and `second` times as long as the radius, and with vertices at a distance of
/// one radius, on the second leg 1 + off radii. An end of a segment may be there, too. The angle to be excused lies at
/// the end of the first leg.
std::optional<WrongMesh> draw_wedge(const Wedge& wedge, double first, double second, const Place& place, double off = 0,
                                    Ends ends = Ends::none, double stray = 0, bool truncated = false) {
  Drawing drawing(place);
  drawing.of.goal.min_angle_deg = wedge.min_angle;
  // An end is one only if the leg turns there. Two collinear segments count as one.
  const double turn = ends == Ends::none ? 0 : wedge.radius / 256;
  const Index far_p = drawing.point(first * wedge.radius, turn),
              far_q = drawing.point(second * wedge.x, second * wedge.y);
  Index start_p = no_index, start_q = no_index, of_p = no_index, of_q = no_index;
  if (truncated) {
    start_p = drawing.point(0.5 * wedge.radius, 0);
    start_q = drawing.point(0.5 * wedge.x, 0.5 * wedge.y);
    drawing.segment(start_p, start_q);
  } else {
    start_p = start_q = drawing.point(0, 0);
  }
  const Point q =
      off == 0 ? place.at(wedge.x, wedge.y) : between(drawing.at(start_q), drawing.at(far_q), (1 + off) / second);
  if (ends == Ends::none) {
    of_p = drawing.segment(start_p, far_p);
  } else {
    const Index p = drawing.point(wedge.radius, 0);
    drawing.segment(start_p, p);
    drawing.segment(p, far_p);
  }
  if (ends == Ends::both) {
    const Index end = drawing.point(q);
    drawing.segment(start_q, end);
    drawing.segment(end, far_q);
  } else {
    of_q = drawing.segment(start_q, far_q);
  }
  drawing.segment(far_p, far_q);
  if (stray > 0) add_stray(drawing, Stray::point, stray);
  if (of_p != no_index) drawing.on(of_p, place.at(wedge.radius, 0));
  if (of_q != no_index) drawing.on(of_q, q);
  drawing.fault({drawing.at(far_p), drawing.at(far_q)}, 0.5);
  return drawing.draw();
}

/// Rings of points at equal distances from a hub are ends of spokes, far inside a square.
std::optional<WrongMesh> hub(std::uint64_t seed) {
  Random random(seed);
  Drawing drawing(some_place(random));
  drawing.of.goal.min_angle_deg = random.chance(2) ? 20.7 : 33;
  const Index centre = drawing.point(0, 0);
  const std::pair<double, double> ring[] = {{65, 0},  {52, 39},   {25, 60},   {0, 65},  {-39, 52}, {-60, 25},
                                            {-65, 0}, {-52, -39}, {-25, -60}, {0, -65}, {39, -52}, {60, -25}};
  for (const auto& [x, y] : ring) drawing.segment(centre, drawing.point(x, y));
  const double far = random.between(1, 1000) * 1000.0;
  drawing.ring(
      {drawing.point(-far, -far), drawing.point(far, -far), drawing.point(far, far), drawing.point(-far, far)});
  drawing.fault({drawing.at(centre)}, 100);
  return drawing.draw();
}

std::optional<WrongMesh> little_below(std::uint64_t seed) {
  Random random(seed);
  const double first = 2 + random.between(1, 16) / 64.0;
  return draw_wedge(one_of(acute, random), first, 2.5, some_place(random, 20));
}

std::optional<WrongMesh> far_below(std::uint64_t seed) {
  Random random(seed);
  const double far = std::round(some_magnitude(random, 4, 1e6));
  return draw_wedge(one_of(acute, random), far, far, some_place(random));
}

std::optional<WrongMesh> unlike_shells(std::uint64_t seed) {
  Random random(seed);
  const double off = some_magnitude(random, 2e-9, 1e-2) * (random.chance(2) ? 1 : -1);
  return draw_wedge(one_of(acute, random), 2, 2.5, some_place(random, 10), off);
}

std::optional<WrongMesh> unlike_shells_by_units_of_a_far_point(std::uint64_t seed) {
  Random random(seed);
  const Wedge& wedge = one_of(acute, random);
  const double off = some_magnitude(random, 2e-9, 1e-2);
  const double stray = std::max(256.0, std::ldexp(off * wedge.radius * 0x1p52, -random.between(0, 3)));
  return draw_wedge(wedge, 2, 2.5, some_place(random, 10), off, Ends::none, stray);
}

std::optional<WrongMesh> more_than_60_degrees(std::uint64_t seed) {
  Random random(seed);
  return draw_wedge(one_of(wide, random), 2, 2.5, some_place(random, 20));
}

template <Ends ends>
std::optional<WrongMesh> at_ends(std::uint64_t seed) {
  Random random(seed);
  return draw_wedge(one_of(acute, random), 2, 2.5, some_place(random, 20), 0, ends);
}

/// The legs do not meet: their apex is cut off.
std::optional<WrongMesh> without_apex(std::uint64_t seed) {
  Random random(seed);
  return draw_wedge(one_of(acute, random), 2, 2.5, some_place(random, 20), 0, Ends::none, 0, true);
}

/// Both other angles of the triangle across a shell are below the bound. Only the one opposite the shell has a cause.
std::optional<WrongMesh> beside_seditious(std::uint64_t seed) {
  Random random(seed);
  auto made = draw_wedge(acute[0], random.chance(2) ? 1.875 : 1.890625, 2.5, some_place(random, 20));
  if (made) {
    made->fault = {made->mesh.points[made->mesh.points.size() - 1]};  // the vertex on the second leg
    made->reach *= 4;
  }
  return made;
}

/// A triangle with two equally small angles, of which one lies between segments.
std::optional<WrongMesh> beside_nestled(std::uint64_t seed) {
  Random random(seed);
  Drawing drawing(some_place(random));
  drawing.of.goal.min_angle_deg = 20;
  const Index a = drawing.point(0, 0), b = drawing.point(4, random.between(1, 16) / 16.0), c = drawing.point(8, 0),
              d = drawing.point(8, 4);
  drawing.ring({a, b, d, c});
  drawing.fault({drawing.at(c)}, 0.5);
  return drawing.draw();
}

/// The ends of the lower side of a square, and the height of a sliver at this side.
struct SliverAtSide {
  Index a, b;
  double y;
};
SliverAtSide square_with_sliver(Drawing& drawing, Random& random) {
  drawing.of.goal.min_angle_deg = 20;
  const double y = random.between(1, 24) / 16.0;
  const Index a = drawing.point(0, 0), b = drawing.point(16, 0);
  drawing.ring({a, b, drawing.point(16, 16), drawing.point(0, 16)});
  return {a, b, y};
}

/// A sliver at a side of a square. `outside`: segments outside the domain meet the corners of the sliver at the same
/// angles.
template <bool outside>
std::optional<WrongMesh> sliver(std::uint64_t seed) {
  Random random(seed);
  Drawing drawing(some_place(random));
  const auto [a, b, y] = square_with_sliver(drawing, random);
  drawing.point(8, y);
  if (outside) {
    drawing.absent_segment(a, drawing.point(-8, y));
    drawing.absent_segment(a, drawing.point(-8, -y));
    drawing.absent_segment(b, drawing.point(24, y));
    drawing.absent_segment(b, drawing.point(24, -y));
  }
  drawing.fault({drawing.at(a), drawing.at(b)}, 0.5);
  return drawing.draw();
}

/// As sliver(), in a corner beside a hole with segments in it.
std::optional<WrongMesh> sliver_at_a_hole(std::uint64_t seed) {
  Random random(seed);
  Drawing drawing(some_place(random));
  const auto [a, b, y] = square_with_sliver(drawing, random);
  drawing.ring({drawing.point(-8, -16), drawing.point(24, -16), drawing.point(24, 32), drawing.point(-8, 32)});
  drawing.hole(8, 8);
  drawing.point(8, -y);
  drawing.absent_segment(a, drawing.point(8, y));
  drawing.absent_segment(b, drawing.point(8, 2 * y));
  drawing.fault({drawing.at(a), drawing.at(b)}, 0.5);
  return drawing.draw();
}

/// A square of six units. The first vertices of the chains at a corner of 90 degrees lie two units off, so that their
/// edges make 11 degrees there. All other angles meet the bound.
std::optional<WrongMesh> between_bent_chains(std::uint64_t seed) {
  Random random(seed);
  const double far = 0x1p52 + 0x1p40;  // one unit is 1 in the lattice
  Drawing drawing(Place{.exponent = random.between(-120, 100), .right = far, .up = far, .swapped = random.chance(2)});
  drawing.of.goal.min_angle_deg = 20.7;
  const Index side = drawing.ring({drawing.point(0, 0), drawing.point(6, 0), drawing.point(6, 6), drawing.point(0, 6)});
  drawing.on(side, drawing.place.at(3, 2));
  drawing.on(side + 1, drawing.place.at(4, 2));
  drawing.on(side + 1, drawing.place.at(4, 4));
  drawing.on(side + 1, drawing.place.at(5, 5));
  drawing.on(side + 2, drawing.place.at(3, 6));
  drawing.on(side + 3, drawing.place.at(2, 3));
  drawing.fault({drawing.place.at(6, 0)}, 0.5);
  return drawing.draw();
}

std::optional<WrongMesh> least_across(std::uint64_t seed) {
  Random random(seed);
  return draw_wedge(one_of(acute, random), 2, 2.5, some_place(random, 20));
}

std::optional<WrongMesh> nestled(std::uint64_t seed) {
  Random random(seed);
  Drawing drawing(some_place(random));
  drawing.of.goal.min_angle_deg = 33;
  drawing.ring({drawing.point(0, 0), drawing.point(16, 0), drawing.point(16, random.between(1, 64) / 16.0)});
  return drawing.draw();
}

const std::vector<ViolationKind> small{small_angle};

const Kind kinds[] = {
    {"excuses", "ends of spokes at equal distances from a hub", small, hub},
    {"excuses", "an angle across a shell is a few per cent too small", small, little_below},
    {"excuses", "an angle across a shell is up to a million times too small", small, far_below},
    {"excuses", "the distances of two shells differ a little", small, unlike_shells},
    {"excuses", "the distances of two shells differ by units of a far point", small,
     unlike_shells_by_units_of_a_far_point},
    {"excuses", "the segments of a shell meet at more than 60 degrees", small, more_than_60_degrees},
    {"excuses", "one of the vertices on a shell is the end of its segment", small, at_ends<Ends::one>},
    {"excuses", "both vertices on a shell are ends of their segments", small, at_ends<Ends::both>},
    {"excuses", "the segments of a shell do not meet", small, without_apex},
    {"excuses", "a second small angle lies beside one across a shell", small, beside_seditious},
    {"excuses", "a second small angle lies beside one between segments", small, beside_nestled},
    {"excuses", "a small angle lies beside a segment", small, sliver<false>},
    {"excuses", "segments outside the domain meet at a small angle", small, sliver<true>},
    {"excuses", "segments in a hole meet at a small angle", small, sliver_at_a_hole},
    {"excuses", "two chains make a small angle at a corner of 90 degrees", small, between_bent_chains},
    {"right", "an angle across a shell is as small as it may be", {}, least_across},
    {"right", "an angle between two segments is small", {}, nestled},
};

}  // namespace
}  // namespace excuses

std::span<const Kind> kinds_of_excuses() { return excuses::kinds; }

}  // namespace pardel::wrong_meshes
