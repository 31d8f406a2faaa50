// A domain without its numbering.
#pragma once

#include <algorithm>
#include <ostream>
#include <set>
#include <tuple>

#include "../../../core/pslg.hpp"

namespace pardel::testing {

/// The places of points and segments. Two domains whose points have other numbers have equal drawings.
struct Drawing {
  using Place = std::tuple<double, double>;
  std::set<Place> points;
  std::multiset<std::tuple<Place, Place, int>> segments;  ///< with their markers

  Drawing() = default;
  explicit Drawing(const Pslg& pslg) { add(pslg); }

  void add(const Pslg& pslg) {
    const auto place = [&](Index i) { return Place(pslg.points[i].x, pslg.points[i].y); };
    for (Index i = 0; i < pslg.points.size(); ++i) points.insert(place(i));
    for (const Segment& s : pslg.segments) {
      const auto [from, to] = std::minmax({place(s.a), place(s.b)});
      segments.insert({from, to, s.marker});
    }
  }

  friend bool operator==(const Drawing&, const Drawing&) = default;
  friend std::ostream& operator<<(std::ostream& out, const Drawing& drawing) {
    return out << drawing.points.size() << " points, " << drawing.segments.size() << " segments";
  }
};

}  // namespace pardel::testing
