// The faces of a triangulation are known: its triangles and the exterior.
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <map>
#include <set>
#include <vector>

#include "../../../properties/checker/model/planar_faces.hpp"
#include "../../../properties/domains/generators/random.hpp"
#include "../../../properties/theorems/framework/property.hpp"

namespace pardel::checker {
namespace {

PARDEL_PROPERTY(PlanarFaces, of_a_triangulation_are_its_triangles,
                {.statement = "the faces of all edges of a triangulation are its triangles and the exterior",
                 .source = "properties/checker/model/planar_faces.hpp",
                 .families = "lattice points, collinear and cocircular ones among them"}) {
  using Delaunay = CGAL::Delaunay_triangulation_2<CGAL::Exact_predicates_inexact_constructions_kernel>;
  generators::Random random(*rc::gen::arbitrary<std::uint32_t>());
  Delaunay delaunay;
  const std::size_t range = 1 + random.below(40);  // small ranges: many collinear and vertical edges
  for (int i = 0; i < 100; ++i) {
    const auto x = static_cast<double>(random.below(range));
    delaunay.insert({x, static_cast<double>(random.below(range))});
  }
  RC_PRE(delaunay.dimension() == 2);
  std::map<Delaunay::Vertex_handle, Index> number;
  std::vector<Point> points;
  for (const auto v : delaunay.finite_vertex_handles()) {
    number[v] = static_cast<Index>(points.size());
    points.push_back({v->point().x(), v->point().y()});
  }
  std::vector<Segment> segments;
  for (const auto& [face, i] : delaunay.finite_edges())
    segments.push_back({number[face->vertex(face->cw(i))], number[face->vertex(face->ccw(i))], 0});
  const PlanarFaces faces(points, segments);
  RC_ASSERT(faces.count() == delaunay.number_of_faces() + 1);
  std::set<Index> met{PlanarFaces::exterior()};
  for (const auto face : delaunay.finite_face_handles()) {
    const auto p = face->vertex(0)->point(), q = face->vertex(1)->point(), r = face->vertex(2)->point();
    RC_ASSERT(met.insert(faces.face_at({(p.x() + q.x() + r.x()) / 3, (p.y() + q.y() + r.y()) / 3})).second);
  }
}

}  // namespace
}  // namespace pardel::checker
