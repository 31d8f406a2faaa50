// Random meshing problems, cut into tiles so small that tasks have neighbours to hand work on to.
#pragma once

#include <cstdint>
#include <string>

#include "../../properties/domains/generators/lattice_domain.hpp"
#include "../parallel/scheduling/many_tasks.hpp"

namespace pardel::determinism {

namespace samples = engine::samples;

inline constexpr std::uint64_t problems_per_family = 30;

struct Problem {
  samples::Case what;  ///< its name tells family, number, goal and options in short
  Options options;     ///< but for the threads
};

/// Number 0 to problems_per_family - 1 of a family. Goals and options vary from one to the next: angles of 0 to 28
/// degrees, areas, caps of regions, conforming or not; tiles by work and the paper's; both placements.
[[nodiscard]] Problem problem(generators::Family family, std::uint64_t number);

/// The problem's line in the file `digests`: what it is, and the digest that mesh() gives on so many threads.
[[nodiscard]] std::string line(const Problem& problem, int threads);

}  // namespace pardel::determinism
