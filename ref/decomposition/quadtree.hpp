// The decomposition of the paper's successor: for graded meshes, the leaves of a quadtree take the place of the cells
// of a lattice. The condition on circumradii is local, and leaves outside each other's buffer zones may be refined at
// the same time (THEORY.md, Quadtree).
//
// Source: A. N. Chernikov, N. P. Chrisochoides, "Generalized Delaunay mesh refinement: from scalar to parallel", 2006,
// as we recall it; the balance of the tree is our addition.
#pragma once

#include <map>
#include <set>

#include "../definitions.hpp"
#include "../region.hpp"
#include "cell.hpp"

namespace pardel::ref {

/// A quadtree over a square. The leaf (i, j) of level l is [x + i s, x + (i + 1) s) x [y + j s, y + (j + 1) s), where
/// (x, y) is the corner of the square and s = side / 2^l.
struct Quadtree {
  Point corner;
  double side;
  std::map<Cell, int> colour_of_leaf;
};

/// In the condition on circumradii, they are smaller than this fraction of the leaf's side.
inline constexpr double paper_fraction = 0.25;

/// The tree whose leaves are all squares of one level.
[[nodiscard]] Quadtree uniform_quadtree(Point corner, double side, int level);

/// The tree for this mesh. Starting with one leaf, each leaf that contains a vertex is divided, if the new leaves are
/// wide enough. With it, leaves around it are divided to keep the tree balanced: the sides of two leaves that touch, in
/// a side or a corner, differ at most by a factor of two. Precondition: the mesh has triangles.
[[nodiscard]] Quadtree quadtree_over(const PlainMesh& mesh);

[[nodiscard]] double side_of(const Quadtree& tree, const Cell& leaf);
/// The closed square of the leaf.
[[nodiscard]] Box box_of(const Quadtree& tree, const Cell& leaf);

/// Do the closed squares of two different leaves have a point in common?
[[nodiscard]] bool touch(const Cell& leaf, const Cell& other);

/// The neighbours of a leaf are the leaves with which it shares a piece of a side. The buffer zone consists of the
/// neighbours, and of their neighbours in the orthogonal direction: those above and below a neighbour on the left or
/// right, and those on the left and right of a neighbour above or below. The leaf itself is not in its buffer zone.
/// A leaf outside it may be refined at the same time (THEORY.md, Quadtree).
[[nodiscard]] std::set<Cell> buffer_zone(const Quadtree& tree, const Cell& leaf);

/// Is the circumradius of each triangle whose open circumdisk meets the leaf smaller than `fraction` times the leaf's
/// side?
[[nodiscard]] bool is_wide_enough(const Quadtree& tree, const Cell& leaf, const PlainMesh& mesh,
                                  double fraction = paper_fraction);

/// The condition under which a leaf may be refined while leaves outside its buffer zone are refined: every leaf of its
/// buffer zone is wide enough. If it holds for two such leaves, cavities of their points have no common vertex
/// (THEORY.md, Quadtree (C)). The refiner asks for more, allows().
[[nodiscard]] bool may_be_refined(const Quadtree& tree, const Cell& leaf, const PlainMesh& mesh,
                                  double fraction = paper_fraction);

/// May the tree be used for this mesh? That is, does it have one leaf, or are all leaves wide enough?
[[nodiscard]] bool allows(const Quadtree& tree, const PlainMesh& mesh);

/// The tree for the next sweep: a new one, because the triangles have become smaller.
[[nodiscard]] Quadtree cells_after(const Quadtree& tree, const PlainMesh& mesh);

/// The leaf that contains p, or the nearest one.
[[nodiscard]] Cell cell_of(const Quadtree& tree, const ExactPoint& p);

/// Colours are numbered from 0. No leaf has the colour of a leaf in its buffer zone.
[[nodiscard]] int colours(const Quadtree& tree);
[[nodiscard]] int colour_of(const Quadtree& tree, const Cell& leaf);

}  // namespace pardel::ref
