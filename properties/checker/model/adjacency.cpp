#include "adjacency.hpp"

#include <numeric>

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

void sort_boundary(std::vector<BoundaryEdge>& boundary, StopSignal* stop) {
  const auto less = [](const BoundaryEdge& x, const BoundaryEdge& y) {
    if (x.from != y.from) return x.from < y.from;
    if (x.to != y.to) return x.to < y.to;
    return x.left.triangle < y.left.triangle;
  };
  stoppable_sort(boundary.begin(), boundary.end(), less, stop);
}

Adjacency::Adjacency(std::span<const Triangle> triangles, Array<Index> start, std::vector<BoundaryEdge> boundary)
    : triangles_(triangles), boundary_(std::move(boundary)), start_(std::move(start)), on_boundary_(start_.size(), 0) {
  for (const BoundaryEdge& edge : boundary_) on_boundary_[edge.from] = on_boundary_[edge.to] = 1;
}

Adjacency::Adjacency(Array<Triangle> rebuilt, Array<Index> start, std::vector<BoundaryEdge> boundary)
    : Adjacency(std::as_const(rebuilt).span(), std::move(start), std::move(boundary)) {
  rebuilt_ = std::move(rebuilt);
}

void Adjacency::count_corners(StopSignal* stop) {
  if (!corners_.empty()) return;
  SparseAsk ask(stop);
  corners_.resize(start_.size(), 0);
  for (std::size_t t = 0; t < triangles_.size(); ++t) {
    ask();
    for (const Index v : triangles_[t].v) {
      start_[v] = static_cast<Index>(t);
      ++corners_[v];
    }
  }
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

Index Adjacency::count_up_to(Index vertex, Index most) const {
  Index count = 0;
  visit_fans(vertex, [&](Index, int) { return ++count < most; });
  return count;
}

bool Adjacency::has_fewer_triangles(Index a, Index b) const {
  // Both walks go on in turn, in steps of growing length, until the shorter one has ended.
  for (Index most = 16;; most *= 2) {
    const Index at_a = count_up_to(a, most), at_b = count_up_to(b, most);
    if (at_a < most || at_b < most) return at_a < at_b;
  }
}

TriangleEdge Adjacency::left_of(Index a, Index b) const {
  TriangleEdge found;
  visit_fans(a, [&](Index t, int corner) {
    if (triangles_[t].v[next(corner)] == b) found = {t, previous(corner)};
  });
  return found;
}

std::vector<Index> boundary_vertices(const Adjacency& adjacency) {
  std::vector<Index> vertices;
  for (const BoundaryEdge& edge : adjacency.boundary())
    if (vertices.empty() || vertices.back() != edge.from) vertices.push_back(edge.from);
  return vertices;
}

std::uint64_t count_used_vertices(const Adjacency& adjacency, std::size_t vertices, StopSignal* stop) {
  std::vector<std::uint64_t> counts(share_count(), 0);
  for_each_run(vertices, stop, [&](std::size_t first, std::size_t last, std::size_t share) {
    std::uint64_t used = 0;
    for (std::size_t v = first; v < last; ++v) used += adjacency.has_triangle(static_cast<Index>(v)) ? 1 : 0;
    counts[share] += used;
  });
  return std::accumulate(counts.begin(), counts.end(), std::uint64_t{0});
}

ExactSum covered_area(std::span<const Point> points, const Adjacency& adjacency) {
  ExactSum sum;
  for (const BoundaryEdge& edge : adjacency.boundary()) sum.add_cross(points[edge.from], points[edge.to]);
  return sum;
}

}  // namespace pardel::checker
