// Checks a mesh that another program made, and prints its violations.
#include <cstdio>
#include <pardel/pardel.hpp>
#include <pardel/properties/checker/check.hpp>

int main() {
  // The domain: the unit square.
  pardel::Pslg square;
  square.points = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  square.segments = {{0, 1}, {1, 2}, {2, 3}, {3, 0}};

  // The other program's mesh, without neighbours, markers or constrained edges. Its triangles cover the square, but
  // the edge from (1, 0) to (0, 1) is not Delaunay: the circle through (0, 0), (1, 0), (0, 1) contains (0.9, 0.9).
  pardel::Mesh foreign;
  for (const pardel::Point p : {pardel::Point{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0.9, 0.9}}) foreign.points.push_back(p);
  for (const auto& corners : {std::array<pardel::Index, 3>{0, 1, 3}, {1, 4, 3}, {1, 2, 4}, {4, 2, 3}}) {
    foreign.triangles.push_back({.v = corners});
  }
  pardel::rebuild_neighbours(foreign.triangles, foreign.points.size());

  // foreign: data that the mesh does not have are not checked, and input points are found by their coordinates.
  const pardel::Certificate certificate = pardel::check(square, foreign, {.min_angle_deg = 0}, {.foreign = true});
  std::printf("valid: %s\n", certificate.valid ? "yes" : "no");
  for (const pardel::Violation& violation : certificate.violations) std::printf("%s\n", violation.message().c_str());
}
