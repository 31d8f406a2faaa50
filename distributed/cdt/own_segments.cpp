#include "own_segments.hpp"

#include <algorithm>
#include <utility>

#include "../../core/support/collective.hpp"
#include "../../core/support/exchange_lists.hpp"
#include "sites_of_numbers.hpp"

namespace pardel::engine {
namespace {

/// A segment whose ends are given by their numbers.
struct NumberedSegment {
  Index a, b, number;
  int marker;
};

/// Sends each segment to the rank that keeps the place of one of its ends. In most files the ends have similar numbers,
/// so this rank keeps the other place, too.
std::vector<NumberedSegment> at_keepers_of_ends(const PartOfSegments& read, const SitesOfNumbers& sites, Ranks& ranks) {
  std::vector<std::vector<NumberedSegment>> leaving(static_cast<std::size_t>(ranks.count()));
  for (std::size_t i = 0; i < read.segments.size(); ++i) {
    const Segment& s = read.segments[i];
    leaving[sites.keeper_of(s.a)].push_back({s.a, s.b, static_cast<Index>(read.first + i), s.marker});
  }
  return concatenated(exchange_lists(std::move(leaving), ranks));
}

/// Collective. The segments that end at points of this rank, in any order.
std::vector<GivenSegment> at_owners_of_ends(const PartOfSegments& read, const TriangulatedPoints& points,
                                            Ranks& ranks) {
  const SitesOfNumbers sites_of_numbers(points, ranks);
  const std::vector<NumberedSegment> here = at_keepers_of_ends(read, sites_of_numbers, ranks);
  std::vector<Index> numbers;
  numbers.reserve(2 * here.size());
  for (const NumberedSegment& s : here) numbers.insert(numbers.end(), {s.a, s.b});
  const std::vector<Site> sites = sites_of_numbers.find(numbers);
  const auto for_each_owner = [&](const auto& visit) {
    for (std::size_t i = 0; i < here.size(); ++i) {
      const int owner_of_a = points.own.owner(sites[2 * i].position);
      const int owner_of_b = points.own.owner(sites[2 * i + 1].position);
      visit(owner_of_a, i);
      if (owner_of_b != owner_of_a) visit(owner_of_b, i);
    }
  };
  std::vector<std::size_t> counts(static_cast<std::size_t>(ranks.count()), 0);
  for_each_owner([&](int owner, std::size_t) { ++counts[owner]; });
  std::vector<std::vector<GivenSegment>> lists(counts.size());
  for (std::size_t rank = 0; rank < counts.size(); ++rank) lists[rank].reserve(counts[rank]);
  for_each_owner([&](int owner, std::size_t i) {
    const auto [a, b] = std::minmax(sites[2 * i], sites[2 * i + 1],
                                    [](const Site& left, const Site& right) { return left.position < right.position; });
    lists[owner].push_back({a, b, here[i].number, here[i].marker});
  });
  lists = exchange_lists(std::move(lists), ranks);
  std::vector<GivenSegment> own = std::exchange(lists[ranks.rank()], {});
  for (const std::vector<GivenSegment>& of_other : lists) own.insert(own.end(), of_other.begin(), of_other.end());
  return own;
}

}  // namespace

OwnSegments send_to_owners_of_ends(const PartOfSegments& read, const TriangulatedPoints& points, Ranks& ranks) {
  OwnSegments own;
  const std::uint64_t all_points = points.own.first.back();
  own.are_sound = std::ranges::all_of(
      read.segments, [&](const Segment& s) { return s.a < all_points && s.b < all_points && s.a != s.b; });
  if (sum_of(own.are_sound ? 0 : 1, ranks) > 0) return {{}, false};
  own.segments = at_owners_of_ends(read, points, ranks);
  sort_by_ends(own.segments);
  const bool has_equal = std::ranges::adjacent_find(own.segments, {}, ends_of) != own.segments.end();
  own.are_sound = sum_of(has_equal ? 1 : 0, ranks) == 0;
  return own;
}

}  // namespace pardel::engine
