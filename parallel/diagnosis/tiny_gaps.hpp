// The gaps that a repair may close by default.
#pragma once

#include "../../core/support/stop_signal.hpp"
#include "../segments/snapping.hpp"
#include "../validate.hpp"
#include "extents_by_scale.hpp"

namespace pardel::engine {

/// The widths below which gaps are tiny.
class TinyDistances {
 public:
  explicit TinyDistances(const Pslg& pslg) { add(pslg); }
  /// Adds segments; if there are none, points. Segments with ends that are out of range are ignored.
  void add(const Pslg& pslg);

  /// The same at all scales (reach.hpp) with one power of two: 2^-30 of the largest one, or a millionth of the extent
  /// of the segments with this power of two, or the next one above or below, if that is smaller.
  [[nodiscard]] double at(double scale) const;
  /// The largest one for a segment; without segments, for a point.
  [[nodiscard]] double largest() const;
  /// The largest scale with the same power of two; `scale` itself if no segment has such a scale.
  [[nodiscard]] double largest_like(double scale) const { return extents_.largest_like(scale); }

 private:
  ExtentsByScale extents_;  ///< of the segments; without segments, of the points
};

/// Widens the snapping distances at the scales of tiny gaps, to close the narrowest of them. These gaps are much
/// narrower than the segments around them. Small features, which consist of small segments, are not among them.
/// `original` is the domain before the repair. False if there are no such gaps, or if the distances are as large
/// already as they may be.
[[nodiscard]] bool widen_to_tiny_gaps(Snapping& snapping, const Pslg& original, const ValidPslg& domain,
                                      StopSignal& stop);

}  // namespace pardel::engine
