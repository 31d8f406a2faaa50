#include "lattice.hpp"

#include <cmath>
#include <limits>

namespace pardel::ref {
namespace {

/// The least distance between points in cells that are not neighbours, in units of r̄ [CC, Theorem 1].
constexpr double separation = 4;

std::int64_t floor_of(const Number& x) {
  double below = std::floor(CGAL::to_double(x));  // may be wrong by 1 if x is close to an integer
  while (x < below) below -= 1;
  while (x >= below + 1) below += 1;
  return static_cast<std::int64_t>(below);
}

Lattice lattice_over(const CGAL::Bbox_2& box, const Number& squared_bound) {
  const double bound = std::sqrt(CGAL::to_interval(squared_bound).second);
  const double side = std::nextafter(separation * bound, std::numeric_limits<double>::infinity());
  return {{box.xmin(), box.ymin()}, side};
}

}  // namespace

Lattice lattice_over(const PlainMesh& mesh) {
  CGAL::Bbox_2 box;
  for (const Corners& t : mesh.triangles)
    for (Index v : t) box += mesh.points[v].bbox();
  return lattice_over(box, squared_circumradius_bound(mesh));
}

Lattice lattice_over(const std::vector<Point>& points, const Number& squared_bound) {
  CGAL::Bbox_2 box;
  for (const Point& p : points) box += exact(p).bbox();
  return lattice_over(box, squared_bound);
}

bool allows(const Lattice& lattice, const PlainMesh& mesh) {
  return lattice.side * lattice.side >= separation * separation * squared_circumradius_bound(mesh);
}

Lattice cells_after(const Lattice& lattice, const PlainMesh& mesh) {
  return allows(lattice, mesh) ? lattice : lattice_over(mesh);
}

Cell cell_of(const Lattice& lattice, const ExactPoint& p) {
  return {floor_of((p.x() - lattice.corner.x()) / lattice.side), floor_of((p.y() - lattice.corner.y()) / lattice.side)};
}

int colour_of(const Lattice& /*lattice*/, const Cell& cell) {
  return static_cast<int>((cell.i & 1) + 2 * (cell.j & 1));
}

}  // namespace pardel::ref
