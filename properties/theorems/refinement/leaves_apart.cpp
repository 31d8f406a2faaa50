#include "leaves_apart.hpp"

#include "../../../ref/decomposition/quadtree.hpp"
#include "../../../ref/independent.hpp"

namespace pardel::properties {
namespace {

/// Sixteen equal leaves. The first point lies in the first column of the second row, half a unit from the leaf on its
/// right; the second point lies beyond this leaf.
ref::Quadtree leaves_around(Point p, Point q) {
  const double side = q.x - p.x - 1;
  return ref::uniform_quadtree({p.x + 0.5 - side, p.y - 1.5 * side}, 4 * side, 2);
}

/// Are the points in leaves outside each other's buffer zones that satisfy the condition with this fraction, but not
/// with a quarter?
bool are_apart(const Scene& scene, double fraction) {
  const Point p = scene.insertions.at(0), q = scene.insertions.at(1);
  const ref::PlainMesh mesh = mesh_of(scene);
  const ref::Quadtree tree = leaves_around(p, q);
  const ref::Cell at_p = cell_of(tree, ref::exact(p)), at_q = cell_of(tree, ref::exact(q));
  const auto both = [&](double bound) {
    return may_be_refined(tree, at_p, mesh, bound) && may_be_refined(tree, at_q, mesh, bound);
  };
  return at_p != at_q && !buffer_zone(tree, at_p).contains(at_q) && both(fraction) && !both(0.25);
}

}  // namespace

bool share_a_vertex_above_a_quarter(const Scene& scene) {
  return are_apart(scene, 0.251) && !ref::closures_are_disjoint(mesh_of(scene), ref::exact(scene.insertions.at(0)),
                                                                ref::exact(scene.insertions.at(1)));
}

bool are_dependent_above_a_half(const Scene& scene) {
  return are_apart(scene, 0.506) &&
         !ref::are_independent(mesh_of(scene), ref::exact(scene.insertions.at(0)), ref::exact(scene.insertions.at(1)));
}

}  // namespace pardel::properties
