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

/// Does the constraint ab hide q from p? That is, does it meet the open segment pq?
bool blocks(const ExactPoint& a, const ExactPoint& b, const ExactPoint& p, const ExactPoint& q) {
  const auto ends = CGAL::intersection(Kernel::Segment_2(a, b), Kernel::Segment_2(p, q));
  if (!ends) return false;
  if (const ExactPoint* at = boost::get<ExactPoint>(&*ends)) return *at != p && *at != q;
  return true;  // a common piece
}

/// Are there points strictly on both sides of the line through m and n?
bool separates(const ExactPoint& m, const ExactPoint& n, const std::array<ExactPoint, 4>& points) {
  bool left = false, right = false;
  for (const ExactPoint& p : points) {
    const auto side = CGAL::orientation(m, n, p);
    left |= side == CGAL::LEFT_TURN;
    right |= side == CGAL::RIGHT_TURN;
  }
  return left && right;
}

/// Is the intersection of t and u empty, exactly their common vertex, or exactly their common edge? Precondition: both
/// are positively oriented.
bool meet_as_in_a_mesh(const PlainMesh& mesh, const Corners& t, const Corners& u) {
  const auto shape = [&](const Corners& c) {
    return Kernel::Triangle_2(mesh.points[c[0]], mesh.points[c[1]], mesh.points[c[2]]);
  };
  std::vector<int> common;  // corners of t
  for (int i = 0; i < 3; ++i)
    if (is_corner(u, t[i])) common.push_back(i);
  if (common.empty()) return !CGAL::do_intersect(shape(t), shape(u));
  if (common.size() == 3) return false;
  // One common vertex: suppose that there is a second common point. The ray to it from the common vertex leaves one of
  // the triangles first. It leaves through the edge opposite to the common vertex, at a point of the other triangle.
  const auto opposite_edge_meets = [&](const Corners& of, const Corners& other) {
    for (int i = 0; i < 3; ++i)
      if (of[i] == t[common[0]]) {
        const Kernel::Segment_2 opposite(corner(mesh, of, i + 1), corner(mesh, of, i + 2));
        return CGAL::do_intersect(opposite, shape(other));
      }
    return false;
  };
  if (common.size() == 1) return !opposite_edge_meets(t, u) && !opposite_edge_meets(u, t);
  // Two common vertices: the triangles lie on different sides of the common edge if they contain it in opposite
  // directions.
  const int apex = 3 - common[0] - common[1];
  const Index a = t[(apex + 1) % 3], b = t[(apex + 2) % 3];
  for (int i = 0; i < 3; ++i)
    if (u[i] == b && u[(i + 1) % 3] == a) return true;
  return false;
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
  // A constraint can hide t from p only if it meets the convex hull of p and t, and if its line has points of the hull
  // on both sides.
  const CGAL::Bbox_2 around = p.bbox() + a.bbox() + b.bbox() + c.bbox();
  std::vector<Kernel::Segment_2> walls;
  for (const Edge& e : mesh.constraints) {
    const ExactPoint &m = mesh.points[e[0]], &n = mesh.points[e[1]];
    if (CGAL::do_overlap(m.bbox() + n.bbox(), around) && separates(m, n, {p, a, b, c})) walls.emplace_back(m, n);
  }
  if (walls.empty()) return true;
  // As a ray from p turns, visibility changes only when it passes an end of a wall. So these rays cut the edges of t
  // into pieces, and one ray through each piece is tested. No wall enters the interior of t. So p sees the whole part
  // of t along a ray or none of it, and it is enough to test the midpoint of this part.
  std::vector<ExactPoint> turns = {a, b, c};
  for (const Kernel::Segment_2& wall : walls) turns.insert(turns.end(), {wall.source(), wall.target()});
  const Kernel::Triangle_2 triangle(a, b, c);
  for (int i = 0; i < 3; ++i) {
    const ExactPoint from = triangle.vertex(i), to = triangle.vertex(i + 1);
    if (CGAL::collinear(p, from, to)) continue;  // rays into t pass through the other edges
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
  std::vector<CGAL::Bbox_2> boxes;
  for (const Corners& t : mesh.triangles) {
    if (!CGAL::left_turn(corner(mesh, t, 0), corner(mesh, t, 1), corner(mesh, t, 2))) return false;
    boxes.push_back(corner(mesh, t, 0).bbox() + corner(mesh, t, 1).bbox() + corner(mesh, t, 2).bbox());
    for (std::size_t j = 0; j + 1 < boxes.size(); ++j)
      if (CGAL::do_overlap(boxes[j], boxes.back()) && !meet_as_in_a_mesh(mesh, t, mesh.triangles[j])) return false;
  }
  return true;
}

std::vector<Index> cavity(const PlainMesh& mesh, const ExactPoint& p) {
  std::vector<Index> triangles;
  for (Index i = 0; i < mesh.triangles.size(); ++i) {
    const Corners& t = mesh.triangles[i];
    if (circumdisk_contains(mesh, t, p) && sees(mesh, p, t)) triangles.push_back(i);
  }
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
