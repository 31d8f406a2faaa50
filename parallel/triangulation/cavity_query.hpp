// The interface between the walk over a cavity (cavity.hpp) and the tests that decide which triangles belong to it.
#pragma once

#include <array>
#include <concepts>

#include "../arithmetic/pair.hpp"
#include "triangulation.hpp"

namespace pardel::engine {

/// A vertex in coordinates relative to the inserted point p.
struct Corner {
  Pair at{};          ///< vertex minus p
  double square = 0;  ///< squared distance from p
};

/// Two answers, one for each of two triangles: does p lie in its circumdisk? Both answers are bits of one number. The
/// number stays in a register, so a branch on it does not wait for memory.
struct InDisks {
  unsigned bits = 0;

  static InDisks of(bool first, bool second) {
    return {static_cast<unsigned>(first) | static_cast<unsigned>(second) << 1U};
  }
  [[nodiscard]] bool first() const { return (bits & 1) != 0; }
  [[nodiscard]] bool second() const { return (bits & 2) != 0; }
};

/// The answers for the two triangles behind two edges, and the far corner of each triangle: its corner opposite the
/// edge.
struct DisksAndCorners {
  InDisks in_disk;
  std::array<Corner, 2> corner;
};

/// The requirements on a query. A query belongs to one point p and answers the questions of Cavity::find about p:
///
/// - is_own(v): true if a triangle with the far corner v may be changed. The far corner of a triangle is the one
///   opposite the edge through which the walk enters it.
/// - corner(v): the vertex v relative to p.
/// - first_and_behind(slot, corners, e): the answers for the walk's first triangle and for e.triangle(). `slot` is the
///   stored record of the first triangle (triangulation.hpp); `corners` are the corners of this triangle relative to p.
///   The edge between its corners 0 and 1 separates it from the next triangle. If this edge is not constrained, e is
///   the edge as a side of the next triangle. If it is constrained, the walk does not cross it: e is then the edge as a
///   side of the first triangle, and the caller ignores the second answer.
/// - both(u, w, v, right, left): the answers for the triangles right.triangle() and left.triangle(). The corners u, w
///   and v are relative to p. The edge `right` joins u and w, the edge `left` joins w and v.
template <class Query>
concept CavityQuery = requires(const Query& query, VertexId v, const Slot& slot, const std::array<Corner, 3>& corners,
                               const Corner& corner, EdgeRef e) {
  { query.is_own(v) } -> std::same_as<bool>;
  { query.corner(v) } -> std::same_as<Corner>;
  { query.first_and_behind(slot, corners, e) } -> std::same_as<InDisks>;
  { query.both(corner, corner, corner, e, e) } -> std::same_as<DisksAndCorners>;
};

/// A query made of three functions, each for one triangle or vertex: in_disk(EdgeRef) -> bool,
/// corner_of(VertexId) -> Corner, and is_own(VertexId) -> bool. The walk's first triangle is not tested; it has to
/// belong to the cavity. The functions have to outlive the query.
template <class InDisk, class CornerOf, class IsOwn>
class SingleTriangleQuery {
 public:
  SingleTriangleQuery(const Triangulation& t, const InDisk& in_disk, const CornerOf& corner_of, const IsOwn& is_own)
      : t_(t), in_disk_(in_disk), corner_of_(corner_of), is_own_(is_own) {}

  [[nodiscard]] bool is_own(VertexId v) const { return is_own_(v); }
  [[nodiscard]] Corner corner(VertexId v) const { return corner_of_(v); }
  [[nodiscard]] InDisks first_and_behind(const Slot& /*first*/, const std::array<Corner, 3>& /*corners*/,
                                         EdgeRef behind) const {
    return InDisks::of(true, in_disk_(behind));
  }
  [[nodiscard]] DisksAndCorners both(Corner /*u*/, Corner /*w*/, Corner /*v*/, EdgeRef right, EdgeRef left) const {
    const auto far = [&](EdgeRef e) { return corner_of_(t_.slot(e).apex(e.side())); };
    return {InDisks::of(in_disk_(right), in_disk_(left)), {far(right), far(left)}};
  }

 private:
  const Triangulation& t_;
  const InDisk& in_disk_;
  const CornerOf& corner_of_;
  const IsOwn& is_own_;
};

}  // namespace pardel::engine
