#include "excerpts.hpp"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "../../core/support/collective.hpp"
#include "../triangulation/held.hpp"

namespace pardel::engine {
namespace {

/// The number of rings of the first excerpt. Each further excerpt has twice as many as the one before.
constexpr unsigned first_rings = 4;

std::vector<Index> without_repetitions(std::vector<Index> ids) {
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  return ids;
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

/// `whole`: the triangulation of the first rank; `known`: its segments, as HeldPart::segments(); `arrived`: what the
/// ranks have sent for the excerpt. Returns the messages with the changes, one for each rank; nothing if the excerpt
/// was too small.
std::optional<std::vector<Writer>> changes_of(const ExcerptWork& work, const Triangulation& whole,
                                              const HeldSegments* known, Index common_vertices,
                                              std::span<const Ranks::Bytes> arrived) {
  DomainTriangulation domain;
  std::optional<HeldSegments> segments;
  if (known != nullptr) {
    domain = known->common_segments();
    segments.emplace(domain, work.creator, known->common());
  }
  Triangulation& t = domain.triangulation = empty_excerpt(whole, common_vertices);
  std::optional<HeldPart> part;
  const auto fill = [&](PhaseRunner& runner) {
    part.emplace(t, runner.vertices(), runner.triangles(), work.creator, HeldPart::Common{common_vertices, 0},
                 segments ? &*segments : nullptr);
    part->forget(0);
    part->read(arrived);
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
    changed = without_repetitions(work.refine({fill, t, segments ? &domain.segments : nullptr}));
  } catch (const NotHeld&) {
    return std::nullopt;
  }
  // The walk over a cavity does not cross constrained edges, so it does not notice that a triangle beyond one is
  // missing.
  for (const TriangleId id : changed)
    for (const EdgeRef across : t.slots[id].n)
      if (part->is_beyond(across)) return std::nullopt;
  std::vector<VertexId> inserted;
  for (const TriangleId id : changed)
    for (const VertexId v : t.slots[id].v)
      if (part->name_of_vertex(v).creator == work.creator) inserted.push_back(v);
  work.finish(*part, t, without_repetitions(std::move(inserted)));
  std::vector<Writer> messages(arrived.size());
  for (std::size_t rank = 0; rank < messages.size() && !changed.empty(); ++rank) {
    std::vector<TriangleId> triangles;
    std::vector<Name> dropped;
    for (const TriangleId id : changed) {
      if (work.is_held_by(static_cast<int>(rank), t, id))
        triangles.push_back(id);
      else if (part->name_of(id).creator != work.creator)
        dropped.push_back(part->name_of(id));
    }
    part->write(triangles, dropped, messages[rank]);
  }
  return messages;
}

}  // namespace

void work_in_excerpts(const ExcerptWork& work, HeldPart& part, const Triangulation& t, Rings& rings, Ranks& ranks) {
  const auto count = static_cast<std::size_t>(ranks.count());
  for (unsigned have = 0, wanted = first_rings;; wanted *= 2) {
    for (; have < wanted && !rings.is_complete(); ++have) rings.grow();
    std::vector<Writer> excerpt(count);
    if (!rings.triangles().empty()) part.write(rings.triangles(), {}, excerpt[0]);
    const std::vector<Ranks::Bytes> arrived = exchange(excerpt, ranks);
    std::optional<std::vector<Writer>> changes;
    if (ranks.rank() == 0) changes = changes_of(work, t, part.segments(), part.common().vertices, arrived);
    if (sum_of(changes ? 1 : 0, ranks) > 0) {
      std::vector<Writer> messages = changes ? *std::move(changes) : std::vector<Writer>(count);
      return part.read(exchange(messages, ranks));
    }
    if (rings.is_complete()) throw NotHeld{};
  }
}

}  // namespace pardel::engine
