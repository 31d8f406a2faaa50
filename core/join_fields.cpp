#include "join_fields.hpp"

#include <algorithm>
#include <limits>

#include "support/same_attribute.hpp"

namespace pardel {
namespace {

constexpr double no_value = std::numeric_limits<double>::quiet_NaN();

bool is_same_field(const Field& f, const Field& g) {
  return f.name == g.name && f.place == g.place && f.components == g.components && is_same_attribute(f.time, g.time);
}

/// Copies the values of a piece whose first triangle is `first_triangle` of the whole mesh.
void copy_values(const Field& from, const NumberedMesh& piece, std::size_t first_triangle, Field& to) {
  const std::size_t k = to.components;
  const auto copy = [&](std::size_t source, std::size_t target) {
    for (std::size_t c = 0; c < k; ++c) {
      double& value = to.values[target * k + c];
      if (value != value) value = from.values[source * k + c];
    }
  };
  if (to.place == Field::Place::points) {
    for (std::size_t v = 0; v < piece.number.size(); ++v) copy(v, piece.number[v]);
  } else {
    for (std::size_t t = 0; t < piece.mesh.triangles.size(); ++t) copy(t, first_triangle + t);
  }
}

}  // namespace

std::vector<Field> join_fields(std::span<const NumberedMesh* const> pieces, std::size_t points) {
  std::size_t triangles = 0;
  for (const NumberedMesh* piece : pieces) triangles += piece->mesh.triangles.size();
  std::vector<Field> joined;
  std::size_t first_triangle = 0;
  for (const NumberedMesh* piece : pieces) {
    for (const Field& field : piece->mesh.fields) {
      auto place = std::ranges::find_if(joined, [&](const Field& other) { return is_same_field(other, field); });
      if (place == joined.end()) {
        const std::size_t places = field.place == Field::Place::points ? points : triangles;
        joined.push_back({field.name, field.place, field.components, Array<double>(places * field.components, no_value),
                          field.time});
        place = joined.end() - 1;
      }
      copy_values(field, *piece, first_triangle, *place);
    }
    first_triangle += piece->mesh.triangles.size();
  }
  return joined;
}

std::vector<GroupName> join_names(std::span<const NumberedMesh* const> pieces) {
  std::vector<GroupName> joined;
  for (const NumberedMesh* piece : pieces)
    for (const GroupName& name : piece->mesh.names) {
      const auto is_named = [&](const GroupName& other) { return other.of == name.of && other.value == name.value; };
      if (std::ranges::none_of(joined, is_named)) joined.push_back(name);
    }
  return joined;
}

}  // namespace pardel
