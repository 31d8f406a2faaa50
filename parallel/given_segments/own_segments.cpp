#include "own_segments.hpp"

#include <algorithm>

#include "../../core/support/collective.hpp"
#include "../../core/support/exchange_lists.hpp"
#include "../../core/support/message.hpp"
#include "sites_of_numbers.hpp"

namespace pardel::engine {
namespace {

/// A segment whose ends are given by their numbers.
struct NumberedSegment {
  Index a, b, number;
  int marker;
};

/// Sends each segment to the rank that has read one of its ends. In most files, this rank has read the other end, too.
/// (A rank that reads a part of a file has read either points or segments.)
std::vector<NumberedSegment> at_readers_of_ends(const PartOfSegments& read, const SitesOfNumbers& sites, Ranks& ranks) {
  std::vector<std::vector<NumberedSegment>> leaving(static_cast<std::size_t>(ranks.count()));
  for (std::size_t i = 0; i < read.segments.size(); ++i) {
    const Segment& s = read.segments[i];
    leaving[sites.reader_of(s.a)].push_back({s.a, s.b, static_cast<Index>(read.first + i), s.marker});
  }
  return concatenated(exchange_lists(leaving, ranks));
}

}  // namespace

OwnSegments send_to_owners_of_ends(const PartOfSegments& read, const std::vector<std::uint64_t>& first_read,
                                   const TriangulatedPoints& points, Ranks& ranks) {
  OwnSegments own;
  own.are_sound = std::ranges::all_of(read.segments, [&](const Segment& s) {
    return s.a < first_read.back() && s.b < first_read.back() && s.a != s.b;
  });
  if (sum_of(own.are_sound ? 0 : 1, ranks) > 0) return {{}, false};

  const SitesOfNumbers sites_of_numbers(points, first_read, ranks);
  const std::vector<NumberedSegment> here = at_readers_of_ends(read, sites_of_numbers, ranks);
  std::vector<Index> numbers;
  numbers.reserve(2 * here.size());
  for (const NumberedSegment& s : here) numbers.insert(numbers.end(), {s.a, s.b});
  const std::vector<Site> sites = sites_of_numbers.find(numbers);
  std::vector<std::vector<std::size_t>> leaving(static_cast<std::size_t>(ranks.count()));  // places in the list
  for (std::size_t i = 0; i < here.size(); ++i) {
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
      return GivenSegment{a, b, here[i].number, here[i].marker};
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
