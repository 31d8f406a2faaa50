// Meshes a square and checks the mesh with the installed checker.
#include <cstdio>
#include <pardel/parallel/mesher.hpp>
#include <pardel/properties/checker/check.hpp>

int main() {
  pardel::Pslg square;
  square.points = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  square.segments = {{0, 1}, {1, 2}, {2, 3}, {3, 0}};
  const pardel::Goal goal{.min_angle_deg = 25, .max_area = 0.01};
  const auto meshed = pardel::mesh(square, goal);
  if (!meshed) return 1;
  const pardel::Certificate certificate = pardel::check(square, meshed->mesh, goal);
  std::printf("valid: %s\n%s", certificate.valid ? "yes" : "no", pardel::to_text(certificate).c_str());
}
