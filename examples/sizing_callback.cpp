// A mesh that is fine near one corner and coarse elsewhere. A function gives the sizes.
#include <cmath>
#include <cstdio>
#include <pardel/pardel.hpp>

namespace {

/// The longest edge allowed near p: 0.01 at the origin, plus a quarter of the distance from the origin.
double wanted_size(pardel::Point p) { return 0.01 + 0.25 * std::hypot(p.x, p.y); }

double length(pardel::Point a, pardel::Point b) { return std::hypot(b.x - a.x, b.y - a.y); }

}  // namespace

int main() {
  pardel::Pslg square;
  square.points = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  square.segments = {{0, 1}, {1, 2}, {2, 3}, {3, 0}};

  // The mesher calls the function from several threads: it must be pure, and its result must be positive.
  pardel::Goal goal{.min_angle_deg = 28};
  goal.size = wanted_size;
  const auto meshed = pardel::mesh(square, goal);
  if (!meshed) {
    std::fprintf(stderr, "%s\n", meshed.error().message.c_str());
    return 1;
  }

  // A triangle is too large if its longest edge exceeds the size at its centroid.
  const pardel::Mesh& mesh = meshed->mesh;
  std::size_t too_large = 0;
  for (const pardel::Triangle& triangle : mesh.triangles) {
    const pardel::Point a = mesh.points[triangle.v[0]], b = mesh.points[triangle.v[1]], c = mesh.points[triangle.v[2]];
    const pardel::Point centroid{(a.x + b.x + c.x) / 3, (a.y + b.y + c.y) / 3};
    const double longest = std::fmax(length(a, b), std::fmax(length(b, c), length(c, a)));
    if (longest > wanted_size(centroid)) ++too_large;
  }
  std::printf("%zu triangles, %zu of them too large\n", mesh.triangles.size(), too_large);
}
