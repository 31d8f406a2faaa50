// Checks that the triangles cover the domain exactly once, and cover nothing else.
//
// Triangles are counter-clockwise. In the sum of their boundaries, the two directions of a common edge cancel; the
// edges without a neighbour, the boundary edges, remain. So the number of triangles that cover a point is the winding
// number of the boundary edges around it. Suppose that the boundary edges are exactly the chain edges between the
// domain and the rest, with the domain on their left. Take a point that is further from the segments than the chains
// are. The chains can be moved onto the segments without passing over this point, so it is covered once if it lies in
// the domain, and never otherwise. For the points between chains and segments the winding number of every face of the
// boundary is computed; it must be 0 or 1. What the faces between chains correspond to is examined by check_faces().
#include <algorithm>
#include <functional>

#include "../arithmetic/exact.hpp"
#include "../arithmetic/exact_sum.hpp"
#include "../arithmetic/measure.hpp"
#include "../arithmetic/text.hpp"
#include "../model/box_tree.hpp"
#include "stages.hpp"

namespace pardel::checker {
namespace {

/// A chain edge must have a triangle on each side that belongs to the domain, and none on the other sides.
void check_sides(const Subject& subject, const Domain& domain, const Chains& chains, Findings& found) {
  const Numbering& names = subject.names;
  SparseAsk ask(found.stop());
  for (const ChainEdge& edge : chains.edges) {
    ask();
    for (const Side side : {Side::left, Side::right}) {
      const TriangleEdge triangle = side == Side::left ? edge.left : edge.right;
      const bool expected = domain.inside(edge.segment, side);
      if (triangle.exists() == expected) continue;
      const Witness place = std::string(side == Side::left ? "left" : "right") + " of edge " +
                            names.edge_text(edge.from, edge.to) + " of segment " + domain_number(edge.segment);
      const std::vector<Point> where{subject.mesh.points[edge.from], subject.mesh.points[edge.to]};
      if (expected)
        found.add(ViolationKind::uncovered_domain, {names.vertex(edge.from), names.vertex(edge.to), edge.segment},
                  where, "no triangle on the " + place + ", where the domain is");
      else
        found.add(ViolationKind::covered_exterior,
                  {names.triangle(triangle.triangle), names.vertex(edge.from), names.vertex(edge.to), edge.segment},
                  where,
                  "triangle " + triangle_number(names.triangle(triangle.triangle)) + " on the " + place +
                      ", outside the domain");
    }
  }
}

/// Each face of the domain must have a triangle at one of its segments.
void check_presence(const Subject& subject, const Domain& domain, const Chains& chains, Findings& found) {
  std::vector<char> has_triangle(domain.faces().count(), 0);
  SparseAsk ask(found.stop());
  for (const ChainEdge& edge : chains.edges) {
    ask();
    if (edge.left.exists()) has_triangle[domain.faces().face(edge.segment, Side::left)] = 1;
    if (edge.right.exists()) has_triangle[domain.faces().face(edge.segment, Side::right)] = 1;
  }
  for (std::size_t s = 0; s < domain.segments().size(); ++s) {
    ask();
    const Segment& segment = domain.segments()[s];
    for (const Side side : {Side::left, Side::right}) {
      const Index face = domain.faces().face(static_cast<Index>(s), side);
      if (!domain.inside(face) || has_triangle[face] != 0) continue;
      has_triangle[face] = 1;  // one report for each face
      found.add(ViolationKind::uncovered_domain, {static_cast<Index>(s)},
                {subject.pslg.points[segment.a], subject.pslg.points[segment.b]},
                "the face of the domain on the " + std::string(side == Side::left ? "left" : "right") + " of segment " +
                    domain_number(s) + " has no triangle at any of its segments");
    }
  }
}

/// Reports an overlap if two boundary edges have more than an end in common. name[i] is the name of
/// the vertex at points[i].
void check_simple(std::span<const Point> points, std::span<const Segment> edges, std::span<const Index> name,
                  Findings& found) {
  std::vector<BoundingBox> boxes(edges.size());
  for (std::size_t e = 0; e < edges.size(); ++e) {
    boxes[e].include(points[edges[e].a]);
    boxes[e].include(points[edges[e].b]);
  }
  const BoxTree tree(boxes, found.stop());
  check_each(edges.size(), found, [&](std::size_t e, Findings& mine) {
    const Segment s = edges[e];
    const Point a = points[s.a], b = points[s.b];
    std::vector<Index> later;  // that may meet this edge
    tree.visit([&](const BoundingBox& box) { return box.meets(boxes[e]); },
               [&](Index other) {
                 if (other > e) later.push_back(other);
               });
    std::ranges::sort(later);
    for (const Index other : later) {
      const Segment t = edges[other];
      const Point c = points[t.a], d = points[t.b];
      const int side_c = exactly::orientation(a, b, c), side_d = exactly::orientation(a, b, d);
      const int side_a = exactly::orientation(c, d, a), side_b = exactly::orientation(c, d, b);
      const bool share_an_end = s.a == t.a || s.a == t.b || s.b == t.a || s.b == t.b;
      bool meet = side_c * side_d <= 0 && side_a * side_b <= 0;  // true for collinear edges, whose boxes meet
      if (share_an_end) {
        // Only collinear edges on the same side of the shared end overlap.
        const Index pivot = s.a == t.a || s.a == t.b ? s.a : s.b;
        const Index p = s.a == pivot ? s.b : s.a, q = t.a == pivot ? t.b : t.a;
        meet = side_c == 0 && side_d == 0 &&
               (p == q || exactly::progress(points[pivot], points[p], points[pivot], points[q]) > 0);
      }
      if (!meet) continue;
      mine.add(ViolationKind::overlap, {name[s.a], name[s.b], name[t.a], name[t.b]}, {a, b, c, d},
               "boundary edges " + edge_text(name[s.a], name[s.b]) + " and " + edge_text(name[t.a], name[t.b]) +
                   " intersect: the ends of each lie on sides " + to_text(side_c) + ", " + to_text(side_d) + " and " +
                   to_text(side_a) + ", " + to_text(side_b) + " of the other");
    }
  });
}

/// The winding number of the boundary in each face of the graph. It is 0 in the exterior, and on the left of a boundary
/// edge it is one larger than on the right.
std::vector<int> winding_numbers(const ChainGraph& graph, StopSignal* stop) {
  struct Step {
    Index from, to;
    int change;
  };
  const PlanarFaces& faces = graph.faces();
  std::vector<Step> steps;
  for (std::size_t i = 0; i < graph.edges().size(); ++i) {
    const auto e = static_cast<Index>(i);
    const Index left = faces.face(e, Side::left), right = faces.face(e, Side::right);
    const int change = i < graph.boundary().size() ? 1 : 0;
    steps.push_back({left, right, -change});
    steps.push_back({right, left, change});
  }
  stoppable_sort(
      steps.begin(), steps.end(), [](const Step& x, const Step& y) { return x.from < y.from; }, stop);
  std::vector<int> winding(faces.count(), 0);
  std::vector<char> known(faces.count(), 0);
  std::vector<Index> stack{PlanarFaces::exterior()};
  known[PlanarFaces::exterior()] = 1;
  SparseAsk ask(stop);
  while (!stack.empty()) {
    ask();
    const Index face = stack.back();
    stack.pop_back();
    auto step = std::lower_bound(steps.begin(), steps.end(), face, [](const Step& s, Index f) { return s.from < f; });
    for (; step != steps.end() && step->from == face; ++step) {
      if (known[step->to] != 0) continue;
      known[step->to] = 1;
      winding[step->to] = winding[face] + step->change;
      stack.push_back(step->to);
    }
  }
  return winding;
}

/// The holes with seeds that triangles may contain. If the edges of the boundary meet at their ends only, and all
/// triangles are counter-clockwise (`regular`), then the winding number around a point in no edge of the boundary is
/// the number of triangles that cover the points near it.
std::vector<Index> holes_not_excluded(const Subject& subject, const PlanarFaces& faces, const std::vector<int>& winding,
                                      bool regular) {
  std::vector<Index> holes;
  for (std::size_t h = 0; h < subject.pslg.holes.size(); ++h) {
    const Index face = faces.face_at(subject.pslg.holes[h]);
    if (!regular || face == no_index || winding[face] != 0) holes.push_back(static_cast<Index>(h));
  }
  return holes;
}

/// Reports boundary edges that are not part of a chain, and faces that are covered more than once. Returns the holes
/// with seeds that triangles may contain.
std::vector<Index> check_boundary(const Subject& subject, const Domain& domain, const Adjacency& adjacency,
                                  const Chains& chains, const ChainGraph& graph, Findings& found) {
  const Numbering& names = subject.names;
  const auto boundary = adjacency.boundary();
  std::vector<Index> name_of_vertex;
  name_of_vertex.reserve(graph.vertices().size());
  for (const Index v : graph.vertices()) name_of_vertex.push_back(names.vertex(v));
  check_simple(graph.points(), graph.boundary(), name_of_vertex, found);
  const bool simple = found.count(ViolationKind::overlap) == 0;

  const PlanarFaces& faces = graph.faces();
  const std::vector<int> winding = winding_numbers(graph, found.stop());
  SparseAsk ask(found.stop());
  for (std::size_t i = 0; i < boundary.size(); ++i) {
    ask();
    const auto e = static_cast<Index>(i);
    const BoundaryEdge& edge = boundary[i];
    const std::vector<Point> where{subject.mesh.points[edge.from], subject.mesh.points[edge.to]};
    const std::vector<Index> in_names{names.triangle(edge.left.triangle), names.vertex(edge.from),
                                      names.vertex(edge.to)};
    const int left = winding[faces.face(e, Side::left)];
    const int right = winding[faces.face(e, Side::right)];
    if (simple && (left != 1 || right != 0)) {
      found.add(ViolationKind::overlap, in_names, where,
                "the triangles cover the left of boundary edge " + names.edge_text(edge.from, edge.to) + " " +
                    to_text(left) + " times and its right " + to_text(right) + " times");
    }
    if (chains.has(edge.left.triangle, edge.left.edge)) continue;
    if (domain.inside(domain.faces().face_at(midpoint(where[0], where[1])))) {
      if (!simple || right == 0)
        found.add(ViolationKind::uncovered_domain, in_names, where,
                  "edge " + names.edge_text(edge.from, edge.to) + " of triangle " + triangle_number(in_names[0]) +
                      " has no neighbour although it lies inside the domain and on no segment");
    } else {
      found.add(ViolationKind::covered_exterior, in_names, where,
                "triangle " + triangle_number(in_names[0]) + " ends at edge " + names.edge_text(edge.from, edge.to) +
                    ", which lies on no chain and not inside the domain");
    }
  }
  return holes_not_excluded(subject, faces, winding, simple && found.count(ViolationKind::degenerate_triangle) == 0);
}

/// The exact sum of the triangles' areas must be the exact area within the chains that bound the domain.
void check_area(const Subject& subject, const Domain& domain, const Adjacency& adjacency, const Chains& chains,
                Findings& found) {
  const Mesh& mesh = subject.mesh;
  const ExactSum covered = covered_area(mesh.points.span(), adjacency);
  ExactSum enclosed;
  SparseAsk ask(found.stop());
  for (const ChainEdge& edge : chains.edges) {
    ask();
    const Point a = mesh.points[edge.from], b = mesh.points[edge.to];
    if (!domain.on_boundary(edge.segment)) continue;
    if (domain.inside(edge.segment, Side::left))
      enclosed.add_cross(a, b);
    else
      enclosed.add_cross(b, a);
  }
  ExactSum difference = covered;
  difference -= enclosed;
  if (difference.sign() != 0)
    found.add(ViolationKind::area_mismatch, {}, {},
              "the triangles' areas sum to " + to_text(covered.rounded() / 2) + ", the area within the boundary is " +
                  to_text(enclosed.rounded() / 2) + "; the exact difference rounds to " +
                  to_text(difference.rounded() / 2));
}

}  // namespace

std::vector<Index> check_coverage(const Subject& subject, const Domain& domain, const Adjacency& adjacency,
                                  const Chains& chains, Findings& found) {
  check_sides(subject, domain, chains, found);
  check_presence(subject, domain, chains, found);
  const ChainGraph graph(subject.mesh.points.span(), adjacency, chains, found.stop());
  std::vector<Index> suspects = check_boundary(subject, domain, adjacency, chains, graph, found);
  check_faces(subject, domain, chains, graph, found);
  if (chains.broken.empty()) check_area(subject, domain, adjacency, chains, found);
  return suspects;
}

}  // namespace pardel::checker
