// Measures one rank of many without the others: the work that it has however small its share of the mesh is.
#pragma once

#include <cstdint>
#include <span>

#include "../../parallel/decomposition/tiles.hpp"
#include "../../parallel/options.hpp"
#include "../../parallel/quality/criteria.hpp"
#include "../../parallel/triangulation/domain_segments.hpp"
#include "../../parallel/triangulation/triangulation.hpp"

namespace pardel::bench {

/// What a refinement needs to know beside the triangulation. All references have to outlive it.
struct Problem {
  const engine::DomainSegments& segments;
  const engine::Criteria& criteria;
  const Options& options;
  std::span<const Index> input_of_vertex{};
  std::span<const int> input_markers{};
};

struct LoneRank {
  double divide_seconds = 0;  ///< processor time of Distribution::divide()
  double phase_seconds = 0;   ///< processor time of a phase in which no cell has work
};

/// Lets the engine divide a triangulation among `ranks` ranks, as the rank in the middle, and run phases without tasks.
/// The other ranks never send anything. `work`: as for engine::Ownership. Precondition: all indices of t are in use.
[[nodiscard]] LoneRank measure_lone_rank(engine::Triangulation t, const engine::Tiles& tiles,
                                         std::span<const double> work, const Problem& problem, int ranks);

struct MessageCosts {
  double write_byte = 0, read_byte = 0;  ///< processor seconds
};

/// Lets one rank send triangles to another one that has the same triangulation. Precondition: as above.
[[nodiscard]] MessageCosts measure_messages(const engine::Triangulation& t);

}  // namespace pardel::bench
