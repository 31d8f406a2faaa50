#include "own_points.hpp"

#include <utility>

#include "../../core/support/message.hpp"
#include "../../core/support/share_of_rank.hpp"
#include "../../parallel/decomposition/hilbert_order.hpp"
#include "../../parallel/threads/parallel_arrays.hpp"

namespace pardel::engine {
namespace {

struct TravellingPoint {
  Point at;
  std::uint64_t number;
};

/// What a rank receives: lists that continue one another, of all ranks.
struct Arrived {
  Array<TravellingPoint> points;
  Array<int> markers;
  Array<double> attributes;
};

std::vector<Ranks::Bytes> messages_to_owners(const PartOfPoints& read, const CurveDivision& division, int ranks) {
  std::vector<std::vector<std::size_t>> of_rank(static_cast<std::size_t>(ranks));
  for (std::size_t i = 0; i < read.points.size(); ++i) of_rank[division.owner(read.points[i])].push_back(i);
  std::vector<Ranks::Bytes> messages;
  const std::size_t k = read.attributes_per_point;
  for (std::vector<std::size_t>& points : of_rank) {
    Writer message;
    message.list_of<TravellingPoint>(points.size(), [&](std::size_t i) {
      return TravellingPoint{read.points[points[i]], read.first + points[i]};
    });
    const bool marked = !read.point_markers.empty();
    message.list_of<int>(marked ? points.size() : 0, [&](std::size_t i) { return read.point_markers[points[i]]; });
    message.list_of<double>(k * points.size(),
                            [&](std::size_t i) { return read.point_attributes[k * points[i / k] + i % k]; });
    points = {};
    messages.push_back(message.take());
  }
  return messages;
}

template <class T>
void append(const PackedList<T>& list, Array<T>& all) {
  for (std::size_t i = 0; i < list.size(); ++i) all.push_back(list[i]);
}

Arrived exchanged(std::vector<Ranks::Bytes> messages, Ranks& ranks) {
  Arrived arrived;
  for (Ranks::Bytes& message : ranks.exchange(std::move(messages))) {
    Reader reader(message);
    append(reader.packed_list<TravellingPoint>(), arrived.points);
    append(reader.packed_list<int>(), arrived.markers);
    append(reader.packed_list<double>(), arrived.attributes);
    message = {};
  }
  return arrived;
}

}  // namespace

OwnPoints send_to_owners(PartOfPoints&& read, const CurveDivision& division, Ranks& ranks, const Threads& threads) {
  OwnPoints own;
  const std::size_t k = own.attributes_per_point = read.attributes_per_point;
  std::vector<Ranks::Bytes> messages = messages_to_owners(read, division, ranks.count());
  { const PartOfPoints used_up = std::move(read); }
  Arrived arrived = exchanged(std::move(messages), ranks);
  const std::size_t n = arrived.points.size();
  if ((!arrived.markers.empty() && arrived.markers.size() != n) || arrived.attributes.size() != k * n)
    throw Reader::does_not_match();
  const Array<Point> places = make_array(threads, n, [&](std::size_t i) { return arrived.points[i].at; });
  const Array<Index> order = hilbert_order(places.span(), division.grid(), threads);
  own.at = make_array(threads, n, [&](std::size_t v) { return places[order[v]]; });
  own.number = make_array(threads, n, [&](std::size_t v) { return arrived.points[order[v]].number; });
  own.marker = make_array(threads, arrived.markers.size(), [&](std::size_t v) { return arrived.markers[order[v]]; });
  own.attributes =
      make_array(threads, k * n, [&](std::size_t i) { return arrived.attributes[k * order[i / k] + i % k]; });
  std::vector<std::uint64_t> counts(static_cast<std::size_t>(ranks.count()), 0);
  counts[ranks.rank()] = n;
  ranks.add_up(counts);
  own.first.push_back(0);
  for (const std::uint64_t count : counts) own.first.push_back(own.first.back() + count);
  return own;
}

}  // namespace pardel::engine
