#include "problems_of_domain.hpp"

#include <string>
#include <vector>

#include "../../core/support/collective.hpp"
#include "../../core/support/message.hpp"
#include "../../parallel/domain/find_problems.hpp"

namespace pardel::engine {
namespace {

/// The messages have the segments in the order of the ranks, which is that of their numbers.
Pslg whole_of(const std::vector<Ranks::Bytes>& messages, std::uint64_t points, const Pslg& rest) {
  Pslg whole = rest;
  whole.points.resize(static_cast<std::size_t>(points));
  for (const Ranks::Bytes& message : messages) {
    Reader reader(message);
    const auto arrived = reader.packed_list<NumberedPoint>();
    for (std::size_t i = 0; i < arrived.size(); ++i) {
      const NumberedPoint point = arrived[i];
      if (point.number >= points) throw Reader::does_not_match();
      whole.points[point.number] = point.at;
    }
    const auto segments = reader.packed_list<Segment>();
    for (std::size_t i = 0; i < segments.size(); ++i) whole.segments.push_back(segments[i]);
  }
  return whole;
}

}  // namespace

std::vector<NumberedPoint> numbered(std::span<const Point> at, const OwnPoints& own) {
  std::vector<NumberedPoint> points;
  for (std::size_t i = 0; i < at.size(); ++i) points.push_back({own.number[i], at[i]});
  return points;
}

std::vector<NumberedPoint> numbered(const PartOfPoints& read) {
  std::vector<NumberedPoint> points;
  for (std::size_t i = 0; i < read.points.size(); ++i) points.push_back({read.first + i, read.points[i]});
  return points;
}

Status status_of_whole(const std::vector<NumberedPoint>& points, const PartOfSegments& segments, const Pslg& rest,
                       bool convex_hull, Ranks& ranks, const Threads& threads) {
  Writer message;
  message.list(points);
  message.list(segments.segments);
  const std::uint64_t in_all = sum_of(points.size(), ranks);
  const std::vector<Ranks::Bytes> all = to_first(message.take(), ranks);
  Writer problems;
  if (ranks.rank() == 0) {
    const Pslg whole = whole_of(all, in_all, rest);
    const std::string text =
        messages(find_problems(whole, ValidateOptions{.convex_hull = convex_hull}, threads), rest.first_id.value);
    problems.list(std::vector<char>(text.begin(), text.end()));
  }
  const Ranks::Bytes told = from_first(problems.take(), ranks);
  const std::vector<char> text = Reader(told).list<char>();
  if (text.empty()) return Done{};
  return Error{ErrorKind::invalid_input, std::string(text.begin(), text.end())};
}

}  // namespace pardel::engine
