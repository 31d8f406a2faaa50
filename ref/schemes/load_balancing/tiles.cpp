#include "tiles.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <numeric>

#include "../../../core/support/point_order.hpp"
#include "../mesh/extent.hpp"

namespace pardel::schemes {
namespace {

/// Does the tile reach the whole cavity? Adds the work of a search that ends at the first triangle out of reach: what
/// lies beyond it may be changed by another tile at the same time.
bool search(const LinkedMesh& mesh, const TileLattice& lattice, int tile, const Cavity& cavity, std::uint64_t& work) {
  for (const Index t : cavity.triangles) {
    ++work;
    if (!lattice.reaches(tile, mesh, t)) return false;
  }
  work += cavity.boundary.size();
  return true;
}

/// The insertion for one item, if the tile reaches all that it changes, and all on which the choice of its point
/// depends.
std::optional<Insertion> within_reach(const LinkedMesh& mesh, const TileRules& rules, int tile, Index t,
                                      std::uint64_t& work) {
  std::optional<Insertion> found = insertion_for(mesh, t, rules.bounds);
  const bool is_circumcentre = found && !found->splits_segment();
  // Which segment a circumcentre encroaches upon depends on its cavity.
  if (!is_circumcentre && !encroached_side(mesh, t) &&
      !search(mesh, rules.lattice, tile, cavity_of(mesh, circumcentre(mesh, t), {t}), work))
    return std::nullopt;
  if (found && !search(mesh, rules.lattice, tile, found->cavity, work)) return std::nullopt;
  return found;
}

/// Moves values[k] to place number[k].
template <class T>
void permute(std::vector<T>& values, const std::vector<Index>& number) {
  std::vector<T> moved(values.size());
  for (std::size_t k = 0; k < values.size(); ++k) moved[number[k]] = std::move(values[k]);
  values = std::move(moved);
}

/// number[k] of the k-th element in the order: 0 for the first one.
template <class Less>
std::vector<Index> numbers(std::size_t size, std::size_t from, const Less& less) {
  std::vector<Index> order(size), number(size);
  std::iota(order.begin(), order.end(), Index{0});
  std::sort(order.begin() + static_cast<std::ptrdiff_t>(from), order.end(), less);
  for (std::size_t k = 0; k < size; ++k) number[order[k]] = static_cast<Index>(k);
  return number;
}

}  // namespace

TileLattice::TileLattice(const LinkedMesh& mesh, int per_side) : per_side_(per_side) {
  const Extent extent = extent_of(mesh.points);
  low_ = extent.low;
  side_ = extent.side() / per_side;
}

int TileLattice::tile_of(Point p) const {
  const auto cell = [&](double x) { return std::clamp(static_cast<int>(std::floor(x / side_)), 0, per_side_ - 1); };
  return cell(p.x - low_.x) + per_side_ * cell(p.y - low_.y);
}

int TileLattice::tile_of(const LinkedMesh& mesh, Index t) const { return tile_of(centroid(mesh, t)); }

Point TileLattice::centre(int tile) const {
  return {low_.x + (tile % per_side_ + 0.5) * side_, low_.y + (tile / per_side_ + 0.5) * side_};
}

std::vector<int> TileLattice::neighbours(int tile) const {
  std::vector<int> found;
  const int i = tile % per_side_, j = tile / per_side_;
  for (int y = std::max(j - 1, 0); y <= std::min(j + 1, per_side_ - 1); ++y)
    for (int x = std::max(i - 1, 0); x <= std::min(i + 1, per_side_ - 1); ++x)
      if (x != i || y != j) found.push_back(x + per_side_ * y);
  return found;
}

bool TileLattice::reaches(int tile, const LinkedMesh& mesh, Index t) const {
  const auto within = [&](double x, double low, int i) {
    // The upper end of one zone and the lower end of the next one of its colour are the same double.
    return x >= low + (i - 0.5) * side_ && x < low + (i + 2 - 0.5) * side_;
  };
  for (int k = 0; k < 3; ++k) {
    const Point p = mesh.corner(t, k);
    if (!within(p.x, low_.x, tile % per_side_) || !within(p.y, low_.y, tile / per_side_)) return false;
  }
  return true;
}

void sort_by_place(const LinkedMesh& mesh, std::vector<KnownTriangle>& items) {
  std::ranges::sort(
      items, [&](const KnownTriangle& a, const KnownTriangle& b) { return place_of(mesh, a.v) < place_of(mesh, b.v); });
}

int tile_for(const LinkedMesh& mesh, Index t, const TileLattice& lattice) {
  const int tile = lattice.tile_of(mesh, t);
  return lattice.reaches(tile, mesh, t) ? tile : -1;
}

bool is_due(const LinkedMesh& mesh, Index t, double least_radius) {
  if (least_radius <= 0) return true;
  const Point p = circumcentre(mesh, t), a = mesh.corner(t, 0);
  return !(std::hypot(p.x - a.x, p.y - a.y) <= least_radius);
}

TileReport work_on_tile(LinkedMesh& mesh, const TileRules& rules, int tile, std::vector<KnownTriangle> items) {
  TileReport report;
  std::erase_if(items, [&](const KnownTriangle& each) { return !is_current(mesh, each); });
  sort_by_place(mesh, items);
  std::deque<KnownTriangle> queue(items.begin(), items.end());
  const auto add_if_bad = [&](Index t) {
    if (!needs_work(mesh, t, rules.bounds)) return;
    if (!is_due(mesh, t, rules.least_radius)) return report.later.push_back(known(mesh, t));
    const int other = tile_for(mesh, t, rules.lattice);
    if (other == tile) return queue.push_back(known(mesh, t));
    if (other < 0) return report.left.push_back(known(mesh, t));
    report.handed_on.push_back({other, known(mesh, t)});
  };
  for (; !queue.empty() && mesh.points.size() <= rules.most_points; queue.pop_front()) {
    ++report.work;
    const KnownTriangle next = queue.front();
    if (!is_current(mesh, next)) continue;
    std::uint64_t work = 0;
    const auto insertion = within_reach(mesh, rules, tile, next.triangle, work);
    report.work += work;
    if (!insertion) {
      report.wasted += work;
      report.left.push_back(next);
      continue;
    }
    const std::vector<Index> made = carry_out(mesh, *insertion);
    report.work += made.size();
    ++report.insertions;
    std::ranges::for_each(made, add_if_bad);
    if (is_current(mesh, next)) queue.push_back(next);
  }
  return report;
}

TileReport work_alone(LinkedMesh& mesh, const TileRules& rules, std::vector<KnownTriangle> items) {
  TileReport report;
  std::erase_if(items, [&](const KnownTriangle& each) { return !is_current(mesh, each); });
  sort_by_place(mesh, items);
  std::deque<KnownTriangle> queue(items.begin(), items.end());
  for (; !queue.empty() && mesh.points.size() <= rules.most_points; queue.pop_front()) {
    ++report.work;
    const KnownTriangle next = queue.front();
    if (!is_current(mesh, next)) continue;
    const auto insertion = insertion_for(mesh, next.triangle, rules.bounds);
    if (!insertion) continue;
    const std::vector<Index> made = carry_out(mesh, *insertion);
    report.work += insertion->work() + made.size();
    for (const Index t : made)
      if (needs_work(mesh, t, rules.bounds))
        is_due(mesh, t, rules.least_radius) ? queue.push_back(known(mesh, t)) : report.later.push_back(known(mesh, t));
    if (is_current(mesh, next)) queue.push_back(next);
  }
  return report;
}

void number_by_place(LinkedMesh& mesh, std::size_t inputs) {
  const std::vector<Index> points = numbers(mesh.points.size(), inputs, [&](Index a, Index b) {
    return lexicographically_less(mesh.points[a], mesh.points[b]);
  });
  permute(mesh.points, points);
  permute(mesh.segment_of, points);
  for (Face& face : mesh.faces)
    for (Index& v : face.v) v = points[v];
  const std::vector<Index> faces =
      numbers(mesh.faces.size(), 0, [&](Index a, Index b) { return mesh.faces[a].v < mesh.faces[b].v; });
  permute(mesh.faces, faces);
  for (Face& face : mesh.faces)
    for (Index& n : face.n)
      if (n != no_index) n = faces[n];
}

}  // namespace pardel::schemes
