// Lattice (d): how many sweeps a refinement needs if triangles are bad by shape only and no circumcentre encroaches.
// Proof: properties/THEORY.md, Lattice.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "../framework/shares.hpp"
#include "refined_channels.hpp"

namespace pardel::properties {
namespace {
using generators::Random;

/// Vertices close together, in a square with a border of short segments.
struct Clusters {
  Pslg pslg;
  double min_angle = 20;
};
std::ostream& operator<<(std::ostream& out, const Clusters& c) {
  for (const Point& p : c.pslg.points) out << '(' << p.x << ", " << p.y << ") ";
  return out << "at " << c.min_angle << " degrees";
}

/// A square of n by n units with a vertex at each multiple of the unit on the border, and near each one inside.
Pslg square_with_vertices(Random& random, int n) {
  constexpr double unit = 64;
  Pslg pslg;
  std::vector<Point> border;
  for (int k = 0; k < n; ++k) border.push_back({k * unit, 0});
  for (int k = 0; k < n; ++k) border.push_back({n * unit, k * unit});
  for (int k = n; k > 0; --k) border.push_back({k * unit, n * unit});
  for (int k = n; k > 0; --k) border.push_back({0, k * unit});
  const auto count = static_cast<Index>(border.size());
  for (Index k = 0; k < count; ++k) pslg.segments.push_back({k, (k + 1) % count});
  pslg.points = border;
  for (int i = 1; i < n; ++i)
    for (int j = 1; j < n; ++j)
      pslg.points.push_back({i * unit + random.between(-6, 6), j * unit + random.between(-6, 6)});
  return pslg;
}

Clusters some_clusters(Random& random, int /*size*/) {
  const int n = random.between(5, 8);
  Clusters made{square_with_vertices(random, n), random.between(10, 20) * 1.0};
  for (int clusters = random.between(1, 4); clusters > 0; --clusters) {
    const auto middle = [&] { return random.between(64 * 2, 64 * (n - 2)) * 1.0; };
    const Point at{middle(), middle()};
    const double reach = random.one_of<double>({1, 2, 4, 8, 16});
    for (int points = random.between(2, 5); points > 0; --points) {
      const Point p{at.x + reach * random.between(-8, 8) / 8, at.y + reach * random.between(-8, 8) / 8};
      if (std::ranges::count(made.pslg.points, p) == 0) made.pslg.points.push_back(p);
    }
  }
  return made;
}

ref::Number squared_shortest(const ref::PlainMesh& mesh) {
  ref::Number least = squared_shortest_edge(mesh, mesh.triangles.front());
  for (const ref::Corners& t : mesh.triangles) least = std::min(least, squared_shortest_edge(mesh, t));
  return least;
}

/// The bound of Lattice (d) on the number of sweeps that insert a point.
int bound_on_sweeps(const ref::PlainMesh& mesh, double min_angle) {
  const double ratio = 1 / (2 * std::sin(min_angle * std::numbers::pi / 180));
  const double radius = std::sqrt(CGAL::to_double(squared_circumradius_bound(mesh)));
  const double edge = std::sqrt(CGAL::to_double(squared_shortest(mesh)));
  return 3 * std::max(0, static_cast<int>(std::ceil(std::log(radius / edge) / std::log(ratio))) - 1);
}

PARDEL_PROPERTY(Sweeps, are_at_most_three_for_each_factor_of_the_shape_bound_between_the_shortest_edge_and_the_bound,
                {.statement = "Let triangles be bad by shape only, and let no circumcentre encroach upon a subsegment. "
                              "Cells of side 4 r refine their bad triangles to the end, colour by colour. At most 3 "
                              "max(0, ceil(log(r / l)) - 1) sweeps insert a point, where the logarithm is to the base "
                              "of the largest allowed ratio of circumradius to shortest edge, l is the shortest edge "
                              "and r the largest circumradius at the start.",
                 .source = "properties/THEORY.md, Lattice (d); [CC] has four iterations",
                 .families = "squares with one to four clusters of close vertices; bounds of 10 to 20 degrees"}) {
  const auto none = [](const Clusters&) { return std::vector<Clusters>{}; };
  const Clusters clusters = *generators::generator(some_clusters, none).as("clusters");
  exhibit.show(clusters.pslg);
  Goal goal;
  goal.min_angle_deg = clusters.min_angle;
  Goal nothing;
  nothing.min_angle_deg = 0;
  const auto made = ref::refine_on_lattice(clusters.pslg, goal, nothing);
  if (!made) RC_FAIL(made.error().message);
  int inserting = 0;
  bool encroaches = false;
  std::size_t points_of_a_cell = 0;
  for (const LatticeSweep& sweep : made->sweeps) {
    std::size_t inserted = 0;
    for (const ref::Phase& phase : sweep.phases) {
      inserted += phase.insertions.size();
      std::map<ref::Cell, std::size_t> of_cell;
      for (const ref::Insertion& insertion : phase.insertions)
        points_of_a_cell = std::max(points_of_a_cell, ++of_cell[insertion.cell]);
      encroaches |= phase.after.constraints != made->preprocessed.constraints || !phase.handed_on.empty();
    }
    inserting += inserted != 0;
  }
  classify(!encroaches, "no circumcentre encroaches", 90);
  if (encroaches) return;
  const int bound = bound_on_sweeps(made->preprocessed, clusters.min_angle);
  RC_ASSERT(inserting <= bound);
  RC_TAG(std::to_string(inserting) + " sweeps that insert");
  classify(inserting >= 2, "two sweeps or more", 25);
  classify(points_of_a_cell > static_cast<std::size_t>(bound), "a cell inserts more points than there may be sweeps",
           5);
}

}  // namespace
}  // namespace pardel::properties
