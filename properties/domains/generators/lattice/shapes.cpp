#include "shapes.hpp"

#include <algorithm>

#include "determinants.hpp"

namespace pardel::generators {

LatticePoint anywhere(Random& random, int low, int high) {
  const int x = random.between(low, high);
  return {x, random.between(low, high)};
}

Contour box(LatticePoint corner, std::int64_t width, std::int64_t height) {
  return {corner, corner + LatticePoint{width, 0}, corner + LatticePoint{width, height},
          corner + LatticePoint{0, height}};
}

Contour cut_box(Random& random, LatticePoint corner, int width, int height) {
  const Contour corners = box(corner, width, height);
  const int most = (std::min(width, height) - 1) / 3;
  Contour contour;
  for (std::size_t i = 0; i < 4; ++i) {
    const int cut = most > 0 && random.chance(2) ? random.between(1, most) : 0;
    const LatticePoint at = corners[i], in = corners[(i + 3) % 4] - at, out = corners[(i + 1) % 4] - at;
    const auto step = [&](LatticePoint along) {
      const auto sign = [](std::int64_t x) { return (x > 0) - (x < 0); };
      return at + LatticePoint{cut * sign(along.x), cut * sign(along.y)};
    };
    contour.push_back(step(in));
    if (cut > 0) contour.push_back(step(out));
  }
  return contour;
}

Contour angle_iron(Random& random, int side) {
  const LatticePoint inner = anywhere(random, side / 4, side - 1);
  return {{0, 0}, {side, 0}, {side, inner.y}, inner, {inner.x, side}, {0, side}};
}

Contour star(Random& random, int radius, int corners) {
  // One in each quadrant, so that no two neighbours are 180 degrees apart.
  Contour spokes;
  for (int quarter = 0; quarter < 4; ++quarter) {
    const LatticePoint p = {random.between(1, radius), random.between(0, radius)};
    const LatticePoint turned[] = {p, {-p.y, p.x}, {-p.x, -p.y}, {p.y, -p.x}};
    spokes.push_back(turned[quarter]);
  }
  while (static_cast<int>(spokes.size()) < corners) {
    const LatticePoint p = anywhere(random, -radius, radius);
    const bool hides = p == LatticePoint{} ||
                       std::ranges::any_of(spokes, [&](LatticePoint q) { return cross(p, q) == 0 && dot(p, q) > 0; });
    if (hides)
      --corners;
    else
      spokes.push_back(p);
  }
  const auto lower = [](LatticePoint p) { return p.y < 0 || (p.y == 0 && p.x < 0); };
  std::ranges::sort(spokes,
                    [&](LatticePoint p, LatticePoint q) { return lower(p) != lower(q) ? lower(q) : cross(p, q) > 0; });
  for (LatticePoint& p : spokes) p = p + LatticePoint{radius, radius};
  return spokes;
}

Contour any_outline(Random& random, int side, int corners) {
  switch (random.below(5)) {
    case 0:
      return box({0, 0}, side, random.between(side * 3 / 4, side));
    case 1:
      return cut_box(random, {0, 0}, side, side);
    case 2:
      return {{0, 0}, {side, 0}, {random.between(0, side), side}};
    case 3:
      return angle_iron(random, side);
    default:
      return star(random, side / 2, corners);
  }
}

Contour small_ring(Random& random, LatticePoint corner, int most) {
  const int w = random.between(2, most), h = random.between(2, most);
  switch (random.below(3)) {
    case 0:
      return {corner, corner + LatticePoint{w, 0}, corner + LatticePoint{random.between(0, w), h}};
    case 1:
      return box(corner, w, h);
    default:
      return {corner + LatticePoint{w / 2, 0}, corner + LatticePoint{w, h / 2}, corner + LatticePoint{w / 2, h},
              corner + LatticePoint{0, h / 2}};
  }
}

}  // namespace pardel::generators
