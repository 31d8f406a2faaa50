// Arrays in, mesh out, errors as values.
#include <cstdio>
#include <pardel/parallel/mesher.hpp>

int main() {
  pardel::Pslg plate;  // a planar straight-line graph: a unit square with a square hole
  plate.points = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0.4, 0.4}, {0.6, 0.4}, {0.6, 0.6}, {0.4, 0.6}};
  plate.segments = {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6}, {6, 7}, {7, 4}};
  plate.holes = {{0.5, 0.5}};

  const auto meshed = pardel::mesh(plate, {.min_angle_deg = 30, .max_area = 0.001});
  if (!meshed) {
    std::fprintf(stderr, "%s\n", meshed.error().message.c_str());
    return 1;
  }
  const pardel::Mesh& mesh = meshed->mesh;
  std::printf("%zu vertices, %zu triangles; every bound holds: %s\n", mesh.points.size(), mesh.triangles.size(),
              meshed->report.goal_met() ? "yes" : "no");
}
