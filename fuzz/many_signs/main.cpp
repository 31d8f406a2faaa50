// many_signs: compares the signs of the predicates with exact signs, for many points.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdint>
#include <cstdio>

#include "../../cli/whole_number.hpp"
#include "../numbered_random.hpp"
#include "compare.hpp"

namespace pardel::fuzz {
namespace {

/// Points are drawn in blocks, each with a seed of its own, so that the result does not depend on the threads.
constexpr std::uint64_t block = 100'000;

template <class Compare>
Comparison compare_many(std::uint64_t count, std::uint64_t seed, int threads, const Compare& compare) {
  Comparison all;
#pragma omp parallel for schedule(dynamic) num_threads(threads)
  for (std::uint64_t first = 0; first < count; first += block) {
    generators::Random random = random_of(seed, first);
    Comparison here;
    for (std::uint64_t i = first; i < std::min(count, first + block); ++i) compare(random, here);
#pragma omp critical
    all.add(here);
  }
  return all;
}

std::string stages(const std::array<std::uint64_t, 5>& counts) {
  return fmt::format("lattice {}, exact differences {}, rounded differences {}, corrected {}, expansions {}", counts[0],
                     counts[1], counts[2], counts[3], counts[4]);
}

void print(const char* what, std::uint64_t points, const Comparison& found) {
  fmt::print("{}: {} times four points, {} calls ({} orientations, {} in-circle tests), {} filters that said yes\n",
             what, points, found.orientations + found.incircles, found.orientations, found.incircles, found.filters);
  fmt::print("  signs that are zero: {}; signs that 64 binary digits leave open: {}\n", found.zeros, found.exact);
  if (found.orient2d_stages != std::array<std::uint64_t, 5>{})
    fmt::print("  stages of orient2d: {}\n  stages of incircle: {}\n", stages(found.orient2d_stages),
               stages(found.incircle_stages));
  fmt::print("  differences: {}\n", found.differences);
  if (found.differences > 0) fmt::print("  the first: {}\n", found.first_difference);
}

}  // namespace
}  // namespace pardel::fuzz

int main(int argc, char** argv) {
  using namespace pardel::fuzz;
  std::uint64_t random = 1'000'000, hard = 100'000, seed = 1;
  int threads = 1;
  CLI::App app{
      "Compares the predicates of the mesher and of the checker with exact signs. Random points get one call of each "
      "predicate; hard points, degenerate or nearly so, get all ways to ask. Exit code 1: a sign differs; 2: the "
      "command line is wrong; 5: standard output cannot be written."};
  app.add_option("--random", random, "How many times four random points")
      ->check(pardel::cli::whole_number())
      ->capture_default_str();
  app.add_option("--hard", hard, "How many times four hard points")
      ->check(pardel::cli::whole_number())
      ->capture_default_str();
  app.add_option("--seed", seed, "The seed of all points")->check(pardel::cli::whole_number())->capture_default_str();
  app.add_option("--threads", threads, "The number of threads; the points do not depend on it")
      ->check(CLI::Range(1, 1'000))
      ->capture_default_str();
  try {
    app.parse(argc, argv);
  } catch (const CLI::Error& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }

  using pardel::generators::Random;
  const Comparison of_random =
      compare_many(random, seed, threads, [](Random& r, Comparison& c) { compare(random_points(r), c); });
  print("random", random, of_random);
  const Comparison of_hard =
      compare_many(hard, ~seed, threads, [](Random& r, Comparison& c) { compare_all(hard_points(r), c); });
  print("hard", hard, of_hard);
  if (std::fflush(stdout) != 0) {
    fmt::print(stderr, "many_signs: standard output cannot be written\n");
    return 5;
  }
  return of_random.differences + of_hard.differences == 0 ? 0 : 1;
}
