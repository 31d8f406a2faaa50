#include "own_segments.hpp"

#include <algorithm>

#include "../../core/support/collective.hpp"
#include "../../core/support/message.hpp"
#include "sites_of_numbers.hpp"

namespace pardel::engine {

OwnSegments send_to_owners_of_ends(const PartOfSegments& read, const std::vector<std::uint64_t>& first_read,
                                   const TriangulatedPoints& points, Ranks& ranks) {
  OwnSegments own;
  std::vector<Index> numbers;
  numbers.reserve(2 * read.segments.size());
  for (const Segment& segment : read.segments) {
    const bool exists = segment.a < first_read.back() && segment.b < first_read.back();
    if (!exists || segment.a == segment.b) own.are_sound = false;
    if (exists) numbers.insert(numbers.end(), {segment.a, segment.b});
  }
  if (sum_of(own.are_sound ? 0 : 1, ranks) > 0) return {{}, false};

  const std::vector<Site> sites = SitesOfNumbers(points, first_read, ranks).find(numbers);
  std::vector<std::vector<std::size_t>> leaving(static_cast<std::size_t>(ranks.count()));  // places in the list
  for (std::size_t i = 0; i < read.segments.size(); ++i) {
    const int owner_of_a = points.own.owner(sites[2 * i].position);
    const int owner_of_b = points.own.owner(sites[2 * i + 1].position);
    leaving[owner_of_a].push_back(i);
    if (owner_of_b != owner_of_a) leaving[owner_of_b].push_back(i);
  }
  std::vector<Writer> messages(leaving.size());
  for (std::size_t rank = 0; rank < messages.size(); ++rank)
    messages[rank].list_of<GivenSegment>(leaving[rank].size(), [&](std::size_t k) {
      const std::size_t i = leaving[rank][k];
      const auto [a, b] = std::minmax(sites[2 * i], sites[2 * i + 1], [](const Site& left, const Site& right) {
        return left.position < right.position;
      });
      return GivenSegment{a, b, static_cast<Index>(read.first + i), read.segments[i].marker};
    });
  for (Ranks::Bytes& message : exchange(messages, ranks)) {
    Reader reader(message);
    const auto arrived = reader.packed_list<GivenSegment>();
    for (std::size_t i = 0; i < arrived.size(); ++i) own.segments.push_back(arrived[i]);
    message = {};
  }
  sort_by_ends(own.segments);
  const bool has_equal = std::ranges::adjacent_find(own.segments, {}, ends_of) != own.segments.end();
  own.are_sound = sum_of(has_equal ? 1 : 0, ranks) == 0;
  return own;
}

}  // namespace pardel::engine
