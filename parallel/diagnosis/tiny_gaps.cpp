#include "tiny_gaps.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "../conversion/domain_triangulation.hpp"
#include "../segments/reach.hpp"
#include "find_gaps.hpp"

namespace pardel::engine {
namespace {

/// The smallest scale of the things that come together if the gap is closed.
double scale_of(const Gap& gap, const Reach& reach) {
  if (gap.kind != GapKind::point_near_segment) return reach.scale_of_points(gap.points[0], gap.points[1]);
  return std::min(reach.scale_of_point(gap.points[0]), reach.scale_of_segment(gap.segment));
}

/// The tiny gaps at scales with the same power of two.
struct TinyGaps {
  std::vector<Gap> gaps;  ///< narrowest first
  double scale = 0;       ///< the largest one
};

std::map<int, TinyGaps> tiny_gaps_by_scale(const ValidPslg& domain, const TinyDistances& tiny, StopSignal& stop) {
  const Threads one(1, &stop);
  const Result<DomainTriangulation> triangulated = triangulate_domain(domain.pslg(), domain.convex_hull(), one);
  if (!triangulated) return {};
  const Pslg& pslg = domain.pslg();
  const Reach reach(Snapping::share_of_scale(1), pslg.points, pslg.segments);
  std::map<int, TinyGaps> by_scale;
  for (Gap& gap : find_gaps(*triangulated, one)) {
    if (gap.kind == GapKind::point_near_hull || much_narrower * gap.distance > gap.surroundings) continue;
    const double scale = scale_of(gap, reach);
    if (gap.distance > tiny.at(scale)) continue;
    TinyGaps& similar = by_scale[std::ilogb(scale)];
    similar.gaps.push_back(std::move(gap));
    similar.scale = std::max(similar.scale, scale);
  }
  return by_scale;
}

}  // namespace

void TinyDistances::add(const Pslg& pslg) {
  for (const Segment& s : pslg.segments)
    if (s.a < pslg.points.size() && s.b < pslg.points.size()) add(Box::around(pslg.points[s.a], pslg.points[s.b]));
  if (box_at_.empty())
    for (const Point p : pslg.points) add(Box::around(p));
}

void TinyDistances::add(const Box& box) {
  box_at_.try_emplace(std::ilogb(box.largest_magnitude()), empty_box).first->second.cover(box);
}

double TinyDistances::at(double scale) const {
  const int power = std::ilogb(scale);
  Box similar = empty_box;
  for (auto at = box_at_.lower_bound(power - 1); at != box_at_.end() && at->first <= power + 1; ++at)
    similar.cover(at->second);
  return std::min(0x1p-30 * largest_like(scale), 1e-6 * std::max(0.0, similar.extent()));
}

double TinyDistances::largest_like(double scale) const {
  const auto same = box_at_.find(std::ilogb(scale));
  return same == box_at_.end() ? scale : same->second.largest_magnitude();
}

double TinyDistances::largest() const {
  double largest = 0;
  for (const auto& [power, box] : box_at_) largest = std::max(largest, at(box.largest_magnitude()));
  return largest;
}

bool widen_to_tiny_gaps(Snapping& snapping, const Pslg& original, const ValidPslg& domain, StopSignal& stop) {
  TinyDistances tiny(original);
  tiny.add(domain.pslg());
  bool is_wider = false;
  for (const auto& [power, similar] : tiny_gaps_by_scale(domain, tiny, stop)) {
    const double now = snapping.at(tiny.largest_like(similar.scale));
    const double wider = std::min(tiny.at(similar.scale), std::max(closing_snap(similar.gaps), 2 * now));
    if (wider <= now) continue;
    snapping.widen(similar.scale, wider);
    is_wider = true;
  }
  return is_wider;
}

}  // namespace pardel::engine
