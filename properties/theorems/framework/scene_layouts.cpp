#include "scene_layouts.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace pardel::properties {
namespace {
using generators::Random;

double squared_distance(Point a, Point b) { return (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y); }

double on_line(int k) { return static_cast<double>(k) * spacing; }

void add(Scene& scene, Point p) {
  if (std::ranges::count(scene.points, p) == 0) scene.points.push_back(p);
}

/// A square grid. `displaced` moves the inner points. Points on the outline stay, because circumcircles near an uneven
/// outline are large.
template <class Displaced>
Scene grid(int lines, const Displaced& displaced) {
  Scene scene;
  for (int i = 0; i < lines; ++i)
    for (int j = 0; j < lines; ++j) {
      const bool on_outline = i == 0 || j == 0 || i == lines - 1 || j == lines - 1;
      const Point at{on_line(i), on_line(j)};
      scene.points.push_back(on_outline ? at : displaced(at, i, j));
    }
  return scene;
}

Point jittered(Random& random, Point at) {
  const double dx = random.between(-3, 3), dy = random.between(-3, 3);
  return {at.x + dx, at.y + dy};
}

Scene jittered_grid(Random& random, int lines) {
  return grid(lines, [&](Point at, int, int) { return jittered(random, at); });
}

Scene exact_grid(Random& /*random*/, int lines) {
  return grid(lines, [](Point at, int, int) { return at; });
}

/// A jittered grid in which one row, column or diagonal is straight and has twice as many points.
Scene collinear_runs(Random& random, int lines) {
  const int kind = random.between(0, 2), at_line = random.between(1, lines - 2);
  const auto on_run = [&](int i, int j) { return kind == 0 ? j == at_line : kind == 1 ? i == at_line : i == j; };
  Scene scene = grid(lines, [&](Point at, int i, int j) { return on_run(i, j) ? at : jittered(random, at); });
  for (int k = 0; k + 1 < lines; ++k) {
    const double middle = on_line(k) + spacing / 2, across = on_line(at_line);
    add(scene, kind == 0 ? Point{middle, across} : kind == 1 ? Point{across, middle} : Point{middle, middle});
  }
  return scene;
}

/// A jittered grid with two to five pairs of points one unit apart.
Scene near_duplicates(Random& random, int lines) {
  Scene scene = jittered_grid(random, lines);
  const std::vector<Point> steps = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
  for (int twins = random.between(2, 5); twins > 0; --twins) {
    const Point at = jittered(random, {on_line(random.between(1, lines - 2)), on_line(random.between(1, lines - 2))});
    const Point step = random.one_of(steps);
    add(scene, at);
    add(scene, {at.x + step.x, at.y + step.y});
  }
  return scene;
}

Scene points_removed(Random& random, int lines) {
  Scene scene = jittered_grid(random, lines);
  const auto inside = [&](Point p) {
    const double last = on_line(lines - 1);
    return p.x > 0 && p.y > 0 && p.x < last && p.y < last;
  };
  for (int wanted = random.between(1, 4); wanted > 0; --wanted)
    if (const std::size_t k = random.below(scene.points.size()); inside(scene.points[k]))
      scene.points.erase(scene.points.begin() + static_cast<std::ptrdiff_t>(k));
  return scene;
}

/// A jittered grid far from the origin; coordinates are still exact in double precision.
Scene far_away(Random& random, int lines) {
  Scene scene = jittered_grid(random, lines);
  const double x = std::ldexp(1, random.between(20, 48)), y = -std::ldexp(1, random.between(0, 48));
  for (Point& p : scene.points) p = {p.x + x, p.y + y};
  return scene;
}

/// Random points of a small lattice, without any spacing.
Scene scattered_points(Random& random, int lines) {
  const int last = (lines - 1) * spacing / 2;
  Scene scene;
  scene.points = {{0, 0}, {static_cast<double>(last), 0}, {0, static_cast<double>(last)}};
  for (int k = random.between(5, lines * lines / 2); k > 0; --k) {
    const double x = random.between(0, last), y = random.between(0, last);
    add(scene, {x, y});
  }
  return scene;
}

struct Layout {
  const char* family;
  Scene (*make)(Random&, int lines);
};

/// "scattered" is the last family.
constexpr std::array<Layout, 7> layouts = {{{"points: jittered grid", jittered_grid},
                                            {"points: exact grid", exact_grid},
                                            {"points: collinear runs", collinear_runs},
                                            {"points: near-duplicates", near_duplicates},
                                            {"points: some removed", points_removed},
                                            {"points: far away", far_away},
                                            {"points: scattered", scattered_points}}};

bool add_wall(Scene& scene, Index a, Index b) {
  const ref::Edge wall = ref::edge(a, b);
  if (a == b || std::ranges::count(scene.walls, wall) != 0 || !can_be_wall(scene, wall)) return false;
  scene.walls.push_back(wall);
  return true;
}

Index random_index(Random& random, const Scene& scene) { return static_cast<Index>(random.below(scene.points.size())); }

/// The points whose distance from `from` is between `least` and `most` spacings, without `from`.
std::vector<Index> at_distance(const Scene& scene, Index from, double least, double most) {
  std::vector<Index> found;
  for (Index v = 0; v < scene.points.size(); ++v) {
    const double distance = std::sqrt(squared_distance(scene.points[v], scene.points[from])) / spacing;
    if (v != from && distance >= least && distance <= most) found.push_back(v);
  }
  return found;
}

bool add_crack(Random& random, Scene& scene) {
  Index at = random_index(random, scene);
  bool added = false;
  for (int length = random.between(1, 4); length > 0; --length) {
    const std::vector<Index> next = at_distance(scene, at, 0, 1.6);
    if (next.empty()) break;
    const Index to = random.one_of(next);
    if (add_wall(scene, at, to)) {
      added = true;
      at = to;
    }
  }
  return added;
}

bool add_long_wall(Random& random, Scene& scene) {
  const Index from = random_index(random, scene);
  const std::vector<Index> to = at_distance(scene, from, 2, 2.4);
  return !to.empty() && add_wall(scene, from, random.one_of(to));
}

/// Joins three to five nearby points to a polygon, in the order of their directions from their centre.
bool add_loop(Random& random, Scene& scene) {
  std::vector<Index> loop = at_distance(scene, random_index(random, scene), 0, 1.6);
  random.shuffle(loop);
  loop.resize(std::min<std::size_t>(loop.size(), static_cast<std::size_t>(random.between(3, 5))));
  if (loop.size() < 3) return false;
  Point centre{0, 0};
  for (const Index v : loop) centre = {centre.x + scene.points[v].x, centre.y + scene.points[v].y};
  const auto n = static_cast<double>(loop.size());
  const auto direction = [&](Index v) {
    return std::atan2(scene.points[v].y - centre.y / n, scene.points[v].x - centre.x / n);
  };
  std::ranges::sort(loop, {}, direction);

  const std::size_t before = scene.walls.size();
  for (std::size_t i = 0; i < loop.size(); ++i)
    if (!add_wall(scene, loop[i], loop[(i + 1) % loop.size()])) {
      scene.walls.resize(before);
      return false;
    }
  return true;
}

}  // namespace

int orientation(Point a, Point b, Point c) {
  const double twice = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  return twice > 0 ? 1 : twice < 0 ? -1 : 0;
}

bool lies_on(Point p, Point a, Point b) {
  return orientation(a, b, p) == 0 && std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) &&
         std::min(a.y, b.y) <= p.y && p.y <= std::max(a.y, b.y);
}

bool can_be_wall(const Scene& scene, const ref::Edge& wall) {
  const Point a = scene.points[wall[0]], b = scene.points[wall[1]];
  for (Index v = 0; v < scene.points.size(); ++v)
    if (v != wall[0] && v != wall[1] && lies_on(scene.points[v], a, b)) return false;
  return std::ranges::none_of(scene.walls, [&](const ref::Edge& other) {
    const Point c = scene.points[other[0]], d = scene.points[other[1]];
    return orientation(a, b, c) * orientation(a, b, d) < 0 && orientation(c, d, a) * orientation(c, d, b) < 0;
  });
}

Scene random_points(Random& random, int lines, bool scattered, Families& families) {
  const Layout& layout = layouts[random.below(scattered ? layouts.size() : layouts.size() - 1)];
  families.emplace_back(layout.family);
  return layout.make(random, lines);
}

void add_random_walls(Random& random, Scene& scene, Families& families) {
  for (int wanted = random.between(1, 3); wanted > 0; --wanted) {
    const int kind = random.between(0, 3);
    if (kind == 0) {
      if (add_loop(random, scene)) families.emplace_back("walls: closed loop");
    } else if (kind == 1) {
      if (add_long_wall(random, scene)) families.emplace_back("walls: long");
    } else if (add_crack(random, scene)) {
      families.emplace_back("walls: crack");
    }
  }
}

}  // namespace pardel::properties
