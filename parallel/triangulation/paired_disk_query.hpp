// A cavity query that tests two circumdisks at a time.
#pragma once

#include <array>

#include "../arithmetic/predicates.hpp"
#include "../decomposition/lattice.hpp"
#include "cavity_query.hpp"
#include "in_circumdisk.hpp"
#include "triangulation.hpp"

namespace pardel::engine {

/// The vertex at v relative to p.
[[nodiscard]] inline Corner corner_around(Pair p, const Point& v) {
  const Pair at = as_pair(v) - p, squares = at * at;
  return {at, squares[0] + squares[1]};
}

/// in_circumdisk() for the slots of a triangulation.
struct PointInDisks {
  const Triangulation& t;
  Point p;
  [[nodiscard]] bool operator()(const Slot& slot) const { return in_circumdisk(t, slot, p); }
};

/// A CavityQuery for the point p within a box. The cavity consists of triangles with all corners in the box.
/// The answers are exact. A floating-point filter almost always suffices. It uses the corners that the walk passes to
/// the query, so no coordinate is loaded twice. Otherwise in_disk(slot) decides: a function that agrees with
/// in_circumdisk() except where p is on the circle.
template <class InDisk>
struct PairedDiskQueryWith {
  const Triangulation& t;
  Pair p;
  Box box;
  InDisk in_disk{t, as_point(p)};

  [[nodiscard]] bool is_own(VertexId v) const { return box.contains_half_open(t.points[v]); }
  [[nodiscard]] Corner corner(VertexId v) const { return corner_around(p, t.points[v]); }
  [[nodiscard]] InDisks first_and_behind(const Slot& first, const std::array<Corner, 3>& c, EdgeRef behind) const {
    const Slot& slot = t.slot(behind);
    const Pair at = as_pair(t.points[slot.apex(behind.side())]) - p;
    const InCircle<Pair> in(firsts(c[1].at, c[0].at), seconds(c[1].at, c[0].at), firsts(c[0].at, c[1].at),
                            seconds(c[0].at, c[1].at), firsts(c[2].at, at), seconds(c[2].at, at),
                            Pair{c[1].square, c[0].square}, Pair{c[0].square, c[1].square});
    return decided(in, first, slot);
  }
  [[nodiscard]] DisksAndCorners both(Corner u, Corner w, Corner v, EdgeRef right, EdgeRef left) const {
    const Slot &r = t.slot(right), &l = t.slot(left);
    const Pair at_r = as_pair(t.points[r.apex(right.side())]) - p, at_l = as_pair(t.points[l.apex(left.side())]) - p;
    const InCircle<Pair> in(firsts(u.at, w.at), seconds(u.at, w.at), firsts(w.at, v.at), seconds(w.at, v.at),
                            firsts(at_r, at_l), seconds(at_r, at_l), Pair{u.square, w.square},
                            Pair{w.square, v.square});
    return {decided(in, r, l), {Corner{at_r, in.square[0]}, Corner{at_l, in.square[1]}}};
  }

 private:
  [[nodiscard]] InDisks decided(const InCircle<Pair>& in, const Slot& a, const Slot& b) const {
    if (!in.is_certain()) [[unlikely]]
      return decided_exactly(a, b);
    return {bits(in.determinant > 0)};
  }
  // Not inlined: it is seldom called, and would make the walk over a cavity slower.
  [[nodiscard, gnu::noinline]] InDisks decided_exactly(const Slot& a, const Slot& b) const {
    return InDisks::of(in_disk(a), in_disk(b));
  }
};
using PairedDiskQuery = PairedDiskQueryWith<PointInDisks>;

}  // namespace pardel::engine
