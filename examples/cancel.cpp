// Stops the mesher from outside: the mesher calls a function with its progress, and the function returns false to stop
// it.
#include <cstdio>
#include <pardel/pardel.hpp>

int main() {
  pardel::Pslg square;
  square.points = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  square.segments = {{0, 1}, {1, 2}, {2, 3}, {3, 0}};

  // A window with a Cancel button would test the button here. This example stops the mesher at 10,000 triangles.
  pardel::Options options;
  options.progress = [](const pardel::Progress& progress) {
    std::printf("about %llu triangles\n", static_cast<unsigned long long>(progress.triangles));
    return progress.triangles < 10'000;
  };

  // If the mesher is not stopped, this mesh has more than a million triangles.
  const auto meshed = pardel::mesh(square, {.max_area = 1e-6}, options);
  if (meshed) {
    std::printf("%zu triangles\n", meshed->mesh.triangles.size());
    return 0;
  }
  const bool cancelled = meshed.error().kind == pardel::ErrorKind::cancelled;
  std::printf("%s: %s\n", cancelled ? "cancelled" : "failed", meshed.error().message.c_str());
  return cancelled ? 0 : 1;
}
