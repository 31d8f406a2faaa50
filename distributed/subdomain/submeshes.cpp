#include "submeshes.hpp"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "../../core/support/collective.hpp"
#include "../../core/support/exchange_lists.hpp"
#include "../../core/support/without_repetitions.hpp"
#include "../../parallel/triangulation/held.hpp"

namespace pardel::engine {
namespace {

/// The rings of the first submesh.
constexpr unsigned first_rings = 3;

/// The next submeshes have more rings around the places where the one before was too small: 2, 2, 4, 4 and so on. Fewer
/// rings at a time would need fewer triangles (one at a time: 4 % fewer, for a coast), but more attempts.
[[nodiscard]] unsigned rings_to_add(unsigned attempts) { return 2U << (attempts / 2); }

/// Copies the vertices that all ranks have in common, and makes one slot without a triangle: arrays of regions that are
/// empty would mean that there are no regions.
Triangulation empty_submesh(const Triangulation& t, Index common_vertices) {
  Triangulation submesh;
  submesh.points.append(t.points.span().first(common_vertices));
  submesh.origin.append(t.origin.span().first(common_vertices));
  submesh.slots.resize(1);
  if (!t.region.empty()) submesh.region.resize(1);
  return submesh;
}

/// What has come of the work in a submesh.
struct Attempt {
  std::optional<std::vector<Writer>> changes;  ///< one for each rank; nothing if the submesh was too small
  std::vector<Name> needs_more_at;             ///< the vertices around which it was too small, if they are known
};

/// The submesh, on the first rank. It grows until it is large enough.
class GrowingSubmesh {
 public:
  /// `whole`: the triangulation of the first rank, and `part` its part of the mesh.
  GrowingSubmesh(const SubmeshWork& work, const Triangulation& whole, const Subdomain& part) : work_(work) {
    if (part.segments() != nullptr) {
      domain_ = part.segments()->domain_of_common();
      segments_.emplace(domain_, work.creator, part.segments()->common());
    }
    const Index common = part.common().vertices;
    t_ = empty_submesh(whole, common);
    vertices_.emplace(common, no_index);
    triangles_.emplace(Index{1}, max_engine_triangles);
    part_.emplace(t_, *vertices_, *triangles_, work.creator, Subdomain::Common{common, 0},
                  segments_ ? &*segments_ : nullptr);
    part_->forget(0);
  }

  void add(std::span<const Ranks::Bytes> messages) {
    part_->read(messages);
    part_->sew();
  }

  /// If the submesh is too small, it is as before.
  [[nodiscard]] Attempt attempt(int ranks) {
    Triangulation before = t_;
    std::vector<TriangleId> changed;
    Attempt result;
    try {
      std::vector<VertexId> needs_more_at;
      changed = refined(needs_more_at);
      sort_without_repetitions(needs_more_at);
      for (const VertexId v : needs_more_at) result.needs_more_at.push_back(part_->name_of_vertex(v));
      if (result.needs_more_at.empty()) result.changes = messages_with(changed, ranks);
    } catch (const NotHeld&) {
      result = {};
    }
    if (!result.changes) t_ = std::move(before);
    return result;
  }

 private:
  /// Returns the changed triangles.
  [[nodiscard]] std::vector<TriangleId> refined(std::vector<VertexId>& needs_more_at) {
    std::vector<QueuedTriangle> first;
    for (const Name name : work_.names) {
      const TriangleId id = part_->triangle(name);
      if (id == no_index) throw Reader::does_not_match();
      first.push_back(QueuedTriangle::now(t_, EdgeRef(id, 0)));
    }
    std::vector<TriangleId> changed =
        work_.refine({std::move(first), t_, segments_ ? &domain_.segments : nullptr, needs_more_at});
    sort_without_repetitions(changed, static_cast<TriangleId>(t_.slots.size()));
    // The walk over a cavity does not cross constrained edges, so it does not notice that a triangle beyond one is
    // missing.
    for (const TriangleId id : changed)
      for (unsigned side = 0; side < 3; ++side)
        if (const Slot& slot = t_.slots[id]; part_->is_beyond(slot.n[side]))
          needs_more_at.insert(needs_more_at.end(), {slot.from(side), slot.to(side)});
    return changed;
  }

  [[nodiscard]] std::vector<Writer> messages_with(std::span<const TriangleId> changed, int ranks) {
    std::vector<VertexId> inserted;
    for (const TriangleId id : changed)
      for (const VertexId v : t_.slots[id].v)
        if (part_->name_of_vertex(v).creator == work_.creator) inserted.push_back(v);
    sort_without_repetitions(inserted, static_cast<VertexId>(t_.points.size()));
    work_.finish(*part_, t_, inserted);
    std::vector<Writer> messages(static_cast<std::size_t>(ranks));
    for (int rank = 0; rank < ranks && !changed.empty(); ++rank) {
      std::vector<TriangleId> triangles;
      std::vector<Name> dropped;
      for (const TriangleId id : changed) {
        if (work_.is_held_by(rank, t_, id))
          triangles.push_back(id);
        else if (part_->name_of(id).creator != work_.creator)
          dropped.push_back(part_->name_of(id));
      }
      part_->write(triangles, dropped, messages[rank]);
    }
    return messages;
  }

  const SubmeshWork& work_;
  DomainTriangulation domain_;
  Triangulation& t_ = domain_.triangulation;
  std::optional<HeldSegments> segments_;
  std::optional<IndexAllocator> vertices_, triangles_;  ///< of the triangles that have arrived
  std::optional<Subdomain> part_;
};

/// Adds rings around these vertices, or around all if these do not help. Returns false if there are no more triangles.
bool grow(Rings& rings, unsigned count, std::span<const Name> vertices) {
  rings.grow_around(vertices);
  rings.grow();
  if (rings.is_complete() && !vertices.empty()) return grow(rings, count, {});
  if (rings.is_complete()) return false;
  for (unsigned ring = 1; ring < count && !rings.is_complete(); ++ring) rings.grow();
  return true;
}

}  // namespace

void work_in_submeshes(const SubmeshWork& work, Subdomain& part, const Triangulation& t, Rings& rings, Ranks& ranks) {
  const auto count = static_cast<std::size_t>(ranks.count());
  std::optional<GrowingSubmesh> submesh;
  if (ranks.rank() == 0) submesh.emplace(work, t, part);
  std::size_t sent = 0;
  for (unsigned ring = 0; ring < first_rings; ++ring) rings.grow();
  for (unsigned attempts = 0;; ++attempts) {
    std::vector<Writer> messages(count);
    const auto fresh = std::span(rings.triangles()).subspan(std::exchange(sent, rings.triangles().size()));
    if (!fresh.empty()) part.write(fresh, {}, messages[0]);
    const std::vector<Ranks::Bytes> arrived = exchange(messages, ranks);
    Attempt here;
    if (submesh) {
      submesh->add(arrived);
      here = submesh->attempt(ranks.count());
    }
    if (sum_of(here.changes ? 1 : 0, ranks) > 0) {
      messages = here.changes ? *std::move(here.changes) : std::vector<Writer>(count);
      return part.read(exchange(messages, ranks));
    }
    if (!grow(rings, rings_to_add(attempts), concatenated(lists_of_all(here.needs_more_at, ranks)))) throw NotHeld{};
  }
}

}  // namespace pardel::engine
