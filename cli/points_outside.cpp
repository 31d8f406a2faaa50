#include "points_outside.hpp"

#include <fmt/core.h>

#include <vector>

#include "../core/support/used_vertices.hpp"
#include "plural.hpp"

namespace pardel::cli {

void PointsOutside::add(const PointsOutside& other) {
  if (other.count > 0 && (count == 0 || other.number < number)) {
    number = other.number;
    first = other.first;
  }
  count += other.count;
}

PointsOutside points_outside(const Mesh& mesh, std::span<const std::uint64_t> numbers) {
  const std::vector<char> used = used_vertices(mesh);
  PointsOutside outside;
  for (std::size_t v = 0; v < used.size(); ++v)
    if (used[v] == 0) outside.add({1, numbers.empty() ? v : numbers[v], mesh.points[v]});
  return outside;
}

std::string note_about(const PointsOutside& outside, bool of_domain, std::string_view then) {
  if (outside.count == 0) return {};
  const bool one = outside.count == 1;
  const Point p = outside.first;
  const std::string where = fmt::format("{} at ({}, {}){}", one ? "" : ", the first", p.x, p.y, one ? "" : ",");
  const char* why =
      one ? ", because it lies outside the domain or in a hole" : ", because they lie outside the domain or in a hole";
  return fmt::format("note: {}{} {} in no triangle{}; {}", plural(outside.count, "point"), where, one ? "is" : "are",
                     of_domain ? why : "", then);
}

}  // namespace pardel::cli
