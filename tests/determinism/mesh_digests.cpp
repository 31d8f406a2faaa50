// Prints the digests of meshes, one per line, for the comparison of builds and machines.
//   mesh_digests                              prints the file `digests`
//   mesh_digests DOMAIN TRIANGLES THREADS...  meshes DOMAIN, which is square, pipe, points or radial, with about
//                                             TRIANGLES triangles, once on each number of threads; tasks run in random
//                                             order and with delays
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

#include "../../core/digest.hpp"
#include "../../properties/domains/domains.hpp"
#include "problems.hpp"

namespace pardel::determinism {
namespace {

constexpr const char* header =
    "# The digests (core/digest.hpp) of the meshes of problems.hpp. They do not depend on threads, compiler, level of\n"
    "# optimisation or machine: the engine takes nothing from the mathematics library that is not exact. Made by\n"
    "#   cmake --build BUILD --target digests\n"
    "# which is right when the algorithm was changed on purpose, and only then.\n";

void print_recorded() {
  std::cout << header;
  for (const generators::Family family : generators::all_families())
    for (std::uint64_t number = 0; number < problems_per_family; ++number)
      std::cout << line(problem(family, number), 1) << '\n';
  for (std::uint64_t number = 0; number < graded_problems; ++number)
    std::cout << line(graded_problem(number), 1) << '\n';
  for (std::uint64_t number = 0; number < filled_problems; ++number)
    std::cout << line(filled_problem(number), 1) << '\n';
}

/// Rings around a point, and sizes that grow with the distance from it over four decades.
samples::Case radial(double triangles) {
  constexpr double triangles_for_ratio_1 = 288;  // measured
  static constexpr double inner = 0.95e-4;
  Goal goal{.min_angle_deg = 25};
  goal.size = [ratio = std::sqrt(triangles_for_ratio_1 / triangles)](Point p) {
    return ratio * std::max(inner, std::sqrt(p.x * p.x + p.y * p.y));
  };
  return {"radial", *domains::generate("radial", 4, 1), goal, {}};
}

/// A problem whose mesh has about this number of triangles: a domain with a bound on areas, or random points with the
/// default bound on angles.
samples::Case large(const std::string& domain, double triangles) {
  if (domain == "square") return {domain, domains::square(), {.max_area = 1.37 / triangles}, {}};
  if (domain == "pipe") return {domain, domains::pipe(), {.max_area = 3.41 / triangles}, {}};
  if (domain == "points") return {domain, domains::random_points(static_cast<Index>(triangles / 3.2), 1), {}, {}};
  if (domain == "radial") return radial(triangles);
  throw std::invalid_argument("no domain '" + domain + "'");
}

void print_on_threads(const samples::Case& what, const std::vector<int>& threads) {
  for (const int n : threads) {
    const Mesh mesh = samples::refined(what, {.threads = n}, samples::shuffled(static_cast<std::uint64_t>(n))).mesh;
    std::cout << what.name << ' ' << mesh.triangles.size() << ' ' << to_string(digest(mesh)) << ' ' << n << std::endl;
  }
}

}  // namespace
}  // namespace pardel::determinism

int main(int argc, char** argv) try {
  if (argc == 1) {
    pardel::determinism::print_recorded();
    return EXIT_SUCCESS;
  }
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  std::vector<int> threads;
  for (std::size_t i = 2; i < arguments.size(); ++i) threads.push_back(std::stoi(arguments[i]));
  if (threads.empty()) throw std::invalid_argument("usage: mesh_digests [DOMAIN TRIANGLES THREADS...]");
  pardel::determinism::print_on_threads(pardel::determinism::large(arguments[0], std::stod(arguments[1])), threads);
} catch (const std::exception& error) {
  std::cerr << "mesh_digests: " << error.what() << '\n';
  return EXIT_FAILURE;
}
