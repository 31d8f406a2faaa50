#include "mesh_case.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "../parallel/repair.hpp"
#include "../properties/domains/domains.hpp"
#include "../properties/domains/generators/decorations.hpp"
#include "../properties/domains/generators/lattice_domain.hpp"
#include "../properties/domains/generators/mixed_scales.hpp"
#include "../properties/domains/paths.hpp"
#include "doubles.hpp"
#include "supply.hpp"

namespace pardel::fuzz {
namespace {

constexpr double no_bound = std::numeric_limits<double>::infinity();

/// Draws points, segments, holes and regions on the lattice [0, side]^2. Every stroke reads at most stroke_bytes bytes.
class Drawing {
 public:
  Drawing(MeshCase& drawn, int side) : case_(drawn), pslg_(drawn.pslg), side_(side) {}

  void outline(int kind) {
    const int half = side_ / 2;
    const double s = side_, h = half;
    if (kind == 0) polygon({{0, 0}, {s, 0}, {s, s}, {0, s}}, 1);
    if (kind == 1) polygon({{0, 0}, {s, 0}, {h, s}}, 2);
    if (kind == 2) polygon({{0, 0}, {s, 0}, {s, h}, {h, h}, {h, s}, {0, s}}, 3);  // the notch of the L is outside
  }
  /// A random domain of one of the families, where its lattice has the unit 1.
  void domain_of_a_family(int family, int size, std::uint64_t seed) {
    const auto& families = generators::all_families();
    generators::Random random(seed);
    generators::LatticeDomain domain =
        generate(families[static_cast<std::size_t>(family) % families.size()], random, size);
    domain.offset = {};
    domain.exponent = 0;
    pslg_ = to_pslg(domain);
    pslg_.has_segment_markers = true;
    // Without segments the domain is the convex hull, and the strokes would be the outline.
    if (pslg_.segments.empty()) outline(0);
  }
  void stroke(Supply bytes) {
    switch (bytes.below(9)) {
      case 0:
        add(lattice_point(bytes), bytes);
        break;
      case 1: {
        const Point from = lattice_point(bytes), to = lattice_point(bytes);
        const Index a = add(from, bytes);
        join(a, add(to, bytes));
        break;
      }
      case 2:
        join(static_cast<Index>(pslg_.points.size() - 1), add(lattice_point(bytes), bytes));
        break;
      case 3:
        fan(bytes);
        break;
      case 4:
        block(lattice_point(bytes));
        break;
      case 5:
        box(bytes, false);
        break;
      case 6:
        twin(bytes);
        break;
      default:
        box(bytes, true);
        break;
    }
  }

 private:
  /// Several segments from one point to neighbouring points. They make small angles.
  void fan(Supply& bytes) {
    const Point apex = lattice_point(bytes), first = lattice_point(bytes);
    const Index centre = add(apex, bytes);
    const int spokes = 2 + bytes.below(5);
    for (int i = 0; i < spokes; ++i) join(centre, add({first.x, clamped(first.y + i)}));
  }
  /// A box around the seed of a hole or of a region.
  void box(Supply& bytes, bool is_hole) {
    const Point corner = lattice_point(bytes);
    const double w = 1 + bytes.below(4), h = 1 + bytes.below(4);
    const double right = clamped(corner.x + w), top = clamped(corner.y + h);
    polygon({corner, {right, corner.y}, {right, top}, {corner.x, top}}, is_hole ? 10 : 20);
    // The seed is not on lines or diagonals of the lattice, so it rarely lies on a segment.
    const Point seed{corner.x + (right - corner.x) * 19 / 64, corner.y + (top - corner.y) * 27 / 64};
    if (is_hole) {
      pslg_.holes.push_back(seed);
    } else {
      const double cap = bytes.below(2) == 0 ? no_bound : 1.0 / (1 + bytes.below(8));
      pslg_.regions.push_back({seed, static_cast<double>(pslg_.regions.size() + 1), cap});
    }
  }
  /// A block of 2 by 2 lattice cells with all their edges, which makes many cocircular points.
  void block(Point corner) {
    for (int i = 0; i <= 2; ++i) {
      line({corner.x, clamped(corner.y + i)}, {clamped(corner.x + 2), clamped(corner.y + i)});
      line({clamped(corner.x + i), corner.y}, {clamped(corner.x + i), clamped(corner.y + 2)});
    }
  }
  /// A copy of a segment at a small distance, 2^-k of its length: a narrow gap.
  void twin(Supply& bytes) {
    if (pslg_.segments.empty()) return;
    const Segment of = pslg_.segments[bytes.byte() % pslg_.segments.size()];
    const Point a = pslg_.points[of.a], b = pslg_.points[of.b];
    const double share = std::exp2(-1 - bytes.below(16));
    const double dx = -(b.y - a.y) * share, dy = (b.x - a.x) * share;
    line({a.x + dx, a.y + dy}, {b.x + dx, b.y + dy});
  }

  [[nodiscard]] double clamped(double x) const { return std::min(x, static_cast<double>(side_)); }
  Point lattice_point(Supply& bytes) {
    const int x = bytes.below(side_ + 1);
    return {static_cast<double>(x), static_cast<double>(bytes.below(side_ + 1))};
  }
  Index add(Point p) {
    pslg_.points.push_back(p);
    return static_cast<Index>(pslg_.points.size() - 1);
  }
  /// Adds the point, in one of four cases moved by up to three units in the last place.
  Index add(Point p, Supply& bytes) {
    const int units = bytes.byte();
    if (units < 192) return add(p);
    case_.nudged = true;
    return add({moved(p.x, units % 8 - 3), moved(p.y, units / 8 % 8 - 3)});
  }
  void join(Index a, Index b) { pslg_.segments.push_back({a, b, static_cast<int>(pslg_.segments.size() % 5)}); }
  void line(Point from, Point to) {
    const Index a = add(from);
    join(a, add(to));
  }
  void polygon(const std::vector<Point>& corners, int marker) { domains::add_closed(pslg_, corners, marker); }

  MeshCase& case_;
  Pslg& pslg_;
  int side_;
};

/// Moves and scales the case to unit scale, projected coordinates, micrometres, or a large power of two.
void place(MeshCase& drawn, int kind) {
  constexpr double scales[] = {1, 1, 0x1p-20, 0x1p40};
  const double scale = scales[kind];
  const Point shift = kind == 1 ? Point{654321, 4987654} : Point{};
  drawn.pslg = domains::moved(std::move(drawn.pslg), shift.x, shift.y, scale);
  drawn.goal.max_area *= scale * scale;
  drawn.goal.max_edge *= scale;
  drawn.options.min_edge *= scale;
  if (!drawn.goal.size) return;
  drawn.goal.size = [size = drawn.goal.size, shift, scale](Point p) {
    return scale * size({p.x / scale - shift.x, p.y / scale - shift.y});
  };
}

/// Wanted lengths that grow with the distance from a corner, or that change abruptly at a line.
std::function<double(Point)> field(int kind, double side) {
  const double least = side / 12.0, slope = kind == 1 ? 0.05 : 0.5;
  if (kind == 3) return [=](Point p) { return p.x < side / 2.0 ? least : 4 * least; };
  return [=](Point p) { return least + slope * std::hypot(p.x, p.y); };
}

void decode_bounds(Supply& header, double side, Goal& goal) {
  goal.region_caps = true;
  goal.min_angle_deg = header.one_of({20.7, 0.0, 25.0, 30.0, 33.0});
  if (const int cap = header.below(8); cap > 3) goal.max_area = side * side / std::exp2(cap);
  if (header.flag(32)) goal.max_edge = side / 4.0;
  goal.conforming = header.flag(64);
  goal.convex_hull = header.flag(32);
  // Each number has its own byte, whether or not it is used.
  if (const int kind = header.below(20); kind >= 17) goal.size = field(kind - 16, side);
  goal.grading = header.one_of({no_bound, no_bound, no_bound, no_bound, no_bound, no_bound, 1.0, 0.25});
  goal.feature_edges = header.one_of({0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 2.0});
}

void decode_options(Supply& header, double side, Options& options) {
  options.placement =
      header.one_of({Placement::off_centre, Placement::automatic, Placement::search, Placement::circumcentre});
  options.decomposition = header.one_of({Decomposition::automatic, Decomposition::lattice, Decomposition::quadtree,
                                         Decomposition::paper, Decomposition::paper_quadtree, Decomposition::none});
  options.triangles_per_tile = header.one_of({8'000U, 4U, 20U, 80U});
  options.max_vertices = header.one_of({300U, 300U, 60U, 1'000U});
  if (header.flag(24)) options.min_edge = side * 0x1p-5;
  if (header.flag(16)) options.no_boundary_splits = true;
  if (header.flag(16)) options.no_segment_splits = true;
  if (!options.no_boundary_splits || !options.no_segment_splits) return;
  options.no_boundary_splits = options.no_segment_splits = false;  // both together mean no more than the second
  options.kept_markers = {1, 3};
}

/// These two bytes are behind all others, and few of the inputs that were stored before have such a second one, so that
/// they keep their meaning. Bounds on lengths mean little where scales are mixed, and the hull of far points can be a
/// needle.
void decode_mixture(Supply& header, MeshCase& drawn) {
  const int first = header.byte(), second = header.byte();
  if (second < 100 || second >= 148) return;
  drawn.mixture = 256 * second + first;
  drawn.goal.max_area = drawn.goal.max_edge = no_bound;
  drawn.goal.size = nullptr;
  drawn.goal.convex_hull = false;
}

/// Data of points, segments and regions, in three of four cases. They depend on the seed, which stored inputs have.
/// Segments keep their markers if some of these are kept.
void decorate(MeshCase& drawn) {
  generators::Random random(drawn.seed);
  auto decorations = generators::any_switches<generators::Decorations>(random);
  const std::vector<Segment> segments = drawn.pslg.segments;
  drawn.pslg = decorated(std::move(drawn.pslg), decorations);
  if (!drawn.options.kept_markers.empty()) drawn.pslg.segments = segments;
}

/// Mixes the scales of a repaired domain.
void mix(Prepared& prepared, const MeshCase& drawn) {
  constexpr int largest_other = 12;
  generators::Random random(static_cast<std::uint64_t>(drawn.mixture) << 32U | drawn.seed);
  Pslg other = prepared.pslg;
  if (random.chance(2)) other = to_pslg(generators::any_domain(random, largest_other));
  generators::Mixed mixed = mixed_scales(prepared.pslg, other, random);
  prepared.far_off = std::ranges::find(mixed.what, generators::Mixture::component_far_off) != mixed.what.end();
  prepared.pslg = std::move(mixed.pslg);
}

}  // namespace

MeshCase decode_mesh_case(std::span<const std::uint8_t> bytes) {
  Supply all(bytes), header(all.take(header_bytes));
  MeshCase drawn;
  drawn.seed = Supply(header.take(seed_bytes)).word();
  drawn.pslg.has_segment_markers = true;
  const int side = 4 << header.below(4), position = header.below(4), outline = header.below(6);
  const int family = header.byte(), size = header.below(32);
  drawn.refine_again = header.flag(48);
  drawn.threads = 2 + header.below(3);
  drawn.ranks = 2 + header.below(4);

  Drawing drawing(drawn, side);
  // A family takes its random numbers from the first stroke.
  if (outline < 3)
    drawing.outline(outline);
  else
    drawing.domain_of_a_family(family, size, Supply(all.take(stroke_bytes)).word());
  // The bounds are shares of the outline, so that a mesh without a limit has some thousand triangles at most.
  double extent = side;
  for (const Point p : drawn.pslg.points) extent = std::max({extent, std::abs(p.x), std::abs(p.y)});
  decode_bounds(header, extent, drawn.goal);
  decode_options(header, extent, drawn.options);
  decode_mixture(header, drawn);
  for (std::size_t strokes = 0; strokes < most_strokes && !all.empty(); ++strokes)
    drawing.stroke(Supply(all.take(stroke_bytes)));
  decorate(drawn);
  place(drawn, position);
  drawn.options.max_vertices += drawn.pslg.points.size();
  // A mesh whose segments may not be split is not conforming in general.
  if (!may_split_all_segments(drawn.options)) drawn.goal.conforming = false;
  return drawn;
}

MeshCase decode_small_case(std::span<const std::uint8_t> bytes) {
  return decode_mesh_case(bytes.first(std::min(bytes.size(), small_case_bytes)));
}

Prepared prepare(const MeshCase& drawn) {
  const RepairOptions options{.snap = 0, .convex_hull = drawn.goal.convex_hull};
  Prepared prepared;
  Result<Repaired> repaired = repair(drawn.pslg, options);
  if (!repaired) {
    Pslg bare = drawn.pslg;
    bare.holes.clear();
    bare.regions.clear();
    repaired = repair(bare, options);
    prepared.reduced = true;
  }
  if (!repaired) return {};
  prepared.pslg = std::move(repaired->domain).pslg();
  prepared.usable = true;
  if (drawn.mixture != 0) mix(prepared, drawn);
  return prepared;
}

}  // namespace pardel::fuzz
