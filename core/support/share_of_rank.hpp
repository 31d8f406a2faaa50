// Numbers that are distributed among ranks.
#pragma once

#include <cstdint>
#include <vector>

#include "../ranks.hpp"

namespace pardel {

/// Of things that are numbered rank by rank: how many belong to the ranks before this one, and to all ranks.
struct ShareOfRank {
  std::uint64_t before = 0, all = 0;
};

/// Collective. `here`: how many belong to this rank.
[[nodiscard]] inline ShareOfRank share_of_rank(std::uint64_t here, Ranks& ranks) {
  std::vector<std::uint64_t> of_rank(ranks.count(), 0);
  of_rank[ranks.rank()] = here;
  ranks.add_up(of_rank);
  ShareOfRank share;
  for (int rank = 0; rank < ranks.count(); ++rank) {
    if (rank < ranks.rank()) share.before += of_rank[rank];
    share.all += of_rank[rank];
  }
  return share;
}

}  // namespace pardel
