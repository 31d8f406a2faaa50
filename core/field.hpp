// What a file carries beside a mesh: fields, and names of markers and regions.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "array.hpp"

namespace pardel {

/// Numbers at the points or in the triangles of a mesh, such as the results of a solver. They say nothing about the
/// mesh itself: the mesher and the checker do not use them.
struct Field {
  enum class Place : std::uint8_t { points, triangles };
  std::string name;
  Place place = Place::points;
  std::size_t components = 1;  ///< numbers per point or triangle, at least 1
  Array<double> values;        ///< point by point or triangle by triangle; NaN where the file has no value
  double time = 0;             ///< in a .msh; 0 elsewhere

  /// Values that are missing are equal.
  friend bool operator==(const Field& f, const Field& g) {
    const auto is_same = [](double a, double b) { return a == b || (a != a && b != b); };
    return f.name == g.name && f.place == g.place && f.components == g.components &&
           std::ranges::equal(f.values, g.values, is_same) && is_same(f.time, g.time);
  }
};

/// The name of a marker of constrained edges, or of the region with this attribute: of a physical group in a .msh.
struct GroupName {
  enum class Of : std::uint8_t { marker, region };
  Of of = Of::marker;
  int value = 1;  ///< the marker or the attribute, at least 1
  std::string name;
  friend bool operator==(const GroupName&, const GroupName&) = default;
};

/// What a reader left out of a file, for messages: "the section $Periodic". No result depends on it, so all values
/// compare equal.
class LeftOut {
 public:
  /// Adds a thing, unless it is listed already.
  void add(std::string_view thing) {
    if (std::ranges::find(things_, thing) == things_.end()) things_.emplace_back(thing);
  }
  [[nodiscard]] const std::vector<std::string>& things() const { return things_; }
  friend bool operator==(const LeftOut&, const LeftOut&) { return true; }

 private:
  std::vector<std::string> things_;
};

}  // namespace pardel
