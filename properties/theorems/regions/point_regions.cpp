#include "point_regions.hpp"

#include "../../../ref/insertion.hpp"
#include "tasks.hpp"

namespace pardel::properties {
namespace {

struct Two {
  const ref::PlainMesh& mesh;
  Point p, q;

  explicit Two(const MeshedScene& given)
      : mesh(given.mesh), p(given.scene.insertions.at(0)), q(given.scene.insertions.at(1)) {}

  [[nodiscard]] bool meet() const { return cavities_meet(mesh, p, q); }
  [[nodiscard]] bool are_apart_by(Apart how) const { return are_apart(mesh, p, q, how); }
  [[nodiscard]] bool give_one_mesh() const { return make_one_mesh(mesh, p, q); }
};

}  // namespace

bool fails_at_a_common_triangle(const MeshedScene& given) {
  const Two two(given);
  return two.meet() && !two.give_one_mesh();
}

bool fails_at_a_common_edge(const MeshedScene& given) {
  const Two two(given);
  return !two.meet() && !two.give_one_mesh();
}

bool depends_on_the_order(const MeshedScene& given) {
  const Two two(given);
  const Tasks tasks = {Task({two.p}), Task({two.q})};
  return !(one_after_the_other(two.mesh, tasks, 0) == one_after_the_other(two.mesh, tasks, 1));
}

bool is_kept_apart_by_a_wall(const MeshedScene& given) {
  const Two two(given);
  const std::vector<Index> k = ref::in_reach_of(two.mesh, {two.p, two.p}),
                           l = ref::in_reach_of(two.mesh, {two.q, two.q});
  return !are_disjoint(std::set(k.begin(), k.end()), std::set(l.begin(), l.end())) &&
         two.are_apart_by(Apart::vertices_in_sight) && two.give_one_mesh();
}

bool holds_at_a_common_vertex(const MeshedScene& given) {
  const Two two(given);
  return two.are_apart_by(Apart::free_edges_in_sight) && !two.are_apart_by(Apart::vertices_in_sight) &&
         two.give_one_mesh();
}

bool grows_beyond_a_wall(const MeshedScene& given) {
  const Two two(given);
  if (!two.are_apart_by(Apart::vertices_of_disks)) return false;
  ref::PlainMesh after = two.mesh;
  const Index p = ref::insert(after, ref::exact(two.p));
  return ref::closure(after, ref::in_reach_of(after, {two.q, two.q})).contains(p);
}

bool fails_for_one_box(const MeshedScene& given) {
  constexpr double far = 0x1p40;
  const ref::Box everything{{-far, -far}, {far, far}};
  const Tasks tasks = {Task({given.scene.insertions.at(0)}, everything),
                       Task({given.scene.insertions.at(1)}, everything)};
  return !(in_turns(given.mesh, tasks) == one_after_the_other(given.mesh, tasks, 0));
}

}  // namespace pardel::properties
