// Selects the bad triangles that a later pass processes.
#pragma once

#include <cstdint>

#include "assessor.hpp"

namespace pardel::engine {

/// A triangle that a pass left for a later one. The two keys are those of the triangle when it was deferred.
struct Deferred {
  QueuedTriangle triangle;
  std::uint16_t key;      ///< the key in the queue, of the shortest side
  std::uint16_t longest;  ///< the key of the square of the longest side

  Deferred(QueuedTriangle what, const Assessment& a)
      : triangle(what),
        key(static_cast<std::uint16_t>(a.key)),
        longest(static_cast<std::uint16_t>(BucketQueue::key(a.longest_squared))) {}
};

/// The rule by which a pass defers triangles. A finer lattice processes triangles whose longest side or whose
/// circumradius is at most the bound given here. The next round processes triangles whose key is above `last_key`.
/// Without bounds nothing is deferred.
struct Deferral {
  double longest_squared = 0;  ///< a bound on the square of the longest side; 0: none
  double squared_radius = 0;   ///< a bound on the square of the circumradius; 0: none
  unsigned last_key = BucketQueue::last;

  /// The rule, exactly.
  [[nodiscard]] bool defers(const Assessment& a, const Measure& m) const {
    return a.longest_squared <= longest_squared || a.key > last_key ||
           (squared_radius > 0 && m.squared_circumradius() <= squared_radius);
  }
  /// A quick test that uses the rounded lengths of the keys: true only where defers() was true when the triangle was
  /// deferred. The assessment may have changed since, with a neighbour across a segment. The test ignores that. The
  /// last pass defers nothing, so it assesses every triangle that an earlier pass skipped.
  [[nodiscard]] bool defers_by_keys(const Deferred& d) const {
    const unsigned least = BucketQueue::key(longest_squared);
    return d.key > last_key || d.longest < least;
  }
};

}  // namespace pardel::engine
