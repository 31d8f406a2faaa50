// The triangles of a mesh that do not satisfy the goal, in words.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "../core/mesh.hpp"
#include "../parallel/report.hpp"

namespace pardel::cli {

/// A triangle that misses the goal for a reason that no small input angle justifies.
struct MissedTriangle {
  std::uint64_t number = 0;  ///< in the whole mesh, from 0
  ExemptReason reason{};
  std::array<Point, 3> corners{};
};

struct ExemptTriangles {
  std::array<std::uint64_t, exempt_reasons> counts{};  ///< by ExemptReason
  std::vector<MissedTriangle> first;                   ///< at most most_listed (verdict.hpp), in ascending order

  /// The number of those that no small input angle justifies.
  [[nodiscard]] std::uint64_t missed() const;
  /// Adds those of another part of the mesh.
  void add(const ExemptTriangles& other);
};

/// Those of a mesh, or of a part of it that begins with the triangle `first_number`. O(Report::exempt).
[[nodiscard]] ExemptTriangles exempt_triangles(const Report& report, const Mesh& mesh, std::uint64_t first_number = 0);

/// The numbers by reason, for example "2 nestled, 1 seditious": either those that are justified, or the others.
[[nodiscard]] std::string reasons(const ExemptTriangles& exempt, bool justified_ones);

/// Describes the triangles that miss the goal for a reason that no small input angle justifies: their number by reason,
/// then the corners of the first ones, then the number of the others. `limit` is the option that limits the vertices.
/// If `all_in` is not empty, the text names it as the place that lists all of them. Returns an empty text if there is
/// no such triangle.
[[nodiscard]] std::string missed_bounds(const ExemptTriangles& exempt, std::string_view limit,
                                        std::string_view all_in = {});

}  // namespace pardel::cli
