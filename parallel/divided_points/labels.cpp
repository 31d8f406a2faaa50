#include "labels.hpp"

#include <numeric>

#include "../../core/support/exchange_lists.hpp"
#include "../../core/support/share_of_rank.hpp"
#include "../triangulation/locate.hpp"
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
  /// Equal for two triangles of any ranks if they are connected. Precondition: has(id).
  [[nodiscard]] std::size_t set_of(TriangleId id) const { return set_[share_.before + of_slot_[id]]; }
  [[nodiscard]] std::size_t size() const { return set_.size(); }

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
    std::ranges::sort(found);
    found.erase(std::unique(found.begin(), found.end()), found.end());
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

/// All triangles of a set have this label.
struct LabelOfSet {
  std::uint64_t set;
  Index label;
  Index unused = 0;
};

struct TravellingSide {
  std::uint64_t from, to;
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

}  // namespace

Labels::Labels(const LocalDelaunay& delaunay, const OwnPoints& own, const SharedHull& hull, const DomainRules& rules,
               Ranks& ranks, const Threads& threads) {
  const Triangulation& t = delaunay.triangulation();
  of_slot_ = Array<Index>(t.slots.size(), no_index);
  if (rules.convex_hull && rules.holes.empty() && rules.region_seeds.empty()) return;
  const Components components(delaunay, own, ranks, threads);
  std::vector<LabelOfSet> here;
  const auto label_set_of = [&](TriangleId id, Index label) {
    if (components.has(id)) here.push_back({components.set_of(id), label});
  };
  if (!rules.convex_hull) for_each_open_to_exterior(delaunay, hull, [&](TriangleId id) { label_set_of(id, outside); });
  TriangleId start = 0;
  while (t.slots[start].is_ghost()) ++start;
  const auto label_face_of = [&](Point seed, Index label) {
    threads.ask();  // a walk through a large triangulation takes long
    label_set_of(locate(t, seed, start), label);
  };
  for (const Point hole : rules.holes) label_face_of(hole, outside);
  for (Index r = 0; r < rules.region_seeds.size(); ++r) label_face_of(rules.region_seeds[r], r);

  // What is outside stays outside. Of several seeds, the last one counts.
  std::vector<Index> label(components.size(), no_index);
  for (const LabelOfSet& each : concatenated(lists_of_all(here, ranks))) {
    Index& present = label[each.set];
    if (each.label == outside || present == no_index || (present != outside && each.label > present))
      present = each.label;
  }
  for (TriangleId id = 0; id < t.slots.size(); ++id)
    if (components.has(id)) of_slot_[id] = label[components.set_of(id)];
  share_sides_outside(delaunay, ranks);
}

/// The owner of the first end of a constrained edge knows the triangle beside it.
void Labels::share_sides_outside(const LocalDelaunay& delaunay, Ranks& ranks) {
  const Triangulation& t = delaunay.triangulation();
  std::vector<TravellingSide> here;
  for (TriangleId id = 0; id < t.slots.size(); ++id) {
    const Slot& slot = t.slots[id];
    if (of_slot_[id] != outside || !slot.any_constrained()) continue;
    for (unsigned side = 0; side < 3; ++side)
      if (slot.n[side].constrained() && delaunay.is_own(slot.from(side)))
        here.push_back({delaunay.site(slot.from(side)).position, delaunay.site(slot.to(side)).position});
  }
  for (const TravellingSide& side : concatenated(lists_of_all(here, ranks)))
    sides_outside_.emplace_back(side.from, side.to);
  std::ranges::sort(sides_outside_);
}

}  // namespace pardel::engine
