#include "delaunay.hpp"

#include <bit>

#include "../core/mutants.hpp"
#include "cavity.hpp"
#include "predicates.hpp"
#include "spatial_sort.hpp"

namespace pardel {
namespace {

std::uint64_t mixed(std::uint64_t h) {
  h = (h ^ h >> 32U) * 0xd6e8feb86659fd93U;
  h = (h ^ h >> 32U) * 0xd6e8feb86659fd93U;
  return h ^ h >> 32U;
}

/// Round r of the insertion holds about 16^-r of the points; the last rounds go first. Chance is a hash of a point's
/// place on the curve: neither the order of the input nor its scale has a say.
std::vector<Index> biased_random_order(std::size_t n) {
  constexpr int rounds = 8;
  std::vector<std::uint8_t> round(n);
  std::array<std::size_t, rounds + 1> start{};
  for (std::size_t i = 0; i < n; ++i) {
    const int level = std::min(rounds - 1, std::countr_zero(mixed(i + 1)) / 4);
    round[i] = static_cast<std::uint8_t>(rounds - 1 - level);
    ++start[round[i] + 1U];
  }
  for (std::size_t r = 1; r < start.size(); ++r) start[r] += start[r - 1];
  std::vector<Index> order(n);
  for (std::size_t i = 0; i < n; ++i) order[start[round[i]]++] = static_cast<Index>(i);
  return order;
}

/// The open disk of a ghost is the open half-plane beyond its hull edge, and the edge's own interior.
bool ghost_disk_contains(const Triangulation& t, const Slot& slot, Point p) {
  const unsigned corner = slot.v[0] == ghost ? 0 : slot.v[1] == ghost ? 1 : 2;
  const Point a = t.points[slot.from(corner)], b = t.points[slot.to(corner)];
  const double side = orient2d(a, b, p);
  if (side != 0 || mutated("points_on_the_hull_make_flat_triangles")) return side > 0;
  return (a.x < p.x && p.x < b.x) || (b.x < p.x && p.x < a.x) || (a.y < p.y && p.y < b.y) || (b.y < p.y && p.y < a.y);
}

bool disk_contains(const Triangulation& t, TriangleId id, Point p) {
  const Slot& slot = t.slots[id];
  if (slot.is_ghost()) return ghost_disk_contains(t, slot, p);
  return incircle(t.points[slot.v[0]], t.points[slot.v[1]], t.points[slot.v[2]], p) > 0;
}

/// One triangle and its three ghosts.
void start_with(Triangulation& t, VertexId a, VertexId b, VertexId c) {
  if (orient2d(t.points[a], t.points[b], t.points[c]) < 0) std::swap(b, c);
  const std::array<VertexId, 3> v{a, b, c};
  t.slots.push_back({v, {EdgeRef(1, 2), EdgeRef(2, 2), EdgeRef(3, 2)}});
  for (unsigned i = 0; i < 3; ++i) {
    // The ghost beyond side i: (to, from, ghost). Its next ghost around the hull shares `from`.
    const VertexId from = v[next_corner[i]], to = v[previous_corner[i]];
    const TriangleId before = 1 + previous_corner[i], after = 1 + next_corner[i];
    t.slots.push_back({{to, from, ghost}, {EdgeRef(before, 1), EdgeRef(after, 0), EdgeRef(0, i)}});
  }
}

Error coordinates_error(const char* what, Point p) {
  return {ErrorKind::invalid_input, std::string(what) + " (" + std::to_string(p.x) + ", " + std::to_string(p.y) + ")"};
}

}  // namespace

TriangleId locate(const Triangulation& t, Point p, TriangleId start) {
  EdgeRef entered;  // the side through which the walk came in
  TriangleId at = start;
  std::uint32_t random =
      1;  // a fixed order of the sides could walk in circles where segments block the Delaunay property
  for (;;) {
    const Slot& slot = t.slots[at];
    if (slot.is_ghost()) return at;
    EdgeRef out;
    random = random * 1664525U + 1013904223U;
    unsigned side = (random >> 16U) % 3;
    for (int tried = 0; tried < 3; ++tried, side = next_corner[side]) {
      if (at == entered.triangle() && side == entered.side()) continue;
      if (orient2d(t.points[slot.from(side)], t.points[slot.to(side)], p) < 0) {
        out = slot.n[side];
        break;
      }
    }
    if (out.none()) return at;
    entered = out;
    at = out.triangle();
  }
}

Result<Delaunay> delaunay(std::span<const Point> points) {
  if (points.size() < 3) return Error{ErrorKind::invalid_input, "fewer than three points span no triangle"};
  if (points.size() > max_triangles / 2 - 2)
    return Error{ErrorKind::resources, "more points than the triangulation can number"};

  Delaunay result;
  result.input_of_vertex = hilbert_order(points);
  Triangulation& t = result.triangulation;
  t.points.reserve(points.size());
  for (const Index i : result.input_of_vertex) t.points.push_back(points[i]);
  std::vector<Index> order = biased_random_order(t.points.size());

  const Point a = t.points[order[0]], b = t.points[order[1]];
  if (a == b) return coordinates_error("two points share the coordinates", a);
  std::size_t third = 2;
  while (third < order.size() && orient2d(a, b, t.points[order[third]]) == 0) ++third;
  if (third == order.size()) return Error{ErrorKind::invalid_input, "all points are collinear"};
  std::rotate(order.begin() + 2, order.begin() + static_cast<std::ptrdiff_t>(third),
              order.begin() + static_cast<std::ptrdiff_t>(third) + 1);

  if (order.size() > 3 && mutated("a_point_is_lost")) order.pop_back();
  t.slots.reserve(2 * points.size() + 8);
  start_with(t, order[0], order[1], order[2]);

  Cavity cavity;
  std::vector<TriangleId> fan;
  TriangleId hint = 0;
  const auto allocate = [&] {
    t.slots.push_back({});
    return static_cast<TriangleId>(t.slots.size() - 1);
  };
  for (std::size_t k = 3; k < order.size(); ++k) {
    const VertexId v = order[k];
    const Point p = t.points[v];
    const TriangleId first = locate(t, p, hint);
    if (!disk_contains(t, first, p)) return coordinates_error("two points share the coordinates", p);
    const auto reach = [&](TriangleId id, unsigned) {
      return disk_contains(t, id, p) ? Reach::inside : Reach::outside;
    };
    if (cavity.find(t, first, reach) != Walk::complete)
      return coordinates_error("the triangulation is inconsistent at", p);
    retriangulate(t, cavity, v, allocate, fan);
    for (std::size_t i = 0; i < fan.size(); ++i)
      if (!t.slots[fan[i]].is_ghost()) {
        hint = fan[i];
        break;
      }
  }
  return result;
}

}  // namespace pardel
