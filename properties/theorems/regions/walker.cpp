#include "walker.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

#include "../../../ref/insertion.hpp"

namespace pardel::properties {
namespace {

using ref::Corners;
using ref::Edge;
using ref::ExactPoint;
using ref::PlainMesh;

/// The triangles that a walk reaches from those of `from`, across free edges, through triangles that `enters` accepts;
/// with those of `from`.
Triangles walk(const PlainMesh& mesh, const Triangles& from, const std::function<bool(const Corners&)>& enters) {
  std::map<Edge, Corners> left_of;
  for (const Corners& t : mesh.triangles)
    for (int k = 0; k < 3; ++k) left_of[{t[k], t[(k + 1) % 3]}] = t;
  Triangles reached = from;
  std::vector<Corners> ahead(from.begin(), from.end());
  while (!ahead.empty()) {
    const Corners t = ahead.back();
    ahead.pop_back();
    for (int k = 0; k < 3; ++k) {
      const Index a = t[k], b = t[(k + 1) % 3];
      const auto across = left_of.find({b, a});
      if (across == left_of.end() || mesh.constraints.contains(ref::edge(a, b))) continue;
      if (enters(across->second) && reached.insert(across->second).second) ahead.push_back(across->second);
    }
  }
  return reached;
}

ExactPoint rounded_to_eighths(const ExactPoint& p) {
  const auto eighth = [](const ref::Number& x) { return std::round(8 * CGAL::to_double(x)) / 8; };
  return {eighth(p.x()), eighth(p.y())};
}

}  // namespace

Triangles closed_set(const PlainMesh& mesh, const Triangles& from, const ref::Box& region) {
  Triangles in_reach;
  for (const Index t : ref::in_reach_of(mesh, region)) in_reach.insert(mesh.triangles[t]);
  return walk(mesh, from, [&](const Corners& t) { return in_reach.contains(t); });
}

/// The wall of a triangle of the set whose middle is nearest to the point; of several, the first by coordinates.
std::optional<Edge> Walker::nearest_wall(const PlainMesh& mesh, Point at) const {
  std::optional<Edge> nearest;
  const auto rank = [&](const Edge& e) {
    const ExactPoint middle = CGAL::midpoint(mesh.points[e[0]], mesh.points[e[1]]);
    return std::pair(CGAL::squared_distance(middle, ref::exact(at)), middle);
  };
  for (const Corners& t : set_)
    for (int k = 0; k < 3; ++k)
      if (const Edge e = ref::edge(t[k], t[(k + 1) % 3]); mesh.constraints.contains(e))
        if (!nearest || rank(e) < rank(*nearest)) nearest = e;
  return nearest;
}

std::optional<Walker::Hole> Walker::found(const PlainMesh& mesh, const Wish& wish) const {
  Hole hole{ref::exact(wish.at), {}, {}, {}};
  Triangles first;
  if (wish.splits) {
    hole.wall = nearest_wall(mesh, wish.at);
    if (!hole.wall) return std::nullopt;
    const auto [m, n] = std::minmax(mesh.points[(*hole.wall)[0]], mesh.points[(*hole.wall)[1]]);
    hole.p = rounded_to_eighths(m + (n - m) / 3);
    for (const Corners& t : mesh.triangles)
      for (int k = 0; k < 3; ++k)
        if (ref::edge(t[k], t[(k + 1) % 3]) == *hole.wall) first.insert(t);
  } else {
    for (const Corners& t : set_)
      if (!ref::Kernel::Triangle_2(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]])
               .has_on_unbounded_side(hole.p))
        first.insert(t);
    // A point on a wall would split it; such points are wished as splits.
    if (first.empty() || ref::constraint_through(mesh, hole.p)) return std::nullopt;
  }
  if (!ref::contains(region_, hole.p)) return std::nullopt;
  const auto has_in_disk = [&](const Corners& t) { return circumdisk_contains(mesh, t, hole.p); };
  const auto may_begin = [&](const Corners& t) { return set_.contains(t) && has_in_disk(t); };
  if (!std::ranges::all_of(first, may_begin)) return std::nullopt;
  hole.triangles = walk(mesh, first, has_in_disk);

  PlainMesh part{mesh.points, {hole.triangles.begin(), hole.triangles.end()}, {}};
  std::vector<Index> all;
  for (Index t = 0; t < part.triangles.size(); ++t) all.push_back(t);
  hole.boundary = ref::boundary(part, all);
  std::erase_if(hole.boundary, [&](const Edge& e) { return hole.wall && ref::edge(e[0], e[1]) == *hole.wall; });
  const auto is_positive = [&](const Edge& e) {
    return CGAL::orientation(mesh.points[e[0]], mesh.points[e[1]], hole.p) == CGAL::POSITIVE;
  };
  if (!std::ranges::all_of(hole.boundary, is_positive)) return std::nullopt;
  return hole;
}

void Walker::replace(PlainMesh& mesh, const Hole& hole) {
  const auto vertex = static_cast<Index>(mesh.points.size());
  mesh.points.push_back(hole.p);
  touched_.insert(vertex);
  std::erase_if(mesh.triangles, [&](const Corners& t) { return hole.triangles.contains(t); });
  for (const Corners& t : hole.triangles) {
    set_.erase(t);
    touched_.insert(t.begin(), t.end());
  }
  for (const Edge& e : hole.boundary) {
    mesh.triangles.push_back({e[0], e[1], vertex});
    set_.insert({e[0], e[1], vertex});
  }
  ++inserted_;
  if (!hole.wall) return;
  const auto [m, n] = *hole.wall;
  bends_ += !CGAL::collinear(mesh.points[m], mesh.points[n], hole.p);
  ref::split_constraint(mesh, *hole.wall, vertex);
}

void Walker::step(PlainMesh& mesh) {
  if (!hole_ && (hole_ = found(mesh, wishes_[next_]))) return;
  if (hole_) replace(mesh, *hole_);
  hole_.reset();
  ++next_;
}

}  // namespace pardel::properties
