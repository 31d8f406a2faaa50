// Domains in which points and segments are repeated, as files of drawings have them.
#pragma once

#include <utility>

#include "../../../core/pslg.hpp"
#include "../framework/property.hpp"

namespace pardel::properties {

/// Inserts a point again, somewhere behind itself, with a marker and attributes of its own. Returns its index.
inline Index add_copy(Pslg& pslg, Index of) {
  const Index at = *rc::gen::inRange<Index>(of + 1, static_cast<Index>(pslg.points.size()) + 1);
  const std::size_t k = pslg.attributes_per_point;
  pslg.points.insert(pslg.points.begin() + at, pslg.points[of]);
  if (!pslg.point_markers.empty())
    pslg.point_markers.insert(pslg.point_markers.begin() + at, *rc::gen::inRange(-9, 10));
  pslg.point_attributes.insert(pslg.point_attributes.begin() + static_cast<std::ptrdiff_t>(at * k), k, 0.125);
  for (Segment& s : pslg.segments)
    for (Index* end : {&s.a, &s.b})
      if (*end >= at) ++*end;
  return at;
}

inline Index some_point(const Pslg& pslg) {
  return *rc::gen::inRange<Index>(0, static_cast<Index>(pslg.points.size()));
}

struct Repetitions {
  Pslg with_copies;
  Pslg repaired;  ///< what repair has to make of it
};

/// Repeats one to five points with other data, and as many segments with other markers. Some segments end at the
/// copies. Repair keeps the data of the first of equal points, and the first marker of equal segments that is not 0.
inline Repetitions some_repetitions(const Pslg& pslg) {
  Pslg with_copies = pslg, repaired = pslg;
  for (int copies = *rc::gen::inRange(1, 6); copies > 0; --copies) {
    const Index original = some_point(with_copies), copy = add_copy(with_copies, original);
    for (Segment& s : with_copies.segments)
      for (Index* end : {&s.a, &s.b})
        if (*end == original && *rc::gen::arbitrary<bool>()) *end = copy;
    if (pslg.segments.empty()) continue;
    const auto which = *rc::gen::inRange<std::size_t>(0, pslg.segments.size());
    Segment& once = repaired.segments[which];
    Segment again{with_copies.segments[which].a, with_copies.segments[which].b, *rc::gen::inRange(-2, 3)};
    if (*rc::gen::arbitrary<bool>()) std::swap(again.a, again.b);
    with_copies.segments.push_back(again);
    if (once.marker == 0) once.marker = again.marker;
  }
  with_copies.has_segment_markers = repaired.has_segment_markers = true;
  return {std::move(with_copies), std::move(repaired)};
}

}  // namespace pardel::properties
