#include "definitions.hpp"

#include <algorithm>

namespace pardel::ref {
namespace {

const ExactPoint& corner(const PlainMesh& mesh, const Corners& t, int i) { return mesh.points[t[i % 3]]; }

bool is_corner(const Corners& t, Index v) { return t[0] == v || t[1] == v || t[2] == v; }

std::set<Index> used_vertices(const PlainMesh& mesh) {
  std::set<Index> used;
  for (const Corners& t : mesh.triangles) used.insert(t.begin(), t.end());
  return used;
}

/// Does the constraint ab hide q from p: does it meet the open segment pq?
bool blocks(const ExactPoint& a, const ExactPoint& b, const ExactPoint& p, const ExactPoint& q) {
  const auto ends = CGAL::intersection(Kernel::Segment_2(a, b), Kernel::Segment_2(p, q));
  if (!ends) return false;
  if (const ExactPoint* at = boost::get<ExactPoint>(&*ends)) return *at != p && *at != q;
  return true;  // a common piece
}

}  // namespace

Edge edge(Index a, Index b) { return a < b ? Edge{a, b} : Edge{b, a}; }
Edge edge_of(const Corners& t, int i) { return edge(t[(i + 1) % 3], t[(i + 2) % 3]); }

Number squared_circumradius(const PlainMesh& mesh, const Corners& t) {
  return CGAL::squared_radius(corner(mesh, t, 0), corner(mesh, t, 1), corner(mesh, t, 2));
}

ExactPoint circumcentre(const PlainMesh& mesh, const Corners& t) {
  return CGAL::circumcenter(corner(mesh, t, 0), corner(mesh, t, 1), corner(mesh, t, 2));
}

Number squared_shortest_edge(const PlainMesh& mesh, const Corners& t) {
  Number shortest = CGAL::squared_distance(corner(mesh, t, 0), corner(mesh, t, 1));
  for (int i = 1; i < 3; ++i)
    shortest = std::min(shortest, Number(CGAL::squared_distance(corner(mesh, t, i), corner(mesh, t, i + 1))));
  return shortest;
}

Number area(const PlainMesh& mesh, const Corners& t) {
  return CGAL::area(corner(mesh, t, 0), corner(mesh, t, 1), corner(mesh, t, 2));
}

bool circumdisk_contains(const PlainMesh& mesh, const Corners& t, const ExactPoint& p) {
  return CGAL::side_of_bounded_circle(corner(mesh, t, 0), corner(mesh, t, 1), corner(mesh, t, 2), p) ==
         CGAL::ON_BOUNDED_SIDE;
}

bool sees(const PlainMesh& mesh, const ExactPoint& p, const Corners& t) {
  const ExactPoint a = corner(mesh, t, 0), b = corner(mesh, t, 1), c = corner(mesh, t, 2);
  // Only a constraint that meets the convex hull of p and t can be in the way.
  const CGAL::Bbox_2 around = p.bbox() + a.bbox() + b.bbox() + c.bbox();
  std::vector<Kernel::Segment_2> walls;
  for (const Edge& e : mesh.constraints) {
    const Kernel::Segment_2 wall(mesh.points[e[0]], mesh.points[e[1]]);
    if (CGAL::do_overlap(wall.bbox(), around)) walls.push_back(wall);
  }
  if (walls.empty()) return true;
  // What p sees changes only where a ray from p passes an end of a wall, so t's edges are cut by all those
  // rays, and p looks once through every piece. No wall enters t's interior, so that whatever is seen of t
  // along a ray is seen as a whole: its middle stands for it.
  std::vector<ExactPoint> turns = {a, b, c};
  for (const Kernel::Segment_2& wall : walls) turns.insert(turns.end(), {wall.source(), wall.target()});
  const Kernel::Triangle_2 triangle(a, b, c);
  for (int i = 0; i < 3; ++i) {
    const ExactPoint from = triangle.vertex(i), to = triangle.vertex(i + 1);
    if (CGAL::collinear(p, from, to)) continue;  // edge-on: what lies behind it is met through the other edges
    std::vector<ExactPoint> stops;
    for (const ExactPoint& turn : turns) {
      if (turn == p) continue;
      const auto hit = CGAL::intersection(Kernel::Ray_2(p, turn), Kernel::Segment_2(from, to));
      if (hit) stops.push_back(boost::get<ExactPoint>(*hit));
    }
    std::sort(stops.begin(), stops.end());
    for (std::size_t k = 1; k < stops.size(); ++k) {
      if (stops[k - 1] == stops[k]) continue;
      const Kernel::Ray_2 look(p, CGAL::midpoint(stops[k - 1], stops[k]));
      const auto chord = boost::get<Kernel::Segment_2>(*CGAL::intersection(look, triangle));
      const ExactPoint target = CGAL::midpoint(chord.source(), chord.target());
      if (std::none_of(walls.begin(), walls.end(),
                       [&](const Kernel::Segment_2& wall) { return blocks(wall.source(), wall.target(), p, target); }))
        return true;
    }
  }
  return false;
}

bool is_delaunay(const PlainMesh& mesh) {
  const std::set<Index> vertices = used_vertices(mesh);
  return std::all_of(mesh.triangles.begin(), mesh.triangles.end(), [&](const Corners& t) {
    return std::none_of(vertices.begin(), vertices.end(),
                        [&](Index v) { return circumdisk_contains(mesh, t, mesh.points[v]); });
  });
}

bool is_constrained_delaunay(const PlainMesh& mesh) {
  const std::set<Index> vertices = used_vertices(mesh);
  return std::all_of(mesh.triangles.begin(), mesh.triangles.end(), [&](const Corners& t) {
    return std::none_of(vertices.begin(), vertices.end(), [&](Index v) {
      const ExactPoint& p = mesh.points[v];
      return circumdisk_contains(mesh, t, p) && sees(mesh, p, t);
    });
  });
}

bool is_conformal(const PlainMesh& mesh) {
  const auto shape = [&](const Corners& t) {
    return Kernel::Triangle_2(corner(mesh, t, 0), corner(mesh, t, 1), corner(mesh, t, 2));
  };
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const Corners& t = mesh.triangles[i];
    if (shape(t).orientation() != CGAL::COUNTERCLOCKWISE) return false;
    for (std::size_t j = 0; j < i; ++j) {
      const Corners& u = mesh.triangles[j];
      const auto common = CGAL::intersection(shape(t), shape(u));
      if (!common) continue;
      const auto shared = std::count_if(t.begin(), t.end(), [&](Index v) { return is_corner(u, v); });
      if (boost::get<ExactPoint>(&*common)) {
        if (shared != 1) return false;
      } else if (const auto* piece = boost::get<Kernel::Segment_2>(&*common)) {
        if (shared != 2) return false;
        std::vector<ExactPoint> ends;
        for (Index v : t)
          if (is_corner(u, v)) ends.push_back(mesh.points[v]);
        if (CGAL::squared_distance(ends[0], ends[1]) != piece->squared_length()) return false;
      } else {
        return false;  // they overlap
      }
    }
  }
  return true;
}

std::vector<Index> cavity(const PlainMesh& mesh, const ExactPoint& p) {
  std::vector<Index> triangles;
  for (Index i = 0; i < mesh.triangles.size(); ++i)
    if (circumdisk_contains(mesh, mesh.triangles[i], p) && sees(mesh, p, mesh.triangles[i])) triangles.push_back(i);
  return triangles;
}

std::set<Index> closure(const PlainMesh& mesh, const std::vector<Index>& triangles) {
  std::set<Index> vertices;
  for (Index i : triangles) vertices.insert(mesh.triangles[i].begin(), mesh.triangles[i].end());
  return vertices;
}

bool encroaches(const ExactPoint& p, const ExactPoint& a, const ExactPoint& b) {
  return p != a && p != b && CGAL::angle(a, p, b) != CGAL::ACUTE;
}

std::vector<Edge> encroached_by(const PlainMesh& mesh, const ExactPoint& p) {
  std::vector<Edge> edges;
  for (const Edge& e : mesh.constraints)
    if (encroaches(p, mesh.points[e[0]], mesh.points[e[1]])) edges.push_back(e);
  return edges;
}

bool is_encroached(const PlainMesh& mesh, const Edge& e) {
  const std::set<Index> vertices = used_vertices(mesh);
  return std::any_of(vertices.begin(), vertices.end(),
                     [&](Index v) { return encroaches(mesh.points[v], mesh.points[e[0]], mesh.points[e[1]]); });
}

Number squared_circumradius_bound(const PlainMesh& mesh) {
  Number bound = 0;
  for (const Corners& t : mesh.triangles) bound = std::max(bound, squared_circumradius(mesh, t));
  return bound;
}

}  // namespace pardel::ref
