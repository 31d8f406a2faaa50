// Lists the problems of an invalid domain, with ids and places, and repairs the domain. The repaired domain can be
// meshed.
#include <cstdio>
#include <pardel/pardel.hpp>

int main() {
  // A square with two faults: a segment crosses two sides, and a point lies in the interior of a third side.
  pardel::Pslg sketch;
  sketch.points = {{0, 0}, {2, 0}, {2, 2}, {0, 2}, {-1, 1}, {3, 1}, {1, 2}};
  sketch.segments = {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}};

  // Validation is exact. Only a domain without problems becomes a ValidPslg, and the mesher accepts only a ValidPslg.
  const auto domain = pardel::validate(sketch);
  if (domain) return 1;
  for (const pardel::Problem& problem : domain.error()) {
    std::printf("%s: %s\n", pardel::name(problem.kind), problem.message().c_str());
  }

  // Repair splits the segments where they meet. It is a separate step, because it changes the domain.
  const auto repaired = pardel::repair(sketch);
  if (!repaired) {
    std::fprintf(stderr, "%s\n", repaired.error().message.c_str());
    return 1;
  }
  for (const std::string& line : repaired->log) std::printf("repaired: %s\n", line.c_str());
  const auto meshed = pardel::mesh(repaired->domain, {.min_angle_deg = 25});
  if (!meshed) return 1;
  std::printf("%zu points became %zu; meshed: yes\n", sketch.points.size(), repaired->domain.pslg().points.size());
}
