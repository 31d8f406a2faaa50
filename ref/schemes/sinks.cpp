#include "sinks.hpp"

#include "mesh/predicates.hpp"

namespace pardel::schemes {

std::optional<Side> flow(const LinkedMesh& mesh, Index t) {
  for (int i = 0; i < 3; ++i) {
    const auto [a, b] = ends(mesh, {t, i});
    // Thales: the angle is obtuse if its corner lies strictly inside the circle whose diameter is the side.
    if (CGAL::side_of_bounded_circle(filtered(mesh.points[a]), filtered(mesh.points[b]), filtered(mesh.corner(t, i))) ==
        CGAL::ON_BOUNDED_SIDE)
      return Side{t, i};
  }
  return std::nullopt;
}

std::vector<Index> walk_to_sink(const LinkedMesh& mesh, Index t) {
  std::vector<Index> walk = {t};
  while (const auto side = flow(mesh, walk.back())) {
    if (is_constrained(mesh, *side)) break;
    walk.push_back(mesh.faces[side->triangle].n[side->i]);
  }
  return walk;
}

std::optional<Insertion> sink_insertion(const LinkedMesh& mesh, Index t, const Bounds& bounds, std::uint64_t& read) {
  if (const auto side = encroached_side(mesh, t)) return split_of(mesh, *side, bounds.small_angles());
  if (!bounds.is_large(mesh, t) && !bounds.is_thin(mesh, t)) return std::nullopt;
  const std::vector<Index> walk = walk_to_sink(mesh, t);
  read += walk.size();
  const auto stopped_at = flow(mesh, walk.back());
  std::optional<Insertion> found = stopped_at ? split_of(mesh, *stopped_at, bounds.small_angles())
                                              : circumcentre_insertion(mesh, walk.back(), bounds);
  if (found) found->triangle = t;
  return found;
}

RoundRules rules_of_sinks(Independence when) {
  RoundRules rules = rules_of_independent_cavities(when);
  rules.propose = sink_insertion;
  return rules;
}

Result<Outcome> sinks(const Problem& problem, Independence when) {
  return refine_in_rounds(problem, rules_of_sinks(when));
}

}  // namespace pardel::schemes
