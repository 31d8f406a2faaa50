// Which bad triangles wait for a later pass.
#pragma once

#include <cstdint>

#include "assessor.hpp"

namespace pardel::engine {

/// A triangle that a pass left for a later one, with its key in the queue and the key of the square of its longest
/// side, as they were then.
struct Deferred {
  Queued triangle;
  std::uint16_t key, longest;

  Deferred(Queued what, const Assessment& a)
      : triangle(what),
        key(static_cast<std::uint16_t>(a.key)),
        longest(static_cast<std::uint16_t>(BucketQueue::key(a.longest_squared))) {}
};

/// What a pass leaves for a later one: triangles no longer than `longest_squared`, or whose circumradius is at most
/// this, wait for a finer lattice, those whose key is above `last_key` for the next round.
struct Deferral {
  double longest_squared = 0;
  double squared_radius = 0;
  unsigned last_key = BucketQueue::last;
  [[nodiscard]] bool applies_to(const Assessment& a, const Measure& m) const {
    return a.longest_squared <= longest_squared || a.key > last_key ||
           (squared_radius > 0 && m.squared_circumradius() <= squared_radius);
  }
  /// By the keys alone. A neighbour across a segment may have changed since what the triangle asks for; whatever is
  /// passed over for that, the last pass looks at.
  [[nodiscard]] bool applied_to(const Deferred& d) const {
    const unsigned least = BucketQueue::key(longest_squared);
    return d.key > last_key || d.longest < least;
  }
};

}  // namespace pardel::engine
