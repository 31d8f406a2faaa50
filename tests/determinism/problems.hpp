// Random meshing problems with tiles so small that there are many tasks. These tasks hand on many triangles: a task
// hands a triangle on to another cell if it cannot process it in its own box.
#pragma once

#include <cstdint>
#include <string>

#include "../../properties/domains/generators/lattice_domain.hpp"
#include "../parallel/scheduling/many_tasks.hpp"

namespace pardel::determinism {

namespace samples = engine::samples;

inline constexpr std::uint64_t problems_per_family = 30;

struct Problem {
  samples::Case what;  ///< the name summarises family, number, goal and options
  Options options;     ///< without the number of threads
};

/// Problem `number`, from 0 to problems_per_family - 1, of a family. Goals and options are random: angle bounds of 0 to
/// 28 degrees, area bounds, area caps of regions, conforming or not, both decompositions, off-centres or circumcentres.
[[nodiscard]] Problem problem(generators::Family family, std::uint64_t number);

inline constexpr std::uint64_t graded_problems = 110;
/// Graded problem `number`, from 0 to graded_problems - 1: the domain and goal of a problem of each family in turn,
/// with sizes that grow from a small one at a point of the domain, on the leaves of a quadtree.
[[nodiscard]] Problem graded_problem(std::uint64_t number);

inline constexpr std::uint64_t filled_problems = 44;
/// Problem `number`, from 0 to filled_problems - 1, with an interior of equilateral triangles: the domain, goal and
/// options of a problem of each family in turn.
[[nodiscard]] Problem filled_problem(std::uint64_t number);

/// The line of the problem in the file `digests`: its name and the digest of the mesh that mesh() makes.
[[nodiscard]] std::string line(const Problem& problem, int threads);

}  // namespace pardel::determinism
