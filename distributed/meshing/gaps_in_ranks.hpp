// The gaps of a domain that all ranks have. Each rank searches its share of the triangles.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "../../core/support/exchange_lists.hpp"
#include "../../parallel/diagnosis/find_gaps.hpp"

namespace pardel::engine {

/// As find_gaps(). Each rank examines a share of the triangles. Collective; all ranks have the same domain.
[[nodiscard]] inline std::vector<Gap> gaps_in_ranks(const DomainTriangulation& domain, Ranks& ranks,
                                                    const Threads& threads) {
  struct TravellingGap {
    double distance, surroundings;
    Point where;
    std::array<Index, 3> points;
    Index segment;
    std::uint32_t points_in_use, kind;
  };
  const Share share{static_cast<std::size_t>(ranks.rank()), static_cast<std::size_t>(ranks.count())};
  std::vector<TravellingGap> found;
  for (const Gap& gap : gaps_in_share(domain, share, threads)) {
    TravellingGap& sent = found.emplace_back(TravellingGap{gap.distance,
                                                           gap.surroundings,
                                                           gap.where,
                                                           {},
                                                           gap.segment,
                                                           static_cast<std::uint32_t>(gap.points.size()),
                                                           static_cast<std::uint32_t>(gap.kind)});
    std::ranges::copy(gap.points, sent.points.begin());
  }
  std::vector<Gap> all;
  for (const TravellingGap& gap : concatenated(lists_of_all(found, ranks)))
    all.push_back({static_cast<GapKind>(gap.kind),
                   {gap.points.begin(), gap.points.begin() + gap.points_in_use},
                   gap.segment,
                   gap.distance,
                   gap.surroundings,
                   gap.where});
  return narrowest_first(std::move(all), domain);
}

}  // namespace pardel::engine
