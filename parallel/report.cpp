#include "report.hpp"

#include <algorithm>

#include "../core/support/enum_names.hpp"
#include "decomposition/lattice.hpp"
#include "decomposition/quadtree.hpp"

namespace pardel {
namespace {

constexpr auto reason_names = enum_names<ExemptReason>({
    {ExemptReason::nestled, "nestled"},
    {ExemptReason::seditious, "seditious"},
    {ExemptReason::budget, "budget"},
    {ExemptReason::min_edge, "min_edge"},
    {ExemptReason::precision, "precision"},
    {ExemptReason::kept_segment, "kept_segment"},
});
static_assert(decltype(reason_names)::size() == exempt_reasons);

engine::Lattice lattice_of(const Tiling& tiling) {
  return {{tiling.low.x, tiling.low.y, tiling.high.x, tiling.high.y}, tiling.columns, tiling.rows};
}

}  // namespace

Index Tiling::cell_of(Point p) const {
  if (leaves.empty()) return lattice_of(*this).cell_of(p);
  const engine::Square square(engine::Box{low.x, low.y, high.x, high.y});
  return engine::leaf_of(leaves, square, p);
}

unsigned Tiling::colour_of(Index cell) const {
  return leaves.empty() ? lattice_of(*this).colour_of(cell) : leaves[cell].colour;
}

const char* name(ExemptReason reason) { return reason_names[reason]; }

std::uint64_t Report::count(ExemptReason reason) const {
  return static_cast<std::uint64_t>(
      std::count_if(exempt.begin(), exempt.end(), [&](const Exemption& e) { return e.reason == reason; }));
}

bool Report::goal_met() const {
  return std::all_of(exempt.begin(), exempt.end(), [](const Exemption& e) { return justified(e.reason); });
}

}  // namespace pardel
