#include "points_outside.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <vector>

#include "../core/support/used_vertices.hpp"
#include "plural.hpp"

namespace pardel::cli {

PointsOutside points_outside(const Mesh& mesh) {
  const std::vector<char> used = used_vertices(mesh);
  PointsOutside outside;
  outside.count = static_cast<std::size_t>(std::ranges::count(used, 0));
  if (outside.count > 0)
    outside.first = mesh.points[static_cast<std::size_t>(std::ranges::find(used, 0) - used.begin())];
  return outside;
}

std::string note_about(const PointsOutside& outside, bool of_domain, std::string_view then) {
  if (outside.count == 0) return {};
  const bool one = outside.count == 1;
  const Point p = outside.first.value_or(Point());
  const std::string where =
      outside.first ? fmt::format("{} at ({}, {}){}", one ? "" : ", the first", p.x, p.y, one ? "" : ",") : "";
  const char* why =
      one ? ", because it lies outside the domain or in a hole" : ", because they lie outside the domain or in a hole";
  return fmt::format("note: {}{} {} in no triangle{}; {}", plural(outside.count, "point"), where, one ? "is" : "are",
                     of_domain ? why : "", then);
}

}  // namespace pardel::cli
