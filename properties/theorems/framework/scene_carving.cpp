#include "scene_carving.hpp"

#include <algorithm>
#include <map>
#include <optional>

#include "scene_layouts.hpp"
#include "shares.hpp"

namespace pardel::properties {
namespace {
using generators::Random;

/// The triangles at each edge.
std::map<ref::Edge, std::vector<Index>> triangles_at_edges(const ref::PlainMesh& mesh) {
  std::map<ref::Edge, std::vector<Index>> at;
  for (Index t = 0; t < mesh.triangles.size(); ++t)
    for (int i = 0; i < 3; ++i) at[ref::edge_of(mesh.triangles[t], i)].push_back(t);
  return at;
}

/// Removes connected sets of triangles from the mesh of a scene.
class Carver {
 public:
  explicit Carver(const Scene& scene)
      : mesh_(mesh_of(scene)), at_(triangles_at_edges(mesh_)), removed_(mesh_.triangles.size(), false) {}

  /// Removes up to `size` triangles, connected across edges, from the outside.
  bool carve_pocket(Random& random, int size) {
    const auto is_outside = [this, border = border_vertices()](Index t) { return corners_in(border, t) >= 2; };
    return carve(random, size, is_outside, [](Index) { return true; });
  }

  /// Removes up to `size` triangles, connected across edges, none of which touches the border.
  bool carve_hole(Random& random, int size) {
    const auto is_inside = [this, border = border_vertices()](Index t) { return corners_in(border, t) == 0; };
    return carve(random, size, is_inside, is_inside);
  }

  /// The scene without the removed triangles: with walls on its border, and seeds of the faces that are carved away.
  /// Nothing if there is no place for a seed.
  [[nodiscard]] std::optional<Scene> carved(const Scene& scene) const {
    Scene result{scene.points, {}, scene.insertions};
    for (const auto& [e, triangles] : at_) {
      const auto kept = std::ranges::count_if(triangles, [&](Index t) { return !removed_[t]; });
      if (kept == 1 || (kept == 2 && mesh_.constraints.contains(e))) result.walls.push_back(e);
    }
    std::vector<bool> done = removed_;
    done.flip();
    for (Index t = 0; t < done.size(); ++t) {
      if (done[t]) continue;
      const std::optional<Point> seed = seed_in_face(reached_from(t, done));
      if (!seed) return std::nullopt;
      result.holes.push_back(*seed);
    }
    return result;
  }

  /// A chain of up to `length` edges from the border into the domain, to be used as walls.
  [[nodiscard]] std::vector<ref::Edge> slit(Random& random, int length) const {
    const std::set<Index> border = border_vertices();
    std::vector<ref::Edge> chain;
    Index from = random.one_of(std::vector<Index>(border.begin(), border.end()));
    for (; length > 0; --length) {
      std::vector<Index> next;  // inner vertices at the other ends of edges
      for (const auto& [e, triangles] : at_) {
        const bool is_kept = std::ranges::none_of(triangles, [&](Index t) { return removed_[t]; });
        if (!is_kept || triangles.size() != 2 || (e[0] != from && e[1] != from)) continue;
        if (const Index to = e[0] == from ? e[1] : e[0]; !border.contains(to)) next.push_back(to);
      }
      if (next.empty()) break;
      const Index to = random.one_of(next);
      chain.push_back(ref::edge(from, to));
      from = to;
    }
    return chain;
  }

 private:
  /// The vertices on the border of what is left.
  [[nodiscard]] std::set<Index> border_vertices() const {
    std::set<Index> vertices;
    for (const auto& [e, triangles] : at_)
      if (std::ranges::count_if(triangles, [&](Index t) { return !removed_[t]; }) == 1)
        vertices.insert(e.begin(), e.end());
    return vertices;
  }

  [[nodiscard]] std::ptrdiff_t corners_in(const std::set<Index>& vertices, Index t) const {
    return std::ranges::count_if(mesh_.triangles[t], [&](Index v) { return vertices.contains(v); });
  }

  /// The triangles that are connected with t across edges and not yet `done`, with t; marks them as done.
  std::vector<Index> reached_from(Index t, std::vector<bool>& done) const {
    std::vector<Index> reached = {t};
    done[t] = true;
    for (std::size_t k = 0; k < reached.size(); ++k)
      for (int i = 0; i < 3; ++i)
        for (const Index other : at_.at(ref::edge_of(mesh_.triangles[reached[k]], i)))
          if (!done[other]) {
            done[other] = true;
            reached.push_back(other);
          }
    return reached;
  }

  template <class Start, class Allowed>
  bool carve(Random& random, int size, const Start& may_start, const Allowed& allowed) {
    std::vector<Index> starts;
    for (Index t = 0; t < removed_.size(); ++t)
      if (!removed_[t] && may_start(t)) starts.push_back(t);
    if (starts.empty()) return false;
    std::vector<Index> blob = {random.one_of(starts)};
    while (blob.size() < static_cast<std::size_t>(size)) {
      std::vector<Index> next;
      for (const Index t : blob)
        for (int i = 0; i < 3; ++i)
          for (const Index other : at_.at(ref::edge_of(mesh_.triangles[t], i)))
            if (!removed_[other] && std::ranges::count(blob, other) == 0 && allowed(other)) next.push_back(other);
      if (next.empty()) break;
      blob.push_back(random.one_of(next));
    }
    for (const Index t : blob) removed_[t] = true;
    if (is_rest_connected()) return true;
    for (const Index t : blob) removed_[t] = false;
    return false;
  }

  [[nodiscard]] bool is_rest_connected() const {
    std::vector<bool> done = removed_;
    const auto first = std::ranges::find(done, false);
    if (first == done.end()) return false;
    (void)reached_from(static_cast<Index>(first - done.begin()), done);
    return std::ranges::count(done, false) == 0;
  }

  /// The centroid of t, rounded, if it lies strictly inside t.
  [[nodiscard]] std::optional<Point> seed_in(Index t) const {
    const ref::Corners& c = mesh_.triangles[t];
    const ref::ExactPoint &p = mesh_.points[c[0]], &q = mesh_.points[c[1]], &r = mesh_.points[c[2]];
    const Point seed = ref::rounded(CGAL::centroid(p, q, r));
    const bool is_inside = ref::Kernel::Triangle_2(p, q, r).has_on_bounded_side(ref::exact(seed));
    return is_inside ? std::optional(seed) : std::nullopt;
  }

  [[nodiscard]] std::optional<Point> seed_in_face(const std::vector<Index>& face) const {
    for (const Index t : face)
      if (const std::optional<Point> seed = seed_in(t)) return seed;
    return std::nullopt;
  }

  ref::PlainMesh mesh_;
  std::map<ref::Edge, std::vector<Index>> at_;
  std::vector<bool> removed_;
};

}  // namespace

bool carve_at_random(Random& random, Scene& scene, Families& families) {
  Carver carver(scene);
  Families done;
  const int pockets = random.between(0, 2), holes = random.between(pockets == 0 ? 1 : 0, 2);
  for (int k = 0; k < pockets; ++k)
    if (carver.carve_pocket(random, random.one_of<int>({1, 2, 3, 5, 8}))) done.emplace_back("carved: a pocket");
  for (int k = 0; k < holes; ++k)
    if (carver.carve_hole(random, random.one_of<int>({1, 1, 2, 3, 6}))) done.emplace_back("carved: a hole");
  if (done.empty()) return false;

  std::optional<Scene> carved = carver.carved(scene);
  if (!carved) return false;
  if (random.chance(2)) {
    const std::size_t walls = carved->walls.size();
    for (const ref::Edge& e : carver.slit(random, random.between(1, 3)))
      if (std::ranges::count(carved->walls, e) == 0) carved->walls.push_back(e);
    if (carved->walls.size() > walls) done.emplace_back("carved: a slit");
  }
  scene = std::move(*carved);
  families.insert(families.end(), done.begin(), done.end());
  return true;
}

Outline outline_of(const ref::PlainMesh& mesh) {
  Outline outline;
  const auto edges = triangles_at_edges(mesh);
  const std::vector<ref::Edge> border = border_of(mesh);
  std::set<Index> vertices, on_border;
  for (const auto& [e, triangles] : edges) vertices.insert(e.begin(), e.end());
  for (const ref::Edge& e : border) on_border.insert(e.begin(), e.end());
  const auto is_wall = [&](const ref::Edge& e) { return mesh.constraints.contains(ref::edge(e[0], e[1])); };
  outline.is_walled = std::ranges::all_of(border, is_wall);
  outline.has_reflex = std::ranges::any_of(border, [&](const ref::Edge& e) {
    return std::ranges::any_of(
        vertices, [&](Index v) { return CGAL::right_turn(mesh.points[e[0]], mesh.points[e[1]], mesh.points[v]); });
  });
  outline.has_hole = vertices.size() + mesh.triangles.size() < edges.size() + 1;
  outline.has_slit = std::ranges::any_of(edges, [&](const auto& entry) {
    const auto& [e, triangles] = entry;
    return triangles.size() == 2 && is_wall(e) && (on_border.contains(e[0]) || on_border.contains(e[1]));
  });
  return outline;
}

bool border_hides(const ref::PlainMesh& mesh, const ref::ExactPoint& p) {
  std::optional<ref::PlainMesh> without_border;
  return std::ranges::any_of(mesh.triangles, [&](const ref::Corners& t) {
    if (!circumdisk_contains(mesh, t, p) || sees(mesh, p, t)) return false;
    if (!without_border) {
      without_border = mesh;
      for (const ref::Edge& e : border_of(mesh)) without_border->constraints.erase(ref::edge(e[0], e[1]));
    }
    return sees(*without_border, p, t);
  });
}

void classify_outline(const MeshedScene& meshed, const std::vector<Point>& insertions, double hidden_percent) {
  const bool is_carved = !meshed.scene.holes.empty();
  const Outline outline = is_carved ? outline_of(meshed.mesh) : Outline{};
  classify(outline.has_reflex && outline.is_walled, "carved: a border that is not convex", 20);
  classify(outline.has_hole, "carved: a mesh with a hole", 12);
  classify(outline.has_slit, "carved: a mesh with a slit", 8);
  classify(
      is_carved && std::ranges::any_of(insertions, [&](Point p) { return border_hides(meshed.mesh, ref::exact(p)); }),
      "carved: the border hides a triangle whose disk contains an insertion", hidden_percent);
}

}  // namespace pardel::properties
