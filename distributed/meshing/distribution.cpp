#include "distribution.hpp"

#include <algorithm>
#include <string>

#include "../../core/support/collective.hpp"
#include "../../core/support/exchange_lists.hpp"
#include "../../core/support/point_order.hpp"
#include "../../parallel/quality/estimates.hpp"
#include "../../parallel/scheduling/pending_triangles.hpp"
#include "../../parallel/scheduling/refine_by_sweeps.hpp"
#include "../../parallel/triangulation/triangle_shape.hpp"

namespace pardel::engine {
namespace {

/// A seed on its way to the rank that owns the cell.
struct TravellingSeed {
  Name triangle;
  Index cell;
};

/// Other ranks may have changed the triangles beyond the box in the same phase.
Stopped changed_beyond_box(Index cell) {
  return {{ErrorKind::internal, "a self-check of the refinement failed: the task of cell " + std::to_string(cell) +
                                    " has made a triangle with a corner outside its box"}};
}

}  // namespace

void Distribution::add_up(std::span<std::uint64_t> values) {
  if (is_in_parts()) ranks_.add_up(values);
}

void Distribution::add_up_estimates(std::span<double> estimates) {
  if (!is_in_parts()) return;
  std::vector<std::uint64_t> parts;
  for (const double each : estimates) parts.push_back(static_cast<std::uint64_t>(each * parts_of_estimate));
  add_up(parts);
  for (std::size_t i = 0; i < parts.size(); ++i) estimates[i] = static_cast<double>(parts[i]) / parts_of_estimate;
}

void Distribution::take_largest(std::span<double> values) {
  if (!is_in_parts()) return;
  for (const std::vector<double>& of_rank : lists_of_all(std::vector(values.begin(), values.end()), ranks_))
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = std::max(values[i], of_rank[i]);
}

Waiting Distribution::refine_coarse(const CoarseWork& work) {
  work.refine_here();
  return {};
}

void Distribution::divide(const Division& division, PhaseRunner& runner) {
  divide_by(division.finest, division.work_of_cells(), runner);
  division.pending.keep_if([&](TriangleId id) { return owner_of(t_.slots[id].v[0]) == ranks_.rank(); });
  if (ranks_.rank() > 0) division.counts = {};  // what all ranks have done alike counts once
}

void Distribution::divide_by(const Tiles& tiles, std::span<const double> work, PhaseRunner& runner) {
  set_owners(ownership_of(tiles, work));
  const Subdomain::Common common{runner.vertices().end(), runner.triangles().end()};
  unused_common_ = runner.vertices().holes();
  part_.emplace(t_, runner.vertices(), runner.triangles(), Name::rank(ranks_.rank()), common);
  std::vector<TriangleId> not_held;
  part_->for_each_triangle([&](TriangleId id) {
    if (!is_held_by(ranks_.rank(), t_, id)) not_held.push_back(id);
  });
  for (const TriangleId id : not_held) part_->drop(id);
}

void Distribution::set_owners(Ownership ownership) {
  ownership_.emplace(std::move(ownership));
  for (Index cell = 0; cell < ownership_->cells(); ++cell) {
    other_watchers_.push_back(ownership_->watchers_of_box(cell));
    std::erase(other_watchers_.back(), ranks_.rank());
  }
}

bool Distribution::is_held_by(int rank, const Triangulation& t, TriangleId id) const {
  return std::ranges::any_of(t.slots[id].v, [&](VertexId v) { return ownership_->watches(rank, t.points[v]); });
}

int Distribution::owner_of_triangle(TriangleId id) const { return owner_of(least_corner(t_, t_.slots[id])); }

void Distribution::deliver(std::vector<PlannedTask>& tasks) {
  if (!is_in_parts()) return;
  std::vector<std::vector<TravellingSeed>> seeds(ranks_.count());
  for (PlannedTask& task : tasks) {
    const int owner = ownership_->owner(task.cell);
    task.elsewhere = owner != ranks_.rank();
    if (!task.elsewhere) continue;
    for (const QueuedTriangle seed : task.seeds) seeds[owner].push_back({part_->name_of(seed.id()), task.cell});
    task.seeds.clear();
  }
  std::vector<Writer> messages(ranks_.count());
  for (int rank = 0; rank < ranks_.count(); ++rank)
    if (!seeds[rank].empty()) messages[rank].list(seeds[rank]);

  std::vector<TravellingSeed> arrived;
  for (const Ranks::Bytes& message : exchange(messages, ranks_)) {
    if (message.empty()) continue;
    const std::vector<TravellingSeed> list = Reader(message).list<TravellingSeed>();
    arrived.insert(arrived.end(), list.begin(), list.end());
  }
  std::ranges::stable_sort(arrived, {}, &TravellingSeed::cell);
  std::vector<PlannedTask> fresh;
  for (auto next = arrived.begin(); next != arrived.end();) {
    const Index cell = next->cell;
    if (cell >= ownership_->cells() || ownership_->owner(cell) != ranks_.rank()) throw Reader::does_not_match();
    auto task = std::ranges::lower_bound(tasks, cell, {}, &PlannedTask::cell);
    const bool is_planned = task != tasks.end() && task->cell == cell;
    PlannedTask& receiver = is_planned ? *task : fresh.emplace_back();
    receiver.cell = cell;
    for (; next != arrived.end() && next->cell == cell; ++next) {
      const TriangleId id = part_->triangle(next->triangle);
      if (id == no_index) throw Reader::does_not_match();
      receiver.seeds.push_back(QueuedTriangle::now(t_, EdgeRef(id, 0)));
    }
    sort_by_place(t_, receiver.seeds);
  }
  std::ranges::move(fresh, std::back_inserter(tasks));
  std::ranges::sort(tasks, {}, &PlannedTask::cell);
  for (PlannedTask& task : tasks) task.lists_changes = !other_watchers_[task.cell].empty();
}

void Distribution::exchange_changes(std::vector<PlannedTask>& tasks) {
  if (!is_in_parts()) return;
  std::vector<Outgoing> outgoing(ranks_.count());
  for (PlannedTask& task : tasks) {
    task.free.vertices.for_each_taken([&](IndexRange inserted) {
      if (inserted.size() > 0) insertions_.push_back({task.cell, inserted});
    });
    const Box box = ownership_->box_of(task.cell);
    const auto is_held = [&](int rank, TriangleId id) {  // the corners lie in the box of the task
      return std::ranges::any_of(t_.slots[id].v,
                                 [&](VertexId v) { return ownership_->watches(rank, t_.points[v], task.cell); });
    };
    for (const TriangleId id : std::exchange(task.result.changed, {})) {
      if (!std::ranges::all_of(t_.slots[id].v, [&](VertexId v) { return box.contains_half_open(t_.points[v]); }))
        throw changed_beyond_box(task.cell);
      for (const int rank : other_watchers_[task.cell]) {
        if (is_held(rank, id))
          outgoing[rank].triangles.push_back(id);
        else if (part_->is_known_elsewhere(id))
          outgoing[rank].dropped.push_back(part_->name_of(id));
      }
    }
  }
  std::vector<Writer> messages(ranks_.count());
  for (int rank = 0; rank < ranks_.count(); ++rank) {
    const Outgoing& out = outgoing[rank];
    if (!out.triangles.empty() || !out.dropped.empty()) part_->write(out.triangles, out.dropped, messages[rank]);
  }
  part_->read(exchange(messages, ranks_));
}

void Distribution::refine_rest(const RestOfWork& work_of_all) {
  std::vector<TriangleId> centre;
  std::vector<Name> own_names;
  for (const QueuedTriangle triangle : work_of_all.take_rest()) {
    if (!triangle.is_current(t_)) continue;
    centre.push_back(triangle.id());
    own_names.push_back(part_->name_of(triangle.id()));
  }
  if (sum_of(own_names.size(), ranks_) == 0) return;
  const std::vector<Name> names = concatenated(lists_of_all(own_names, ranks_));
  const SubmeshWork work{Name::rank(ranks_.count()), names, work_of_all.refine_submesh,
                         [&](int rank, const Triangulation& t, TriangleId id) { return is_held_by(rank, t, id); },
                         [&](const Subdomain& part, const Triangulation& t, std::span<const VertexId> inserted) {
                           std::vector<VertexId> by_place(inserted.begin(), inserted.end());
                           std::ranges::sort(by_place, [&](VertexId a, VertexId b) {
                             return lexicographically_less(t.points[a], t.points[b]);
                           });
                           for (const VertexId v : by_place) inserted_in_submesh_.push_back(part.name_of_vertex(v));
                         }};
  Rings rings(
      *part_, t_, ranks_, [&](VertexId v) { return owner_of(v); }, centre);
  work_in_submeshes(work, *part_, t_, rings, ranks_);
}

}  // namespace pardel::engine
