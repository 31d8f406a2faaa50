// The families of wrong meshes, and what their kinds have in common.
#pragma once

#include <cmath>
#include <span>

#include "drawing.hpp"

namespace pardel::wrong_meshes {

[[nodiscard]] std::span<const Kind> kinds_of_moved_chains();
[[nodiscard]] std::span<const Kind> kinds_of_holes_and_outlines();
[[nodiscard]] std::span<const Kind> kinds_of_pinched_chains();
[[nodiscard]] std::span<const Kind> kinds_of_orders();
[[nodiscard]] std::span<const Kind> kinds_of_changed_sides();
[[nodiscard]] std::span<const Kind> kinds_of_excuses();
[[nodiscard]] std::span<const Kind> kinds_of_labels();
[[nodiscard]] std::span<const Kind> kinds_of_sizes();
[[nodiscard]] std::span<const Kind> kinds_of_structure();

/// A part of the input that is far away, so that its coordinates are large.
enum class Stray { point, component, outline_around, island_in_its_hole };

/// Where the largest coordinate is so large that `distance`, in units of the lattice, is some number of its units, from
/// 1 to a million.
[[nodiscard]] inline double far_for(double distance, generators::Random& random) {
  const double units = some_magnitude(random, 1, 1e6);
  return std::ldexp(1.0, static_cast<int>(std::log2(distance * 0x1p52 / units)));
}

/// Adds the far part. It may come before or after the other points; no inserted vertex may come before it. `far` is at
/// least 256 and in units of the lattice. Precondition: the drawing lies within [0, 64]^2.
void add_stray(Drawing& drawing, Stray stray, double far);
[[nodiscard]] inline Stray some_stray(generators::Random& random) { return Stray(random.below(4)); }

/// The mesh as a file gives it: without origins, and perhaps without a list of constrained edges.
inline void make_foreign(WrongMesh& mesh, generators::Random& random) {
  mesh.options.foreign = true;
  mesh.mesh.origin.clear();
  if (random.chance(2)) mesh.mesh.constrained_edges.clear();
}

/// The mesh of a drawing, in one of three cases as a file gives it.
inline std::optional<WrongMesh> finished(Drawing& drawing, generators::Random& random) {
  auto made = drawing.draw();
  if (made && random.chance(3)) make_foreign(*made, random);
  return made;
}

/// Points near the line y = 8 of the lattice.
class Beside {
 public:
  explicit Beside(const Place& place) : place_(place) {}
  /// A point of the lattice with y = 8, a number of units off.
  [[nodiscard]] Point operator()(double x, double units) const {
    Point p = place_.at(x, 8);
    double& y = place_.swapped ? p.x : p.y;
    y += units * spacing(y);
    return p;
  }

 private:
  const Place& place_;
};

}  // namespace pardel::wrong_meshes
