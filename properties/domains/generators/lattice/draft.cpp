#include "draft.hpp"

#include <algorithm>
#include <numeric>
#include <set>

namespace pardel::generators {

Index Draft::point(LatticePoint place) {
  const auto known = std::ranges::find(points_, place);
  const auto id = static_cast<Index>(known - points_.begin());
  if (known != points_.end()) return id;
  points_.push_back(place);
  // At most one segment passes here, because segments do not cross.
  const auto through =
      std::ranges::find_if(segments_, [&](const Segment& s) { return lies_inside(place, points_[s.a], points_[s.b]); });
  if (through != segments_.end()) {
    const Index b = through->b;
    through->b = id;
    segments_.push_back({id, b});
  }
  return id;
}

bool Draft::free_point(LatticePoint place) {
  const bool taken =
      std::ranges::find(points_, place) != points_.end() ||
      std::ranges::any_of(segments_, [&](const Segment& s) { return lies_inside(place, points_[s.a], points_[s.b]); });
  if (!taken) points_.push_back(place);
  return !taken;
}

bool Draft::is_segment(Index a, Index b) const {
  return std::ranges::any_of(segments_,
                             [&](const Segment& s) { return (s.a == a && s.b == b) || (s.a == b && s.b == a); });
}

bool Draft::segment(LatticePoint a, LatticePoint b) {
  const bool crosses = std::ranges::any_of(
      segments_, [&](const Segment& s) { return cross_each_other(a, b, points_[s.a], points_[s.b]); });
  if (a == b || crosses) return false;
  point(a);
  point(b);
  std::vector<LatticePoint> stops = {a, b};
  for (const LatticePoint p : points_)
    if (lies_inside(p, a, b)) stops.push_back(p);
  std::ranges::sort(stops);
  for (std::size_t i = 1; i < stops.size(); ++i) {
    const Index from = point(stops[i - 1]), to = point(stops[i]);
    if (!is_segment(from, to)) segments_.push_back({from, to});
  }
  return true;
}

void Draft::path(std::span<const LatticePoint> contour) {
  for (std::size_t i = 1; i < contour.size(); ++i) segment(contour[i - 1], contour[i]);
}

void Draft::polygon(std::vector<LatticePoint> contour) {
  contour.push_back(contour.front());
  path(contour);
}

bool Draft::free_polygon(const std::vector<LatticePoint>& contour) {
  const auto [left, right] = std::ranges::minmax(contour, {}, &LatticePoint::x);
  const auto [low, high] = std::ranges::minmax(contour, {}, &LatticePoint::y);
  const LatticePoint corners[] = {{left.x, low.y}, {right.x, low.y}, {right.x, high.y}, {left.x, high.y}};
  const bool holds_a_point = std::ranges::any_of(points_, [&](LatticePoint p) {
    return p.x >= corners[0].x && p.x <= corners[2].x && p.y >= corners[0].y && p.y <= corners[2].y;
  });
  // A segment that meets the box and has no end in the box passes through a corner or crosses a side.
  const bool meets_a_segment = std::ranges::any_of(segments_, [&](const Segment& s) {
    for (int i = 0; i < 4; ++i)
      if (lies_inside(corners[i], points_[s.a], points_[s.b]) ||
          cross_each_other(points_[s.a], points_[s.b], corners[i], corners[(i + 1) % 4]))
        return true;
    return false;
  });
  if (holds_a_point || meets_a_segment) return false;
  polygon(contour);
  return true;
}

void Draft::hull() {
  // Jarvis's march. If several points lie on one line, the nearest point is the next.
  const LatticePoint first = std::ranges::min(points_);
  LatticePoint at = first;
  do {
    LatticePoint next = at;
    for (const LatticePoint p : points_) {
      if (p == at) continue;
      const std::int64_t side = next == at ? -1 : turn(at, next, p);
      if (side < 0 || (side == 0 && lies_inside(p, at, next))) next = p;
    }
    segment(at, next);
    at = next;
  } while (at != first);
}

LatticeDomain Draft::finished(Random& random, int regions) const {
  LatticeDomain domain;
  std::vector<Index> order(points_.size()), place(points_.size());
  std::iota(order.begin(), order.end(), Index{0});
  random.shuffle(order);
  for (Index i = 0; i < order.size(); ++i) {
    place[order[i]] = i;
    domain.points.push_back(points_[order[i]]);
  }
  const bool marked = random.chance(2);
  for (const Segment& s : segments_) {
    const int marker = marked ? random.between(0, 3) : 0;
    domain.segments.push_back(random.chance(2) ? Segment{place[s.a], place[s.b], marker}
                                               : Segment{place[s.b], place[s.a], marker});
  }
  random.shuffle(domain.segments);

  LatticeFaces faces(domain.points, domain.segments);
  std::vector<Index> half_edges(faces.half_edges());
  std::iota(half_edges.begin(), half_edges.end(), Index{0});
  for (const Direction& hole : holes_) {
    const auto side_of_hole = std::ranges::find_if(half_edges, [&](Index h) {
      const LatticePoint a = domain.points[faces.ends(h).a], b = domain.points[faces.ends(h).b];
      return a == hole.from && cross(b - a, hole.to - a) == 0 && dot(b - a, hole.to - a) > 0;
    });
    if (side_of_hole == half_edges.end() || faces.domain_faces() == 1) continue;
    const Index face = faces.left_of(*side_of_hole);
    if (!faces.is_domain(face)) continue;
    domain.holes.push_back(faces.seed_left_of(*side_of_hole));
    faces.make_hole(face);
  }
  random.shuffle(half_edges);
  std::set<Index> claimed;
  const auto area = static_cast<double>(width(points_) * width(points_));
  for (const Index h : half_edges) {
    const Index face = faces.left_of(h);
    if (static_cast<int>(claimed.size()) == regions) break;
    if (!faces.is_domain(face) || !claimed.insert(face).second) continue;
    LatticeRegion& region = domain.regions.emplace_back();
    region.seed = faces.seed_left_of(h);
    region.attribute = random.between(0, 3);
    if (random.chance(2)) region.max_area = area / random.between(8, 100);
  }
  return domain;
}

}  // namespace pardel::generators
