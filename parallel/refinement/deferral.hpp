// Selects the bad triangles that a later pass processes.
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "assessor.hpp"

namespace pardel::engine {

/// A triangle that a pass left for a later pass. The two keys are the values at the time when it was deferred.
struct Deferred {
  QueuedTriangle triangle;
  std::uint16_t key;      ///< the key in the queue, from the shortest side
  std::uint16_t longest;  ///< the key of the square of the longest side

  Deferred(QueuedTriangle what, const Assessment& a)
      : triangle(what),
        key(static_cast<std::uint16_t>(a.key)),
        longest(static_cast<std::uint16_t>(BucketQueue::key(a.longest_squared))) {}
  /// With keys that another rank has computed.
  Deferred(QueuedTriangle what, std::uint16_t its_key, std::uint16_t its_longest)
      : triangle(what), key(its_key), longest(its_longest) {}
};

/// The rule by which a pass defers triangles. It defers a triangle to a finer level if the longest side or the
/// circumradius is at most the bound given here. It defers a triangle to the next pass on the same level if its key
/// is above `last_key`. By default nothing is deferred.
struct Deferral {
  double longest_squared = 0;  ///< a bound on the square of the longest side; 0: no bound
  double squared_radius = 0;   ///< a bound on the square of the circumradius; 0: no bound
  unsigned last_key = BucketQueue::last;

  /// The rule, evaluated with the lengths themselves.
  [[nodiscard]] bool defers(const Assessment& a, const Measure& m) const {
    return a.longest_squared <= longest_squared || a.key > last_key ||
           (squared_radius > 0 && m.squared_circumradius() <= squared_radius);
  }
  /// A quick test with the rounded lengths in the keys. True only if defers() was true when the triangle was deferred.
  /// The assessment can have changed since, together with a neighbour across a segment; the test ignores such changes.
  /// The last pass defers nothing, so it assesses every triangle that an earlier pass skipped.
  [[nodiscard]] bool defers_by_keys(const Deferred& d) const {
    const unsigned least = BucketQueue::key(longest_squared);
    return d.key > last_key || d.longest < least;
  }
};

/// The rules of a pass: one for all cells, or one for each cell.
class Deferrals {
 public:
  Deferrals(const Deferral& everywhere = {}) : rules_{everywhere}, weakest_(everywhere) {}
  explicit Deferrals(std::vector<Deferral> per_cell) : rules_(std::move(per_cell)) {
    weakest_ = rules_.front();
    for (const Deferral& rule : rules_) {
      weakest_.longest_squared = std::min(weakest_.longest_squared, rule.longest_squared);
      weakest_.squared_radius = std::min(weakest_.squared_radius, rule.squared_radius);
      weakest_.last_key = std::max(weakest_.last_key, rule.last_key);
    }
  }

  [[nodiscard]] bool same_everywhere() const { return rules_.size() == 1; }
  [[nodiscard]] const Deferral& of(Index cell) const { return rules_[same_everywhere() ? 0 : cell]; }
  /// A rule that defers only what all rules defer.
  [[nodiscard]] const Deferral& weakest() const { return weakest_; }

 private:
  std::vector<Deferral> rules_;
  Deferral weakest_;
};

}  // namespace pardel::engine
