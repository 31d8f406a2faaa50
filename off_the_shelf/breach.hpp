// A breach: a way in which the answer of a mesher breaks the contract of subdomain_mesher.hpp.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "../core/pslg.hpp"

namespace pardel {

enum class BreachKind : std::uint8_t {
  failed,             ///< the mesher said so, or threw an exception
  crashed,            ///< its process ended by a signal or with an exit code that means no success
  timed_out,          ///< it did not answer in time
  unreadable,         ///< its files cannot be read
  moved_point,        ///< a point of the subdomain is missing or has other coordinates
  unusable_point,     ///< a new point is not finite, or out of the range of the exact predicates
  too_many_points,    ///< more new points than allowed
  wrong_index,        ///< a triangle names a point that does not exist, or a point an edge that does not exist
  unused_point,       ///< no triangle has the point as a corner
  wrong_orientation,  ///< a triangle is not exactly counter-clockwise
  overlap,            ///< two triangles lie on the same side of an edge
  lost_edge,          ///< an edge that must stay, or a piece of it, is no edge of a triangle
  open_edge,          ///< an edge has a triangle on one side only, and is not on the border of the subdomain
  split_frozen_edge,  ///< a new point lies on a frozen edge
  off_segment,        ///< a new point is not on the edge that it is said to split
  outside_cell,       ///< a new point lies outside the cell of the task
  too_short_edge,     ///< a new edge, also after flips to Delaunay, is shorter than the floor (Options::min_edge)
  too_near_edge,      ///< a new point lies so close to an edge that must stay that doubles hardly resolve the triangle
  other_answer,       ///< the same subdomain got another answer the second time
};
inline constexpr int breach_kinds = 19;
/// The enumerator as text: "moved_point".
[[nodiscard]] const char* name(BreachKind kind);

struct Breach {
  BreachKind kind = BreachKind::failed;
  Point where;       ///< a point at the place
  std::string what;  ///< one sentence with coordinates, or the words of the mesher
};

/// The breaches of a run: how many of each kind, and the first one.
struct Breaches {
  std::array<std::uint64_t, breach_kinds> count{};
  std::array<Breach, breach_kinds> first{};

  void add(const Breach& breach);
  [[nodiscard]] std::uint64_t of(BreachKind kind) const { return count[static_cast<std::size_t>(kind)]; }
  [[nodiscard]] std::uint64_t total() const;
};

}  // namespace pardel
