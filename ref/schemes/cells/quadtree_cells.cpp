#include "quadtree_cells.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>
#include <unordered_map>

#include "../mesh/extent.hpp"
#include "../mesh/triangle.hpp"
#include "circumradius.hpp"

namespace pardel::schemes::cells {
namespace {

/// Leaves of this level are not divided.
constexpr int deepest = 20;
/// Disks are enlarged by this share. It is above the rounding of their centres and radii.
constexpr double enlarged = 1 + 0x1p-20;

struct Disk {
  Point centre;
  double radius;
};

/// Square (i, j) of a level.
struct Square {
  std::int64_t i = 0, j = 0;
  int level = 0;
  [[nodiscard]] Square quarter(int k) const { return {2 * i + k % 2, 2 * j + k / 2, level + 1}; }
  [[nodiscard]] std::uint64_t key() const {
    return static_cast<std::uint64_t>(level) << 48U | static_cast<std::uint64_t>(i) << 24U |
           static_cast<std::uint64_t>(j);
  }
};

/// The squares of a level cover [low, high) in units of the deepest level.
struct Interval {
  std::int64_t low, high;
};
Interval columns_of(const Square& s) {
  const std::int64_t width = std::int64_t{1} << (deepest - s.level);
  return {s.i * width, (s.i + 1) * width};
}
Interval rows_of(const Square& s) { return columns_of({s.j, 0, s.level}); }
bool overlap(const Interval& a, const Interval& b) { return a.low < b.high && b.low < a.high; }
bool border(const Interval& a, const Interval& b) { return a.high == b.low || b.high == a.low; }
/// Do the leaves share a piece of a vertical side? Of a horizontal side?
bool are_beside(const Square& a, const Square& b) {
  return border(columns_of(a), columns_of(b)) && overlap(rows_of(a), rows_of(b));
}
bool are_above(const Square& a, const Square& b) {
  return border(rows_of(a), rows_of(b)) && overlap(columns_of(a), columns_of(b));
}

class Quadtree {
 public:
  Quadtree(const LinkedMesh& mesh, const Bounds& bounds, double wanted, double fraction) : fraction_(fraction) {
    // The mesh is in the middle of the square, more than a third of its side away from its border. If the square is
    // divided, all circumradii are below side / 8, so all circumdisks lie in it.
    const Extent extent = extent_of(mesh.points);
    side_ = std::exp2(std::ceil(std::log2(extent.side())) + 2);
    const double unit = std::ldexp(side_, -deepest);
    const auto below = [&](double low, double high) {
      return std::floor((low / 2 + high / 2 - side_ / 2) / unit) * unit;
    };
    corner_ = {below(extent.low.x, extent.high.x), below(extent.low.y, extent.high.y)};
    divide(mesh, bounds, wanted);
  }

  [[nodiscard]] const std::vector<Square>& leaves() const { return leaves_; }
  [[nodiscard]] double side_of(const Square& s) const { return std::ldexp(side_, -s.level); }
  [[nodiscard]] Point corner_of(const Square& s) const {
    return {corner_.x + static_cast<double>(s.i) * side_of(s), corner_.y + static_cast<double>(s.j) * side_of(s)};
  }

  [[nodiscard]] Index leaf_at(Point p) const {
    constexpr auto count = static_cast<double>(std::int64_t{1} << deepest);
    const auto unit = [&](double offset) {
      const double scaled = offset / side_ * count;
      return !(scaled >= 1) ? std::int64_t{0} : static_cast<std::int64_t>(std::min(scaled, count - 1));
    };
    return leaf_at(unit(p.x - corner_.x), unit(p.y - corner_.y));
  }

  /// The buffer zone: the neighbours across sides, and their neighbours in the orthogonal direction.
  [[nodiscard]] std::vector<Index> buffer_zone(Index leaf) const {
    std::set<Index> zone;
    const Square& s = leaves_[leaf];
    for (const Index neighbour : around(leaf)) {
      const Square& n = leaves_[neighbour];
      if (!are_beside(s, n) && !are_above(s, n)) continue;
      zone.insert(neighbour);
      for (const Index other : around(neighbour))
        if (are_beside(s, n) ? are_above(n, leaves_[other]) : are_beside(n, leaves_[other])) zone.insert(other);
    }
    zone.erase(leaf);
    return {zone.begin(), zone.end()};
  }

  /// Is the disk small enough for all leaves that it meets?
  [[nodiscard]] bool allows(const Disk& disk) const { return leaves_.size() == 1 || allows(0, disk); }

 private:
  /// A square of the level that is being divided.
  struct Part {
    Index node;
    std::vector<Index> disks;  ///< that meet it
    double expected;           ///< triangles
  };
  struct Node {
    Square square;
    Index first_quarter = no_index, leaf = no_index;
  };

  [[nodiscard]] Index leaf_at(std::int64_t i, std::int64_t j) const {
    Index node = 0;
    while (nodes_[node].leaf == no_index) {
      const int shift = deepest - nodes_[node].square.level - 1;
      node = nodes_[node].first_quarter + static_cast<Index>((i >> shift & 1) + 2 * (j >> shift & 1));
    }
    return nodes_[node].leaf;
  }

  /// The leaves that touch a leaf in a side or a corner: in a balanced tree, each contains one of 12 squares of half
  /// its side around it.
  [[nodiscard]] std::vector<Index> around(Index leaf) const {
    const Interval columns = columns_of(leaves_[leaf]), rows = rows_of(leaves_[leaf]);
    const std::int64_t half = std::max((columns.high - columns.low) / 2, std::int64_t{1});
    std::set<Index> found;
    for (std::int64_t j = rows.low - half; j <= rows.high; j += half)
      for (std::int64_t i = columns.low - half; i <= columns.high; i += half)
        if (i >= 0 && j >= 0 && i < std::int64_t{1} << deepest && j < std::int64_t{1} << deepest)
          found.insert(leaf_at(i, j));
    found.erase(leaf);
    return {found.begin(), found.end()};
  }

  [[nodiscard]] bool meets(const Disk& disk, const Square& s) const {
    const Point low = corner_of(s);
    const double side = side_of(s);
    const double dx = std::max({low.x - disk.centre.x, disk.centre.x - low.x - side, 0.0});
    const double dy = std::max({low.y - disk.centre.y, disk.centre.y - low.y - side, 0.0});
    const double reach = disk.radius * enlarged;
    return !(dx * dx + dy * dy > reach * reach);
  }

  [[nodiscard]] bool allows(Index at, const Disk& disk) const {
    const Node& node = nodes_[at];
    if (!meets(disk, node.square)) return true;
    if (node.leaf != no_index) return disk.radius * enlarged < fraction_ * side_of(node.square);
    for (Index k = 0; k < 4; ++k)
      if (!allows(node.first_quarter + k, disk)) return false;
    return true;
  }

  /// Divides the squares of one level after the other.
  void divide(const LinkedMesh& mesh, const Bounds& bounds, double wanted) {
    std::vector<Disk> disks;
    std::vector<double> expected;
    double all = 0;
    for (Index t = 0; t < mesh.faces.size(); ++t) {
      if (!mesh.in_use(t)) continue;
      disks.push_back({circumcentre(mesh, t), circumradius(mesh, t)});
      expected.push_back(expected_triangles(mesh, t, bounds));
      all += expected.back();
    }
    std::vector<Part> level(1, Part{0, {}, all});
    nodes_.push_back({});
    for (Index k = 0; k < disks.size(); ++k) level[0].disks.push_back(k);
    while (!level.empty()) {
      std::unordered_map<std::uint64_t, double> inside;
      for (const Part& part : level) inside.emplace(nodes_[part.node].square.key(), part.expected);
      std::vector<Part> next;
      for (const Part& part : level) {
        const Square square = nodes_[part.node].square;
        const double most = fraction_ * side_of(square) / 2;
        const auto is_small = [&](Index k) { return disks[k].radius * enlarged < most; };
        if (square.level == deepest || !is_wanted(inside, square, all / wanted) ||
            !std::ranges::all_of(part.disks, is_small)) {
          nodes_[part.node].leaf = static_cast<Index>(leaves_.size());
          leaves_.push_back(square);
          continue;
        }
        const auto first = static_cast<Index>(nodes_.size());
        nodes_[part.node].first_quarter = first;
        for (int q = 0; q < 4; ++q) {
          nodes_.push_back({square.quarter(q)});
          next.push_back({first + static_cast<Index>(q), {}, 0});
          for (const Index k : part.disks) {
            if (!meets(disks[k], square.quarter(q))) continue;
            next.back().disks.push_back(k);
            next.back().expected += expected[k];
          }
        }
      }
      level = std::move(next);
    }
  }

  /// Is more than this share expected in the square, or in one beside it, so that quarters of that one have neighbours
  /// of their size? Not if a square beside it does not exist: else a quarter would touch a leaf four times as wide.
  static bool is_wanted(const std::unordered_map<std::uint64_t, double>& inside, const Square& s, double share) {
    const std::int64_t count = std::int64_t{1} << s.level;
    bool wanted = false;
    for (std::int64_t j = s.j - 1; j <= s.j + 1; ++j)
      for (std::int64_t i = s.i - 1; i <= s.i + 1; ++i) {
        if (i < 0 || j < 0 || i >= count || j >= count) continue;
        const auto found = inside.find(Square{i, j, s.level}.key());
        if (found == inside.end()) return false;
        wanted = wanted || found->second > share;
      }
    return wanted;
  }

  double fraction_, side_ = 1;
  Point corner_;
  std::vector<Node> nodes_;
  std::vector<Square> leaves_;
};

/// Each leaf gets the least colour that no leaf of its buffer zone has.
void choose_colours(Division& division) {
  division.colour.assign(division.colour.size(), -1);
  division.colours = 1;
  for (Index leaf = 0; leaf < division.colour.size(); ++leaf) {
    std::set<int> taken;
    for (const Index other : division.touching(leaf)) taken.insert(division.colour[other]);
    int least = 0;
    while (taken.contains(least)) ++least;
    division.colour[leaf] = least;
    division.colours = std::max(division.colours, least + 1);
  }
}

}  // namespace

double expected_triangles(const LinkedMesh& mesh, Index t, const Bounds& bounds) {
  return std::max(1.0, twice_area(mesh, t) / 2 / bounds.wanted_area(centroid(mesh, t), mesh.faces[t].region));
}

Division quadtree_cells(const LinkedMesh& mesh, const Bounds& bounds, double wanted, double fraction,
                        Assignment assignment, const Territory& territory) {
  const auto tree = std::make_shared<const Quadtree>(mesh, bounds, wanted, fraction);
  Division division;
  division.colour.resize(tree->leaves().size());
  division.cell_of = [tree](Point p) { return tree->leaf_at(p); };
  auto zones = std::make_shared<std::vector<std::vector<Index>>>();
  for (Index leaf = 0; leaf < tree->leaves().size(); ++leaf) zones->push_back(tree->buffer_zone(leaf));
  division.touching = [zones](Index leaf) { return (*zones)[leaf]; };
  division.in_box = [tree](Index leaf, Point p) {
    const Point low = tree->corner_of(tree->leaves()[leaf]);
    const double side = tree->side_of(tree->leaves()[leaf]);
    return p.x >= low.x - side / 2 && p.x < low.x + 1.5 * side && p.y >= low.y - side / 2 && p.y < low.y + 1.5 * side;
  };
  division.allows = [tree](Point centre, double radius) { return tree->allows({centre, radius}); };
  choose_colours(division);
  assign(division, assignment, territory, [&](Index leaf) {
    const Point low = tree->corner_of(tree->leaves()[leaf]);
    const double half = tree->side_of(tree->leaves()[leaf]) / 2;
    return Point{low.x + half, low.y + half};
  });
  return division;
}

}  // namespace pardel::schemes::cells
