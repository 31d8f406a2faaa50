#include "correspondence.hpp"

#include <algorithm>
#include <map>

#include "units.hpp"

namespace pardel::fuzz {

using ref::ExactPoint;
using Face = PlaneFaces::Face;

std::set<Index> meeting_points(const Chains& chains, const Pslg& pslg) {
  std::set<Index> found;
  for (const Chain& chain : chains)
    for (const Chain& other : chains)
      for (const Index v : chain.path)
        if (&chain != &other && v >= pslg.points.size() && other.passes(v)) found.insert(v);
  return found;
}

std::set<Index> points_of_another_order(const ExactMesh& mesh, const Chains& chains, const Pslg& pslg) {
  std::set<Index> found;
  const auto& p = mesh.plain.points;
  for (Index centre = 0; centre < pslg.points.size(); ++centre) {
    struct Leaving {
      ref::Kernel::Direction_2 wall, chain;
    };
    std::vector<Leaving> leaving;
    for (const Chain& chain : chains) {
      if (!chain.ends_at(centre)) continue;
      const Index far = chain.wall->a == centre ? chain.wall->b : chain.wall->a;
      leaving.push_back({(p[far] - p[centre]).direction(), (p[chain.next_to(centre)] - p[centre]).direction()});
    }
    for (const Leaving& u : leaving)
      for (const Leaving& v : leaving)
        for (const Leaving& w : leaving) {
          if (&u == &v || &v == &w || &w == &u || !v.wall.counterclockwise_in_between(u.wall, w.wall)) continue;
          if (!v.chain.counterclockwise_in_between(u.chain, w.chain)) found.insert(centre);
        }
  }
  return found;
}

bool has_the_sides_of_the_domain(const ExactMesh& mesh, const Chains& chains) {
  Edges on_chains;
  for (const Chain& chain : chains)
    for (std::size_t i = 1; i < chain.path.size(); ++i) {
      const Index from = chain.path[i - 1], to = chain.path[i];
      on_chains.insert(ref::edge(from, to));
      if (mesh.has_triangle_left_of(from, to) != chain.wall->left_inside) return false;
      if (mesh.has_triangle_left_of(to, from) != chain.wall->right_inside) return false;
    }
  return std::ranges::all_of(mesh.triangles_at,
                             [&](const auto& at) { return at.second.size() == 2 || on_chains.contains(at.first); });
}

namespace {

/// The lines of the walls that have chains.
std::vector<PlaneFaces::Line> lines_of_walls(const ExactMesh& mesh, const Chains& chains) {
  std::vector<PlaneFaces::Line> lines;
  for (const Chain& chain : chains)
    lines.emplace_back(mesh.plain.points[chain.path.front()], mesh.plain.points[chain.path.back()]);
  return lines;
}

std::vector<PlaneFaces::Line> lines_of_chains(const ExactMesh& mesh, const Chains& chains) {
  std::vector<PlaneFaces::Line> lines;
  for (const Chain& chain : chains)
    for (std::size_t i = 1; i < chain.path.size(); ++i)
      lines.emplace_back(mesh.plain.points[chain.path[i - 1]], mesh.plain.points[chain.path[i]]);
  return lines;
}

/// Pairs of faces, each with at most one partner.
class Pairs {
 public:
  /// False if one of them has another partner.
  bool add(Face wall, Face chain) {
    return of_wall_.emplace(wall, chain).first->second == chain && of_chain_.emplace(chain, wall).first->second == wall;
  }
  [[nodiscard]] bool contain(Face wall, Face chain) const {
    const auto at = of_wall_.find(wall);
    return at != of_wall_.end() && at->second == chain;
  }

 private:
  std::map<Face, Face> of_wall_, of_chain_;
};

}  // namespace

FacesOfChains::FacesOfChains(const ExactMesh& mesh, const Chains& chains, const Pslg& pslg, const InputFaces& faces) {
  const PlaneFaces walls(lines_of_walls(mesh, chains)), drawn(lines_of_chains(mesh, chains));
  const auto& p = mesh.plain.points;
  Pairs pairs;
  std::map<Face, InputFaces::Face> in_domain;
  pairs.add(walls.outside(), drawn.outside());
  for (const Chain& chain : chains) {
    const auto& path = chain.path;
    const Face left = walls.left_of(p[path.front()], p[path.back()]);
    const Face right = walls.left_of(p[path.back()], p[path.front()]);
    for (std::size_t i = 1; i < path.size(); ++i) {
      const Face drawn_left = drawn.left_of(p[path[i - 1]], p[path[i]]);
      const Face drawn_right = drawn.left_of(p[path[i]], p[path[i - 1]]);
      correspond = pairs.add(left, drawn_left) && pairs.add(right, drawn_right) && correspond;
      in_domain.emplace(drawn_left, chain.wall->left);
      in_domain.emplace(drawn_right, chain.wall->right);
    }
  }
  if (!correspond) return;
  for (Index i = 0; i < pslg.points.size(); ++i) {
    const auto& all = faces.walls();
    const bool is_on_wall = std::ranges::any_of(all, [&](const Wall& wall) { return wall.a == i || wall.b == i; });
    if (is_on_wall || !faces.contains(p[i])) continue;
    if (!pairs.contain(walls.around(p[i]).front(), drawn.around(p[i]).front())) strayed.insert(i);
  }
  for (const ref::Corners& c : mesh.plain.triangles)
    of_triangle.push_back(in_domain.at(drawn.around(CGAL::centroid(p[c[0]], p[c[1]], p[c[2]])).front()));
}

std::set<std::pair<Index, Index>> triangles_in_holes(const ExactMesh& mesh, const Chains& chains, const Pslg& pslg) {
  std::set<std::pair<Index, Index>> found;
  for (Index h = 0; h < pslg.holes.size(); ++h) {
    const Point seed = pslg.holes[h];
    std::set<Index> beside;  // the vertices of the chains that may have passed the seed
    for (const auto& [wall, path] : chains)
      if (is_within_two_units(seed, pslg.points[wall->a], pslg.points[wall->b]))
        beside.insert(path.begin(), path.end());
    for (Index t = 0; t < mesh.plain.triangles.size(); ++t) {
      const auto& [a, b, c] = mesh.plain.triangles[t];
      const auto& p = mesh.plain.points;
      if (ref::Kernel::Triangle_2(p[a], p[b], p[c]).has_on_unbounded_side(ref::exact(seed))) continue;
      if (!beside.contains(a) && !beside.contains(b) && !beside.contains(c)) found.emplace(t, h);
    }
  }
  return found;
}

bool are_chains_of_the_domain(const ExactMesh& mesh, const Chains& chains, const Pslg& pslg, const InputFaces& faces) {
  if (!meeting_points(chains, pslg).empty() || !points_of_another_order(mesh, chains, pslg).empty()) return false;
  if (!has_the_sides_of_the_domain(mesh, chains)) return false;
  const FacesOfChains of_chains(mesh, chains, pslg, faces);
  return of_chains.correspond && of_chains.strayed.empty();
}

}  // namespace pardel::fuzz
