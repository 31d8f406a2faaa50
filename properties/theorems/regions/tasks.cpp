#include "tasks.hpp"

#include "../../../ref/independent.hpp"
#include "../../../ref/insertion.hpp"

namespace pardel::properties {
namespace {

std::set<Index> as_set(const std::vector<Index>& triangles) { return {triangles.begin(), triangles.end()}; }

}  // namespace

void Task::step(ref::PlainMesh& mesh) {
  const ref::ExactPoint p = ref::exact(points_[handed_on_.size()]);
  if (hole_) {
    replace_hole(mesh, p);
    hole_.reset();
    handed_on_.push_back(false);
    return;
  }
  const std::vector<Index> cavity = ref::cavity(mesh, p);
  if (box_ && !ref::owns(mesh, *box_, cavity)) {
    handed_on_.push_back(true);
    return;
  }
  hole_.emplace();
  for (const Index t : cavity) hole_->push_back(mesh.triangles[t]);
}

void Task::replace_hole(ref::PlainMesh& mesh, const ref::ExactPoint& p) {
  const auto vertex = static_cast<Index>(mesh.points.size());
  mesh.points.push_back(p);
  std::erase_if(mesh.triangles, [&](const ref::Corners& t) { return std::ranges::count(*hole_, t) != 0; });
  const ref::PlainMesh hole{mesh.points, *hole_, {}};
  std::vector<Index> all;
  for (Index t = 0; t < hole.triangles.size(); ++t) all.push_back(t);
  for (const ref::Corners& t : ref::retriangulation(hole, all, vertex)) mesh.triangles.push_back(t);
  if (const auto split = ref::constraint_through(mesh, p)) ref::split_constraint(mesh, *split, vertex);
  touched_.merge(ref::closure(hole, all));
  touched_.insert(vertex);
}

MeshAsPoints as_points(const ref::PlainMesh& mesh) {
  MeshAsPoints made{ref::triangles_as_points(mesh), {}};
  for (const ref::Edge& e : mesh.constraints) {
    const ref::ExactPoint &a = mesh.points[e[0]], &b = mesh.points[e[1]];
    made.constraints.insert({std::min(a, b), std::max(a, b)});
  }
  return made;
}

Outcome outcome(ref::PlainMesh mesh, Tasks& tasks, const std::function<int()>& turn) {
  run(mesh, tasks, turn);
  return {as_points(mesh), {tasks[0].handed_on(), tasks[1].handed_on()}};
}

Outcome one_after_the_other(const ref::PlainMesh& mesh, Tasks tasks, int first) {
  return outcome(mesh, tasks, [first] { return first; });
}

Outcome in_turns(const ref::PlainMesh& mesh, Tasks tasks) {
  int turns = 0;
  return outcome(mesh, tasks, [&turns] { return turns++ % 2; });
}

Outcome interleaved(const ref::PlainMesh& mesh, Tasks& tasks, generators::Random& random) {
  return outcome(mesh, tasks, [&random] { return static_cast<int>(random.below(2)); });
}

bool make_one_mesh(const ref::PlainMesh& mesh, Point p, Point q) {
  const Tasks tasks = {Task({p}), Task({q})};
  const Outcome expected = one_after_the_other(mesh, tasks, 0);
  return one_after_the_other(mesh, tasks, 1) == expected && in_turns(mesh, tasks) == expected;
}

std::vector<Index> reach(const ref::PlainMesh& mesh, const ref::Box& region, Apart how) {
  return how == Apart::vertices_of_disks ? ref::in_reach_of(mesh, region) : ref::in_reach_and_sight_of(mesh, region);
}

bool are_apart(const ref::PlainMesh& mesh, const std::vector<Index>& k, const std::vector<Index>& l, Apart how) {
  if (how != Apart::free_edges_in_sight) return are_disjoint(ref::closure(mesh, k), ref::closure(mesh, l));
  return are_disjoint(as_set(k), as_set(l)) && are_disjoint(ref::free_edges(mesh, k), ref::free_edges(mesh, l));
}

bool are_apart(const ref::PlainMesh& mesh, Point p, Point q, Apart how) {
  return are_apart(mesh, reach(mesh, {p, p}, how), reach(mesh, {q, q}, how), how);
}

bool cavities_meet(const ref::PlainMesh& mesh, Point p, Point q) {
  return !are_disjoint(as_set(ref::cavity(mesh, ref::exact(p))), as_set(ref::cavity(mesh, ref::exact(q))));
}

}  // namespace pardel::properties
