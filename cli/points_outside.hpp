// Points of the input that are in no triangle.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "../core/mesh.hpp"

namespace pardel::cli {

/// The vertices of a mesh that are in no triangle. In the mesh of a domain they are the points of the input outside the
/// domain and in holes.
struct PointsOutside {
  std::size_t count = 0;
  std::optional<Point> first{};  ///< empty if there are none, or if nobody knows which is the first
};
/// O(n).
[[nodiscard]] PointsOutside points_outside(const Mesh& mesh);

/// A note with their number, without the name of the file; empty if there are none. `of_domain`: the mesh is that of a
/// domain. `then`: what becomes of them, or what can be done.
[[nodiscard]] std::string note_about(const PointsOutside& outside, bool of_domain, std::string_view then);

}  // namespace pardel::cli
