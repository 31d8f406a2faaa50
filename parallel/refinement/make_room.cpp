#include "make_room.hpp"

#include <cstdint>
#include <optional>

#include "../arithmetic/predicates.hpp"
#include "../triangulation/flips.hpp"
#include "../triangulation/held.hpp"

namespace pardel::engine {
namespace {

/// The end of the edge around which diagonals are flipped.
enum class Pivot : std::uint8_t { from, to };

struct Flips {
  Pivot around = Pivot::from;
  int count = 0;
};

/// The triangle on one side of an edge from a to b.
class Beside {
 public:
  Beside(const Triangulation& t, EdgeRef e, Point p) : t_(t), e_(e), p_(p), a_(at(from(e))), b_(at(to(e))) {}

  /// The fewest flips after which p sees both other sides; nothing if there are none.
  [[nodiscard]] std::optional<Flips> flips_for_room() const {
    const Point apex = at(t_.slot(e_).apex(e_.side()));
    const bool sees_far_side = orient2d(b_, apex, p_) > 0, sees_near_side = orient2d(apex, a_, p_) > 0;
    if (sees_far_side && sees_near_side) return Flips{};
    if (!sees_far_side && !sees_near_side) return {};
    const Pivot around = sees_far_side ? Pivot::to : Pivot::from;
    return turned(around, apex);
  }

 private:
  [[nodiscard]] VertexId from(EdgeRef e) const { return t_.slot(e).from(e.side()); }
  [[nodiscard]] VertexId to(EdgeRef e) const { return t_.slot(e).to(e.side()); }
  [[nodiscard]] Point at(VertexId v) const {
    require_held(t_.points[v]);
    return t_.points[v];
  }

  /// Passes the triangles around the pivot until p sees both sides between the edge and the corner `tip` of the last
  /// one. All quadrilaterals on the way have to be convex.
  [[nodiscard]] std::optional<Flips> turned(Pivot around, Point tip) const {
    const bool around_a = around == Pivot::from;
    EdgeRef diagonal(e_.triangle(), around_a ? previous_corner[e_.side()] : next_corner[e_.side()]);
    for (int count = 1;; ++count) {
      const EdgeRef across = t_.slot(diagonal).n[diagonal.side()];
      if (across.constrained() || t_.slot(across).is_ghost()) return {};
      const Point next = at(t_.slot(across).apex(across.side()));
      const bool is_convex = around_a ? orient2d(b_, tip, next) > 0 : orient2d(a_, next, tip) > 0;
      if (!is_convex || orient2d(a_, b_, next) <= 0) return {};
      const bool sees_far_side = orient2d(b_, next, p_) > 0, sees_near_side = orient2d(next, a_, p_) > 0;
      if (sees_far_side && sees_near_side) return Flips{around, count};
      if (!(around_a ? sees_near_side : sees_far_side)) return {};
      tip = next;
      diagonal = EdgeRef(across.triangle(), around_a ? previous_corner[across.side()] : next_corner[across.side()]);
    }
  }

  const Triangulation& t_;
  EdgeRef e_;
  Point p_, a_, b_;
};

/// Returns the edge as a side of the triangle that it has after the flips.
EdgeRef flipped(Triangulation& t, EdgeRef e, Flips flips, std::vector<TriangleId>& changed) {
  for (int i = 0; i < flips.count; ++i) {
    const bool around_from = flips.around == Pivot::from;
    const EdgeRef diagonal(e.triangle(), around_from ? previous_corner[e.side()] : next_corner[e.side()]);
    const TriangleId across = t.slot(diagonal).n[diagonal.side()].triangle();
    flip(t, diagonal);
    changed.insert(changed.end(), {e.triangle(), across});
    e = around_from ? EdgeRef(across, 0) : EdgeRef(e.triangle(), 2);
  }
  return e;
}

}  // namespace

EdgeRef make_room(Triangulation& t, EdgeRef e, Point p, std::vector<TriangleId>& changed) {
  const EdgeRef other = t.slot(e).n[e.side()];
  // Flips on one side of e take triangles whose other corners lie on this side, so they leave the other side as it is.
  const std::optional<Flips> here = Beside(t, e, p).flips_for_room();
  const std::optional<Flips> there = other.none() ? Flips{} : Beside(t, other, p).flips_for_room();
  if (!here || !there) return {};
  e = flipped(t, e, *here, changed);
  if (!other.none()) flipped(t, t.slot(e).n[e.side()], *there, changed);
  return e;
}

}  // namespace pardel::engine
