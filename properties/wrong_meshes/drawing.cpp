#include "drawing.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "../checker/arithmetic/exact.hpp"
#include "../defects/edit.hpp"

namespace pardel::wrong_meshes {
namespace {

using Edge = std::pair<Index, Index>;
using checker::exactly::orientation;
namespace edit = defects::edit;

/// A triangulation of points that contains given edges: all pairs of points from the nearest to the furthest, if they
/// cross no edge before them.
class Greedy {
 public:
  explicit Greedy(const std::vector<Point>& points) : points_(points), around_(points.size()) {}

  /// False if the edge crosses another one or passes through a point.
  bool add(Index a, Index b) {
    if (around_[a].contains(b)) return true;
    if (a == b || passes_a_point(a, b) || std::ranges::any_of(edges_, [&](const Edge& e) { return cross(e, a, b); }))
      return false;
    edges_.emplace_back(a, b);
    around_[a].insert(b);
    around_[b].insert(a);
    return true;
  }

  void leave_out(Index point) { left_out_.insert(point); }

  void complete() {
    std::vector<std::pair<double, Edge>> pairs;
    for (Index a = 0; a < points_.size(); ++a)
      for (Index b = a + 1; b < points_.size(); ++b)
        if (!left_out_.contains(a) && !left_out_.contains(b))
          pairs.push_back({std::hypot(points_[b].x - points_[a].x, points_[b].y - points_[a].y), {a, b}});
    std::ranges::sort(pairs);
    for (const auto& [length, pair] : pairs) (void)add(pair.first, pair.second);
  }

  [[nodiscard]] std::vector<std::array<Index, 3>> triangles() const {
    std::vector<std::array<Index, 3>> found;
    for (Index a = 0; a < points_.size(); ++a)
      for (const Index b : around_[a]) {
        const Index c = next_around(a, b);
        if (a < b && a < c && c != no_index && around_[b].contains(c)) found.push_back({a, b, c});
      }
    return found;
  }

 private:
  [[nodiscard]] int turn(Index a, Index b, Index c) const { return orientation(points_[a], points_[b], points_[c]); }
  [[nodiscard]] bool cross(const Edge& e, Index a, Index b) const {
    const auto [c, d] = e;
    if (a == c || a == d || b == c || b == d) return false;
    return turn(a, b, c) * turn(a, b, d) < 0 && turn(c, d, a) * turn(c, d, b) < 0;
  }
  [[nodiscard]] bool passes_a_point(Index a, Index b) const {
    const Point p = points_[a], q = points_[b];
    for (Index c = 0; c < points_.size(); ++c) {
      if (c == a || c == b || left_out_.contains(c)) continue;
      const Point r = points_[c];
      const bool in_box = std::min(p.x, q.x) <= r.x && r.x <= std::max(p.x, q.x) && std::min(p.y, q.y) <= r.y &&
                          r.y <= std::max(p.y, q.y);
      if (in_box && turn(a, b, c) == 0) return true;
    }
    return false;
  }
  /// The neighbour of a that follows b counter-clockwise within 180 degrees.
  [[nodiscard]] Index next_around(Index a, Index b) const {
    Index best = no_index;
    for (const Index c : around_[a])
      if (turn(a, b, c) > 0 && (best == no_index || turn(a, c, best) > 0)) best = c;
    return best;
  }

  const std::vector<Point>& points_;
  std::vector<std::set<Index>> around_;
  std::vector<Edge> edges_;
  std::set<Index> left_out_;
};

bool contains(const Mesh& mesh, Index t, Point p) {
  const auto& v = mesh.triangles[t].v;
  for (int i = 0; i < 3; ++i)
    if (orientation(mesh.points[v[i]], mesh.points[v[(i + 1) % 3]], p) < 0) return false;
  return true;
}

/// Flips edges that are not constrained until all are locally Delaunay.
void make_delaunay(Mesh& mesh, const std::set<Edge>& walls) {
  for (bool changed = true; changed;) {
    changed = false;
    for (Index t = 0; t < mesh.triangles.size(); ++t)
      for (int i = 0; i < 3; ++i) {
        const edit::Side s{t, i};
        if (edit::across(mesh, s) == no_index || walls.contains(edit::ends(edit::tail(mesh, s), edit::head(mesh, s))))
          continue;
        const auto& v = mesh.triangles[t].v;
        const Index apex = edit::apex(mesh, edit::opposite(mesh, s));
        if (checker::exactly::in_circle(mesh.points[v[0]], mesh.points[v[1]], mesh.points[v[2]], mesh.points[apex]) > 0)
          changed = edit::flip(mesh, s) || changed;
      }
  }
}

}  // namespace

Index Drawing::point(Point p) {
  of.pslg.points.push_back(p);
  return static_cast<Index>(of.pslg.points.size() - 1);
}

Index Drawing::segment(Index a, Index b) {
  const auto s = static_cast<Index>(of.pslg.segments.size());
  of.pslg.segments.push_back({a, b, 0});
  chains_.push_back({a, b, s, false, {}});
  return static_cast<Index>(chains_.size() - 1);
}

Index Drawing::absent_segment(Index a, Index b) {
  const Index chain = segment(a, b);
  chains_[chain].is_absent = true;
  return chain;
}

Index Drawing::ring(const std::vector<Index>& corners) {
  const auto first = static_cast<Index>(chains_.size());
  for (std::size_t i = 0; i < corners.size(); ++i) segment(corners[i], corners[(i + 1) % corners.size()]);
  return first;
}

Index Drawing::hull_side(Index a, Index b) {
  chains_.push_back({a, b, no_index, false, {}});
  return static_cast<Index>(chains_.size() - 1);
}

void Drawing::hole(double x, double y) {
  of.pslg.holes.push_back(place.at(x, y));
  gaps_.push_back(place.at(x, y));
}

void Drawing::region(double x, double y, double attribute) { of.pslg.regions.push_back({place.at(x, y), attribute}); }

Index Drawing::insert(Point p, Index origin) {
  inserted_.push_back(p);
  origins_.push_back(origin);
  return static_cast<Index>(points() - 1);
}

Index Drawing::on(Index chain, Point p) {
  const Index segment = chains_[chain].segment;
  const Index v = insert(p, segment == no_index ? hull_vertex : origin_on_segment(segment));
  pass(chain, v);
  return v;
}

Point Drawing::at(Index vertex) const {
  const std::size_t inputs = of.pslg.points.size();
  return vertex < inputs ? of.pslg.points[vertex] : inserted_[vertex - inputs];
}

void Drawing::fault(std::initializer_list<Point> places, double reach) {
  of.fault = places;
  of.reach = place.length(reach);
}

std::optional<WrongMesh> Drawing::draw() {
  if (!triangulate()) return std::nullopt;
  return std::move(of);
}

bool Drawing::has_shortcut(const Mesh& mesh, Index chain) const {
  std::vector<Index> path{chains_[chain].a};
  path.insert(path.end(), chains_[chain].inside.begin(), chains_[chain].inside.end());
  path.push_back(chains_[chain].b);
  for (std::size_t i = 0; i < path.size(); ++i)
    for (std::size_t j = i + 2; j < path.size(); ++j)
      for (const Triangle& t : mesh.triangles)
        if (std::ranges::count(t.v, path[i]) != 0 && std::ranges::count(t.v, path[j]) != 0) return true;
  return false;
}

bool Drawing::triangulate() {
  Mesh& mesh = of.mesh;
  std::vector<Point> points = of.pslg.points;
  points.insert(points.end(), inserted_.begin(), inserted_.end());
  mesh.points.append(points);
  mesh.origin.resize(of.pslg.points.size(), input_vertex);
  mesh.origin.append(origins_);

  Greedy greedy(points);
  for (const Index v : left_out_) greedy.leave_out(v);
  std::set<Edge> walls;
  std::vector<ConstrainedEdge> listed;
  for (const Chain& chain : chains_) {
    if (chain.is_absent) continue;
    std::vector<Index> path{chain.a};
    path.insert(path.end(), chain.inside.begin(), chain.inside.end());
    path.push_back(chain.b);
    for (std::size_t i = 1; i < path.size(); ++i) {
      if (!greedy.add(path[i - 1], path[i])) return false;
      if (walls.insert(edit::ends(path[i - 1], path[i])).second)
        listed.push_back({path[i - 1], path[i], chain.segment, 0});
    }
  }
  greedy.complete();
  for (const auto& v : greedy.triangles()) edit::append_triangle(mesh, v);
  edit::relink(mesh);
  make_delaunay(mesh, walls);

  // What is reached from outside or from a seed without crossing a chain has no triangles.
  std::vector<Index> stack;
  for (Index t = 0; t < mesh.triangles.size(); ++t) {
    for (int i = 0; i < 3; ++i)
      if (const edit::Side s{t, i};
          edit::across(mesh, s) == no_index && !walls.contains(edit::ends(edit::tail(mesh, s), edit::head(mesh, s))))
        stack.push_back(t);
    if (std::ranges::any_of(gaps_, [&](Point p) { return contains(mesh, t, p); })) stack.push_back(t);
  }
  std::set<Index> gone;
  while (!stack.empty()) {
    const Index t = stack.back();
    stack.pop_back();
    if (!gone.insert(t).second) continue;
    for (int i = 0; i < 3; ++i)
      if (const edit::Side s{t, i};
          edit::across(mesh, s) != no_index && !walls.contains(edit::ends(edit::tail(mesh, s), edit::head(mesh, s))))
        stack.push_back(edit::across(mesh, s));
  }
  edit::erase_triangles(mesh, {gone.begin(), gone.end()});

  std::map<Edge, int> sides;
  for (Index t = 0; t < mesh.triangles.size(); ++t)
    for (int i = 0; i < 3; ++i) ++sides[edit::ends(edit::tail(mesh, {t, i}), edit::head(mesh, {t, i}))];
  for (ConstrainedEdge& e : listed) e.marker = sides[edit::ends(e.a, e.b)] == 1 ? 1 : 0;
  mesh.constrained_edges = std::move(listed);

  if (!of.pslg.regions.empty()) {
    mesh.region.resize(mesh.triangles.size(), no_index);
    const std::vector<Index> face = edit::faces(mesh);
    for (Index r = 0; r < of.pslg.regions.size(); ++r) {
      mesh.region_attributes.push_back(of.pslg.regions[r].attribute);
      for (Index t = 0; t < mesh.triangles.size(); ++t)
        if (contains(mesh, t, of.pslg.regions[r].seed))
          for (Index u = 0; u < face.size(); ++u)
            if (face[u] == face[t]) mesh.region[u] = r;
    }
  }
  return !mesh.triangles.empty();
}

}  // namespace pardel::wrong_meshes
