#include "rounds.hpp"

#include <algorithm>
#include <numeric>

namespace pardel::schemes {
namespace {

/// Disks of one class differ in their radii by a factor of less than two.
constexpr double squared_ratio_of_class = 4;

double distance_squared(Point p, Point q) { return (p.x - q.x) * (p.x - q.x) + (p.y - q.y) * (p.y - q.y); }

/// The candidates that take part, in the order in which they are considered.
std::vector<std::size_t> participants(const std::vector<Candidate>& candidates, const std::vector<double>& radii,
                                      const RoundChoices& choices) {
  std::vector<std::size_t> order = by_priority(candidates);
  if (choices.batch == Batch::largest_class) {
    const double largest = *std::ranges::max_element(radii);
    std::erase_if(order, [&](std::size_t k) { return radii[k] * squared_ratio_of_class <= largest; });
  }
  if (choices.priority == Priority::largest_first)
    std::ranges::stable_sort(order, std::greater<>{}, [&](std::size_t k) { return radii[k]; });
  return order;
}

}  // namespace

double squared_radius(const LinkedMesh& mesh, const Insertion& insertion) {
  if (!insertion.splits_segment()) return distance_squared(insertion.point, mesh.corner(insertion.triangle, 0));
  const auto [a, b] = ends(mesh, insertion.split);
  return std::min(distance_squared(insertion.point, mesh.points[a]), distance_squared(insertion.point, mesh.points[b]));
}

bool conflict(const LinkedMesh& mesh, const Insertion& p, const Insertion& q) {
  return distance_squared(p.point, q.point) < std::min(squared_radius(mesh, p), squared_radius(mesh, q));
}

Chosen centres_apart(const LinkedMesh& mesh, const std::vector<Candidate>& candidates, const RoundChoices& choices) {
  std::vector<double> radii;
  for (const Candidate& c : candidates) radii.push_back(squared_radius(mesh, c.insertion));
  // Of each triangle: the chosen candidates whose cavities contain it, and the depth of the decisions about it.
  std::vector<std::vector<std::size_t>> chosen_at(mesh.faces.size());
  std::vector<std::uint64_t> depth_at(mesh.faces.size(), 0);
  Chosen chosen;
  for (const std::size_t k : participants(candidates, radii, choices)) {
    const std::vector<Index>& cavity = candidates[k].insertion.cavity.triangles;
    std::uint64_t depth = 0;
    bool is_apart = true;
    for (const Index t : cavity) {
      depth = std::max(depth, depth_at[t]);
      for (const std::size_t other : chosen_at[t])
        is_apart = is_apart && distance_squared(candidates[k].insertion.point, candidates[other].insertion.point) >=
                                   std::min(radii[k], radii[other]);
    }
    for (const Index t : cavity) depth_at[t] = depth + 1;
    chosen.depth = std::max(chosen.depth, depth + 1);
    if (!is_apart) continue;
    for (const Index t : cavity) chosen_at[t].push_back(k);
    chosen.candidates.push_back(k);
  }
  std::ranges::stable_sort(chosen.candidates, std::greater<>{}, [&](std::size_t k) { return radii[k]; });
  return chosen;
}

RoundRules rules_of_rounds(const RoundChoices& choices) {
  const auto propose = [](const LinkedMesh& mesh, Index t, const Bounds& bounds, std::uint64_t&) {
    return insertion_for(mesh, t, bounds);
  };
  const auto choose = [choices](const LinkedMesh& mesh, const std::vector<Candidate>& candidates) {
    return centres_apart(mesh, candidates, choices);
  };
  return {propose, choose};
}

Result<Outcome> rounds(const Problem& problem, const RoundChoices& choices) {
  return refine_in_rounds(problem, rules_of_rounds(choices));
}

}  // namespace pardel::schemes
