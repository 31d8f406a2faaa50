#include "wide_corners.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "../../../ref/refinement.hpp"

namespace pardel::properties {
namespace {
using generators::Random;
constexpr double degree = std::numbers::pi / 180;

/// A polygon, counter-clockwise, around the origin. The disk around the origin lies in it.
struct Outline {
  std::vector<Point> corners;
  double inner_radius = 0;
};

double length(Point p) { return std::hypot(p.x, p.y); }

Outline regular(int sides) {
  Outline outline{{}, std::cos(std::numbers::pi / sides)};
  for (int k = 0; k < sides; ++k)
    outline.corners.push_back({std::cos(2 * std::numbers::pi * k / sides), std::sin(2 * std::numbers::pi * k / sides)});
  return outline;
}

/// The angles at the base are `left` and `right` degrees, at least 60; the top is parallel to the base.
Outline quadrangle(double base, double height, double left, double right) {
  const double at_left = height / std::tan(left * degree), at_right = height / std::tan(right * degree);
  const double middle = (at_left - at_right) / 4;
  Outline outline{{{-base / 2, -height / 2},
                   {base / 2, -height / 2},
                   {base / 2 - at_right, height / 2},
                   {-base / 2 + at_left, height / 2}},
                  0};
  for (Point& p : outline.corners) p.x -= middle;
  const double least = std::min(base, base - at_left - at_right) / 2 * std::sin(60 * degree);
  outline.inner_radius = std::min(height / 2, least);
  return outline;
}

Outline some_outline(Random& random) {
  const double steep = random.uniform(60.5, 75);
  switch (random.between(0, 6)) {
    case 0:
      return quadrangle(2, random.chance(2) ? 2 : random.uniform(1, 2), 90, 90);
    case 1:
      return quadrangle(2, random.uniform(1, 1.8), steep, 180 - steep);
    case 2:
      return quadrangle(2, random.uniform(0.8, 1.2), steep, random.uniform(60.5, 90));
    case 3:  // a house: the gable has 60 to 120 degrees
      return {{{-1, -1}, {1, -1}, {1, 0.5}, {0, 0.5 + 1 / std::tan(random.uniform(31, 60) * degree)}, {-1, 0.5}}, 0.6};
    case 4:  // an L
      return {{{-1, -1}, {1, -1}, {1, 0.5}, {0.5, 0.5}, {0.5, 1}, {-1, 1}}, 0.5};
    default:
      return regular(random.between(5, 8));
  }
}

/// Turned about the origin by a right angle or by any angle, stretched, and rounded to multiples of 1/4.
std::vector<Point> placed(const std::vector<Point>& corners, double scale, double turn) {
  std::vector<Point> result;
  const double c = std::cos(turn), s = std::sin(turn);
  for (const Point& p : corners)
    result.push_back(
        {std::round(4 * scale * (c * p.x - s * p.y)) / 4, std::round(4 * scale * (s * p.x + c * p.y)) / 4});
  return result;
}

double some_turn(Random& random) {
  return random.chance(4) ? 90 * random.between(0, 3) * degree : random.uniform(0, 360) * degree;
}

void add_ring(Pslg& pslg, const std::vector<Point>& corners) {
  const auto first = static_cast<Index>(pslg.points.size()), n = static_cast<Index>(corners.size());
  pslg.points.insert(pslg.points.end(), corners.begin(), corners.end());
  for (Index k = 0; k < n; ++k) pslg.segments.push_back({first + k, first + (k + 1) % n});
}

/// Adds a hole, an island, three walls at 120 degrees, a free segment, or nothing. Returns the radius of a disk around
/// the origin that contains what was added.
double add_inside(Pslg& pslg, Random& random, double room) {
  const double radius = room * random.uniform(0.3, 0.6), turn = some_turn(random);
  const auto first = static_cast<Index>(pslg.points.size());
  switch (random.between(0, 5)) {
    case 0:
    case 1:
    case 2:
      add_ring(pslg,
               placed(random.chance(3) ? quadrangle(1.2, 1, 65, 115).corners : regular(random.between(4, 8)).corners,
                      radius, turn));
      if (!random.chance(3)) pslg.holes.push_back({0, 0});
      return radius;
    case 3: {
      std::vector<Point> star = placed(regular(3).corners, radius, turn);
      star.push_back({0, 0});
      pslg.points.insert(pslg.points.end(), star.begin(), star.end());
      for (Index k = 0; k < 3; ++k) pslg.segments.push_back({first + k, first + 3});
      return radius;
    }
    case 4: {
      const std::vector<Point> ends = placed({{-1, 0}, {1, 0}}, radius, turn);
      pslg.points.insert(pslg.points.end(), ends.begin(), ends.end());
      pslg.segments.push_back({first, first + 1});
      return radius;
    }
    default:
      return 0;
  }
}

/// Close above the middle of a side of the outline. It encroaches upon the side, so that a vertex is inserted there.
Point above_a_side(const std::vector<Point>& outline, Random& random, double room) {
  const std::size_t k = random.below(outline.size());
  const Point a = outline[k], b = outline[(k + 1) % outline.size()];
  const double side = length({b.x - a.x, b.y - a.y}), height = room * random.uniform(0.1, 0.25);
  const Point at{(a.x + b.x) / 2 - (b.y - a.y) / side * height, (a.y + b.y) / 2 + (b.x - a.x) / side * height};
  return {std::round(4 * at.x) / 4, std::round(4 * at.y) / 4};
}

/// A square in any direction, or a rhombus of 60.3 degrees whose sides differ by less than one per cent.
Pslg empty_rhombus(Random& random) {
  Pslg pslg;
  const double a = random.between(2, 8), b = random.between(-8, 8), scale = random.between(1, 3);
  if (random.chance(2))
    add_ring(pslg, {{0, 0}, {a, b}, {a - b, a + b}, {-b, a}});
  else
    add_ring(pslg, {{0, 0}, {8 * scale, 0}, {12 * scale, 7 * scale}, {4 * scale, 7 * scale}});
  return pslg;
}

Pslg tried(Random& random, const WideCorners& wanted) {
  if (wanted.empty_ones && random.chance(5)) return empty_rhombus(random);
  const double scale = random.uniform(wanted.least_radius, wanted.most_radius) / std::numbers::sqrt2;
  const Outline outline = some_outline(random);
  const std::vector<Point> corners = placed(outline.corners, scale, some_turn(random));
  Pslg pslg;
  add_ring(pslg, corners);
  const double room = scale * outline.inner_radius - 0.5, taken = add_inside(pslg, random, room);
  const auto add = [&](Point p) {
    if (std::ranges::none_of(pslg.points, [&](Point q) { return length({p.x - q.x, p.y - q.y}) < 0.7; }))
      pslg.points.push_back(p);
  };
  for (int k = random.between(0, wanted.points); k > 0; --k) {
    const double away = random.uniform(taken + 0.7, room), angle = random.uniform(0, 2 * std::numbers::pi);
    if (taken + 0.7 < room) add(placed({{away, 0}}, 1, angle).front());
  }
  if (wanted.points_at_sides && room > 2 && random.chance(2)) add(above_a_side(corners, random, room - taken));
  return pslg;
}

}  // namespace

Pslg random_wide_corners(Random& random, const WideCorners& wanted) {
  for (int attempt = 0; attempt < 20; ++attempt)
    if (Pslg pslg = tried(random, wanted); !ref::unsupported(pslg, {})) return pslg;
  Pslg square;
  add_ring(square, placed({{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}, 8, 0));
  return square;
}

Corners60 kind_of(const Pslg& pslg) {
  Corners60 kind;
  kind.has_hole = !pslg.holes.empty();
  std::vector<std::vector<Point>> ends(pslg.points.size());  // of the segments at each point, relative to it
  for (const Segment& s : pslg.segments) {
    const Point d{pslg.points[s.b].x - pslg.points[s.a].x, pslg.points[s.b].y - pslg.points[s.a].y};
    kind.is_slanted |= d.x != 0 && d.y != 0;
    ends[s.a].push_back(d);
    ends[s.b].push_back({-d.x, -d.y});
  }
  int obtuse = 0;
  for (const std::vector<Point>& here : ends)
    for (std::size_t i = 1; i < here.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) {
        const double dot = here[i].x * here[j].x + here[i].y * here[j].y;
        kind.is_sharp |= dot > std::cos(65 * degree) * length(here[i]) * length(here[j]);
        if (here.size() == 2 && dot < std::cos(100 * degree) * length(here[i]) * length(here[j])) ++obtuse;
      }
  kind.is_no_quadrangle = obtuse >= 3;
  return kind;
}

std::vector<Pslg> with_fewer_points(const Pslg& pslg) {
  std::vector<Pslg> simpler;
  Index first_free = 0;
  for (const Segment& s : pslg.segments) first_free = std::max({first_free, s.a + 1, s.b + 1});
  for (Index i = first_free; i < pslg.points.size(); ++i) {
    simpler.push_back(pslg);
    simpler.back().points.erase(simpler.back().points.begin() + i);
  }
  return simpler;
}

}  // namespace pardel::properties
