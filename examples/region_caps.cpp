// Two materials with a common boundary. Each region has its own largest area, and its triangles have its attribute.
#include <cstdio>
#include <pardel/pardel.hpp>

int main() {
  // A rectangle of 2 by 1. The segment from (1, 0) to (1, 1) divides it into two faces.
  pardel::Pslg plate;
  plate.points = {{0, 0}, {1, 0}, {2, 0}, {2, 1}, {1, 1}, {0, 1}};
  plate.segments = {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 5}, {5, 0}, {1, 4}};
  // One seed point inside each face. The attribute is any number; here it identifies the material.
  plate.regions = {{.seed = {0.5, 0.5}, .attribute = 7, .max_area = 0.001},
                   {.seed = {1.5, 0.5}, .attribute = 9, .max_area = 0.02}};

  const auto meshed = pardel::mesh(plate, {.min_angle_deg = 30, .region_caps = true});
  if (!meshed) {
    std::fprintf(stderr, "%s\n", meshed.error().message.c_str());
    return 1;
  }
  const pardel::Mesh& mesh = meshed->mesh;
  for (std::size_t r = 0; r < mesh.region_attributes.size(); ++r) {
    std::size_t triangles = 0;
    double largest = 0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      if (mesh.region[t] != r) continue;
      const auto& v = mesh.triangles[t].v;
      const pardel::Point a = mesh.points[v[0]], b = mesh.points[v[1]], c = mesh.points[v[2]];
      const double area = ((b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y)) / 2;
      ++triangles;
      if (area > largest) largest = area;
    }
    std::printf("material %g: %zu triangles, largest area %.6f\n", mesh.region_attributes[r], triangles, largest);
  }
}
