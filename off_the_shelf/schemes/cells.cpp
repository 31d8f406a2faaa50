// The paper's scheme: cells of several colours, and a phase for each colour. A task gets the triangles that an
// insertion in its cell can change: those whose circumdisk meets the cell. They lie in the box of the cell if
// circumradii are small enough (T1), and the boxes of one colour are disjoint (THEORY.md, Lattice and Quadtree), so the
// tasks of a phase never share a triangle. A cell whose task would need a triangle beyond its box waits for the next
// sweep, which measures circumradii again. A task also gets the triangles in its box with a constrained side whose
// diametral disk meets the cell: an insertion may encroach upon such a side.
#include <algorithm>
#include <cmath>
#include <utility>

#include "../../parallel/arithmetic/between_ends.hpp"
#include "../../parallel/decomposition/lattice_levels.hpp"
#include "../../parallel/decomposition/tiles.hpp"
#include "../../parallel/planning/expected_size.hpp"
#include "../../parallel/threads/parallel_for.hpp"
#include "../../parallel/triangulation/radii.hpp"
#include "../../parallel/triangulation/triangle_shape.hpp"
#include "portions.hpp"
#include "schemes.hpp"

namespace pardel::engine {
namespace {

struct Disk {
  Point centre;
  double squared_radius;
};

Disk circumdisk(const Shape& shape) {
  const Point p = shape.p[0];
  const Point to_centre = to_circumcentre({shape.p[1].x - p.x, shape.p[1].y - p.y},
                                          {shape.p[2].x - p.x, shape.p[2].y - p.y}, shape.twice_area);
  return {{p.x + to_centre.x, p.y + to_centre.y}, to_centre.x * to_centre.x + to_centre.y * to_centre.y};
}

Disk diametral_disk(Point a, Point b) {
  const double dx = b.x - a.x, dy = b.y - a.y;
  return {middle_of(a, b), 0.25 * (dx * dx + dy * dy)};
}

/// The rectangle of a cell. At the border of the tiles it extends to infinity, as the box of the cell does.
SubdomainCell rectangle_of(const Tiles& tiles, Index cell) {
  const Point centre = tiles.centre_of(cell);
  const auto [half_width, half_height] = tiles.half_size(cell);
  const Box box = tiles.box_of(cell);
  return {{box.min_x == -INFINITY ? -INFINITY : centre.x - half_width,
           box.min_y == -INFINITY ? -INFINITY : centre.y - half_height},
          {box.max_x == INFINITY ? INFINITY : centre.x + half_width,
           box.max_y == INFINITY ? INFINITY : centre.y + half_height}};
}

bool meets(const Disk& disk, const SubdomainCell& cell) {
  const double dx = disk.centre.x - std::clamp(disk.centre.x, cell.low.x, cell.high.x);
  const double dy = disk.centre.y - std::clamp(disk.centre.y, cell.low.y, cell.high.y);
  return dx * dx + dy * dy <= disk.squared_radius;
}

/// One sweep: a phase for each colour.
class CellSweep {
 public:
  CellSweep(MesherRun& run, const Tiles& tiles) : run_(run), t_(run.mesh.t), tiles_(tiles) {
    for (Index cell = 0; cell < tiles.cells(); ++cell) {
      rectangles_.push_back(rectangle_of(tiles, cell));
      double least = tiles.radius_that_fits(cell);
      for (const Index other : tiles.touching(cell)) least = std::min(least, tiles.radius_that_fits(other));
      radius_around_.push_back(least);
    }
  }

  /// `to_split`: the triangles that wait when the sweep starts.
  void run(std::span<const TriangleId> to_split) {
    find_cells_with_work(to_split);
    find_nearby();
    for (unsigned colour = 0; colour < tiles_.colours(); ++colour) {
      run_.threads.ask();
      Portions portions = portions_of(colour);
      if (portions.all.empty()) continue;
      const auto before = static_cast<TriangleId>(t_.slots.size());
      show(run_, run_tasks(run_, std::move(portions)));
      for (TriangleId id = before; id < t_.slots.size(); ++id) nearby_.push_back(id);
    }
  }

 private:
  void find_cells_with_work(std::span<const TriangleId> to_split) {
    has_work_.assign(tiles_.cells(), 0);
    for (const TriangleId id : to_split) {
      const Shape shape(t_, t_.slots[id]);
      has_work_[tiles_.cell_of(circumdisk(shape).centre)] = 1;
      has_work_[tiles_.cell_of(shape.centroid())] = 1;
    }
  }

  /// For each cell, the cells of a colour with work among it and those that touch it.
  [[nodiscard]] std::vector<std::vector<Index>> due_around(unsigned colour) const {
    std::vector<std::vector<Index>> due(tiles_.cells());
    for (Index cell = 0; cell < tiles_.cells(); ++cell) {
      if (is_due(cell, colour)) due[cell].push_back(cell);
      for (const Index other : tiles_.touching(cell))
        if (is_due(other, colour)) due[cell].push_back(other);
    }
    return due;
  }

  /// The cell, of those that are due around the triangle's centroid, whose task needs the triangle; no_index if there
  /// is none. There is at most one: the boxes of a colour are disjoint.
  [[nodiscard]] Index cell_for(const Slot& slot, const Shape& shape, const Disk& disk,
                               const std::vector<Index>& due) const {
    for (const Index cell : due)
      if (fits_box(cell, shape) && is_needed(cell, slot, shape, disk)) return cell;
    return no_index;
  }
  [[nodiscard]] bool is_due(Index cell, unsigned colour) const {
    return has_work_[cell] != 0 && tiles_.colour_of(cell) == colour;
  }
  [[nodiscard]] bool fits_box(Index cell, const Shape& shape) const {
    const Box box = tiles_.box_of(cell);
    return std::ranges::all_of(shape.p, [&](Point p) { return box.contains_half_open(p); });
  }
  /// True if an insertion in the cell can change the triangle, or be blocked by one of its sides. `disk`: the
  /// circumdisk.
  [[nodiscard]] bool is_needed(Index cell, const Slot& slot, const Shape& shape, const Disk& disk) const {
    if (meets(disk, rectangles_[cell])) return true;
    for (unsigned side = 0; side < 3; ++side)
      if (slot.n[side].constrained() &&
          meets(diametral_disk(shape.p[next_corner[side]], shape.p[previous_corner[side]]), rectangles_[cell]))
        return true;
    return false;
  }

  /// Marks cells of the colour whose tasks would need a triangle beyond their boxes. `disk`: its circumdisk.
  void mark_without_room(TriangleId id, const Shape& shape, const Disk& disk, unsigned colour,
                         std::vector<char>& without_room) const {
    const Slot& slot = t_.slots[id];
    // The cells that meet a disk are connected.
    std::vector<Index> found;
    const auto add = [&](Index cell) {
      if (is_needed(cell, slot, shape, disk) && std::ranges::find(found, cell) == found.end()) found.push_back(cell);
    };
    add(tiles_.cell_of(disk.centre));
    for (unsigned side = 0; side < 3; ++side)
      if (slot.n[side].constrained())
        add(tiles_.cell_of(middle_of(shape.p[next_corner[side]], shape.p[previous_corner[side]])));
    for (std::size_t i = 0; i < found.size(); ++i) {
      if (is_due(found[i], colour) && !fits_box(found[i], shape)) without_room[found[i]] = 1;
      for (const Index other : tiles_.touching(found[i])) add(other);
    }
  }

  /// The triangles that a task of the sweep may need, before its first phase.
  void find_nearby() {
    std::vector<char> near_work(has_work_);
    for (Index cell = 0; cell < tiles_.cells(); ++cell)
      if (has_work_[cell] != 0)
        for (const Index other : tiles_.touching(cell)) near_work[other] = 1;
    std::vector<std::vector<TriangleId>> found(block_count(t_.slots.size()));
    parallel_blocks(run_.threads, t_.slots.size(), [&](std::size_t first, std::size_t last, std::size_t block) {
      for (std::size_t id = first; id < last; ++id) {
        const Shape shape(t_, t_.slots[id]);
        const Index cell = tiles_.cell_of(shape.centroid());
        if (near_work[cell] != 0 || is_large(circumdisk(shape), cell)) found[block].push_back(static_cast<Index>(id));
      }
    });
    for (const std::vector<TriangleId>& of_block : found)
      nearby_.insert(nearby_.end(), of_block.begin(), of_block.end());
  }

  /// False only if the box of every cell that meets the disk contains the disk. `cell`: that of the centroid of the
  /// disk's triangle.
  [[nodiscard]] bool is_large(const Disk& disk, Index cell) const {
    return !(disk.squared_radius <= radius_around_[cell] * radius_around_[cell]);
  }

  [[nodiscard]] Portions portions_of(unsigned colour) const {
    Portions portions;
    portions.portion_of.assign(t_.slots.size(), no_index);
    const std::vector<std::vector<Index>> due = due_around(colour);
    std::vector<Index> cell_of(nearby_.size());
    std::vector<std::vector<TriangleId>> large(block_count(nearby_.size()));
    parallel_blocks(run_.threads, nearby_.size(), [&](std::size_t first, std::size_t last, std::size_t block) {
      for (std::size_t i = first; i < last; ++i) {
        const TriangleId id = nearby_[i];
        const Shape shape(t_, t_.slots[id]);
        const Disk disk = circumdisk(shape);
        const Index cell = tiles_.cell_of(shape.centroid());
        cell_of[i] = cell_for(t_.slots[id], shape, disk, due[cell]);
        if (is_large(disk, cell)) large[block].push_back(id);
      }
    });
    std::vector<char> without_room(tiles_.cells(), 0);
    for (const std::vector<TriangleId>& of_block : large)
      for (const TriangleId id : of_block) {
        const Shape shape(t_, t_.slots[id]);
        mark_without_room(id, shape, circumdisk(shape), colour, without_room);
      }
    std::vector<Index> portion_of_cell(tiles_.cells(), no_index);
    for (std::size_t i = 0; i < nearby_.size(); ++i) {
      const TriangleId id = nearby_[i];
      const Index cell = cell_of[i];
      if (cell == no_index || without_room[cell] != 0) continue;
      if (portion_of_cell[cell] == no_index) {
        portion_of_cell[cell] = static_cast<Index>(portions.all.size());
        portions.all.push_back({{}, rectangles_[cell]});
      }
      portions.portion_of[id] = portion_of_cell[cell];
      portions.all[portion_of_cell[cell]].triangles.push_back(id);
    }
    return portions;
  }

  MesherRun& run_;
  const Triangulation& t_;
  const Tiles& tiles_;
  std::vector<SubdomainCell> rectangles_;
  std::vector<char> has_work_;
  std::vector<double> radius_around_;  ///< what fits the boxes of the cell and of those that touch it
  std::vector<TriangleId> nearby_;     ///< triangles that a task of the sweep may need; with all that it makes
};

/// The lattice with cells of about the wanted work that are at least four circumradii wide.
Tiles lattice_for(const MesherRun& run, double tasks) {
  const Triangulation& t = run.mesh.t;
  const Box bounds = bounds_of(t, run.threads);
  const auto along = static_cast<Index>(std::clamp(std::ceil(std::sqrt(tasks)), 1.0, 4096.0));
  const IndexAllocator triangles(static_cast<Index>(t.slots.size()), max_engine_triangles);
  const double side = Lattice::radii_per_side * 1.02 * largest_radii(t, triangles, run.threads).radius;
  return Tiles(with_cells_at_least(side, bounds, Lattice::over(bounds, along)));
}

/// The quadtree whose leaves have about the wanted work. A leaf is divided only if the circumradii in it and in the
/// leaves around it fit its children.
Tiles quadtree_for(const MesherRun& run, double work_per_leaf) {
  const Triangulation& t = run.mesh.t;
  Quadtree tree(bounds_of(t, run.threads));
  for (unsigned depth = 0; depth < Square::deepest; ++depth) {
    std::vector<double> work(tree.cells(), 0), radius(tree.cells(), 0);
    LocalHints hints;
    for (TriangleId id = 0; id < t.slots.size(); ++id) {
      const Shape shape(t, t.slots[id]);
      const Index leaf = tree.cell_of(shape.centroid());
      work[leaf] += std::max(1.0, run.criteria.triangles_wanted(shape, run.mesh.assessor.region_of(id), hints));
      radius[leaf] = std::max(radius[leaf], std::sqrt(circumdisk(shape).squared_radius));
    }
    std::vector<double> to_divide = work;
    for (Index leaf = 0; leaf < tree.cells(); ++leaf) {
      double around = radius[leaf];
      for (const Index other : tree.touching(leaf)) around = std::max(around, radius[other]);
      if (!(around <= tree.radius_that_fits(leaf) / 2)) to_divide[leaf] = 0;
    }
    if (std::ranges::all_of(to_divide, [&](double sum) { return sum <= work_per_leaf; })) break;
    tree = tree.divided(to_divide, work_per_leaf);
  }
  return Tiles(std::move(tree));
}

}  // namespace

void sweep_over_cells(MesherRun& run) {
  constexpr double largest_share_left = 0.9;
  repeat_sweeps(run, largest_share_left, [&](const ToSplit& to_split, unsigned) {
    const double per_task = run.how.triangles_per_task;
    const Tiles tiles =
        run.criteria.depends_on_place()
            ? quadtree_for(run, per_task)
            : lattice_for(run,
                          expected_triangles(run.mesh.t, run.criteria, run.options.min_edge, run.threads) / per_task);
    CellSweep(run, tiles).run(to_split.triangles);
  });
}

}  // namespace pardel::engine
