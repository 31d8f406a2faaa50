#include "quadtree.hpp"

#include <algorithm>
#include <cmath>

namespace pardel::ref {
namespace {

/// Leaves of this level are not divided.
constexpr int deepest = 20;

/// The squares of a level cover [low, high) in units of the deepest level.
struct Interval {
  std::int64_t low, high;
};
Interval columns_of(const Cell& leaf) {
  const std::int64_t width = std::int64_t{1} << (deepest - leaf.level);
  return {leaf.i * width, (leaf.i + 1) * width};
}
Interval rows_of(const Cell& leaf) { return columns_of({leaf.j, 0, leaf.level}); }

bool overlap(const Interval& a, const Interval& b) { return a.low < b.high && b.low < a.high; }
bool border(const Interval& a, const Interval& b) { return a.high == b.low || b.high == a.low; }

/// Do the leaves share a piece of a vertical side?
bool are_beside(const Cell& a, const Cell& b) {
  return border(columns_of(a), columns_of(b)) && overlap(rows_of(a), rows_of(b));
}
/// Do the leaves share a piece of a horizontal side?
bool are_above(const Cell& a, const Cell& b) {
  return border(rows_of(a), rows_of(b)) && overlap(columns_of(a), columns_of(b));
}

bool share_a_side(const Cell& a, const Cell& b) { return are_beside(a, b) || are_above(a, b); }

/// A circumdisk, with its rounded centre and radius.
struct Disk {
  ExactPoint centre;
  Number squared_radius;
  double x, y, radius;
};

std::vector<Disk> circumdisks(const PlainMesh& mesh) {
  std::vector<Disk> disks;
  for (const Corners& t : mesh.triangles) {
    const ExactPoint centre = circumcentre(mesh, t);
    const Number squared = squared_circumradius(mesh, t);
    disks.push_back({centre, squared, CGAL::to_double(centre.x()), CGAL::to_double(centre.y()),
                     std::sqrt(CGAL::to_double(squared))});
  }
  return disks;
}

template <class T>
T beyond(const T& value, double low, double high) {
  return value < low ? T(low - value) : value > high ? T(value - high) : T(0);
}

/// Does the open disk meet the closed box? Doubles decide if they differ by more than their rounding.
bool meets(const Disk& disk, const Box& box) {
  const double far = std::hypot(beyond(disk.x, box.low.x, box.high.x), beyond(disk.y, box.low.y, box.high.y));
  const double rounding = 1e-9 * (std::abs(disk.x) + std::abs(disk.y) + disk.radius);
  if (std::abs(far - disk.radius) > rounding) return far < disk.radius;
  const Number x = beyond(disk.centre.x(), box.low.x, box.high.x), y = beyond(disk.centre.y(), box.low.y, box.high.y);
  return x * x + y * y < disk.squared_radius;
}

Box square_of(Point corner, double side, const Cell& leaf) {
  const double s = std::ldexp(side, -leaf.level);
  return {{corner.x + static_cast<double>(leaf.i) * s, corner.y + static_cast<double>(leaf.j) * s},
          {corner.x + static_cast<double>(leaf.i + 1) * s, corner.y + static_cast<double>(leaf.j + 1) * s}};
}

bool is_wide_enough(const Box& square, double side, const std::vector<Disk>& disks, double fraction) {
  const Number most = Number(fraction) * Number(side), most_squared = most * most;
  return std::ranges::none_of(
      disks, [&](const Disk& disk) { return disk.squared_radius >= most_squared && meets(disk, square); });
}

/// Divides `leaf`, and first the leaves that touch it and would be too large for its quarters.
void divide(std::set<Cell>& leaves, std::set<Cell>& made, const Cell& leaf) {
  if (!leaves.contains(leaf)) return;
  const auto is_too_large = [&](const Cell& other) { return other.level < leaf.level && touch(leaf, other); };
  for (auto other = std::ranges::find_if(leaves, is_too_large); other != leaves.end();
       other = std::ranges::find_if(leaves, is_too_large))
    divide(leaves, made, Cell(*other));
  leaves.erase(leaf);
  made.erase(leaf);
  for (const int quarter : {0, 1, 2, 3}) {
    const Cell part{2 * leaf.i + quarter % 2, 2 * leaf.j + quarter / 2, leaf.level + 1};
    leaves.insert(part);
    made.insert(part);
  }
}

/// Each leaf gets the least colour that no leaf of its buffer zone has.
void choose_colours(Quadtree& tree) {
  for (auto& [leaf, colour] : tree.colour_of_leaf) colour = -1;
  for (auto& [leaf, colour] : tree.colour_of_leaf) {
    std::set<int> taken;
    for (const Cell& other : buffer_zone(tree, leaf)) taken.insert(tree.colour_of_leaf.at(other));
    int least = 0;
    while (taken.contains(least)) ++least;
    colour = least;
  }
}

Quadtree with_leaves(Point corner, double side, const std::set<Cell>& leaves) {
  Quadtree tree{corner, side, {}};
  for (const Cell& leaf : leaves) tree.colour_of_leaf.emplace(leaf, 0);
  choose_colours(tree);
  return tree;
}

}  // namespace

bool touch(const Cell& leaf, const Cell& other) {
  const auto meet = [](const Interval& a, const Interval& b) { return a.low <= b.high && b.low <= a.high; };
  return leaf != other && meet(columns_of(leaf), columns_of(other)) && meet(rows_of(leaf), rows_of(other));
}

Quadtree uniform_quadtree(Point corner, double side, int level) {
  std::set<Cell> leaves;
  for (std::int64_t i = 0; i < std::int64_t{1} << level; ++i)
    for (std::int64_t j = 0; j < std::int64_t{1} << level; ++j) leaves.insert({i, j, level});
  return with_leaves(corner, side, leaves);
}

Quadtree quadtree_over(const PlainMesh& mesh) {
  CGAL::Bbox_2 bounds;
  for (const Corners& t : mesh.triangles)
    for (Index v : t) bounds += mesh.points[v].bbox();
  // The bounds are in the middle of the square, more than a third of its side away from its border. If the square is
  // divided, its quarters are wide enough: all circumradii are below side / 8, and all circumdisks lie in the square.
  // The side is a power of two, and the corner lies on the lattice of the deepest level. So the corners of leaves are
  // doubles unless the coordinates are 2^32 times as large as the extent.
  const double extent = std::max(bounds.xmax() - bounds.xmin(), bounds.ymax() - bounds.ymin());
  const double side = std::exp2(std::ceil(std::log2(extent)) + 2), unit = std::ldexp(side, -deepest);
  const auto below = [&](double low, double high) { return std::floor((low / 2 + high / 2 - side / 2) / unit) * unit; };
  const Point corner{below(bounds.xmin(), bounds.xmax()), below(bounds.ymin(), bounds.ymax())};

  const std::vector<Disk> disks = circumdisks(mesh);
  std::map<Cell, bool> known;
  const auto may_be = [&](const Cell& square) {
    const auto [entry, is_new] = known.try_emplace(square);
    if (is_new)
      entry->second =
          is_wide_enough(square_of(corner, side, square), std::ldexp(side, -square.level), disks, paper_fraction);
    return entry->second;
  };
  const auto has_a_vertex = [&](const Cell& leaf) {
    const Box square = square_of(corner, side, leaf);
    return std::ranges::any_of(mesh.points, [&](const ExactPoint& p) { return contains(square, p); });
  };
  std::set<Cell> leaves{Cell{0, 0, 0}};
  std::set<Cell> undivided = leaves;  // leaves that may still be divided
  while (!undivided.empty()) {
    const Cell leaf = *undivided.begin();
    undivided.erase(undivided.begin());
    if (leaf.level == deepest || !has_a_vertex(leaf)) continue;
    std::set<Cell> after = leaves, made;
    divide(after, made, leaf);
    if (!std::ranges::all_of(made, may_be)) continue;
    leaves = after;
    undivided.merge(made);
  }
  return with_leaves(corner, side, leaves);
}

double side_of(const Quadtree& tree, const Cell& leaf) { return std::ldexp(tree.side, -leaf.level); }

Box box_of(const Quadtree& tree, const Cell& leaf) { return square_of(tree.corner, tree.side, leaf); }

std::set<Cell> buffer_zone(const Quadtree& tree, const Cell& leaf) {
  std::set<Cell> zone;
  for (const auto& [neighbour, of_neighbour] : tree.colour_of_leaf) {
    if (!share_a_side(leaf, neighbour)) continue;
    zone.insert(neighbour);
    for (const auto& [other, of_other] : tree.colour_of_leaf)
      if (are_beside(leaf, neighbour) ? are_above(neighbour, other) : are_beside(neighbour, other)) zone.insert(other);
  }
  zone.erase(leaf);
  return zone;
}

bool is_wide_enough(const Quadtree& tree, const Cell& leaf, const PlainMesh& mesh, double fraction) {
  return is_wide_enough(box_of(tree, leaf), side_of(tree, leaf), circumdisks(mesh), fraction);
}

bool may_be_refined(const Quadtree& tree, const Cell& leaf, const PlainMesh& mesh, double fraction) {
  return std::ranges::all_of(buffer_zone(tree, leaf),
                             [&](const Cell& other) { return is_wide_enough(tree, other, mesh, fraction); });
}

bool allows(const Quadtree& tree, const PlainMesh& mesh) {
  if (tree.colour_of_leaf.size() == 1) return true;
  const std::vector<Disk> disks = circumdisks(mesh);
  return std::ranges::all_of(tree.colour_of_leaf, [&](const auto& entry) {
    return is_wide_enough(box_of(tree, entry.first), side_of(tree, entry.first), disks, paper_fraction);
  });
}

Quadtree cells_after(const Quadtree& /*tree*/, const PlainMesh& mesh) { return quadtree_over(mesh); }

Cell cell_of(const Quadtree& tree, const ExactPoint& p) {
  constexpr std::int64_t count = std::int64_t{1} << deepest;
  const auto index_of = [&](const Number& offset) {
    const Number scaled = offset / Number(tree.side / static_cast<double>(count));
    auto index = static_cast<std::int64_t>(std::floor(CGAL::to_double(scaled)));  // may be wrong by 1
    while (scaled < static_cast<double>(index)) --index;
    while (scaled >= static_cast<double>(index + 1)) ++index;
    return std::clamp(index, std::int64_t{0}, count - 1);
  };
  Cell square{index_of(p.x() - tree.corner.x), index_of(p.y() - tree.corner.y), deepest};
  while (!tree.colour_of_leaf.contains(square)) square = {square.i / 2, square.j / 2, square.level - 1};
  return square;
}

int colours(const Quadtree& tree) {
  int most = 0;
  for (const auto& [leaf, colour] : tree.colour_of_leaf) most = std::max(most, colour);
  return most + 1;
}

int colour_of(const Quadtree& tree, const Cell& leaf) { return tree.colour_of_leaf.at(leaf); }

}  // namespace pardel::ref
