#include "curve_division.hpp"

#include <cmath>

#include "../../core/support/exchange_lists.hpp"
#include "../../core/support/share_of_rank.hpp"
#include "../../parallel/decomposition/bounding_box.hpp"

namespace pardel::engine {
namespace {

/// Each rank shows the others so many of its keys at most. The sizes of the shares then differ by a few percent.
constexpr std::size_t keys_shown = 16'384;

/// A key, and how many points it stands for.
struct SampledKey {
  std::uint32_t key;
  std::uint32_t unused = 0;
  double weight;
};

Box bounds_of(std::span<const Point> points) {
  Box bounds = empty_box;
  for (const Point p : points) bounds.cover(Box::around(p));
  return bounds;
}

/// All ranks get the same list, in ascending order.
std::vector<SampledKey> sample_keys(std::span<const Point> points, const CurveGrid& grid, Ranks& ranks) {
  const std::size_t step = points.size() / keys_shown + 1;
  std::vector<SampledKey> own;
  for (std::size_t i = 0; i < points.size(); i += step)
    own.push_back({grid.key(points[i]), 0, static_cast<double>(std::min(step, points.size() - i))});
  std::vector<SampledKey> all = concatenated(lists_of_all(own, ranks));
  std::ranges::sort(all, [](const SampledKey& a, const SampledKey& b) {
    return a.key != b.key ? a.key < b.key : a.weight < b.weight;
  });
  return all;
}

}  // namespace

Disk Disk::around(Point a, Point b, Point c) {
  const double bx = b.x - a.x, by = b.y - a.y, cx = c.x - a.x, cy = c.y - a.y;
  const double left = bx * cy, right = by * cx, twice_area = left - right;
  // Coordinates relative to `a` and their products have relative errors of a few 2^-53. So if the area is at least this
  // share of its terms, its relative error is below 1e-7, and the error of the centre below a millionth of the terms of
  // its numerators.
  constexpr double least_share = 1e-8, error = 1e-6;
  if (!(std::abs(twice_area) > least_share * (std::abs(left) + std::abs(right)))) return {};
  const double b2 = bx * bx + by * by, c2 = cx * cx + cy * cy;
  const double x = (cy * b2 - by * c2) / (2 * twice_area), y = (bx * c2 - cx * b2) / (2 * twice_area);
  const double terms = ((std::abs(cx) + std::abs(cy)) * b2 + (std::abs(bx) + std::abs(by)) * c2) / std::abs(twice_area);
  const double rounding = 0x1p-45 * (std::abs(a.x) + std::abs(a.y));  // of the coordinates of the centre
  const Disk disk{{a.x + x, a.y + y}, std::hypot(x, y) + error * terms + rounding};
  return std::isfinite(disk.radius) && std::isfinite(disk.centre.x) && std::isfinite(disk.centre.y) ? disk : Disk{};
}

bool Disk::may_meet(const Box& box) const {
  if (radius == INFINITY) return true;
  const double dx = std::max({box.min_x - centre.x, centre.x - box.max_x, 0.0});
  const double dy = std::max({box.min_y - centre.y, centre.y - box.max_y, 0.0});
  return !(dx > radius || dy > radius || std::hypot(dx, dy) > radius);
}

bool HalfPlane::may_meet(const Box& box) const {
  const double dx = b.x - a.x, dy = b.y - a.y;
  for (const double x : {box.min_x, box.max_x})
    for (const double y : {box.min_y, box.max_y}) {
      const double left = dx * (y - a.y), right = dy * (x - a.x);
      constexpr double rounding = 0x1p-50;
      if (!(left - right < -rounding * (std::abs(left) + std::abs(right)))) return true;
    }
  return false;
}

bool CurveDivision::certainly_owns(int rank, const Disk& disk) const {
  if (disk.is_whole_plane()) return false;
  const CurveGrid::Quadrant quadrant = grid_.around(disk.bounds());
  return owner(CurveGrid::first_key(quadrant)) == rank && owner(CurveGrid::last_key(quadrant)) == rank;
}

Box bounds_of_all(const Box& own, Ranks& ranks) {
  Box all = empty_box;
  for (const Box& box : concatenated(lists_of_all(std::vector{own}, ranks))) all.cover(box);
  return all;
}

CurveDivision divide_along_curve(std::span<const Point> points, Ranks& ranks) {
  const std::uint64_t all = share_of_rank(points.size(), ranks).all;
  Box bounds = bounds_of_all(bounds_of(points), ranks);
  if (all <= few_points) bounds = Box::around(all > 0 ? Point{bounds.min_x, bounds.min_y} : Point{});
  const CurveGrid grid(bounds);
  const std::vector<SampledKey> sample = sample_keys(points, grid, ranks);
  std::vector<std::uint32_t> first_key{0};
  double before = 0;
  for (const SampledKey& each : sample) {
    // A rank begins where the ranks before it have their share.
    while (static_cast<int>(first_key.size()) < ranks.count() &&
           before * ranks.count() >= static_cast<double>(first_key.size()) * static_cast<double>(all))
      first_key.push_back(each.key);
    before += each.weight;
  }
  // Ranks without points: they own the last cell only if no other rank does.
  first_key.resize(static_cast<std::size_t>(ranks.count()), UINT32_MAX);
  return {grid, std::move(first_key)};
}

}  // namespace pardel::engine
