#include "hairlines.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "../arithmetic/distance.hpp"
#include "../arithmetic/floor.hpp"
#include "../arithmetic/predicates.hpp"
#include "../triangulation/triangle_shape.hpp"

namespace pardel::engine {
namespace {

/// Rounding moves points by much less than this.
double hairline_at(Point p) { return Floor(0).at(p) / 16; }

/// Flat triangles that share sides.
class FlatTriangles {
 public:
  explicit FlatTriangles(std::span<const FlatTriangle> all) : all_(all) {
    for (std::size_t i = 0; i < all.size(); ++i)
      for (unsigned side = 0; side < 3; ++side) at_[{from(all[i], side), to(all[i], side)}] = {i, side};
  }

  /// The hairlines at one triangle.
  void examine(const FlatTriangle& t, std::vector<Hairline>& found) const {
    std::array<double, 3> length;
    for (unsigned side = 0; side < 3; ++side)
      length[side] = distance(t.at[next_corner[side]], t.at[previous_corner[side]]);
    for (unsigned side = 0; side < 3; ++side) {
      const unsigned u = next_corner[side], v = previous_corner[side];
      if (t.is_segment[side] != 0 || !(length[side] < hairline_at(t.at[u]))) continue;
      found.push_back({t.v[u], t.v[v], t.v[v], t.at[u], t.at[v], t.at[v]});
      found.push_back({t.v[v], t.v[u], t.v[u], t.at[v], t.at[u], t.at[u]});
    }
    const auto top = static_cast<unsigned>(std::ranges::max_element(length) - length.begin());
    walk_across(t, top, found);
  }

 private:
  static std::uint64_t from(const FlatTriangle& t, unsigned side) { return t.v[next_corner[side]]; }
  static std::uint64_t to(const FlatTriangle& t, unsigned side) { return t.v[previous_corner[side]]; }

  /// Walks from a corner straight across the opposite side, to a segment if only flat triangles lie before it.
  void walk_across(const FlatTriangle& start, unsigned top, std::vector<Hairline>& found) const {
    const Point tip = start.at[top], a = start.at[next_corner[top]], b = start.at[previous_corner[top]];
    const auto lies_ahead = [&](Point p) { return (b.x - a.x) * (p.x - tip.x) + (b.y - a.y) * (p.y - tip.y) > 0; };
    const FlatTriangle* t = &start;
    unsigned side = top;
    for (std::size_t step = 0; step < all_.size() && t->is_segment[side] == 0; ++step) {
      const auto across = at_.find({to(*t, side), from(*t, side)});
      if (across == at_.end()) return;
      t = &all_[across->second.first];
      const unsigned apex = across->second.second;
      side = exit_side(apex, lies_ahead(t->at[apex]), lies_ahead(t->at[next_corner[apex]]));
    }
    const unsigned u = next_corner[side], v = previous_corner[side];
    if (t->is_segment[side] != 0 && t->v[u] != start.v[top] && t->v[v] != start.v[top])
      found.push_back({start.v[top], t->v[u], t->v[v], tip, t->at[u], t->at[v]});
  }

  std::span<const FlatTriangle> all_;
  std::map<std::pair<std::uint64_t, std::uint64_t>, std::pair<std::size_t, unsigned>> at_;
};

/// The sine of the angle between the directions from a to b and from c to d, or less.
double least_sine(Point a, Point b, Point c, Point d) {
  constexpr double error = 0x1p-50;
  const double ux = b.x - a.x, uy = b.y - a.y, vx = d.x - c.x, vy = d.y - c.y;
  return std::max(0.0, std::abs(ux * vy - uy * vx) / (distance(a, b) * distance(c, d)) - error);
}

double slope_of(const Hairline& line, VertexId tip, Index segment, const DomainSegments& segments,
                const Array<Point>& points) {
  if (line.a == line.b) return 0;
  return least_sine(line.a_at, line.b_at, line.tip_at, points[segments.other_end(segment, tip)]);
}

}  // namespace

bool is_flat(Point a, Point b, Point c) {
  const Shape shape(a, b, c);
  const double narrow = std::max({hairline_at(a), hairline_at(b), hairline_at(c)});
  return shape.twice_area * shape.twice_area < narrow * narrow * shape.longest_squared();
}

std::vector<Hairline> hairlines_among(std::span<const FlatTriangle> flat) {
  const FlatTriangles all(flat);
  std::vector<Hairline> found;
  for (const FlatTriangle& t : flat) all.examine(t, found);
  return found;
}

double gap_of(const Hairline& line) {
  if (line.a == line.b) return distance(line.tip_at, line.a_at);
  return std::abs(exact::twice_area(line.a_at, line.b_at, line.tip_at)) / distance(line.a_at, line.b_at);
}

double slope_at_tip(const Hairline& line, VertexId tip, const DomainSegments& segments, const Array<Point>& points) {
  if (segments.segments_at(tip).empty()) return 0;
  double least = 1;
  for (const Index s : segments.segments_at(tip)) least = std::min(least, slope_of(line, tip, s, segments, points));
  return least;
}

void keep_clear(const Hairline& line, VertexId tip, Index beside, DomainSegments& segments,
                const Array<Point>& points) {
  const double gap = gap_of(line);
  if (beside != no_index) segments.add_clearance(beside, {line.tip_at, gap, line.slope, /*is_passed=*/true});
  if (tip == no_index) return;
  for (const Index s : segments.segments_at(tip))
    segments.add_clearance(s, {line.tip_at, gap, slope_of(line, tip, s, segments, points)});
}

void keep_clear(std::vector<Hairline> all, const Triangulation& t, DomainSegments& segments) {
  for (Hairline& line : all) {
    const auto tip = static_cast<VertexId>(line.tip), a = static_cast<VertexId>(line.a),
               b = static_cast<VertexId>(line.b);
    const Index around = segment_of_origin(t.origin[tip]);
    const bool is_inside = around < segments.size();
    if (!is_inside && segments.segments_at(tip).empty()) continue;
    line.slope = slope_at_tip(line, tip, segments, t.points);
    keep_clear(line, tip, a == b ? no_index : segments.segment_of(t, a, b), segments, t.points);
    if (is_inside) segments.add_clearance(around, {line.tip_at, gap_of(line)});
  }
}

}  // namespace pardel::engine
