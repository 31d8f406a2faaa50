#include "part.hpp"

#include <algorithm>
#include <span>

#include "../../../core/support/without_repetitions.hpp"
#include "../mesh/predicates.hpp"
#include "../mesh/triangulation.hpp"

namespace pardel::schemes {
namespace {

using DirectedEdge = std::array<Index, 2>;

std::array<Index, 2> undirected(Index a, Index b) { return {std::min(a, b), std::max(a, b)}; }

std::vector<Index> sorted_ends(const std::vector<DirectedEdge>& edges) {
  std::vector<Index> ends;
  for (const auto& [a, b] : edges) {
    ends.push_back(a);
    ends.push_back(b);
  }
  sort_without_repetitions(ends);
  return ends;
}

bool holds(const std::vector<Index>& sorted, Index v) { return std::ranges::binary_search(sorted, v); }

/// Which edges lie inside a region.
class Inside {
 public:
  Inside(const std::vector<Point>& points, const std::vector<DirectedEdge>& border) : points_(points) {
    for (const auto& [a, b] : border) {
      spokes_.push_back({a, b, true});
      spokes_.push_back({b, a, false});
    }
    std::ranges::sort(spokes_, {}, &Spoke::at);
  }

  /// Does the edge ab lie inside the region? Not if it is part of the border. Precondition: it crosses no edge of the
  /// border, and at least one of its ends is inside or on the border.
  [[nodiscard]] bool operator()(Index a, Index b) const {
    const std::span<const Spoke> at_a = spokes_at(a);
    if (at_a.empty() || spokes_at(b).empty()) return true;
    if (std::any_of(at_a.begin(), at_a.end(), [b](const Spoke& s) { return s.to == b; })) return false;
    // The first edge clockwise from ab decides: the region is on the left of edges that leave a, and on the right of
    // those that arrive there, seen from a.
    const auto before = [&](const Spoke& s, const Spoke& r) {
      const int of_s = half(a, b, s.to), of_r = half(a, b, r.to);
      return of_s != of_r ? of_s < of_r : orientation(points_[a], points_[s.to], points_[r.to]) < 0;
    };
    return std::min_element(at_a.begin(), at_a.end(), before)->leaves;
  }

 private:
  struct Spoke {
    Index at, to;
    bool leaves;
  };
  [[nodiscard]] std::span<const Spoke> spokes_at(Index v) const {
    const auto from = std::ranges::lower_bound(spokes_, v, {}, &Spoke::at);
    const auto to = std::ranges::upper_bound(spokes_, v, {}, &Spoke::at);
    return {from, to};
  }
  /// 0 on the right of ab, 1 straight behind a, 2 on the left.
  [[nodiscard]] int half(Index a, Index b, Index v) const {
    return orientation(points_[a], points_[b], points_[v]) + 1;
  }

  const std::vector<Point>& points_;
  std::vector<Spoke> spokes_;
};

}  // namespace

std::vector<Index> inner_points(const Part& part) {
  const std::vector<Index> on_border = sorted_ends(part.border);
  std::vector<Index> inner;
  for (const Index v : part.points)
    if (!holds(on_border, v)) inner.push_back(v);
  return inner;
}

Index median(const std::vector<Point>& points, std::vector<Index> list, Cut cut, int lower, int count) {
  const auto key = [&](Index v) {
    const Point p = turned(points[v], cut);
    return std::pair(p.x, p.y);
  };
  const auto middle = list.begin() + static_cast<std::ptrdiff_t>(list.size() * static_cast<std::size_t>(lower) /
                                                                 static_cast<std::size_t>(count));
  std::nth_element(list.begin(), middle, list.end(), [&](Index v, Index w) { return key(v) < key(w); });
  return *middle;
}

PathPlaces::PathPlaces(const std::vector<Index>& path) {
  for (Index k = 0; k < path.size(); ++k) places_.emplace_back(path[k], k);
  std::ranges::sort(places_);
}

Index PathPlaces::operator[](Index v) const {
  const auto found = std::ranges::lower_bound(places_, v, {}, &std::pair<Index, Index>::first);
  return found != places_.end() && found->first == v ? found->second : no_index;
}

bool lies_low(const std::vector<Point>& points, const std::vector<Index>& path, const PathPlaces& places,
              const std::vector<Index>& vertices, Point m, Cut cut) {
  // A point that is not on the path is on the same side of the path and of the line (Section 2).
  Index first = no_index, last = 0;
  for (const Index v : vertices) {
    const Index place = places[v];
    if (place == no_index) return turned(points[v], cut).x < turned(m, cut).x;
    first = std::min(first, place);
    last = std::max(last, place);
  }
  // All are on the path. What the path passes between them lies on its other side, seen from the edge.
  const Point a = points[path[first]], b = points[path[last]];
  return orientation(a, b, points[path[first + 1]]) < 0;
}

Halves halves_of(const std::vector<Point>& points, const Part& part, const std::vector<Index>& path, Point m, Cut cut) {
  const PathPlaces places(path);
  const Inside inside(points, part.border);
  Halves halves;
  // Border edges stay on their side. Those on the path belong to the side on which their region is.
  for (const auto& [a, b] : part.border) {
    const Index from = places[a], to = places[b];
    const bool on_path = from != no_index && to != no_index && (from + 1 == to || to + 1 == from);
    const bool low = on_path ? from < to : lies_low(points, path, places, {a, b}, m, cut);
    (low ? halves.low : halves.high).border.push_back({a, b});
  }
  // The path may touch the border and leave the region: only its edges inside become new borders.
  for (std::size_t k = 1; k < path.size(); ++k) {
    if (!inside(path[k - 1], path[k])) continue;
    halves.low.border.push_back({path[k - 1], path[k]});
    halves.high.border.push_back({path[k], path[k - 1]});
  }
  const std::vector<Index> border = sorted_ends(part.border);
  const std::vector<Index> low = sorted_ends(halves.low.border), high = sorted_ends(halves.high.border);
  for (const Index v : part.points) {
    const bool off = places[v] == no_index && !holds(border, v);
    const bool below = off && lies_low(points, path, places, {v}, m, cut);
    if (below || holds(low, v)) halves.low.points.push_back(v);
    if ((off && !below) || holds(high, v)) halves.high.points.push_back(v);
  }
  return halves;
}

PartTriangles triangles_of(const std::vector<Point>& points, const Part& part) {
  PartTriangles result;
  Pslg local;
  for (const Index v : part.points) local.points.push_back(points[v]);
  Result<Triangulated> triangulated = triangulation_of(local);
  if (!triangulated) return result;  // no region: all points are on one line
  LinkedMesh& mesh = triangulated->mesh;
  result.work = triangulated->work + 2 * settle_ties(mesh);
  result.held = mesh.faces.size();

  std::vector<DirectedEdge> border = part.border;
  std::ranges::sort(border);
  const std::vector<Index> ends_of_border = sorted_ends(border);
  std::vector<bool> on_border;
  for (const Index v : part.points) on_border.push_back(holds(ends_of_border, v));
  const auto is_border = [&](Index v, Index w) {
    return on_border[v] && on_border[w] &&
           std::ranges::binary_search(border, DirectedEdge{part.points[v], part.points[w]});
  };
  // The region is what can be reached from the left of its border without crossing it.
  std::vector<bool> in_region(mesh.faces.size(), false);
  std::vector<Index> frontier;
  for (Index t = 0; t < mesh.faces.size(); ++t)
    for (int i = 0; i < 3; ++i)
      if (const auto [v, w] = ends(mesh, {t, i}); is_border(v, w)) frontier.push_back(t);
  while (!frontier.empty()) {
    const Index t = frontier.back();
    frontier.pop_back();
    if (in_region[t]) continue;
    in_region[t] = true;
    for (int i = 0; i < 3; ++i) {
      const auto [v, w] = ends(mesh, {t, i});
      if (mesh.faces[t].n[i] != no_index && !is_border(v, w) && !is_border(w, v))
        frontier.push_back(mesh.faces[t].n[i]);
    }
  }
  for (Index t = 0; t < mesh.faces.size(); ++t) {
    const Corners& v = mesh.faces[t].v;
    if (in_region[t]) result.triangles.push_back({part.points[v[0]], part.points[v[1]], part.points[v[2]]});
  }
  return result;
}

LinkedMesh linked(std::vector<Point> points, const std::vector<Corners>& triangles, const std::vector<Piece>& pieces,
                  std::vector<std::size_t>& missing) {
  LinkedMesh mesh{std::move(points), {}, {}, {}};
  mesh.segment_of.resize(mesh.points.size(), no_segment);
  struct Sided {
    std::array<Index, 2> ends;
    Side side;
  };
  std::vector<Sided> sides;
  sides.reserve(3 * triangles.size());
  for (const Corners& v : triangles) {
    const auto t = static_cast<Index>(mesh.faces.size());
    mesh.faces.push_back({v});
    for (int i = 0; i < 3; ++i) sides.push_back({undirected(v[(i + 1) % 3], v[(i + 2) % 3]), {t, i}});
  }
  std::ranges::sort(sides, {}, &Sided::ends);
  for (std::size_t k = 1; k < sides.size(); ++k) {
    if (sides[k - 1].ends != sides[k].ends) continue;
    const Side p = sides[k - 1].side, q = sides[k].side;
    mesh.faces[p.triangle].n[p.i] = q.triangle;
    mesh.faces[q.triangle].n[q.i] = p.triangle;
  }
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    const std::array<Index, 2> wanted = undirected(pieces[k].a, pieces[k].b);
    auto found = std::ranges::lower_bound(sides, wanted, {}, &Sided::ends);
    if (found == sides.end() || found->ends != wanted) missing.push_back(k);
    for (; found != sides.end() && found->ends == wanted; ++found)
      mesh.faces[found->side.triangle].segment[found->side.i] = pieces[k].segment;
  }
  return mesh;
}

}  // namespace pardel::schemes
