#include "delaunay.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numeric>
#include <optional>
#include <utility>

#include "../../core/support/shortest.hpp"
#include "../arithmetic/predicates.hpp"
#include "../decomposition/bounding_box.hpp"
#include "../decomposition/hilbert_order.hpp"
#include "../threads/parallel_arrays.hpp"
#include "begin_with_latest.hpp"
#include "bowyer_watson.hpp"
#include "point_tiles.hpp"

namespace pardel::engine {
namespace {

/// The vertices in the order of their insertion. Round r is order[start[r]] to order[start[r + 1] - 1].
struct Rounds {
  static constexpr std::size_t count = InsertionOrder::rounds;
  Array<std::uint8_t> round;  ///< of each vertex
  Array<VertexId> order;
  std::array<std::size_t, count + 1> start{};
};

/// Distributes the vertices to the rounds. In a round, they are in the order of their indices.
Rounds in_rounds(std::size_t n, const InsertionOrder& insertion_order, const Threads& threads) {
  Rounds rounds;
  rounds.round = make_array(threads, n, [&](std::size_t v) {
    return static_cast<std::uint8_t>(InsertionOrder::round_of(insertion_order.position(static_cast<VertexId>(v))));
  });
  // First the number of points of each round in each block, then the position of the next of these points.
  std::vector<std::array<std::size_t, Rounds::count>> next(block_count(n));
  const auto for_each_point = [&](const auto& visit) {
    parallel_blocks(threads, n, [&](std::size_t first, std::size_t last, std::size_t block) {
      for (std::size_t i = first; i < last; ++i) visit(i, next[block][rounds.round[i]]);
    });
  };
  for_each_point([](std::size_t, std::size_t& number) { ++number; });
  std::size_t place = 0;
  for (std::size_t r = 0; r < Rounds::count; ++r) {
    rounds.start[r] = place;
    for (auto& of_block : next) place += std::exchange(of_block[r], place);
  }
  rounds.start[Rounds::count] = n;
  rounds.order.resize_uninitialised(n);
  for_each_point([&](std::size_t i, std::size_t& to) { rounds.order[to++] = static_cast<VertexId>(i); });
  return rounds;
}

/// Makes one triangle and its three ghosts.
void start_with(Triangulation& t, VertexId a, VertexId b, VertexId c) {
  if (orient2d(t.points[a], t.points[b], t.points[c]) < 0) std::swap(b, c);
  const std::array<VertexId, 3> v{a, b, c};
  t.slots[0] = {v, {EdgeRef(1, 2), EdgeRef(2, 2), EdgeRef(3, 2)}};
  for (unsigned i = 0; i < 3; ++i) {
    // The ghost beyond side i is (to, from, ghost). The next ghost around the hull shares `from`.
    const VertexId from = v[next_corner[i]], to = v[previous_corner[i]];
    const TriangleId before = 1 + previous_corner[i], after = 1 + next_corner[i];
    t.slots[1 + i] = {{to, from, ghost}, {EdgeRef(before, 1), EdgeRef(after, 0), EdgeRef(0, i)}};
  }
}

Error coordinates_error(const char* what, Point p) {
  return {ErrorKind::invalid_input, std::string(what) + " " + shortest(p)};
}

/// The number of triangles, ghosts included, of a triangulation of n points: n points and the vertex at infinity
/// triangulate a sphere. The point at position k of the insertion order adds two triangles; their ids start at
/// triangle_count(k).
constexpr TriangleId triangle_count(std::size_t n) { return static_cast<TriangleId>(2 * (n + 1) - 4); }

/// Points are inserted on a quadtree if the cells of a lattice are more overloaded than this: the lattice needs less
/// work if points are spread evenly.
constexpr double most_overload = 4;

/// A leaf is divided if it has more points than this multiple of the number wanted for a tile. A task works on a box of
/// 2.25 leaves, and of four cells in a lattice.
constexpr double points_per_leaf = 2.5;

/// Inserts the points round by round. A position is an index into the order of insertion.
class RoundInserter {
 public:
  RoundInserter(Triangulation& t, const Array<VertexId>& order, const InsertionOrder& insertion_order,
                const Threads& threads, std::size_t per_tile)
      : t_(t),
        order_(order),
        bounds_(bounding_box(threads, t.points.size(), [&](std::size_t v) { return t.points[v]; })),
        threads_(threads),
        per_tile_(per_tile) {
    for (int i = 0; i < threads_.count; ++i) workers_.push_back(std::make_unique<BowyerWatson>(t, insertion_order));
  }

  [[nodiscard]] bool has_used_tiles() const { return has_used_tiles_; }

  /// Inserts the points at the positions [first, last). Precondition: those before `first` have been inserted.
  Status insert(std::size_t first, std::size_t last) {
    Tile everything{};
    if (Status inserted = insert_on_tiles(first, last, everything.positions); !inserted) return inserted;
    everything.near = some_triangle();
    run(everything, Box{}, *workers_.front());
    return everything.error ? Status(*everything.error) : Done{};
  }

 private:
  struct Tile {
    std::vector<Index> positions;   ///< before: the points to insert; after: those whose insertion leaves the box
    TriangleId near = no_index;     ///< the triangle at which point location starts
    double near_centre = INFINITY;  ///< squared distance of the first corner of `near` from the centre of the cell
    std::optional<Error> error{};
  };

  /// The number of tiles. Even few points are divided into several tiles of each colour, unless too many points would
  /// then lie near the borders of tiles.
  [[nodiscard]] double tiles_for(std::size_t points) const {
    constexpr double enough = 36, smallest_fraction = 0.125;
    const double full = static_cast<double>(points) / static_cast<double>(per_tile_);
    return std::max({1.0, full, std::min(enough, full / smallest_fraction)});
  }

  /// Inserts points on the cells of a lattice, or on the leaves of a quadtree if most points would be in few cells.
  /// Appends the positions of those whose insertion leaves the box of their tile to `outside`, in ascending order.
  Status insert_on_tiles(std::size_t first, std::size_t last, std::vector<Index>& outside) {
    const double tiles = tiles_for(last - first);
    const Lattice lattice = Lattice::over(bounds_, static_cast<Index>(std::sqrt(tiles)));
    if (lattice.cells() == 1) {
      outside.resize(last - first);
      std::iota(outside.begin(), outside.end(), static_cast<Index>(first));
      return Done{};
    }
    has_used_tiles_ = true;
    std::vector<Tile> cells = distributed(lattice, first, last);
    if (overload(cells) <= most_overload) return insert_on(lattice, cells, first, outside);
    const double per_leaf = points_per_leaf * static_cast<double>(last - first) / tiles;
    const Quadtree tree = quadtree_of(bounds_, sample(first, last, per_leaf), last - first, per_leaf);
    std::vector<Tile> leaves = distributed(tree, first, last);
    return insert_on(tree, leaves, first, outside);
  }

  /// The tiles with the positions [first, last).
  template <class Shape>
  [[nodiscard]] std::vector<Tile> distributed(const Shape& shape, std::size_t first, std::size_t last) const {
    std::vector<Tile> tiles(shape.cells());
    visit_by_cell(
        threads_, last - first, tiles.size(),
        [&](std::size_t i) { return shape.cell_of(t_.points[order_[first + i]]); },
        [&](Index cell, std::size_t i) { tiles[cell].positions.push_back(static_cast<Index>(first + i)); });
    return tiles;
  }

  /// The number of points in the tile of an average point, divided by the average number over all tiles.
  [[nodiscard]] static double overload(const std::vector<Tile>& tiles) {
    double sum = 0, squares = 0;
    for (const Tile& tile : tiles) {
      const auto n = static_cast<double>(tile.positions.size());
      sum += n;
      squares += n * n;
    }
    return squares * static_cast<double>(tiles.size()) / (sum * sum);
  }

  /// Some of the points at the positions [first, last), about 64 in a leaf. Points that are close in the plane are
  /// close in the order, so every part of the plane has its share.
  [[nodiscard]] std::vector<Point> sample(std::size_t first, std::size_t last, double per_leaf) const {
    const auto step = static_cast<std::size_t>(std::max(1.0, per_leaf / 64));
    std::vector<Point> points;
    for (std::size_t i = first; i < last; i += step) points.push_back(t_.points[order_[i]]);
    return points;
  }

  template <class Shape>
  Status insert_on(const Shape& shape, std::vector<Tile>& tiles, std::size_t first, std::vector<Index>& outside) {
    find_starts(shape, tiles, triangle_count(first));
    for (unsigned colour = 0; colour < shape.colours(); ++colour) {
      // Check here that each tile's start is still in its box: while tasks run, another task may change the start.
      std::vector<Index> cells;
      for (Index cell = 0; cell < shape.cells(); ++cell)
        if (shape.colour_of(cell) == colour && starts_inside(tiles[cell], shape.box_of(cell))) cells.push_back(cell);
      std::stable_sort(cells.begin(), cells.end(),
                       [&](Index a, Index b) { return tiles[a].positions.size() > tiles[b].positions.size(); });
      parallel_for(threads_, cells.size(), [&](std::size_t i, int thread) {
        run(tiles[cells[i]], shape.box_of(cells[i]), *workers_[static_cast<std::size_t>(thread)]);
      });
    }
    for (const Tile& tile : tiles) {
      if (tile.error) return *tile.error;
      outside.insert(outside.end(), tile.positions.begin(), tile.positions.end());
    }
    std::sort(outside.begin(), outside.end());
    return Done{};
  }

  /// Finds for each tile a triangle in its box, near the centre of its cell. Even after tasks of other cells have run,
  /// the slot of this triangle very likely holds a triangle in the box.
  template <class Shape>
  void find_starts(const Shape& shape, std::vector<Tile>& tiles, TriangleId triangles) const {
    const auto cell_of = [&](std::size_t id) {
      const Slot& slot = t_.slots[id];
      return slot.is_ghost() ? no_index : shape.cell_of(t_.points[slot.v[0]]);
    };
    visit_by_cell(threads_, triangles, tiles.size(), cell_of, [&](Index cell, std::size_t id) {
      const Slot& slot = t_.slots[id];
      const Point p = t_.points[slot.v[0]], centre = shape.centre_of(cell);
      const double distance = (p.x - centre.x) * (p.x - centre.x) + (p.y - centre.y) * (p.y - centre.y);
      if (distance >= tiles[cell].near_centre) return;
      if (!lies_inside(slot, shape.box_of(cell))) return;
      tiles[cell].near = static_cast<TriangleId>(id);
      tiles[cell].near_centre = distance;
    });
  }

  [[nodiscard]] bool starts_inside(const Tile& tile, const Box& box) const {
    return tile.near != no_index && lies_inside(t_.slots[tile.near], box);
  }
  [[nodiscard]] bool lies_inside(const Slot& slot, const Box& box) const {
    return std::ranges::all_of(slot.v, [&](VertexId v) { return v != ghost && box.contains_half_open(t_.points[v]); });
  }

  void run(Tile& tile, const Box& box, BowyerWatson& worker) const {
    worker.start(box, tile.near);
    SparseAsk ask(threads_.stop);
    std::erase_if(tile.positions, [&](Index position) {
      if (tile.error) return false;
      ask();
      const VertexId v = order_[position];
      const Inserted inserted = worker.insert(v, triangle_count(position));
      if (inserted == Inserted::duplicate)
        tile.error = coordinates_error("two points share the coordinates", t_.points[v]);
      if (inserted == Inserted::inconsistent)
        tile.error = coordinates_error("the triangulation is inconsistent at", t_.points[v]);
      return inserted == Inserted::yes;
    });
  }

  [[nodiscard]] TriangleId some_triangle() const {
    TriangleId id = 0;
    while (t_.slots[id].is_ghost()) ++id;
    return id;
  }

  Triangulation& t_;
  const Array<VertexId>& order_;
  Box bounds_;
  Threads threads_;
  std::size_t per_tile_;
  std::vector<std::unique_ptr<BowyerWatson>> workers_;
  bool has_used_tiles_ = false;
};

Status check_number(std::size_t points) {
  if (points < 3) return Error{ErrorKind::invalid_input, "fewer than three points span no triangle"};
  if (points > max_engine_triangles / 2 - 2)
    return Error{ErrorKind::resources, "more points than the triangulation can number"};
  return Done{};
}

}  // namespace

Status triangulate_points(Triangulation& t, const InsertionOrder& insertion_order, const Threads& threads,
                          std::size_t per_tile) {
  if (Status fine = check_number(t.points.size()); !fine) return fine;
  Rounds rounds = in_rounds(t.points.size(), insertion_order, threads);
  Array<VertexId>& order = rounds.order;

  const Point a = t.points[order[0]], b = t.points[order[1]];
  if (a == b) return coordinates_error("two points share the coordinates", a);
  std::size_t third = 2;
  while (third < order.size() && orient2d(a, b, t.points[order[third]]) == 0) ++third;
  if (third == order.size()) return Error{ErrorKind::invalid_input, "all points are collinear"};
  std::rotate(order.begin() + 2, order.begin() + third, order.begin() + third + 1);

  t.slots.resize_uninitialised(triangle_count(order.size()));
  start_with(t, order[0], order[1], order[2]);
  RoundInserter inserter(t, order, insertion_order, threads, per_tile);
  std::size_t first = 3;
  for (const std::size_t last : rounds.start) {
    if (last <= first) continue;
    if (Status inserted = inserter.insert(first, last); !inserted) return inserted;
    first = last;
  }
  // Without tiles, points are inserted in their order.
  if (!inserter.has_used_tiles()) return Done{};
  const std::array<VertexId, 3> first_three{order[0], order[1], order[2]};
  const auto when = [&](VertexId v) { return InsertionOrder::time_of(rounds.round[v], insertion_order.position(v)); };
  if (third == 2)
    begin_with_latest(t, first_three, when, threads);
  else
    begin_with_latest(t, first_three, with_early_third(order[2], when), threads);
  return Done{};
}

Result<Delaunay> delaunay(std::span<const Point> points, const Threads& threads, std::size_t per_tile) {
  if (Status fine = check_number(points.size()); !fine) return fine.error();
  Delaunay result;
  result.input_of_vertex = hilbert_order(points, threads);
  Triangulation& t = result.triangulation;
  t.points = make_array(threads, points.size(), [&](std::size_t v) { return points[result.input_of_vertex[v]]; });
  if (Status made = triangulate_points(t, order_of_indices, threads, per_tile); !made) return made.error();
  return result;
}

}  // namespace pardel::engine
