// Channels with a bound on edge lengths that depends on the place: the meshes are graded.
#pragma once

#include <cmath>
#include <ostream>
#include <vector>

#include "../../../ref/decomposition/cell_refiner.hpp"
#include "refined_channels.hpp"

namespace pardel::properties {

/// Edges are at most `least` long at a point, and longer by `growth` times the distance from it.
struct GradedChannel {
  Channel channel;
  Point finest;
  double least = 1;
  double growth = 0.25;
};

inline std::ostream& operator<<(std::ostream& out, const GradedChannel& g) {
  return out << g.channel << ", edges up to " << g.least << " at (" << g.finest.x << ", " << g.finest.y << ") and "
             << g.growth << " times the distance more";
}

/// `coarseness` times the lengths.
[[nodiscard]] inline Goal goal_of(const GradedChannel& graded, double coarseness = 1) {
  Goal goal;
  goal.conforming = true;
  goal.region_caps = false;
  goal.size = [graded, coarseness](Point p) {
    return coarseness * (graded.least + graded.growth * std::hypot(p.x - graded.finest.x, p.y - graded.finest.y));
  };
  return goal;
}

[[nodiscard]] inline GradedChannel random_graded_channel(generators::Random& random, int size) {
  GradedChannel graded{random_channel(random, size), {}, 0, 0};
  const Pslg pslg = to_pslg(graded.channel);
  graded.finest = random.one_of(pslg.points);
  graded.least = 0.25 * random.between(3, 6);
  graded.growth = 0.0625 * random.between(3, 5);
  return graded;
}

[[nodiscard]] inline std::vector<GradedChannel> simpler(const GradedChannel& graded) {
  std::vector<GradedChannel> all;
  for (const Channel& channel : simpler(graded.channel)) {
    all.push_back(graded);
    all.back().channel = channel;
  }
  return all;
}

inline GradedChannel some_graded_channel(Exhibit& exhibit) {
  const auto simpler_ones = [](const GradedChannel& g) { return simpler(g); };
  const GradedChannel graded = *generators::generator(random_graded_channel, simpler_ones);
  RC_TAG(std::string(name(graded.channel.shape)));
  exhibit.show(to_pslg(graded.channel));
  return graded;
}

/// The refinement on quadtrees, in which the leaves of a phase take turns. The preprocessing makes edges half as long
/// again.
inline ref::QuadtreeRefinement refined_in_turns(const GradedChannel& graded, const ref::Turns& turns) {
  auto result = ref::refine_on_quadtree(to_pslg(graded.channel), goal_of(graded), goal_of(graded, 1.5), turns);
  if (!result) RC_FAIL(result.error().message);
  return std::move(*result);
}

}  // namespace pardel::properties
