#include "tiny_gaps.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "../arithmetic/box.hpp"
#include "../construction/domain_triangulation.hpp"
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
    if (s.a < pslg.points.size() && s.b < pslg.points.size())
      extents_.add(Box::around(pslg.points[s.a], pslg.points[s.b]));
  if (extents_.empty())
    for (const Point p : pslg.points) extents_.add(Box::around(p));
}

double TinyDistances::at(double scale) const {
  return std::min(0x1p-30 * largest_like(scale), 1e-6 * extents_.near(scale));
}

double TinyDistances::largest() const {
  double largest = 0;
  extents_.for_each_scale([&](double scale) { largest = std::max(largest, at(scale)); });
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
