#include "make_room.hpp"

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "../arithmetic/predicates.hpp"
#include "../triangulation/flips.hpp"
#include "../triangulation/held.hpp"

namespace pardel::engine {
namespace {

/// The end of the edge around which diagonals are flipped.
enum class Pivot : std::uint8_t { from, to };

/// The other side of the triangle at the pivot. `side` begins there (Pivot::from) or ends there (Pivot::to), and so
/// does each diagonal around the pivot, seen from the triangle beyond it.
EdgeRef next_side(EdgeRef side, Pivot around) {
  const auto& next = around == Pivot::from ? previous_corner : next_corner;
  return {side.triangle(), next[side.side()]};
}

/// Which diagonals around the pivot are flipped, one after the other: their places among those that are left, counted
/// from the edge.
struct Flips {
  Pivot around = Pivot::from;
  std::vector<std::size_t> places;
};

/// The triangle on one side of an edge from a to b.
class Beside {
 public:
  Beside(const Triangulation& t, EdgeRef e, Point p) : t_(t), e_(e), p_(p), a_(at(from(e))), b_(at(to(e))) {}

  /// Flips after which p sees both other sides; nothing if there are none.
  [[nodiscard]] std::optional<Flips> flips_for_room() const {
    const Point apex = at(t_.slot(e_).apex(e_.side()));
    const bool sees_far_side = orient2d(b_, apex, p_) > 0, sees_near_side = orient2d(apex, a_, p_) > 0;
    if (sees_far_side && sees_near_side) return Flips{};
    if (!sees_far_side && !sees_near_side) return {};
    return turned(sees_far_side ? Pivot::to : Pivot::from, apex);
  }

 private:
  [[nodiscard]] VertexId from(EdgeRef e) const { return t_.slot(e).from(e.side()); }
  [[nodiscard]] VertexId to(EdgeRef e) const { return t_.slot(e).to(e.side()); }
  [[nodiscard]] Point at(VertexId v) const {
    require_held(t_.points[v]);
    return t_.points[v];
  }

  /// Passes the triangles around the pivot until p sees both sides between the edge and the far corner of the last one.
  [[nodiscard]] std::optional<Flips> turned(Pivot around, Point apex) const {
    const bool around_a = around == Pivot::from;
    std::vector<Point> rim{around_a ? b_ : a_, apex};  // the corners that have been passed
    EdgeRef diagonal = next_side(e_, around);
    while (true) {
      const EdgeRef across = t_.slot(diagonal).n[diagonal.side()];
      if (across.constrained() || t_.slot(across).is_ghost()) return {};
      rim.push_back(at(t_.slot(across).apex(across.side())));
      if (orient2d(a_, b_, rim.back()) <= 0) return {};
      const bool sees_far_side = orient2d(b_, rim.back(), p_) > 0, sees_near_side = orient2d(rim.back(), a_, p_) > 0;
      if (!(around_a ? sees_near_side : sees_far_side)) return {};
      if (sees_far_side && sees_near_side)
        if (auto places = ears(around, rim)) return Flips{around, std::move(*places)};
      diagonal = next_side(across, around);
    }
  }

  /// The order in which the diagonals from the pivot to the inner corners of the rim can be flipped: each when its
  /// quadrilateral is convex, that is, when its corner is an ear of what is left of the rim. Nothing if some cannot.
  [[nodiscard]] std::optional<std::vector<std::size_t>> ears(Pivot around, std::vector<Point> rim) const {
    const bool around_a = around == Pivot::from;
    const auto turns_left = [&](Point u, Point v, Point w) {
      return (around_a ? orient2d(u, v, w) : orient2d(w, v, u)) > 0;
    };
    std::vector<std::size_t> places;
    while (rim.size() > 2) {
      std::size_t i = 1;
      while (i + 1 < rim.size() &&
             !(turns_left(rim[i - 1], rim[i], rim[i + 1]) && turns_left(around_a ? a_ : b_, rim[i - 1], rim[i + 1])))
        ++i;
      if (i + 1 == rim.size()) return {};
      places.push_back(i - 1);
      rim.erase(rim.begin() + static_cast<std::ptrdiff_t>(i));
    }
    return places;
  }

  const Triangulation& t_;
  EdgeRef e_;
  Point p_, a_, b_;
};

/// Returns the edge as a side of the triangle that it has after the flips.
EdgeRef flipped(Triangulation& t, EdgeRef e, const Flips& flips, std::vector<TriangleId>& changed) {
  const bool around_from = flips.around == Pivot::from;
  for (const std::size_t place : flips.places) {
    EdgeRef diagonal = next_side(e, flips.around);
    for (std::size_t i = 0; i < place; ++i) diagonal = next_side(t.slot(diagonal).n[diagonal.side()], flips.around);
    const TriangleId across = t.slot(diagonal).n[diagonal.side()].triangle();
    flip(t, diagonal);
    changed.insert(changed.end(), {diagonal.triangle(), across});
    if (place == 0) e = around_from ? EdgeRef(across, 0) : EdgeRef(e.triangle(), 2);
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
