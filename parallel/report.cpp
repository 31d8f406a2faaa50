#include "report.hpp"

#include <algorithm>

#include "concurrency/lattice.hpp"

namespace pardel {
namespace {

engine::Lattice lattice_of(const Tiling& tiling) {
  return {{tiling.low.x, tiling.low.y, tiling.high.x, tiling.high.y}, tiling.columns, tiling.rows};
}

}  // namespace

Index Tiling::cell_of(Point p) const { return lattice_of(*this).cell_of(p); }

unsigned Tiling::colour_of(Index cell) const { return lattice_of(*this).colour_of(cell); }

const char* name(ExemptReason reason) {
  switch (reason) {
    case ExemptReason::nestled:
      return "nestled";
    case ExemptReason::seditious:
      return "seditious";
    case ExemptReason::budget:
      return "budget";
    case ExemptReason::min_edge:
      return "min_edge";
    case ExemptReason::precision:
      return "precision";
    case ExemptReason::kept_segment:
      return "kept_segment";
  }
  return "";
}

std::uint64_t Report::count(ExemptReason reason) const {
  return static_cast<std::uint64_t>(
      std::count_if(exempt.begin(), exempt.end(), [&](const Exemption& e) { return e.reason == reason; }));
}

bool Report::goal_met() const {
  return std::all_of(exempt.begin(), exempt.end(), [](const Exemption& e) { return justified(e.reason); });
}

}  // namespace pardel
