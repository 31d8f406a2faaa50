#include "adjacency.hpp"

namespace pardel::checker {

void rebuild_neighbours(std::span<Triangle> triangles, std::vector<NonManifoldEdge>& non_manifold, StopSignal* stop) {
  SparseAsk ask(stop);
  struct HalfEdge {
    Index low, high;
    Index triangle;
    std::uint8_t edge;
    bool rising;  ///< runs from low to high
  };
  Array<HalfEdge> halves;
  halves.reserve(3 * triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    ask();
    triangles[t].n = {no_index, no_index, no_index};
    for (int i = 0; i < 3; ++i) {
      const Index from = triangles[t].v[next(i)];
      const Index to = triangles[t].v[previous(i)];
      halves.push_back(
          {std::min(from, to), std::max(from, to), static_cast<Index>(t), static_cast<std::uint8_t>(i), from < to});
    }
  }
  const auto less = [](const HalfEdge& x, const HalfEdge& y) {
    if (x.low != y.low) return x.low < y.low;
    if (x.high != y.high) return x.high < y.high;
    if (x.rising != y.rising) return x.rising;
    return x.triangle < y.triangle;
  };
  stoppable_sort(halves.begin(), halves.end(), less, stop);
  for (const HalfEdge* first = halves.begin(); first != halves.end();) {
    ask();
    const HalfEdge* last = first;
    while (last != halves.end() && last->low == first->low && last->high == first->high) ++last;
    const HalfEdge* falling = std::find_if(first, last, [](const HalfEdge& h) { return !h.rising; });
    if (falling != first && falling != last) {
      triangles[first->triangle].n[first->edge] = falling->triangle;
      triangles[falling->triangle].n[falling->edge] = first->triangle;
    }
    if (falling - first > 1 || last - falling > 1) {
      NonManifoldEdge edge{first->low, first->high, {}};
      for (const HalfEdge* h = first; h != last; ++h) edge.triangles.push_back(h->triangle);
      non_manifold.push_back(std::move(edge));
    }
    first = last;
  }
}

Adjacency::Adjacency(Array<Triangle> rebuilt, const Mesh& mesh, StopSignal* stop)
    : rebuilt_(std::move(rebuilt)),
      triangles_(rebuilt_.empty() ? mesh.triangles.span() : std::as_const(rebuilt_).span()),
      start_(mesh.points.size(), no_index),
      corners_(mesh.points.size(), 0),
      on_boundary_(mesh.points.size(), 0) {
  SparseAsk ask(stop);
  for (std::size_t t = 0; t < triangles_.size(); ++t) {
    ask();
    const Triangle& triangle = triangles_[t];
    for (int i = 0; i < 3; ++i) {
      start_[triangle.v[i]] = static_cast<Index>(t);
      ++corners_[triangle.v[i]];
      if (triangle.n[i] != no_index) continue;
      const Index from = triangle.v[next(i)];
      const Index to = triangle.v[previous(i)];
      boundary_.push_back({from, to, {static_cast<Index>(t), i}});
      on_boundary_[from] = on_boundary_[to] = 1;
    }
  }
  const auto less = [](const BoundaryEdge& x, const BoundaryEdge& y) {
    if (x.from != y.from) return x.from < y.from;
    if (x.to != y.to) return x.to < y.to;
    return x.left.triangle < y.left.triangle;
  };
  stoppable_sort(boundary_.begin(), boundary_.end(), less, stop);
}

void Adjacency::index_irregular_vertices(StopSignal* stop) {
  SparseAsk ask(stop);
  Array<char> is_irregular(start_.size(), 0);
  bool any = false;
  for (std::size_t v = 0; v < start_.size(); ++v) {
    ask();
    Index reached = 0;
    visit_fans(static_cast<Index>(v), [&](Index, int) { ++reached; });
    is_irregular[v] = reached != corners_[v];
    any = any || is_irregular[v] != 0;
  }
  if (!any) return;
  std::vector<std::pair<Index, Index>> found;
  for (std::size_t t = 0; t < triangles_.size(); ++t) {
    ask();
    for (const Index v : triangles_[t].v)
      if (is_irregular[v] != 0) found.emplace_back(v, static_cast<Index>(t));
  }
  std::sort(found.begin(), found.end());
  irregular_ = std::move(found);
}

TriangleEdge Adjacency::left_of(Index a, Index b) const {
  TriangleEdge found;
  visit_fans(a, [&](Index t, int corner) {
    if (triangles_[t].v[next(corner)] == b) found = {t, previous(corner)};
  });
  return found;
}

}  // namespace pardel::checker
