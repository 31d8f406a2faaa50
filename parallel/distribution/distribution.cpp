#include "distribution.hpp"

#include <algorithm>

#include "../../core/support/collective.hpp"
#include "../../core/support/point_order.hpp"
#include "../triangulation/held.hpp"
#include "../triangulation/triangle_shape.hpp"

namespace pardel::engine {
namespace {

/// A seed on its way to the rank that owns the cell.
struct TravellingSeed {
  Name triangle;
  Index cell;
};

std::vector<Index> without_repetitions(std::vector<Index> ids) {
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  return ids;
}

std::vector<Reader> readers_of(const std::vector<Ranks::Bytes>& messages) {
  std::vector<Reader> readers;
  for (const Ranks::Bytes& message : messages)
    if (!message.empty()) readers.emplace_back(message);
  return readers;
}

/// Copies the vertices that all ranks have in common, and makes one slot without a triangle: arrays of regions that are
/// empty would mean that there are no regions.
Triangulation empty_excerpt(const Triangulation& t, Index common_vertices) {
  Triangulation excerpt;
  excerpt.points.append(t.points.span().first(common_vertices));
  excerpt.origin.append(t.origin.span().first(common_vertices));
  excerpt.slots.resize(1);
  if (!t.region.empty()) excerpt.region.resize(1);
  return excerpt;
}

}  // namespace

void Distribution::divide(const Tiles& tiles, std::span<const double> work, PhaseRunner& runner) {
  set_owners(ownership_of(tiles, work));
  const HeldPart::Common common{runner.vertices().end(), runner.triangles().end()};
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

std::vector<Ranks::Bytes> Distribution::exchange(std::vector<Writer>& messages) {
  std::vector<Ranks::Bytes> bytes;
  for (Writer& message : messages) bytes.push_back(message.take());
  return ranks_.exchange(std::move(bytes));
}

void Distribution::receive(const std::vector<Ranks::Bytes>& messages) {
  std::vector<Reader> readers = readers_of(messages);
  part_->read(readers);
}

void Distribution::deliver(std::vector<PlannedTask>& tasks) {
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
  for (const Ranks::Bytes& message : exchange(messages)) {
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
  std::vector<Outgoing> outgoing(ranks_.count());
  for (PlannedTask& task : tasks) {
    task.free.vertices.for_each_taken([&](IndexRange inserted) {
      if (inserted.size() > 0) insertions_.push_back({task.cell, inserted});
    });
    const auto is_held = [&](int rank, TriangleId id) {  // the corners lie in the box of the task
      return std::ranges::any_of(t_.slots[id].v,
                                 [&](VertexId v) { return ownership_->watches(rank, t_.points[v], task.cell); });
    };
    for (const TriangleId id : std::exchange(task.result.changed, {})) {
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
  receive(exchange(messages));
}

/// The triangles with an own corner in the cells, or in those that are at most `reach` steps away from them.
Distribution::PartOfExcerpt Distribution::part_around(std::span<const Index> cells, unsigned reach) const {
  std::vector<char> is_in(ownership_->cells(), 0);
  std::vector<Index> frontier;
  const auto add = [&](Index cell) {
    if (std::exchange(is_in[cell], 1) == 0) frontier.push_back(cell);
  };
  for (const Index cell : cells) add(cell);
  for (unsigned step = 0; step < reach; ++step)
    for (const Index cell : std::exchange(frontier, {}))
      for (const Index other : ownership_->touching(cell)) add(other);

  PartOfExcerpt part{{}, std::ranges::count(is_in, 0) == 0};
  part_->for_each_triangle([&](TriangleId id) {
    if (std::ranges::any_of(t_.slots[id].v, [&](VertexId v) {
          const Index cell = cell_of(v);
          return is_in[cell] != 0 && ownership_->owner(cell) == ranks_.rank();
        }))
      part.triangles.push_back(id);
  });
  return part;
}

void Distribution::refine_rest(std::span<const QueuedTriangle> rest, const RefineExcerpt& refine) {
  std::vector<Name> names;
  std::vector<Index> cells;
  for (const QueuedTriangle triangle : rest) {
    if (!triangle.is_current(t_)) continue;
    names.push_back(part_->name_of(triangle.id()));
    for (const VertexId v : t_.slots[triangle.id()].v) cells.push_back(cell_of(v));
  }
  std::uint64_t count = names.size();
  ranks_.add_up({&count, 1});
  if (count == 0) return;
  std::vector<Writer> messages(ranks_.count());
  for (Writer& message : messages) {
    message.list(names);
    message.list(cells);
  }
  names.clear();
  cells.clear();
  for (const Ranks::Bytes& message : exchange(messages)) {
    Reader reader(message);
    const auto more_names = reader.list<Name>();
    const auto more_cells = reader.list<Index>();
    names.insert(names.end(), more_names.begin(), more_names.end());
    cells.insert(cells.end(), more_cells.begin(), more_cells.end());
  }

  const ExcerptWork work{Name::rank(ranks_.count()), names, refine,
                         [&](int rank, const Triangulation& t, TriangleId id) { return is_held_by(rank, t, id); },
                         [&](const HeldPart& part, const Triangulation& t, std::span<const VertexId> inserted) {
                           std::vector<VertexId> by_place(inserted.begin(), inserted.end());
                           std::ranges::sort(by_place, [&](VertexId a, VertexId b) {
                             return lexicographically_less(t.points[a], t.points[b]);
                           });
                           for (const VertexId v : by_place) inserted_in_excerpt_.push_back(part.name_of_vertex(v));
                         }};
  unsigned reach = 1;
  work_in_excerpts(work, [&] {
    reach *= 2;
    return part_around(cells, reach);
  });
}

void Distribution::work_in_excerpts(const ExcerptWork& work, const std::function<PartOfExcerpt()>& next_part) {
  std::vector<Writer> messages(ranks_.count());
  for (bool is_done = false; !is_done;) {
    const PartOfExcerpt part = next_part();
    std::vector<Writer> parts(ranks_.count());
    if (!part.triangles.empty()) part_->write(part.triangles, {}, parts[0]);
    const std::vector<Ranks::Bytes> excerpt = exchange(parts);
    is_done = sum_of(ranks_.rank() == 0 && work_in_excerpt(excerpt, work, messages) ? 1 : 0, ranks_) > 0;
    if (!is_done && part.is_largest) throw NotHeld{};
  }
  receive(exchange(messages));
}

bool Distribution::work_in_excerpt(const std::vector<Ranks::Bytes>& excerpt, const ExcerptWork& work,
                                   std::vector<Writer>& messages) const {
  const Index common_vertices = part_->common().vertices;
  Triangulation t = empty_excerpt(t_, common_vertices);
  std::optional<HeldPart> part;
  const auto fill = [&](PhaseRunner& runner) {
    part.emplace(t, runner.vertices(), runner.triangles(), work.creator, HeldPart::Common{common_vertices, 0});
    part->forget(0);
    std::vector<Reader> readers = readers_of(excerpt);
    part->read(readers);
    part->sew();
    std::vector<QueuedTriangle> entries;
    for (const Name name : work.names) {
      const TriangleId id = part->triangle(name);
      if (id == no_index) throw Reader::does_not_match();
      entries.push_back(QueuedTriangle::now(t, EdgeRef(id, 0)));
    }
    return entries;
  };
  std::vector<TriangleId> changed;
  try {
    changed = without_repetitions(work.refine({fill, t}));
  } catch (const NotHeld&) {
    return false;
  }
  // The walk over a cavity does not cross constrained edges, so it does not notice that a triangle beyond one is
  // missing.
  for (const TriangleId id : changed)
    for (const EdgeRef across : t.slots[id].n)
      if (part->is_beyond(across)) return false;
  std::vector<VertexId> inserted;
  for (const TriangleId id : changed)
    for (const VertexId v : t.slots[id].v)
      if (part->name_of_vertex(v).creator == work.creator) inserted.push_back(v);
  work.finish(*part, t, without_repetitions(std::move(inserted)));
  for (int rank = 0; rank < ranks_.count(); ++rank) {
    Outgoing out;
    for (const TriangleId id : changed) {
      if (work.is_held_by(rank, t, id))
        out.triangles.push_back(id);
      else if (part->name_of(id).creator != work.creator)
        out.dropped.push_back(part->name_of(id));
    }
    if (!changed.empty()) part->write(out.triangles, out.dropped, messages[rank]);
  }
  return true;
}

}  // namespace pardel::engine
