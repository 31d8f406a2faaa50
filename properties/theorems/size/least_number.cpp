#include "least_number.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "../refinement/feature_size.hpp"

namespace pardel::properties {
namespace {

/// A part of the domain.
struct Cell {
  Point centre;
  double radius;     ///< no point of the cell is further from its centre
  double area;       ///< of the cell
  double clearance;  ///< no point of the cell is further from all features of the domain
  double cap;        ///< the bound on the areas of triangles
};

double distance(Point a, Point b) { return std::hypot(a.x - b.x, a.y - b.y); }
Point middle(Point a, Point b) { return {(a.x + b.x) / 2, (a.y + b.y) / 2}; }

Cell cell_of(const Mesh& domain, const std::vector<Feature>& features, const std::array<Point, 3>& t, double cap) {
  const auto [p, q, r] = t;
  Cell cell{{(p.x + q.x + r.x) / 3, (p.y + q.y + r.y) / 3}, 0, 0, std::numeric_limits<double>::infinity(), cap};
  for (const Point& corner : t) cell.radius = std::max(cell.radius, distance(cell.centre, corner));
  cell.area = std::abs((q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x)) / 2;
  for (const Feature& f : features) cell.clearance = std::min(cell.clearance, distance_to(domain, f, cell.centre));
  cell.clearance += cell.radius;
  return cell;
}

/// A quarter of each triangle is a cell. The cells with the largest clearance come first.
std::vector<Cell> cells_of(const Mesh& domain, const Mesh& mesh, const std::function<double(std::size_t)>& cap) {
  const std::vector<Feature> features = features_of(domain);
  std::vector<Cell> cells;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto [a, b, c] = mesh.triangles[t].v;
    const Point p = mesh.points[a], q = mesh.points[b], r = mesh.points[c];
    const Point pq = middle(p, q), qr = middle(q, r), rp = middle(r, p);
    for (const std::array<Point, 3>& quarter :
         {std::array{p, pq, rp}, std::array{pq, q, qr}, std::array{rp, qr, r}, std::array{pq, qr, rp}})
      cells.push_back(cell_of(domain, features, quarter, cap(t)));
  }
  std::ranges::sort(cells, std::ranges::greater(), &Cell::clearance);
  return cells;
}

}  // namespace

double least_number_of_triangles(const Mesh& domain, const Mesh& cells, double min_angle_deg,
                                 const std::function<double(std::size_t)>& largest_area) {
  const double angle = min_angle_deg * (std::numbers::pi / 180), sine = std::sin(angle / 2);
  const double most_area = 2 / std::tan(angle / 2) + std::tan(angle);  // of a triangle, in squared inradii
  const std::vector<Cell> all = cells_of(domain, cells, largest_area);
  double sum = 0;
  for (const Cell& here : all) {
    // A triangle that contains a point of this cell has its incentre in some cell `there`, near enough for its
    // inradius.
    const auto may_have_the_incentre = [&](const Cell& there) {
      return distance(here.centre, there.centre) - here.radius - there.radius <= there.clearance / sine;
    };
    const double inradius = std::ranges::find_if(all, may_have_the_incentre)->clearance;
    sum += here.area / std::min(here.cap, most_area * inradius * inradius);
  }
  return std::max(sum, static_cast<double>(domain.triangles.size()));
}

}  // namespace pardel::properties
