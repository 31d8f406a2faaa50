// Refines a mesh in places where a solver needs smaller triangles. All vertices of the old mesh keep their indices.
#include <cstdio>
#include <limits>
#include <pardel/pardel.hpp>
#include <vector>

int main() {
  pardel::Pslg square;
  square.points = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  square.segments = {{0, 1}, {1, 2}, {2, 3}, {3, 0}};
  const auto coarse = pardel::mesh(square, {.min_angle_deg = 25, .max_area = 0.02});
  if (!coarse) return 1;

  // One area cap per triangle of the old mesh. Infinity means that the triangle need not become smaller.
  const pardel::Mesh& old = coarse->mesh;
  std::vector<double> caps(old.triangles.size(), std::numeric_limits<double>::infinity());
  for (std::size_t t = 0; t < caps.size(); ++t) {
    for (const pardel::Index v : old.triangles[t].v) {
      if (old.points[v].x < 0.25) caps[t] = 0.0005;
    }
  }

  const auto finer = pardel::refine(old, caps, {.min_angle_deg = 25});
  if (!finer) {
    std::fprintf(stderr, "%s\n", finer.error().message.c_str());
    return 1;
  }
  bool kept = true;
  for (std::size_t v = 0; v < old.points.size(); ++v) kept = kept && finer->mesh.points[v] == old.points[v];
  std::printf("%zu triangles became %zu; old vertices kept: %s\n", old.triangles.size(), finer->mesh.triangles.size(),
              kept ? "yes" : "no");
}
