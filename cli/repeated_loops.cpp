#include "repeated_loops.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <set>
#include <vector>

namespace pardel::cli {
namespace {

/// The segments that are given again, as a graph. The first of several equal points stands for all of them.
class RepeatedSegments {
 public:
  RepeatedSegments(const Pslg& pslg, std::span<const Problem> problems) {
    std::map<Index, Index> first_equal;
    for (const Problem& problem : problems)
      if (problem.kind == ProblemKind::duplicate_points) first_equal[problem.ids[1]] = problem.ids[0];
    const auto first = [&](Index point) {
      const auto found = first_equal.find(point);
      return found == first_equal.end() ? point : found->second;
    };
    for (const Problem& problem : problems) {
      if (problem.kind != ProblemKind::duplicate_segments) continue;
      if (++times_[problem.ids[0]] > 1) continue;
      const Segment& segment = pslg.segments[problem.ids[0]];
      at_[first(segment.a)].push_back({problem.ids[0], first(segment.b)});
      at_[first(segment.b)].push_back({problem.ids[0], first(segment.a)});
    }
  }

  struct Loop {
    std::set<Index> points;  ///< empty if the segments make no loop
    int times = 1;
  };
  /// Follows the segments from a point that has not been visited. They make a loop if each point has two of them and
  /// all are given equally often.
  Loop follow(Index start) {
    Loop loop{{}, 1 + times_.at(at_.at(start).front().segment)};
    bool closed = true;
    std::vector<Index> front = {start};
    visited_.insert(start);
    while (!front.empty()) {
      const Index point = front.back();
      front.pop_back();
      loop.points.insert(point);
      closed = closed && at_.at(point).size() == 2;
      for (const auto& [segment, other] : at_.at(point)) {
        closed = closed && 1 + times_.at(segment) == loop.times;
        if (visited_.insert(other).second) front.push_back(other);
      }
    }
    if (!closed) loop.points.clear();
    return loop;
  }
  std::vector<Loop> loops() {
    std::vector<Loop> found;
    for (const auto& [point, ignored] : at_) {
      if (visited_.contains(point)) continue;
      if (Loop loop = follow(point); !loop.points.empty()) found.push_back(std::move(loop));
    }
    return found;
  }

 private:
  struct End {
    Index segment;
    Index other;  ///< the point at the other end
  };
  std::map<Index, int> times_;            ///< how often each segment is given again
  std::map<Index, std::vector<End>> at_;  ///< the segments at each point
  std::set<Index> visited_;
};

}  // namespace

std::string repeated_loops(const Pslg& pslg, std::span<const Problem> problems) {
  std::string text;
  for (const auto& [points, times] : RepeatedSegments(pslg, problems).loops()) {
    const long long first = *points.begin(), last = *points.rbegin(), base = pslg.first_id.value;
    const bool is_range = last - first + 1 == static_cast<long long>(points.size());
    text += is_range ? fmt::format("\nThe loop of points {} to {} is given ", first + base, last + base)
                     : fmt::format("\nThe loop of {} points, the first of them point {}, is given ", points.size(),
                                   first + base);
    text += times == 2 ? std::string("twice.") : fmt::format("{} times.", times);
  }
  return text;
}

}  // namespace pardel::cli
