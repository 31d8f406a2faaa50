#include "labels.hpp"

#include <numeric>

#include "../../core/support/answers_of_ranks.hpp"
#include "../../core/support/share_of_rank.hpp"
#include "../../core/support/without_repetitions.hpp"
#include "../../parallel/arithmetic/predicates.hpp"
#include "../../parallel/triangulation/locate.hpp"
#include "triangles_at_borders.hpp"

namespace pardel::engine {
namespace {

/// Sets of components that are connected.
class ConnectedComponents {
 public:
  explicit ConnectedComponents(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0); }

  /// A number that all members of a set have in common.
  [[nodiscard]] std::size_t set_of(std::size_t component) {
    while (parent_[component] != component) component = parent_[component] = parent_[parent_[component]];
    return component;
  }
  void join(std::size_t a, std::size_t b) { parent_[set_of(a)] = set_of(b); }

 private:
  std::vector<std::size_t> parent_;
};

/// Triangles of one rank that are connected without crossing a constraint. Such components of several ranks can be
/// connected with each other.
class Components {
 public:
  Components(const LocalDelaunay& delaunay, const OwnPoints& own, Ranks& ranks, const Threads& threads)
      : delaunay_(delaunay), t_(delaunay.triangulation()), own_(own), ranks_(ranks), ask_(threads.stop) {
    find();
    const std::size_t n = share_.all;
    ConnectedComponents sets(n);
    for (const auto& [a, b] : concatenated(lists_of_all(connections(), ranks_))) {
      if (a >= n || b >= n) throw Reader::does_not_match();
      sets.join(a, b);
    }
    set_.resize(n);
    for (std::size_t c = 0; c < n; ++c) set_[c] = sets.set_of(c);
  }

  [[nodiscard]] bool has(TriangleId id) const { return of_slot_[id] != no_index; }
  /// Equal for two triangles of any ranks if they are connected; less than size(). Precondition: has(id).
  [[nodiscard]] std::size_t set_of(TriangleId id) const { return set_[share_.before + of_slot_[id]]; }
  [[nodiscard]] std::size_t size() const { return set_.size(); }
  /// For each component of any rank, the set that it belongs to.
  [[nodiscard]] const std::vector<std::size_t>& sets() const { return set_; }

 private:
  void find() {
    of_slot_ = Array<Index>(t_.slots.size(), no_index);
    Index count = 0;
    std::vector<TriangleId> stack;
    for (TriangleId first = 0; first < t_.slots.size(); ++first) {
      ask_();
      if (of_slot_[first] != no_index || !is_member(first)) continue;
      stack.push_back(first);
      flood_members(stack, count++);
    }
    share_ = share_of_rank(count, ranks_);
  }

  [[nodiscard]] bool is_member(TriangleId id) const { return !t_.slots[id].is_ghost() && delaunay_.has_own_corner(id); }

  void flood_members(std::vector<TriangleId>& stack, Index component) {
    while (!stack.empty()) {
      ask_();
      const TriangleId id = stack.back();
      stack.pop_back();
      if (of_slot_[id] != no_index) continue;
      of_slot_[id] = component;
      for (const EdgeRef out : t_.slots[id].n)
        if (!out.constrained() && of_slot_[out.triangle()] == no_index && is_member(out.triangle()))
          stack.push_back(out.triangle());
    }
  }

  using Connection = std::array<std::uint64_t, 2>;

  /// A triangle that several ranks have belongs to a component of each.
  [[nodiscard]] std::vector<Connection> connections() const {
    const std::vector<std::uint64_t> first = concatenated(lists_of_all(std::vector{share_.before}, ranks_));
    std::vector<Connection> found;
    for (const ToldTriangle& told : told_by_homes(
             delaunay_, own_, ranks_, [&](TriangleId id) { return has(id); },
             [&](TriangleId id) { return of_slot_[id]; }))
      found.push_back({first[told.home] + told.value, share_.before + of_slot_[told.id]});
    sort_without_repetitions(found);
    return found;
  }

  const LocalDelaunay& delaunay_;
  const Triangulation& t_;
  const OwnPoints& own_;
  Ranks& ranks_;
  mutable SparseAsk ask_;
  Array<Index> of_slot_;  ///< numbers on this rank, from 0
  ShareOfRank share_;     ///< components of all ranks are numbered one rank after the other
  std::vector<std::size_t> set_;
};

/// Calls visit(triangle) for the triangles of this rank that are certainly beside the exterior: an edge of the hull is
/// no constraint.
template <class Visit>
void for_each_open_to_exterior(const LocalDelaunay& delaunay, const SharedHull& hull, const Visit& visit) {
  for (const Slot& slot : delaunay.triangulation().slots) {
    if (!slot.is_ghost()) continue;
    const unsigned corner = slot.corner_of(ghost);
    const std::uint64_t from = delaunay.site(slot.to(corner)).position, to = delaunay.site(slot.from(corner)).position;
    if (!slot.n[corner].constrained() && hull.has_edge(from, to)) visit(slot.n[corner].triangle());
  }
}

/// True if the triangle contains the seed, and no segment does. (A seed at a vertex may be at the end of a segment,
/// even if no side of the triangle is a segment.)
bool is_off_segments(const Triangulation& t, const Slot& slot, Point seed) {
  if (slot.is_ghost()) return false;
  for (unsigned side = 0; side < 3; ++side) {
    const Point a = t.points[slot.from(side)], b = t.points[slot.to(side)];
    if (seed == a) return false;
    const bool is_barrier = slot.n[side].constrained() || t.slot(slot.n[side]).is_ghost();
    if (is_barrier && orient2d(a, b, seed) == 0) return false;
  }
  return true;
}

/// The sets of components in which seeds lie.
class SetsOfSeeds {
 public:
  static constexpr std::uint64_t no_set = UINT64_MAX;

  SetsOfSeeds(const LocalDelaunay& delaunay, const Components& components, Ranks& ranks, const Threads& threads)
      : t_(delaunay.triangulation()), components_(components), ranks_(ranks), threads_(threads) {
    while (t_.slots[start_].is_ghost()) ++start_;
  }

  /// Collective. no_set for a seed outside the convex hull.
  [[nodiscard]] std::vector<std::uint64_t> find(std::span<const Point> seeds) {
    struct Found {
      std::uint64_t seed, set, is_off_segments;
    };
    std::vector<Found> here;
    for (std::size_t i = 0; i < seeds.size(); ++i) {
      threads_.ask();  // a walk through a large triangulation takes long
      if (!is_usable(seeds[i])) continue;
      const TriangleId id = locate(t_, seeds[i], start_);
      if (components_.has(id))
        here.push_back({i, components_.set_of(id), is_off_segments(t_, t_.slots[id], seeds[i]) ? 1U : 0U});
    }
    std::vector<std::uint64_t> sets(seeds.size(), no_set);
    // Several ranks may have the triangle in which a seed lies.
    for (const Found& each : concatenated(lists_of_all(here, ranks_))) {
      if (each.seed >= sets.size() || each.set >= components_.size()) throw Reader::does_not_match();
      sets[each.seed] = each.set;
      are_off_segments_ = are_off_segments_ && each.is_off_segments != 0;
    }
    return sets;
  }
  /// False if a seed may be on a segment.
  [[nodiscard]] bool are_off_segments() const { return are_off_segments_; }

 private:
  const Triangulation& t_;
  const Components& components_;
  Ranks& ranks_;
  Threads threads_;
  TriangleId start_ = 0;
  bool are_off_segments_ = true;
};

}  // namespace

Labels::Labels(const LocalDelaunay& delaunay, const OwnPoints& own, const SharedHull& hull, const DomainRules& rules,
               Ranks& ranks, const Threads& threads)
    : delaunay_(delaunay) {
  const Triangulation& t = delaunay.triangulation();
  of_slot_ = Array<Index>(t.slots.size(), no_index);
  if (rules.convex_hull && rules.holes.empty() && rules.region_seeds.empty()) return;
  const Components components(delaunay, own, ranks, threads);
  // What is outside stays outside. Of several seeds of regions, the last one counts.
  std::vector<Index> label(components.size(), no_index);
  if (!rules.convex_hull) {
    std::vector<std::uint64_t> here;
    for_each_open_to_exterior(delaunay, hull, [&](TriangleId id) {
      if (components.has(id)) here.push_back(components.set_of(id));
    });
    sort_without_repetitions(here);
    for (const std::uint64_t set : concatenated(lists_of_all(here, ranks))) label[set] = outside;
  }
  const std::vector<Index> exterior = label;
  SetsOfSeeds sets(delaunay, components, ranks, threads);
  for (const std::uint64_t set : sets.find(rules.holes))
    if (set == SetsOfSeeds::no_set || exterior[set] == outside)
      are_certainly_valid_ = false;
    else
      label[set] = outside;
  const std::vector<std::uint64_t> of_regions = sets.find(rules.region_seeds);
  for (Index r = 0; r < of_regions.size(); ++r)
    if (const std::uint64_t set = of_regions[r]; set == SetsOfSeeds::no_set || label[set] != no_index)
      are_certainly_valid_ = false;
    else
      label[set] = r;
  const bool is_empty = std::ranges::all_of(components.sets(), [&](std::size_t set) { return label[set] == outside; });
  are_certainly_valid_ = are_certainly_valid_ && sets.are_off_segments() && !is_empty;
  for (TriangleId id = 0; id < t.slots.size(); ++id)
    if (components.has(id)) of_slot_[id] = label[components.set_of(id)];
  ask_about_sides(own, ranks);
}

bool Labels::is_in_domain_beyond(const Slot& slot, unsigned side) const {
  const TriangleId id = slot.n[side].triangle();
  if (delaunay_.has_own_corner(id)) return is_in_domain(id);
  return !std::ranges::binary_search(sides_outside_, beyond(slot, side));
}

/// The owner of the first end of a side knows the triangle on its left.
void Labels::ask_about_sides(const OwnPoints& own, Ranks& ranks) {
  const Triangulation& t = delaunay_.triangulation();
  std::vector<Side> asked, outside_here;
  for (TriangleId id = 0; id < t.slots.size(); ++id) {
    const Slot& slot = t.slots[id];
    if (slot.is_ghost() || !slot.any_constrained() || !delaunay_.has_own_corner(id)) continue;
    for (unsigned side = 0; side < 3; ++side) {
      const TriangleId across = slot.n[side].triangle();
      if (!slot.n[side].constrained() || t.slots[across].is_ghost()) continue;
      if (!delaunay_.has_own_corner(across))
        asked.push_back(beyond(slot, side));
      else if (of_slot_[across] == outside && delaunay_.is_own(slot.to(side)))
        outside_here.push_back(beyond(slot, side));
    }
  }
  std::ranges::sort(outside_here);
  const std::vector<char> answers = answers_of_ranks<char>(
      asked, 1, ranks, [&](std::size_t i) { return own.owner(asked[i].from); },
      [&](const std::vector<Side>& sides) {
        std::vector<char> are_outside;
        are_outside.reserve(sides.size());
        for (const Side& side : sides) are_outside.push_back(std::ranges::binary_search(outside_here, side) ? 1 : 0);
        return are_outside;
      });
  for (std::size_t i = 0; i < asked.size(); ++i)
    if (answers[i] != 0) sides_outside_.push_back(asked[i]);
  std::ranges::sort(sides_outside_);
}

}  // namespace pardel::engine
