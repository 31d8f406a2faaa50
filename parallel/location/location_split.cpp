#include "location_split.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace pardel::engine {
namespace {

/// The middle of the triangles' boxes in one direction, as many on each side.
double median_middle(const LocatedTriangles& all, std::span<const Index> list, LocationSplit::Kind kind) {
  std::vector<double> middles;
  middles.reserve(list.size());
  for (const Index t : list) {
    const Box box = all.box(t);
    middles.push_back(kind == LocationSplit::Kind::x ? box.min_x / 2 + box.max_x / 2 : box.min_y / 2 + box.max_y / 2);
  }
  const auto median = middles.begin() + static_cast<std::ptrdiff_t>(middles.size() / 2);
  std::ranges::nth_element(middles, median);
  return *median;
}

DividedTriangles divided_by_coordinate(const LocatedTriangles& all, std::span<const Index> list,
                                       LocationSplit::Kind kind) {
  DividedTriangles parts{.split = {.kind = kind, .at = median_middle(all, list, kind)}, .lists = {}};
  for (const Index t : list) {
    const Box box = all.box(t);
    const bool is_x = kind == LocationSplit::Kind::x;
    if ((is_x ? box.min_x : box.min_y) <= parts.split.at) parts.lists[LocationSplit::below].push_back(t);
    if ((is_x ? box.max_x : box.max_y) > parts.split.at) parts.lists[LocationSplit::above].push_back(t);
  }
  return parts;
}

DividedTriangles divided_by_edge(const LocatedTriangles& all, std::span<const Index> list, Point from, Point to) {
  DividedTriangles parts{.split = {.kind = LocationSplit::Kind::edge, .from = from, .to = to}, .lists = {}};
  std::vector<std::pair<Index, Index>> touching;  // a vertex on the line, and a triangle with no other point there
  for (const Index t : list) {
    std::array<unsigned, 3> corners{};
    Index vertex = no_index;
    for (const Index v : all.triangles[t].v) {
      const LocationSplit::Side side = parts.split.side_of(all.points[v]);
      ++corners[side];
      if (side == LocationSplit::on) vertex = v;
    }
    const bool is_below = corners[LocationSplit::below] > 0, is_above = corners[LocationSplit::above] > 0;
    if (is_below) parts.lists[LocationSplit::below].push_back(t);
    if (is_above) parts.lists[LocationSplit::above].push_back(t);
    if (corners[LocationSplit::on] > 1 || (is_below && is_above))
      parts.lists[LocationSplit::on].push_back(t);
    else if (corners[LocationSplit::on] == 1)
      touching.emplace_back(vertex, t);
  }
  std::ranges::sort(touching);
  for (std::size_t i = 0; i < touching.size(); ++i)
    if (i == 0 || touching[i].first != touching[i - 1].first)
      parts.lists[LocationSplit::on].push_back(touching[i].second);
  std::ranges::sort(parts.lists[LocationSplit::on]);
  return parts;
}

}  // namespace

std::size_t DividedTriangles::longest() const { return std::max({lists[0].size(), lists[1].size(), lists[2].size()}); }

std::optional<DividedTriangles> divided(const LocatedTriangles& all, std::span<const Index> list) {
  const auto good = list.size() * 13 / 20, useful = list.size() * 4 / 5;
  DividedTriangles best = divided_by_coordinate(all, list, LocationSplit::Kind::x);
  const auto consider = [&](DividedTriangles other) {
    if (other.longest() < best.longest()) best = std::move(other);
  };
  consider(divided_by_coordinate(all, list, LocationSplit::Kind::y));
  // Long thin triangles across each other's boxes, and fans around a vertex, are divided by their own edges.
  constexpr std::size_t tried = 6;
  for (std::size_t i = 0; i < tried && best.longest() > good; ++i) {
    const auto corners = all.corners(list[list.size() * (2 * i + 1) / (2 * tried)]);
    consider(divided_by_edge(all, list, corners[i % 3], corners[(i + 1) % 3]));
  }
  if (best.longest() > useful || best.total() > 2 * list.size()) return {};
  return best;
}

}  // namespace pardel::engine
