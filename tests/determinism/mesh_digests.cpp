// The digests of meshes, one a line, to be compared between builds and machines.
//   mesh_digests                              the file `digests`
//   mesh_digests DOMAIN TRIANGLES THREADS...  square or pipe, with about so many triangles; on each number of threads
//                                             in a random order of tasks, with delays
#include <cstdlib>
#include <exception>
#include <iostream>
#include <string>
#include <vector>

#include "../../core/digest.hpp"
#include "../../properties/domains.hpp"
#include "problems.hpp"

namespace pardel::determinism {
namespace {

constexpr const char* header =
    "# The digests (core/digest.hpp) of the meshes of problems.hpp. They do not depend on threads, compiler, "
    "optimisation\n"
    "# or machine: the engine takes nothing from the mathematics library that libraries round differently. Made by\n"
    "#   cmake --build BUILD --target digests\n"
    "# which is right when the algorithm was changed on purpose, and only then.\n";

void print_recorded() {
  std::cout << header;
  for (const generators::Family family : generators::all_families())
    for (std::uint64_t number = 0; number < problems_per_family; ++number)
      std::cout << line(problem(family, number), 1) << '\n';
}

/// The bound on areas that gives about so many triangles.
double area_for(const std::string& domain, double triangles) { return (domain == "pipe" ? 3.855 : 1.552) / triangles; }

void print_on_threads(const std::string& domain, const std::string& triangles, const std::vector<int>& threads) {
  const Goal goal{.max_area = area_for(domain, std::stod(triangles))};
  const samples::Case what{domain, domain == "pipe" ? domains::pipe() : domains::square(), goal, {}};
  for (const int n : threads) {
    const Mesh mesh = samples::refined(what, {.threads = n}, samples::shuffled(static_cast<std::uint64_t>(n))).mesh;
    std::cout << domain << ' ' << mesh.triangles.size() << ' ' << to_string(digest(mesh)) << ' ' << n << std::endl;
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
  if (threads.empty() || (arguments[0] != "square" && arguments[0] != "pipe")) {
    std::cerr << "usage: mesh_digests [square|pipe TRIANGLES THREADS...]\n";
    return 2;
  }
  pardel::determinism::print_on_threads(arguments[0], arguments[1], threads);
} catch (const std::exception& error) {
  std::cerr << "mesh_digests: " << error.what() << '\n';
  return EXIT_FAILURE;
}
