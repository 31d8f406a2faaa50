// Points of the input that are in no triangle.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "../core/mesh.hpp"

namespace pardel::cli {

/// The vertices of a mesh that are in no triangle. In the mesh of a domain they are the points of the input outside the
/// domain and in holes.
struct PointsOutside {
  std::size_t count = 0;
  std::uint64_t number = 0;  ///< of the first of them
  Point first{};             ///< its place; without meaning if there are none

  /// Adds those of another part of the mesh.
  void add(const PointsOutside& other);
};
/// `numbers`: of the points, if the mesh is a part of another one; else they are the indices. O(n).
[[nodiscard]] PointsOutside points_outside(const Mesh& mesh, std::span<const std::uint64_t> numbers = {});

/// A note with their number, without the name of the file; empty if there are none. `of_domain`: the mesh is that of a
/// domain. `then`: what becomes of them, or what can be done.
[[nodiscard]] std::string note_about(const PointsOutside& outside, bool of_domain, std::string_view then);

}  // namespace pardel::cli
