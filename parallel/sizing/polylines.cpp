#include "polylines.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "../../core/support/point_order.hpp"
#include "../arithmetic/distance.hpp"

namespace pardel::engine {
namespace {

constexpr double least_cosine = 0.65;  ///< of the turn at a smooth vertex; no regular polygon turns by nearly so much

bool turns_little(Point a, Point v, Point b) {
  const double dot = (v.x - a.x) * (b.x - v.x) + (v.y - a.y) * (b.y - v.y);
  return dot > least_cosine * (distance(a, v) * distance(v, b));
}

class PolylineSearch {
 public:
  explicit PolylineSearch(const Pslg& pslg) : pslg_(pslg), used_(pslg.segments.size()) {
    first_.assign(pslg.points.size() + 1, 0);
    for (const Segment& s : pslg.segments) ++first_[s.a], ++first_[s.b];
    Index sum = 0;
    for (Index& f : first_) sum += f, f = sum - f;
    at_.resize(2 * pslg.segments.size());
    std::vector<Index> next = first_;
    for (Index s = 0; s < pslg.segments.size(); ++s)
      for (const Index v : {pslg.segments[s].a, pslg.segments[s].b}) at_[next[v]++] = s;
    found_.is_corner.resize(pslg.points.size());
    for (Index v = 0; v < pslg.points.size(); ++v) found_.is_corner[v] = !is_smooth(v);
  }

  Polylines run(const Threads& threads) && {
    SparseAsk ask(threads.stop);
    // Those that end at corners come first; what is left is closed.
    for (const bool closed : {false, true})
      for (Index s = 0; s < pslg_.segments.size(); ++s) {
        ask();
        const Segment& segment = pslg_.segments[s];
        if (used_[s]) continue;
        if (closed)
          add(segment.a, s, true);
        else if (found_.is_corner[segment.a])
          add(segment.a, s, false);
        else if (found_.is_corner[segment.b])
          add(segment.b, s, false);
      }
    return std::move(found_);
  }

 private:
  [[nodiscard]] Index other_end(Index s, Index v) const {
    return pslg_.segments[s].a == v ? pslg_.segments[s].b : pslg_.segments[s].a;
  }
  [[nodiscard]] bool is_smooth(Index v) const {
    if (first_[v + 1] - first_[v] != 2) return false;
    const Index s = at_[first_[v]], t = at_[first_[v] + 1];
    return turns_little(pslg_.points[other_end(s, v)], pslg_.points[v], pslg_.points[other_end(t, v)]);
  }

  void add(Index from, Index s, bool closed) {
    Polyline line{{from}, closed};
    Index v = from;
    while (!used_[s]) {
      used_[s] = true;
      v = other_end(s, v);
      line.vertices.push_back(v);
      if (found_.is_corner[v]) break;
      const Index one = at_[first_[v]], two = at_[first_[v] + 1];
      s = one == s ? two : one;
    }
    orient(line);
    found_.all.push_back(std::move(line));
  }

  void orient(Polyline& line) const {
    std::vector<Index>& v = line.vertices;
    const auto before = [&](Index a, Index b) { return lexicographically_less(pslg_.points[a], pslg_.points[b]); };
    if (line.closed) {
      v.pop_back();
      std::rotate(v.begin(), std::ranges::min_element(v, before), v.end());
      v.push_back(v.front());
    }
    const bool loop = v.front() == v.back();
    if (loop ? before(v[v.size() - 2], v[1]) : before(v.back(), v.front())) std::ranges::reverse(v);
  }

  const Pslg& pslg_;
  std::vector<Index> first_, at_;  ///< the segments at each point
  std::vector<bool> used_;
  Polylines found_;
};

}  // namespace

Polylines find_polylines(const Pslg& pslg, const Threads& threads) { return PolylineSearch(pslg).run(threads); }

}  // namespace pardel::engine
