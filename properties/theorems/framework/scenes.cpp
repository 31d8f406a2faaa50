#include "scenes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <ostream>

#include "../../../core/support/enum_names.hpp"
#include "../../../ref/insertion.hpp"
#include "rapidcheck_generators.hpp"
#include "scene_carving.hpp"
#include "scene_layouts.hpp"

namespace pardel::properties {
namespace {
using generators::Random;

Point on_halves(double x, double y) { return {std::round(2 * x) / 2, std::round(2 * y) / 2}; }

/// The kinds of positions at which a point is inserted.
enum class Kind : std::uint8_t {
  anywhere,
  on_an_edge,
  on_a_circumcircle,
  above_a_vertex,
  next_to_a_vertex,
  facing_an_earlier_one,
  near_a_wall,
  near_a_carved_part,
  on_a_wall
};

constexpr auto kind_names =
    enum_names<Kind>({{Kind::anywhere, "inserted: anywhere"},
                      {Kind::on_an_edge, "inserted: on an edge"},
                      {Kind::on_a_circumcircle, "inserted: on a circumcircle"},
                      {Kind::above_a_vertex, "inserted: above a vertex"},
                      {Kind::next_to_a_vertex, "inserted: next to a vertex"},
                      {Kind::facing_an_earlier_one, "inserted: on a circle through an edge and an earlier insertion"},
                      {Kind::near_a_wall, "inserted: near a wall"},
                      {Kind::near_a_carved_part, "inserted: near a pocket or a hole"},
                      {Kind::on_a_wall, "inserted: on a wall"}});

/// Chooses positions in one scene. Relative to its lower left corner, they are small multiples of 1/2.
class Positions {
 public:
  Positions(Random& random, const MeshedScene& scene) : random_(random), scene_(scene), points_(scene.scene.points) {
    low_ = high_ = points_.front();
    for (const Point& p : points_) {
      low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y)};
      high_ = {std::max(high_.x, p.x), std::max(high_.y, p.y)};
    }
  }

  /// A position in the bounding box; also returns its family. `earlier` is one of the insertions so far, or null.
  Point any(const SceneSpec& spec, const Point* earlier, std::string& family) {
    std::vector<Kind> kinds = {Kind::anywhere,          Kind::anywhere,       Kind::on_an_edge,
                               Kind::on_a_circumcircle, Kind::above_a_vertex, Kind::next_to_a_vertex};
    if (earlier != nullptr) kinds.push_back(Kind::facing_an_earlier_one);
    if (!scene_.scene.walls.empty()) kinds.push_back(Kind::near_a_wall);
    if (!scene_.scene.holes.empty()) kinds.insert(kinds.end(), 6, Kind::near_a_carved_part);
    if (!scene_.scene.walls.empty() && spec.on_walls)
      kinds.insert(kinds.end(), spec.mostly_on_walls ? kinds.size() : 1, Kind::on_a_wall);
    const Kind kind = random_.one_of(kinds);
    family = kind_names[kind];
    switch (kind) {
      case Kind::anywhere:
        return anywhere();
      case Kind::on_an_edge:
        return middle_of_an_edge();
      case Kind::on_a_circumcircle:
        return on_a_circle(corners(random_.one_of(scene_.mesh.triangles)));
      case Kind::above_a_vertex:
        return {random_.one_of(points_).x, anywhere().y};
      case Kind::next_to_a_vertex:
        return moved(random_.one_of(points_), 1);
      case Kind::facing_an_earlier_one:
        return on_a_circle(facing(*earlier));
      case Kind::near_a_wall:
        return moved(middle_of_a_wall(), 6);
      case Kind::near_a_carved_part:
        return moved(middle_of_a_carved_edge(), 3);
      case Kind::on_a_wall:
        return spec.mostly_on_walls ? inside_a_wall() : middle_of_a_wall();
    }
    return {};
  }

  /// Is p in the mesh and not at a vertex? If on_walls is false, p must not lie on a wall either.
  [[nodiscard]] bool is_free(Point p, bool on_walls) const {
    const auto at = [&](Index v) { return points_[v]; };
    return lies_in(scene_.mesh, ref::exact(p)) && std::ranges::count(points_, p) == 0 &&
           (on_walls || std::ranges::none_of(scene_.scene.walls,
                                             [&](const ref::Edge& e) { return lies_on(p, at(e[0]), at(e[1])); }));
  }

 private:
  using Three = std::array<Point, 3>;

  Three corners(const ref::Corners& t) const { return {points_[t[0]], points_[t[1]], points_[t[2]]}; }

  Point anywhere() {
    const auto between = [&](double low, double high) {
      return low + random_.between(0, static_cast<int>(2 * (high - low))) / 2.0;
    };
    const double x = between(low_.x, high_.x), y = between(low_.y, high_.y);
    return {x, y};
  }

  static Point middle(Point a, Point b) { return on_halves((a.x + b.x) / 2, (a.y + b.y) / 2); }

  Point middle_of_an_edge() {
    const Three t = corners(random_.one_of(scene_.mesh.triangles));
    return middle(t[0], t[1]);
  }

  Point middle_of_a_wall() {
    const ref::Edge wall = random_.one_of(scene_.scene.walls);
    return middle(points_[wall[0]], points_[wall[1]]);
  }

  /// One of the positions inside a wall whose coordinates are multiples of 1/2. The middle is always one of them.
  Point inside_a_wall() {
    const ref::Edge wall = random_.one_of(scene_.scene.walls);
    const Point a = points_[wall[0]], b = points_[wall[1]];
    const int dx = static_cast<int>(2 * (b.x - a.x)), dy = static_cast<int>(2 * (b.y - a.y)), steps = std::gcd(dx, dy);
    const double share = random_.between(1, steps - 1) / (2.0 * steps);
    return {a.x + dx * share, a.y + dy * share};
  }

  /// The middle of an edge of the border with parts of the mesh beyond its line; of a wall, if there is none.
  Point middle_of_a_carved_edge() {
    std::vector<ref::Edge> edges = border_of(scene_.mesh);
    std::erase_if(edges, [&](const ref::Edge& e) {
      return std::ranges::none_of(scene_.mesh.triangles, [&](const ref::Corners& t) {
        return std::ranges::any_of(t,
                                   [&](Index v) { return orientation(points_[e[0]], points_[e[1]], points_[v]) < 0; });
      });
    });
    if (edges.empty()) return middle_of_a_wall();
    const ref::Edge e = random_.one_of(edges);
    return middle(points_[e[0]], points_[e[1]]);
  }

  /// Moves both coordinates by up to `halves` times 1/2 in either direction.
  Point moved(Point from, int halves) {
    const double dx = random_.between(-halves, halves) / 2.0, dy = random_.between(-halves, halves) / 2.0;
    return {from.x + dx, from.y + dy};
  }

  /// p and the ends of an edge of the boundary of its cavity. A point inside the circle through them is not independent
  /// of p.
  Three facing(Point p) {
    const auto edges = ref::boundary(scene_.mesh, ref::cavity(scene_.mesh, ref::exact(p)));
    const ref::Edge e = random_.one_of(edges);
    return {p, points_[e[0]], points_[e[1]]};
  }

  /// A position exactly on the circle through three points; one of the three points if there is no other position.
  Point on_a_circle(const Three& t) {
    const double bx = t[1].x - t[0].x, by = t[1].y - t[0].y, cx = t[2].x - t[0].x, cy = t[2].y - t[0].y;
    const double twice = bx * cy - by * cx;
    if (twice == 0) return t[0];
    const double b = bx * bx + by * by, c = cx * cx + cy * cy;
    // Relative to t[0], the circle is twice · (x² + y²) + u x + v y = 0. These coefficients are exact.
    const double u = by * c - cy * b, v = cx * b - bx * c;
    const double centre_x = -u / (2 * twice), centre_y = -v / (2 * twice), radius = std::hypot(centre_x, centre_y);
    const double first = std::max(low_.x - t[0].x, std::ceil(2 * (centre_x - radius)) / 2);
    const double last = std::min(high_.x - t[0].x, centre_x + radius);
    std::vector<Point> found;
    for (double x = first; x <= last; x += 0.5)
      for (const double sign : {-1.0, 1.0}) {
        const double dx = x - centre_x;
        const Point at = on_halves(x, centre_y + sign * std::sqrt(std::max(0.0, radius * radius - dx * dx)));
        const Point p{t[0].x + at.x, t[0].y + at.y};
        if (twice * (at.x * at.x + at.y * at.y) + u * at.x + v * at.y == 0 && is_free(p, true)) found.push_back(p);
      }
    return found.empty() ? t[0] : random_.one_of(found);
  }

  Random& random_;
  const MeshedScene& scene_;
  const std::vector<Point>& points_;
  Point low_, high_;
};

ref::Number exact_squared_distance(Point p, Point q) { return CGAL::squared_distance(ref::exact(p), ref::exact(q)); }

/// Does p have the specified distances from the insertions before the k-th?
bool keeps_distance(const MeshedScene& meshed, const SceneSpec& spec, Point p, std::size_t k) {
  bool is_near_one = k == 0 || std::isinf(spec.most);
  for (std::size_t i = 0; i < k; ++i) {
    const ref::Number distance = exact_squared_distance(p, meshed.scene.insertions[i]);
    if (distance < spec.least * spec.least * meshed.squared_bound) return false;
    is_near_one = is_near_one || distance < spec.most * spec.most * meshed.squared_bound;
  }
  return is_near_one;
}

bool are_edges(const ref::PlainMesh& mesh, const std::vector<ref::Edge>& walls) {
  return std::ranges::all_of(walls, [&](const ref::Edge& wall) { return mesh.constraints.contains(wall); });
}

bool may_encroach(const MeshedScene& meshed, const SceneSpec& spec, Point at) {
  if (spec.encroaching || meshed.mesh.constraints.empty()) return true;
  const ref::ExactPoint p = ref::exact(at);
  return std::ranges::none_of(ref::boundary(meshed.mesh, ref::cavity(meshed.mesh, p)), [&](const ref::Edge& e) {
    const ref::ExactPoint &a = meshed.mesh.points[e[0]], &b = meshed.mesh.points[e[1]];
    return meshed.mesh.constraints.contains(ref::edge(e[0], e[1])) && !CGAL::collinear(a, p, b) &&
           ref::encroaches(p, a, b);
  });
}

/// The number of lines of points that a scene needs for the specified insertions. r̄ is about one spacing.
int lines_for(Random& random, const SceneSpec& spec) {
  const double count = std::max(2, spec.insertions);
  return random.between(5, 7) + static_cast<int>(std::ceil(spec.least * (std::sqrt(count) - 1) / 2));
}

MeshedScene random_mesh(Random& random, const SceneSpec& spec) {
  Families families;
  Scene layout = random_points(random, lines_for(random, spec), spec.least == 0, families);
  if (spec.walls || spec.carved) add_random_walls(random, layout, families);
  constexpr int attempts = 4;
  for (int attempt = 0; spec.carved && attempt < attempts; ++attempt)
    if (carve_at_random(random, layout, families)) break;
  return meshed(std::move(layout), std::move(families));
}

/// Is the mesh wide enough for the specified separation? (Long walls make r̄ large, so some meshes are too narrow.)
bool is_large_enough(const MeshedScene& meshed, const SceneSpec& spec) {
  const std::vector<Point>& points = meshed.scene.points;
  const auto [low, high] = std::ranges::minmax(points, {}, [](Point p) { return p.x + p.y; });
  return exact_squared_distance(low, high) >= spec.least * spec.least * meshed.squared_bound;
}

/// Adds an insertion that satisfies the specification, if such a position is found.
bool add_insertion(Random& random, MeshedScene& meshed, const SceneSpec& spec, Positions& positions) {
  std::vector<Point>& insertions = meshed.scene.insertions;
  constexpr int trials = 40;
  for (int trial = 0; trial < trials; ++trial) {
    std::string family;
    const Point* earlier = insertions.empty() ? nullptr : &random.one_of(insertions);
    const Point p = positions.any(spec, earlier, family);
    if (positions.is_free(p, spec.on_walls) && std::ranges::count(insertions, p) == 0 &&
        keeps_distance(meshed, spec, p, insertions.size()) && may_encroach(meshed, spec, p)) {
      insertions.push_back(p);
      meshed.families.push_back(std::move(family));
      return true;
    }
  }
  return false;
}

}  // namespace

std::ostream& operator<<(std::ostream& out, const MeshedScene& meshed) { return out << meshed.scene; }

std::vector<ref::Edge> border_of(const ref::PlainMesh& mesh) {
  std::vector<Index> all(mesh.triangles.size());
  for (Index t = 0; t < all.size(); ++t) all[t] = t;
  return ref::boundary(mesh, all);
}

bool lies_in(const ref::PlainMesh& mesh, const ref::ExactPoint& p) {
  return std::ranges::any_of(mesh.triangles, [&](const ref::Corners& t) {
    for (int i = 0; i < 3; ++i)
      if (CGAL::right_turn(mesh.points[t[i]], mesh.points[t[(i + 1) % 3]], p)) return false;
    return true;
  });
}

MeshedScene meshed(Scene scene, Families families) {
  MeshedScene result{std::move(scene), {}, 0, std::move(families)};
  result.mesh = mesh_of(result.scene);
  result.squared_bound = ref::squared_circumradius_bound(result.mesh);
  return result;
}

MeshedScene random_scene(Random& random, const SceneSpec& spec) {
  const auto wanted = static_cast<std::size_t>(spec.insertions);
  constexpr int attempts = 6, trials = 4;
  MeshedScene result;
  for (int attempt = 0; attempt < attempts; ++attempt) {
    result = random_mesh(random, spec);
    if (!is_large_enough(result, spec)) continue;
    const Families without_insertions = result.families;
    Positions positions(random, result);
    for (int trial = 0; trial < trials; ++trial) {
      result.scene.insertions.clear();
      result.families = without_insertions;
      while (result.scene.insertions.size() < wanted && add_insertion(random, result, spec, positions)) {
      }
      if (result.scene.insertions.size() < wanted) continue;
      for (int k = 0; k < spec.more && add_insertion(random, result, spec, positions);) ++k;
      return result;
    }
  }
  return result;
}

SceneSpec in_any_domain(SceneSpec spec) {
  const int kind = *rc::gen::element(0, 1, 2).as("a hull, a hull with walls, or a carved domain");
  spec.walls = kind > 0;
  spec.carved = kind == 2;
  return spec;
}

SceneSpec in_any_walled_domain(SceneSpec spec) {
  spec.walls = true;
  spec.carved = *rc::gen::arbitrary<bool>().as("a carved domain");
  return spec;
}

bool satisfies(const MeshedScene& meshed, const SceneSpec& spec) {
  if (!are_edges(meshed.mesh, meshed.scene.walls)) return false;
  Random unused(0);
  const Positions positions(unused, meshed);
  const std::vector<Point>& insertions = meshed.scene.insertions;
  if (insertions.size() < static_cast<std::size_t>(spec.insertions)) return false;
  for (std::size_t k = 0; k < insertions.size(); ++k)
    if (!positions.is_free(insertions[k], spec.on_walls) || !keeps_distance(meshed, spec, insertions[k], k) ||
        !may_encroach(meshed, spec, insertions[k]))
      return false;
  return true;
}

rc::Gen<MeshedScene> scenes(const SceneSpec& spec) {
  const auto make = [spec](Random& random, int /*size*/) {
    MeshedScene scene = random_scene(random, spec);
    if (scene.scene.insertions.size() < static_cast<std::size_t>(spec.insertions))
      throw rc::GenerationFailure("no room for the insertions");
    return scene;
  };
  const auto shrinks = [spec](const MeshedScene& large) {
    std::vector<MeshedScene> result;
    for (Scene& scene : simpler(large.scene))
      if (MeshedScene small = meshed(std::move(scene), large.families); satisfies(small, spec))
        result.push_back(std::move(small));
    return result;
  };
  return generators::generator(make, shrinks);
}

void tag_families(const MeshedScene& meshed) {
  for (const std::string& family : meshed.families) RC_TAG(family);
}

}  // namespace pardel::properties
