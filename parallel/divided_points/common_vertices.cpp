#include "common_vertices.hpp"

#include <algorithm>

#include "../../core/support/exchange_lists.hpp"

namespace pardel::engine {
namespace {

/// The points at the ends of the segments, ascending.
std::vector<std::uint64_t> numbers_of_ends(std::span<const Segment> segments) {
  std::vector<std::uint64_t> numbers;
  for (const Segment& segment : segments) numbers.insert(numbers.end(), {segment.a, segment.b});
  std::ranges::sort(numbers);
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  return numbers;
}

}  // namespace

CommonVertices::CommonVertices(const SharedHull& hull, std::span<const Segment> segments, const LocalDelaunay& delaunay,
                               const OwnPoints& own, Ranks& ranks) {
  for (const HullVertex& v : hull.vertices()) vertices_.push_back({v.at, v.position, v.number, v.marker});
  const std::vector<std::uint64_t> ends = numbers_of_ends(segments);
  std::vector<CommonVertex> here;
  for (VertexId v = 0; v < delaunay.own() && !ends.empty(); ++v)
    if (std::ranges::binary_search(ends, own.number[v])) {
      const Site site = delaunay.site(v);
      here.push_back({site.at, site.position, own.number[v], own.marker.empty() ? 0 : own.marker[v]});
    }
  const std::vector<CommonVertex> all = concatenated(lists_of_all(here, ranks));
  vertices_.insert(vertices_.end(), all.begin(), all.end());
  sort_by_position(vertices_);

  std::vector<std::pair<std::uint64_t, Index>> by_number;
  for (Index i = 0; i < size(); ++i) by_number.emplace_back(vertices_[i].number, i);
  std::ranges::sort(by_number);
  const auto index_of = [&](Index number) {
    const auto found = std::ranges::lower_bound(by_number, std::pair{std::uint64_t{number}, Index{0}});
    return found != by_number.end() && found->first == number ? found->second : no_index;
  };
  for (const Segment& segment : segments)
    segments_.push_back({index_of(segment.a), index_of(segment.b), segment.marker});
}

}  // namespace pardel::engine
