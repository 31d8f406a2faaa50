#include "independent_cavities.hpp"

#include <algorithm>

#include "mesh/predicates.hpp"

namespace pardel::schemes {
namespace {

constexpr std::size_t none = static_cast<std::size_t>(-1);

bool has_vertex(const LinkedMesh& mesh, const Cavity& cavity, Index v) {
  return std::ranges::any_of(cavity.triangles,
                             [&](Index t) { return std::ranges::find(mesh.faces[t].v, v) != mesh.faces[t].v.end(); });
}

/// Does an unconstrained edge on both boundaries stop being locally Delaunay if both points are inserted?
bool meet_at_an_edge(const LinkedMesh& mesh, const Insertion& p, const Insertion& q) {
  return std::ranges::any_of(p.cavity.boundary, [&](Side side) {
    if (is_constrained(mesh, side) || !q.cavity.contains(mesh.faces[side.triangle].n[side.i])) return false;
    const auto [m, n] = ends(mesh, side);
    return in_circumdisk(mesh.points[m], mesh.points[n], p.point, q.point);
  });
}

/// What the chosen insertions have taken: vertices of closures, or triangles of cavities.
class Taken {
 public:
  Taken(const LinkedMesh& mesh, Independence when)
      : mesh_(mesh),
        when_(when),
        by_(when == Independence::closures ? mesh.points.size() : mesh.faces.size(), none),
        depth_(by_.size(), 0) {}

  /// Calls visit(place) for each place that the insertion needs.
  template <class Visit>
  void places(const Insertion& insertion, const Visit& visit) const {
    for (const Index t : insertion.cavity.triangles)
      if (when_ == Independence::exact)
        visit(t);
      else
        for (const Index v : mesh_.faces[t].v) visit(v);
  }

  /// May candidate k be taken beside those that are?
  [[nodiscard]] bool allows(const std::vector<Candidate>& candidates, std::size_t k) const {
    const Insertion& insertion = candidates[k].insertion;
    bool free = true;
    places(insertion, [&](Index place) { free = free && by_[place] == none; });
    if (when_ == Independence::closures || !free) return free;
    return std::ranges::none_of(insertion.cavity.boundary, [&](Side side) {
      const Index beyond = mesh_.faces[side.triangle].n[side.i];
      return beyond != no_index && !is_constrained(mesh_, side) && by_[beyond] != none &&
             meet_at_an_edge(mesh_, insertion, candidates[by_[beyond]].insertion);
    });
  }

  void take(const Insertion& insertion, std::size_t k) {
    places(insertion, [&](Index place) { by_[place] = k; });
  }

  /// Workers that decide in parallel wait for earlier decisions about the same places. Returns how many decisions of
  /// such a chain end with this one: the depth, one more than that of every earlier decision about one of its places.
  std::uint64_t decide(const Insertion& insertion) {
    std::uint64_t deepest = 0;
    places(insertion, [&](Index place) { deepest = std::max(deepest, depth_[place]); });
    places(insertion, [&](Index place) { depth_[place] = deepest + 1; });
    return deepest + 1;
  }

 private:
  const LinkedMesh& mesh_;
  Independence when_;
  std::vector<std::size_t> by_;
  std::vector<std::uint64_t> depth_;
};

}  // namespace

bool are_independent(const LinkedMesh& mesh, const Insertion& p, const Insertion& q, Independence when) {
  if (when == Independence::closures)
    return std::ranges::none_of(p.cavity.triangles, [&](Index t) {
      return std::ranges::any_of(mesh.faces[t].v, [&](Index v) { return has_vertex(mesh, q.cavity, v); });
    });
  const bool share = std::ranges::any_of(p.cavity.triangles, [&](Index t) { return q.cavity.contains(t); });
  return !share && !meet_at_an_edge(mesh, p, q);
}

Chosen independent_set(const LinkedMesh& mesh, const std::vector<Candidate>& candidates, Independence when) {
  Chosen chosen;
  Taken taken(mesh, when);
  for (const std::size_t k : by_priority(candidates)) {
    const Insertion& insertion = candidates[k].insertion;
    chosen.depth = std::max(chosen.depth, taken.decide(insertion));
    if (!taken.allows(candidates, k)) continue;
    taken.take(insertion, k);
    chosen.candidates.push_back(k);
  }
  return chosen;
}

RoundRules rules_of_independent_cavities(Independence when) {
  const auto propose = [](const LinkedMesh& mesh, Index t, const Bounds& bounds, std::uint64_t&) {
    return insertion_for(mesh, t, bounds);
  };
  const auto choose = [when](const LinkedMesh& mesh, const std::vector<Candidate>& candidates) {
    return independent_set(mesh, candidates, when);
  };
  return {propose, choose};
}

Result<Outcome> independent_cavities(const Problem& problem, Independence when) {
  return refine_in_rounds(problem, rules_of_independent_cavities(when));
}

}  // namespace pardel::schemes
