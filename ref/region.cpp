#include "region.hpp"

#include <algorithm>

namespace pardel::ref {
namespace {

/// The corners of a convex polygon, counter-clockwise. The polygon may be a segment or a point.
using Polygon = std::vector<ExactPoint>;

Polygon corners_of(const Box& box) {
  return {exact(box.low), {box.high.x, box.low.y}, exact(box.high), {box.low.x, box.high.y}};
}

struct Disk {
  ExactPoint centre;
  Number squared_radius;
};

Disk circumdisk(const PlainMesh& mesh, const Corners& t) {
  const ExactPoint centre = circumcentre(mesh, t);
  return {centre, CGAL::squared_distance(centre, mesh.points[t[0]])};
}

/// Does the open disk meet the polygon?
bool meets(const Disk& disk, const Polygon& polygon) {
  int left_turns = 0, right_turns = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const ExactPoint &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    if (CGAL::squared_distance(disk.centre, Kernel::Segment_2(a, b)) < disk.squared_radius) return true;
    left_turns += CGAL::left_turn(a, b, disk.centre) ? 1 : 0;
    right_turns += CGAL::right_turn(a, b, disk.centre) ? 1 : 0;
  }
  return left_turns > 0 && right_turns == 0;  // the centre is inside
}

/// Does the constraint ab cut the open disk into two parts?
bool crosses(const Disk& disk, const ExactPoint& a, const ExactPoint& b) {
  return CGAL::squared_distance(disk.centre, a) >= disk.squared_radius &&
         CGAL::squared_distance(disk.centre, b) >= disk.squared_radius &&
         CGAL::squared_distance(disk.centre, Kernel::Segment_2(a, b)) < disk.squared_radius;
}

/// The part of the polygon on the line ab or to the left of it.
Polygon left_part(const Polygon& polygon, const ExactPoint& a, const ExactPoint& b) {
  Polygon part;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const ExactPoint &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    const CGAL::Orientation at_p = CGAL::orientation(a, b, p), at_q = CGAL::orientation(a, b, q);
    if (at_p != CGAL::RIGHT_TURN) part.push_back(p);
    if (at_p * at_q == CGAL::NEGATIVE)
      part.push_back(boost::get<ExactPoint>(*CGAL::intersection(Kernel::Line_2(a, b), Kernel::Segment_2(p, q))));
  }
  return part;
}

/// Does t lie to the left of ab? Precondition: the line ab does not cross the interior of t.
bool lies_left(const PlainMesh& mesh, const Corners& t, const ExactPoint& a, const ExactPoint& b) {
  return std::any_of(t.begin(), t.end(), [&](Index v) { return CGAL::left_turn(a, b, mesh.points[v]); });
}

Polygon part_in_sight(const PlainMesh& mesh, const Corners& t, const Disk& disk, Polygon region) {
  for (const Edge& e : mesh.constraints) {
    const ExactPoint &a = mesh.points[e[0]], &b = mesh.points[e[1]];
    if (!crosses(disk, a, b)) continue;
    region = lies_left(mesh, t, a, b) ? left_part(region, a, b) : left_part(region, b, a);
  }
  return region;
}

}  // namespace

bool contains(const Box& box, const ExactPoint& p) {
  return box.low.x <= p.x() && p.x() <= box.high.x && box.low.y <= p.y() && p.y() <= box.high.y;
}

std::vector<Index> in_reach_of(const PlainMesh& mesh, const Box& region) {
  const Polygon polygon = corners_of(region);
  std::vector<Index> reached;
  for (Index i = 0; i < mesh.triangles.size(); ++i)
    if (meets(circumdisk(mesh, mesh.triangles[i]), polygon)) reached.push_back(i);
  return reached;
}

std::vector<Index> in_reach_and_sight_of(const PlainMesh& mesh, const Box& region) {
  const Polygon polygon = corners_of(region);
  std::vector<Index> reached;
  for (const Index i : in_reach_of(mesh, region)) {
    const Corners& t = mesh.triangles[i];
    const Disk disk = circumdisk(mesh, t);
    if (meets(disk, part_in_sight(mesh, t, disk, polygon))) reached.push_back(i);
  }
  return reached;
}

std::set<Edge> free_edges(const PlainMesh& mesh, const std::vector<Index>& triangles) {
  std::set<Edge> edges;
  for (const Index t : triangles)
    for (int i = 0; i < 3; ++i)
      if (const Edge e = edge_of(mesh.triangles[t], i); !mesh.constraints.contains(e)) edges.insert(e);
  return edges;
}

bool owns(const PlainMesh& mesh, const Box& box, const std::vector<Index>& triangles) {
  return std::all_of(triangles.begin(), triangles.end(), [&](Index i) {
    const Corners& t = mesh.triangles[i];
    return std::all_of(t.begin(), t.end(), [&](Index v) { return contains(box, mesh.points[v]); });
  });
}

}  // namespace pardel::ref
