// Generates a random domain of each family: first the part that has the trait, then further parts that keep the trait.
#include <algorithm>
#include <cstdlib>

#include "lattice/determinants.hpp"
#include "lattice/draft.hpp"
#include "lattice/shapes.hpp"
#include "lattice_domain.hpp"

namespace pardel::generators {
namespace {

/// The state of the generation of one domain. `size` is from 0 to 100.
struct Drawing {
  Draft draft;
  Random& random;
  int size;

  /// A random number from `least` to a bound that grows with the size up to `most`.
  int some(int least, int most) { return random.between(least, least + (most - least) * size / 100); }
  bool chance(int one_in) { return random.chance(one_in); }
  LatticePoint inside(int side) { return anywhere(random, 1, side - 1); }
};

void add_hole(Draft& draft, const Contour& ring) {
  draft.polygon(ring);
  draft.hole_left_of(ring[0], ring[1]);
}

/// Adds rings (about half of them become holes) and points in [0, side]^2, if they fit.
void fill_up(Drawing& d, int side, int rings, int points) {
  for (int i = d.some(0, rings); i > 0; --i) {
    const Contour ring = small_ring(d.random, d.inside(side), std::max(2, side / 6));
    if (d.draft.free_polygon(ring) && d.chance(2)) d.draft.hole_left_of(ring[0], ring[1]);
  }
  for (int i = d.some(0, points); i > 0; --i) d.draft.free_point(d.inside(side));
}

void join_some_points(Drawing& d, int segments) {
  for (int i = d.some(0, segments); i > 0; --i) {
    const LatticePoint a = d.random.one_of(d.draft.points());
    d.draft.segment(a, d.random.one_of(d.draft.points()));
  }
}

/// True if p is on no circle through three of the points and not nearly collinear with two of them. (The number of
/// triangles that a sliver needs grows with its thinness.)
bool is_in_general_position(const Contour& points, LatticePoint p) {
  constexpr std::int64_t least_height = 4;
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const std::int64_t longest = width({points[i], points[j], p}) * least_height;
      if (std::abs(turn(points[i], points[j], p)) <= longest) return false;
      for (std::size_t k = 0; k < j; ++k)
        if (in_circle(points[i], points[j], points[k], p) == 0) return false;
    }
  return true;
}

void draw_general_position(Drawing& d) {
  // Start with a triangle without small angles, because the mesh of a thin hull needs very many triangles.
  const auto near = [&](int x, int y) { return LatticePoint{x, y} + anywhere(d.random, -150, 150); };
  for (const LatticePoint p : {near(0, 0), near(1000, 0), near(500, 1000)}) d.draft.point(p);
  // In the end about one place in eight is still suitable.
  const auto n = static_cast<std::size_t>(d.some(4, 24));
  while (d.draft.points().size() < n) {
    const LatticePoint p = anywhere(d.random, 0, 1000);
    if (is_in_general_position(d.draft.points(), p)) d.draft.point(p);
  }
  if (d.chance(3)) return;  // points alone
  d.draft.hull();
  join_some_points(d, 20);
  for (int i = d.some(0, 3); i > 0; --i) {
    const LatticePoint a = d.random.one_of(d.draft.points());
    d.draft.hole_left_of(a, d.random.one_of(d.draft.points()));
  }
}

/// The twelve lattice points on the circle of radius 5 around the middle of [0, 10]^2, multiplied by `unit`.
Contour dodecagon(int unit) {
  Contour contour = {{10, 5}, {9, 8}, {8, 9}, {5, 10}, {2, 9}, {1, 8}, {0, 5}, {1, 2}, {2, 1}, {5, 0}, {8, 1}, {9, 2}};
  for (LatticePoint& p : contour) p = unit * p;
  return contour;
}

void draw_cocircular_circle(Drawing& d) {
  const int unit = d.random.between(1, 4);
  d.draft.polygon(dodecagon(unit));
  if (d.chance(2)) d.draft.point({5 * unit, 5 * unit});
  join_some_points(d, 12);
}

void draw_cocircular_grid(Drawing& d) {
  if (d.chance(4)) return draw_cocircular_circle(d);
  const int columns = d.some(2, 6), rows = d.some(2, 6), gap = d.random.between(1, 4);
  const auto node = [&](int i, int j) { return LatticePoint{i * gap, j * gap}; };
  const bool with_gaps = columns * rows >= 9 && d.chance(2);
  for (int i = 0; i <= columns; ++i)
    for (int j = 0; j <= rows; ++j)
      if (!with_gaps || !d.chance(10)) d.draft.point(node(i, j));
  d.draft.polygon(box({0, 0}, columns * gap, rows * gap));
  const int one_in = d.random.between(2, 8);
  for (int i = 0; i < columns; ++i)
    for (int j = 0; j < rows; ++j) {
      if (d.chance(one_in)) d.draft.segment(node(i, j), node(i + 1, j));
      if (d.chance(one_in)) d.draft.segment(node(i, j), node(i, j + 1));
      if (d.chance(2 * one_in)) d.draft.segment(node(i, j), node(i + 1, j + 1));
      if (d.chance(4 * one_in)) add_hole(d.draft, box(node(i, j), gap, gap));
    }
}

void draw_collinear_runs(Drawing& d) {
  constexpr int divisible = 12;
  const int cells = d.random.between(2, 5), side = 4 * cells * divisible;
  Contour outline = any_outline(d.random, 4 * cells, 6);
  for (LatticePoint& p : outline) p = divisible * p;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const LatticePoint a = outline[i], along = outline[(i + 1) % outline.size()] - a;
    const int parts = i == 0 || d.chance(2) ? d.random.one_of<int>({2, 3, 4, 6}) : 1;
    for (int k = 0; k < parts; ++k) d.draft.point(a + LatticePoint{along.x / parts * k, along.y / parts * k});
  }
  d.draft.polygon(outline);
  for (int rows = d.some(0, 3); rows > 0; --rows) {
    const LatticePoint start = d.inside(side / 2), step = anywhere(d.random, 0, side / 8);
    const int points = d.random.between(3, 5);
    for (int k = 0; k < points; ++k) d.draft.free_point(start + k * step);
    if (d.chance(2)) d.draft.segment(start, start + (points - 1) * step);
  }
}

void draw_near_duplicates(Drawing& d) {
  const int side = 1 << d.random.between(10, 13);
  d.draft.polygon(d.chance(2) ? box({0, 0}, side, side) : cut_box(d.random, {0, 0}, side, side));
  const auto somewhere = [&] { return anywhere(d.random, side / 3, side - side / 3); };
  for (int pairs = d.some(1, 5); pairs > 0; --pairs) {
    const LatticePoint p = somewhere();
    const LatticePoint q = p + d.random.one_of<LatticePoint>({{1, 0}, {0, 1}, {1, 1}, {-1, 0}, {1, -1}});
    d.draft.point(p);
    d.draft.point(q);
    if (d.chance(3)) d.draft.segment(p, somewhere());
    if (d.chance(4)) d.draft.segment(p, q);
  }
  if (d.chance(3)) {  // two vertices of a long side, one next to it
    const int x = d.random.between(side / 3, side / 2);
    d.draft.point({x, 0});
    if (d.chance(2)) d.draft.point({x + 1, 0});
    if (d.chance(2)) d.draft.point({x, 1});
  }
  fill_up(d, side, 2, 8);
}

/// p, rotated by `times` quarter turns.
LatticePoint turned(LatticePoint p, int times) {
  for (; times > 0; --times) p = {-p.y, p.x};
  return p;
}

void draw_spike(Drawing& d) {
  const int length = d.random.between(16, 100), height = d.random.between(1, length / 5);
  d.draft.polygon({{0, 0}, {length, 0}, {length, height}});
  for (int i = d.some(0, 3); i > 0; --i) d.draft.segment({0, 0}, {length, d.random.between(0, height)});
}

void draw_small_angles(Drawing& d) {
  if (d.chance(4)) return draw_spike(d);
  const int side = d.random.between(72, 128);
  d.draft.polygon(box({0, 0}, side, side));
  for (int fans = d.some(1, 3); fans > 0; --fans) {
    const LatticePoint apex = anywhere(d.random, side / 3, side - side / 3);
    const int reach = d.random.between(8, side / 6 - 1), first = d.random.between(0, reach / 2);
    const int direction = d.random.between(0, 3);
    for (int k = d.some(1, 4); k >= 0; --k)
      d.draft.segment(apex, apex + d.random.between(1, 2) * turned({reach, first + k}, direction));
  }
  fill_up(d, side, 3, 10);
}

void draw_parallels(Drawing& d) {
  struct Slant {
    LatticePoint along, apart;
  };
  const auto [along, apart] = d.random.one_of<Slant>(
      {{{1, 0}, {0, 1}}, {{1, 0}, {0, 2}}, {{0, 1}, {1, 0}}, {{1, 1}, {1, 0}}, {{2, 1}, {0, 1}}, {{1, 3}, {1, 1}}});
  const auto least = static_cast<int>(20 * std::abs(cross(along, apart)) / dot(along, along)) + 1;
  const int length = d.random.between(least, 2 * least), lines = d.some(2, 5);
  const LatticePoint start{8, 8}, reach = length * along;
  d.draft.polygon(box({0, 0}, reach.x + 32, reach.y + 32));
  for (int i = 0; i < lines; ++i) {
    const LatticePoint from = start + i * apart + d.random.between(0, length / 4) * along;
    d.draft.segment(from, from + reach);
  }
  fill_up(d, static_cast<int>(std::min(reach.x, reach.y)) + 32, 2, 8);
}

void draw_comb(Drawing& d) {
  const int teeth = d.some(1, 4), gauge = d.random.between(1, 3), spacing = gauge * d.random.between(2, 8);
  const int bar = gauge * d.random.between(2, 10), top = bar + gauge * d.random.between(21, 30);
  const int length = teeth * (gauge + spacing) + spacing;
  Contour outline = {{0, 0}, {length, 0}, {length, bar}};
  for (int i = teeth; i > 0; --i) {
    const int right = i * (gauge + spacing), left = right - gauge;
    outline.insert(outline.end(), {{right, bar}, {right, top}, {left, top}, {left, bar}});
  }
  outline.push_back({0, bar});
  d.draft.polygon(outline);
}

void draw_slot(Drawing& d) {
  const int gauge = d.random.between(1, 3), length = gauge * d.random.between(21, 40), side = length + 20;
  d.draft.polygon(box({0, 0}, side, side));
  const LatticePoint corner{gauge, d.random.between(2, 18)};
  add_hole(d.draft, box(corner, d.random.between(1, side / 3), length));
  fill_up(d, side, 3, 10);
}

void draw_thin_channels(Drawing& d) {
  switch (d.random.below(3)) {
    case 0:
      return draw_parallels(d);
    case 1:
      return draw_comb(d);
    default:
      return draw_slot(d);
  }
}

void draw_nested_holes(Drawing& d) {
  const int rings = d.some(3, 5);
  int side = 10 * rings + d.random.between(0, 30);
  LatticePoint corner{0, 0};
  for (int i = 0; i < rings; ++i) {
    const Contour ring = d.chance(2) ? box(corner, side, side) : cut_box(d.random, corner, side, side);
    d.draft.polygon(ring);
    if (i % 2 == 1) d.draft.hole_left_of(ring[0], ring[1]);
    // The next ring must not reach the cut corners. A cut takes less than a third of each of the two sides.
    const int inset = side / 6 + d.random.between(1, 2);
    corner = corner + LatticePoint{inset, inset};
    side -= 2 * inset + d.random.between(0, 1);
    if (side < 2) break;
  }
  fill_up(d, 10 * rings, 2, 10);
}

/// Diamonds in a column that touch each other. The lowest diamond may touch the outline.
void draw_diamonds(Drawing& d) {
  const int w = d.random.between(2, 8), h = d.random.between(2, 6), diamonds = d.some(2, 4);
  LatticePoint bottom{d.random.between(w + 2, 20), d.random.between(0, 2)};
  d.draft.polygon(box({0, 0}, 32, 2 * h * diamonds + 8));
  for (int i = 0; i < diamonds; ++i) {
    const LatticePoint top = bottom + LatticePoint{0, 2 * h};
    add_hole(d.draft, {bottom, bottom + LatticePoint{w, h}, top, bottom + LatticePoint{-w, h}});
    bottom = top;
  }
}

/// Boxes and triangles along a diagonal that touch in corners.
void draw_stairs(Drawing& d) {
  LatticePoint at = anywhere(d.random, 1, 6);
  Contour stairs = {at};
  for (int steps = d.some(2, 5); steps > 0; --steps) stairs.push_back(stairs.back() + anywhere(d.random, 2, 7));
  const LatticePoint end = stairs.back() + anywhere(d.random, 1, 6);
  d.draft.polygon(box({0, 0}, end.x, end.y));
  for (std::size_t i = 1; i < stairs.size(); ++i) {
    const LatticePoint low = stairs[i - 1], high = stairs[i];
    if (d.chance(2)) {
      add_hole(d.draft, box(low, high.x - low.x, high.y - low.y));
    } else {
      add_hole(d.draft, {low, {high.x, low.y}, high});
    }
  }
}

void draw_touching_holes(Drawing& d) {
  if (d.chance(2)) {
    draw_diamonds(d);
  } else {
    draw_stairs(d);
  }
  fill_up(d, 32, 2, 8);
}

void draw_cracks(Drawing& d) {
  const int side = d.random.between(12, 36), margin = side / 3;
  d.draft.polygon(d.chance(2) ? box({0, 0}, side, side) : cut_box(d.random, {0, 0}, side, side));
  const auto is_free = [&](LatticePoint place) {
    Draft tried = d.draft;
    return tried.free_point(place);
  };
  LatticePoint tip{margin, margin};
  for (int legs = d.some(1, 16); legs > 0; --legs) {
    // Every leg ends at a free place, so at least one leg has a free end.
    const LatticePoint to = anywhere(d.random, margin + 1, side - margin);
    if (is_free(to) && d.draft.segment(tip, to)) tip = to;
    if (d.chance(3)) tip = d.random.one_of(d.draft.points());
    if (d.chance(4)) tip = anywhere(d.random, margin, side - margin);
  }
  fill_up(d, side, 3, 8);
}

void draw_isolated_points(Drawing& d) {
  const int side = 2 * d.random.between(8, 32);
  const LatticePoint centre{side / 2, side / 2};
  d.draft.polygon(d.chance(2) ? star(d.random, side / 2, d.some(5, 16)) : cut_box(d.random, {0, 0}, side, side));
  d.draft.free_point(centre);
  fill_up(d, side, 4, 24);
}

void draw(Family family, Drawing& d) {
  switch (family) {
    case Family::general_position:
      return draw_general_position(d);
    case Family::cocircular_grid:
      return draw_cocircular_grid(d);
    case Family::collinear_runs:
      return draw_collinear_runs(d);
    case Family::near_duplicates:
      return draw_near_duplicates(d);
    case Family::small_angles:
      return draw_small_angles(d);
    case Family::thin_channels:
      return draw_thin_channels(d);
    case Family::nested_holes:
      return draw_nested_holes(d);
    case Family::touching_holes:
      return draw_touching_holes(d);
    case Family::cracks:
      return draw_cracks(d);
    case Family::isolated_points:
      return draw_isolated_points(d);
    case Family::far_offset:
      return;
  }
}

/// A domain of another family, moved far away.
LatticeDomain far_away(Random& random, int size) {
  std::vector<Family> others = all_families();
  std::erase(others, Family::far_offset);
  LatticeDomain domain = generate(random.one_of(others), random, size);
  domain.family = Family::far_offset;
  const std::int64_t least = width(domain.points) << 20;
  const auto distance = [&] {
    const auto beyond = static_cast<std::int64_t>(random.below(static_cast<std::size_t>(least)));
    return random.chance(2) ? least + beyond : -least - beyond;
  };
  domain.offset = {distance(), random.chance(3) ? 0 : distance()};
  return domain;
}

}  // namespace

LatticeDomain generate(Family family, Random& random, int size) {
  if (family == Family::far_offset) return far_away(random, size);
  Drawing drawing{{}, random, size};
  draw(family, drawing);
  LatticeDomain domain = drawing.draft.finished(random, drawing.chance(3) ? drawing.some(1, 3) : 0);
  domain.family = family;
  if (random.chance(4)) domain.offset = anywhere(random, -1000, 1000);
  if (random.chance(4)) domain.exponent = random.between(-10, 30);
  return domain;
}

LatticeDomain any_domain(Random& random, int size) {
  LatticeDomain domain = generate(random.one_of(all_families()), random, size);
  // Not drawn from `random`, so that the geometry of later domains does not depend on decorations.
  Random of_domain(static_cast<std::uint64_t>(weight(domain).magnitude));
  domain.decorations = any_switches<Decorations>(of_domain);
  return domain;
}

}  // namespace pardel::generators
