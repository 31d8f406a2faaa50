// The program whose instructions bench/gate counts. It meshes the pipe with about 22,000 triangles, then 3,000 random
// points with a minimum angle of 30 degrees.
#include <cstdio>

#include "../parallel/mesher.hpp"
#include "../properties/domains/domains.hpp"

int main() {
  using namespace pardel;
  const Result<Meshed> pipe = mesh(domains::pipe(), {.max_area = 1.54e-4}, {.threads = 1});
  const Result<Meshed> points = mesh(domains::random_points(3000, 1), {.min_angle_deg = 30}, {.threads = 1});
  if (!pipe || !points) return 1;
  std::printf("%zu + %zu triangles\n", pipe->mesh.triangles.size(), points->mesh.triangles.size());
}
