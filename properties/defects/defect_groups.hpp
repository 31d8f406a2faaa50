// The groups of defects, and helpers that find a place for a defect.
#pragma once

#include <span>

#include "defects.hpp"
#include "edit.hpp"

namespace pardel::defects {

[[nodiscard]] std::span<const Defect> defects_of_arrays();
[[nodiscard]] std::span<const Defect> defects_of_topology();
[[nodiscard]] std::span<const Defect> defects_of_coverage();
[[nodiscard]] std::span<const Defect> defects_of_geometry();
[[nodiscard]] std::span<const Defect> defects_of_labels();
[[nodiscard]] std::span<const Defect> defects_of_goals();

/// Calls attempt(place) for the places 0 to n - 1 in cyclic order, from a place that depends on the seed, until an
/// attempt returns true. Returns false if no attempt does.
template <class Attempt>
bool at_some(std::size_t n, std::uint64_t seed, const Attempt& attempt) {
  const std::uint64_t start = seed * 0x9e3779b97f4a7c15 >> 20;
  for (std::size_t k = 0; k < n; ++k)
    if (attempt(static_cast<Index>((start + k) % n))) return true;
  return false;
}

template <class Attempt>
bool at_some_triangle(const Mesh& mesh, std::uint64_t seed, const Attempt& attempt) {
  return at_some(mesh.triangles.size(), seed, attempt);
}

template <class Attempt>
bool at_some_side(const Mesh& mesh, std::uint64_t seed, const Attempt& attempt) {
  return at_some(3 * mesh.triangles.size(), seed, [&](Index k) {
    return attempt(edit::Side{k / 3, static_cast<int>(k % 3)});
  });
}

template <class Attempt>
bool at_some_vertex(const Mesh& mesh, std::uint64_t seed, const Attempt& attempt) {
  return at_some(mesh.points.size(), seed, attempt);
}

[[nodiscard]] inline bool is_interior(const Mesh& mesh, Index v) { return mesh.origin[v] == interior_vertex; }
/// True for a vertex that the mesher put on an input segment.
[[nodiscard]] inline bool is_on_segment(const Pslg& pslg, const Mesh& mesh, Index v) {
  return segment_of_origin(mesh.origin[v]) < pslg.segments.size();
}
/// A number below n that depends on the seed. It is practically independent of the first place in at_some().
/// Precondition: n > 0.
[[nodiscard]] inline Index another(std::uint64_t seed, std::size_t n) {
  return static_cast<Index>((seed * 0xd1342543de82ef95 >> 24) % n);
}

}  // namespace pardel::defects
