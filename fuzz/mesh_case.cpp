#include "mesh_case.hpp"

#include <array>
#include <cmath>

#include "../parallel/repair.hpp"
#include "../properties/domains/domains.hpp"
#include "../properties/domains/paths.hpp"

namespace pardel::fuzz {
namespace {

/// Supplies small numbers from the bytes, and zeros after the last byte.
class Supply {
 public:
  explicit Supply(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}
  [[nodiscard]] bool empty() const { return next_ >= bytes_.size(); }
  int below(int n) { return (empty() ? 0 : bytes_[next_++]) % n; }

 private:
  std::span<const std::uint8_t> bytes_;
  std::size_t next_ = 0;
};

/// Draws points, segments, holes and regions on the lattice [0, side]^2.
class Drawing {
 public:
  Drawing(Pslg& pslg, Supply& supply, int side) : pslg_(pslg), supply_(supply), side_(side) {}

  void outline(int kind) {
    const double s = side_, h = side_ / 2;
    if (kind == 0) polygon({{0, 0}, {s, 0}, {s, s}, {0, s}}, 1);
    if (kind == 1) polygon({{0, 0}, {s, 0}, {h, s}}, 2);
    if (kind == 2) polygon({{0, 0}, {s, 0}, {s, h}, {h, h}, {h, s}, {0, s}}, 3);  // the notch of the L is outside
  }
  void point() { add(lattice_point()); }
  void segment() { join(add(lattice_point()), add(lattice_point())); }
  void continued_segment() { join(static_cast<Index>(pslg_.points.size() - 1), add(lattice_point())); }
  /// Several segments from one point to neighbouring points. They make small angles.
  void fan() {
    const Point apex = lattice_point(), first = lattice_point();
    const Index centre = add(apex);
    const int spokes = 2 + supply_.below(5);
    for (int i = 0; i < spokes; ++i) join(centre, add({first.x, clamped(first.y + i)}));
  }
  /// A box around the seed of a hole or of a region.
  void box(bool is_hole) {
    const Point corner = lattice_point();
    const double w = 1 + supply_.below(4), h = 1 + supply_.below(4);
    const double right = clamped(corner.x + w), top = clamped(corner.y + h);
    polygon({corner, {right, corner.y}, {right, top}, {corner.x, top}}, is_hole ? 10 : 20);
    // The seed is not on lines or diagonals of the lattice, so it rarely lies on a segment.
    const Point seed{corner.x + (right - corner.x) * 19 / 64, corner.y + (top - corner.y) * 27 / 64};
    if (is_hole) {
      pslg_.holes.push_back(seed);
    } else {
      const double cap = supply_.below(2) == 0 ? std::numeric_limits<double>::infinity() : 1.0 / (1 + supply_.below(8));
      pslg_.regions.push_back({seed, static_cast<double>(pslg_.regions.size() + 1), cap});
    }
  }
  /// A block of 2 by 2 lattice cells with all their edges, which makes many cocircular points.
  void block() {
    const Point corner = lattice_point();
    for (int i = 0; i <= 2; ++i) {
      join(add({corner.x, clamped(corner.y + i)}), add({clamped(corner.x + 2), clamped(corner.y + i)}));
      join(add({clamped(corner.x + i), corner.y}), add({clamped(corner.x + i), clamped(corner.y + 2)}));
    }
  }

 private:
  [[nodiscard]] double clamped(double x) const { return std::min(x, static_cast<double>(side_)); }
  Point lattice_point() {
    const int x = supply_.below(side_ + 1);
    return {static_cast<double>(x), static_cast<double>(supply_.below(side_ + 1))};
  }
  Index add(Point p) {
    pslg_.points.push_back(p);
    return static_cast<Index>(pslg_.points.size() - 1);
  }
  void join(Index a, Index b) { pslg_.segments.push_back({a, b, static_cast<int>(pslg_.segments.size() % 5)}); }
  void polygon(const std::vector<Point>& corners, int marker) { domains::add_closed(pslg_, corners, marker); }

  Pslg& pslg_;
  Supply& supply_;
  int side_;
};

/// Moves and scales the case to unit scale, projected coordinates, micrometres, or a large power of two.
void place(Pslg& pslg, Goal& goal, int kind) {
  constexpr std::array<double, 4> scales{1, 1, 0x1p-20, 0x1p40};
  const double scale = scales[kind];
  const Point shift = kind == 1 ? Point{654321, 4987654} : Point{};
  pslg = domains::moved(std::move(pslg), shift.x, shift.y, scale);
  goal.max_area *= scale * scale;
  goal.max_edge *= scale;
}

}  // namespace

MeshCase decode_mesh_case(std::span<const std::uint8_t> bytes) {
  constexpr std::array<double, 5> angles{20.7, 0, 25, 30, 33};
  Supply supply(bytes);
  MeshCase drawn;
  drawn.pslg.has_segment_markers = true;
  drawn.goal.region_caps = true;
  drawn.goal.min_angle_deg = angles[supply.below(angles.size())];
  const int side = 4 << supply.below(4);
  if (const int cap = supply.below(8); cap > 3) drawn.goal.max_area = side * side / std::exp2(cap);
  if (supply.below(8) == 7) drawn.goal.max_edge = side / 4.0;
  drawn.goal.conforming = supply.below(4) == 3;
  drawn.goal.convex_hull = supply.below(8) == 7;
  constexpr std::array<Placement, 4> placements{Placement::off_centre, Placement::automatic, Placement::search,
                                                Placement::circumcentre};
  drawn.options.placement = placements[static_cast<std::size_t>(supply.below(4))];
  const int position = supply.below(4);

  Drawing drawing(drawn.pslg, supply, side);
  drawing.outline(supply.below(3));
  for (int strokes = 0; strokes < 24 && !supply.empty(); ++strokes) {
    switch (supply.below(8)) {
      case 0:
        drawing.point();
        break;
      case 1:
        drawing.segment();
        break;
      case 2:
        drawing.continued_segment();
        break;
      case 3:
        drawing.fan();
        break;
      case 4:
        drawing.block();
        break;
      case 5:
        drawing.box(false);
        break;
      default:
        drawing.box(true);
        break;
    }
  }
  place(drawn.pslg, drawn.goal, position);
  drawn.options.max_vertices = drawn.pslg.points.size() + 2000;
  return drawn;
}

Prepared prepare(const MeshCase& drawn) {
  if (Result<Repaired> repaired = repair(drawn.pslg, {.snap = 0}))
    return {std::move(repaired->domain).pslg(), true, false};
  Pslg bare = drawn.pslg;
  bare.holes.clear();
  bare.regions.clear();
  if (Result<Repaired> repaired = repair(bare, {.snap = 0})) return {std::move(repaired->domain).pslg(), true, true};
  return {};
}

}  // namespace pardel::fuzz
