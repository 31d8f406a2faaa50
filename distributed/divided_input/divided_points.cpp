#include "divided_points.hpp"

#include <algorithm>
#include <utility>

#include "../../core/support/collective.hpp"
#include "../../core/support/exchange_lists.hpp"
#include "../../parallel/scheduling/pending_triangles.hpp"
#include "../../parallel/triangulation/triangle_shape.hpp"

namespace pardel::engine {

/// A triangle that waits, on its way to another rank.
struct DividedPoints::TravellingEntry {
  enum class Kind : std::uint32_t { deferred, needs_larger_box };
  Name triangle;
  std::uint16_t key = 0, longest = 0;
  Kind kind = Kind::deferred;
};

/// Sends the entries of list r to rank r. Returns what arrives here.
Waiting DividedPoints::exchanged(std::vector<std::vector<TravellingEntry>> entries) {
  Waiting here;
  for (const TravellingEntry& entry : concatenated(exchange_lists(std::move(entries), ranks_))) {
    const TriangleId id = part_->triangle(entry.triangle);
    if (id == no_index || !part_->holds(id)) throw Reader::does_not_match();
    const QueuedTriangle triangle = QueuedTriangle::now(t_, EdgeRef(id, 0));
    if (entry.kind == TravellingEntry::Kind::deferred)
      here.deferred.emplace_back(triangle, entry.key, entry.longest);
    else
      here.needing_larger_box.push_back(triangle);
  }
  return here;
}

void DividedPoints::begin(PhaseRunner& runner) {
  part_.emplace(t_, runner.vertices(), runner.triangles(), Name::rank(ranks_.rank()),
                Subdomain::Common{start_.common, 0}, &segments_);
  for (const auto& [v, name] : start_.named_vertices) part_->name_vertex(v, name);
  for (const auto& [id, name] : start_.named_triangles) part_->name_triangle(id, name);
  for (const auto& [segment, name] : start_.named_segments) segments_.name(segment, name);
  for (const EdgeRef side : start_.cut) part_->cut(side);
  has_markers_ = sum_of(start_.marker.empty() ? 0 : 1, ranks_) > 0;
}

int DividedPoints::home_before(TriangleId id, const Triangulation& t) const {
  return owner_before(least_corner(t, t.slots[id]), t);
}

std::function<bool(TriangleId)> DividedPoints::counted() const {
  return [this](TriangleId id) { return part_->holds(id) && home_before(id, t_) == ranks_.rank(); };
}

void DividedPoints::drop_halo() {
  for (const TriangleId id : std::exchange(start_.halo, {})) part_->drop(id);
}

Waiting DividedPoints::refine_coarse(const CoarseWork& coarse) {
  drop_halo();
  std::vector<TriangleId> centre;
  std::vector<Name> own_names;
  for (const Deferred& each : coarse.take_due()) {
    centre.push_back(each.triangle.id());
    own_names.push_back(part_->name_of(each.triangle.id()));
  }
  const std::vector<Name> names = concatenated(lists_of_all(own_names, ranks_));
  if (names.empty()) return {};
  std::vector<std::vector<TravellingEntry>> entries(static_cast<std::size_t>(ranks_.count()));
  Waiting waiting;
  const std::uint32_t creator = Name::rank(ranks_.count() + 1);  // no rank

  // Of the vertices of the submesh after the work; -1: not yet looked up. Each is a corner of several triangles.
  std::vector<int> owners;
  const auto owner_in_submesh = [&](VertexId v, const Triangulation& t) {
    owners.resize(t.points.size(), -1);
    if (owners[v] < 0) owners[v] = owner_before(v, t);
    return owners[v];
  };
  const auto is_held_after = [&](int rank, const Triangulation& t, TriangleId id) {
    return std::ranges::any_of(t.slots[id].v, [&](VertexId v) { return owner_in_submesh(v, t) == rank; });
  };
  const SubmeshWork work{
      creator, names,
      [&](const GatheredSubmesh& submesh) {
        std::vector<TriangleId> changed;
        waiting = coarse.refine_submesh(submesh, changed);
        return changed;
      },
      is_held_after,
      [&](const Subdomain& part, const Triangulation& t, std::span<const VertexId> inserted) {
        for (const VertexId v : inserted) inserted_before_division_.push_back(part.name_of_vertex(v));
        const auto entries_for = [&](TriangleId id) -> std::vector<TravellingEntry>& {
          return entries[owner_in_submesh(least_corner(t, t.slots[id]), t)];
        };
        for (const Deferred& d : waiting.deferred)
          if (d.triangle.is_current(t))
            entries_for(d.triangle.id()).push_back({part.name_of(d.triangle.id()), d.key, d.longest});
        for (const QueuedTriangle triangle : waiting.needing_larger_box)
          if (triangle.is_current(t))
            entries_for(triangle.id())
                .push_back({part.name_of(triangle.id()), 0, 0, TravellingEntry::Kind::needs_larger_box});
      }};
  Rings rings(
      *part_, t_, ranks_, [&](VertexId v) { return owner_before(v, t_); }, centre);
  work_in_submeshes(work, *part_, t_, rings, ranks_);
  return exchanged(std::move(entries));
}

void DividedPoints::divide(const Division& division, PhaseRunner& /*runner*/) {
  division.pending.add(divide_anew(division));
}

Waiting DividedPoints::divide_anew(const Division& division) {
  const std::vector<double> work = division.work_of_cells();
  Waiting waiting = division.pending.take();
  drop_halo();
  set_owners(ownership_of(division.finest, work));
  std::vector<std::vector<TravellingEntry>> entries(static_cast<std::size_t>(ranks_.count()));
  const auto send = [&](QueuedTriangle triangle, TravellingEntry entry) {
    if (!triangle.is_current(t_)) return;
    entry.triangle = part_->name_of(triangle.id());
    entries[owner_of(t_.slots[triangle.id()].v[0])].push_back(entry);
  };
  for (const Deferred& d : waiting.deferred) send(d.triangle, {{}, d.key, d.longest});
  for (const QueuedTriangle triangle : waiting.needing_larger_box)
    send(triangle, {{}, 0, 0, TravellingEntry::Kind::needs_larger_box});
  waiting = {};

  std::vector<std::vector<TriangleId>> leaving(static_cast<std::size_t>(ranks_.count()));
  part_->for_each_triangle([&](TriangleId id) {
    if (home_before(id, t_) != ranks_.rank()) return;
    std::vector<int> holders;
    for (const VertexId v : t_.slots[id].v)
      for (const int rank : ownership_->near(cell_of(v)))
        if (rank != ranks_.rank() && ownership_->watches(rank, t_.points[v]) &&
            std::ranges::find(holders, rank) == holders.end())
          holders.push_back(rank);
    for (const int rank : holders) leaving[rank].push_back(id);
  });
  std::vector<Writer> messages(ranks_.count());
  for (int rank = 0; rank < ranks_.count(); ++rank)
    if (!leaving[rank].empty()) part_->write(leaving[rank], {}, messages[rank]);
  leaving = {};
  part_->read(exchange(messages, ranks_));
  std::vector<TriangleId> not_held;
  part_->for_each_triangle([&](TriangleId id) {
    if (!is_held_by(ranks_.rank(), t_, id)) not_held.push_back(id);
  });
  for (const TriangleId id : not_held) part_->drop(id);
  part_->sew();
  send_loose_points();

  return exchanged(std::move(entries));
}

void DividedPoints::send_loose_points() {
  std::vector<std::vector<Subdomain::LoosePoint>> leaving(static_cast<std::size_t>(ranks_.count()));
  for (const VertexId v : start_.loose)
    if (const int owner = owner_of(v); owner != ranks_.rank())
      leaving[owner].push_back({part_->name_of_vertex(v), t_.points[v]});
  part_->add(concatenated(exchange_lists(std::move(leaving), ranks_)));
}

}  // namespace pardel::engine
