// Random problems whose domains mix scales (domains/generators/mixed_scales.hpp).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "../../domains/generators/mixed_scales.hpp"
#include "meshing.hpp"

namespace pardel::properties {

inline constexpr const char* mixed_families =
    "lattice domains of every family, random goals; far points, a huge outline, a component up to 2^60 times smaller "
    "beside the domain, in a hole or in a face, a component far off, or a tiny feature";

/// Mixtures of two components, each with an outline of its own. No face lies between them.
inline const std::vector<generators::Mixture> mixtures_of_components{generators::Mixture::component_beside,
                                                                     generators::Mixture::component_in_hole,
                                                                     generators::Mixture::component_far_off};

/// A problem with a mixed domain, and how it was mixed.
struct MixedProblem {
  Problem problem;
  generators::Mixed mixed;
};

/// Two domains, a goal, and the seed of the mixture.
struct Ingredients {
  generators::Case one;
  generators::LatticeDomain other;
  std::uint64_t seed = 0;
};
[[nodiscard]] inline Ingredients any_ingredients(generators::Random& random, int size) {
  Ingredients drawn{generators::any_case(random, size), {}, 0};
  drawn.other = random.chance(2) ? drawn.one.domain : generators::any_domain(random, size / 2);
  drawn.seed = random.next();
  return drawn;
}
[[nodiscard]] inline std::vector<Ingredients> shrinks(const Ingredients& drawn) {
  std::vector<Ingredients> simpler;
  for (generators::Case& one : generators::shrinks(drawn.one))
    simpler.push_back({std::move(one), drawn.other, drawn.seed});
  for (generators::LatticeDomain& other : generators::shrinks(drawn.other))
    simpler.push_back({drawn.one, std::move(other), drawn.seed});
  return simpler;
}

/// A random problem that mixes scales in one of the given ways. Tags the case with the mixtures. Domains that cannot be
/// mixed are discarded. `smaller`: the domain has so many times fewer points than those of other properties.
inline MixedProblem some_mixed_problem(Exhibit& exhibit,
                                       const std::vector<generators::Mixture>& mixtures = generators::all_mixtures(),
                                       int smaller = 2) {
  const auto make = [smaller](generators::Random& random, int size) { return any_ingredients(random, size / smaller); };
  const Ingredients drawn = *generators::generator(make, [](const Ingredients& simpler) { return shrinks(simpler); });
  generators::Random random(drawn.seed);
  const Problem unmixed = to_problem(drawn.one);
  MixedProblem result{unmixed, mixed_scales(unmixed.pslg, to_pslg(drawn.other), random, false, mixtures)};
  RC_PRE(!result.mixed.what.empty());
  for (const generators::Mixture mixture : result.mixed.what) RC_TAG(std::string(name(mixture)));
  result.problem.pslg = result.mixed.pslg;
  if (result.mixed.enlarges) result.problem.goal.max_area = std::numeric_limits<double>::infinity();
  exhibit.show(result.problem.pslg);
  return result;
}

/// True if an outline or a hull is more than 2^55 times as large as the distance of two points inside of it. There the
/// engine misses bounds on angles beside the two points (a known fault); properties of meshes leave such cases out.
inline bool is_vast_around_near_points(const generators::Mixed& mixed) {
  using enum generators::Mixture;
  const std::vector<generators::Mixture> inside{far_points_inside, far_points_of_hull, component_in_face, tiny_feature};
  if (std::ranges::find_first_of(mixed.what, inside) == mixed.what.end()) return false;
  const auto& [points, segments] = std::tie(mixed.pslg.points, mixed.pslg.segments);
  const auto distance = [&](Index a, Index b) {
    return std::hypot(points[a].x - points[b].x, points[a].y - points[b].y);
  };
  double longest = 0, least = std::numeric_limits<double>::infinity();
  for (const Segment& s : segments) longest = std::max(longest, distance(s.a, s.b));
  for (Index a = 0; a < points.size(); ++a)
    for (Index b = 0; b < a; ++b) {
      least = std::min(least, distance(a, b));
      if (segments.empty()) longest = std::max(longest, distance(a, b));
    }
  return longest > 0x1p55 * least;
}

}  // namespace pardel::properties
