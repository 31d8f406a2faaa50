// The target of a defect: the fields of the mesh, the input and the goal that the defect changes, and in how many
// entries.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>

namespace pardel::defects {

/// A field that a defect may change. Neighbours follow from corners: a defect that changes corners may change any
/// neighbours, too.
enum class Field : std::uint16_t {
  corners = 1 << 0,
  neighbours = 1 << 1,
  coordinates = 1 << 2,
  origins = 1 << 3,
  markers = 1 << 4,
  attributes = 1 << 5,  ///< one entry per vertex
  regions = 1 << 6,
  region_attributes = 1 << 7,
  constrained_edges = 1 << 8,
  input_points = 1 << 9,  ///< with their attributes and markers
  input_segments = 1 << 10,
  input_holes = 1 << 11,
  input_regions = 1 << 12,
  bounds = 1 << 13,  ///< the members of the goal
};

/// A set of fields.
class Fields {
 public:
  constexpr Fields(Field field) : bits_(static_cast<std::uint16_t>(field)) {}  // NOLINT: a field is a set of fields
  constexpr Fields() = default;
  friend constexpr Fields operator|(Fields a, Fields b) { return Fields(a.bits_ | b.bits_); }
  friend constexpr bool operator==(Fields, Fields) = default;
  [[nodiscard]] constexpr bool has(Field field) const { return (bits_ & static_cast<std::uint16_t>(field)) != 0; }

 private:
  constexpr explicit Fields(int bits) : bits_(static_cast<std::uint16_t>(bits)) {}
  std::uint16_t bits_ = 0;
};
[[nodiscard]] constexpr Fields operator|(Field a, Field b) { return Fields(a) | Fields(b); }

/// The entries of a vertex in the arrays of the mesh.
inline constexpr Fields vertex_entries = Field::coordinates | Field::origins | Field::markers | Field::attributes;
/// The entries of a triangle in the arrays of the mesh.
inline constexpr Fields triangle_entries = Field::corners | Field::regions;

inline constexpr std::size_t any_number = std::numeric_limits<std::size_t>::max();

/// A defect changes at least one of these fields, and each of them in at most this number of entries.
struct Target {
  Fields fields;
  std::size_t entries = 1;
};

}  // namespace pardel::defects
