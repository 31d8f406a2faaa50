// Named domains: the inputs that demos, tests, benchmarks and fuzzing share. All are valid Pslgs. Seeds
// make them reproducible on every platform (the generator is our own splitmix, not std::distribution).
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "../../core/pslg.hpp"
#include "../../core/result.hpp"

namespace pardel::domains {

[[nodiscard]] Pslg square();  ///< the unit square, 4 segments
/// Outer circle of radius 1 (200 segments), a central hole of radius 0.35 and six of radius 0.12 at
/// distance 0.67 (60 segments each): the paper's "pipe cross-section".
[[nodiscard]] Pslg pipe();
/// A door key in the spirit of the paper's Figure 2: bow with a ring hole, shaft, teeth, arcs; at least 150 segments.
[[nodiscard]] Pslg key();
[[nodiscard]] Pslg random_points(std::uint64_t n, std::uint64_t seed);  ///< uniform in the unit square, no segments
[[nodiscard]] Pslg star(int spikes, double spike_degrees);              ///< spikes with the given tip angle
[[nodiscard]] Pslg comb(int teeth, double gap);                         ///< thin channels of width `gap`
[[nodiscard]] Pslg wedge(int segments, double degrees_apart);           ///< segments from one vertex inside a box
[[nodiscard]] Pslg grid(int n);         ///< (n+1)^2 lattice points, all grid edges and one diagonal a cell as segments
[[nodiscard]] Pslg grid_points(int n);  ///< the lattice points alone: everything cocircular
[[nodiscard]] Pslg touching_holes();    ///< holes that meet at a vertex
[[nodiscard]] Pslg cracks();            ///< dangling and free segments, isolated points
[[nodiscard]] Pslg regions();           ///< three regions with attributes and area caps
[[nodiscard]] Pslg moved(Pslg pslg, double dx, double dy,
                         double scale = 1);  ///< about coordinates like (654321, 4987654)

/// `pardel generate NAME`: names as above; n and seed where they have a meaning (0: the default).
[[nodiscard]] Result<Pslg> generate(std::string_view name, std::uint64_t n, std::uint64_t seed);
[[nodiscard]] std::vector<std::string> names();

}  // namespace pardel::domains
