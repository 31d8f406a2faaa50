// The Delaunay triangulation of the points that a rank knows.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

#include "../../core/array.hpp"
#include "../../core/result.hpp"
#include "../../parallel/construction/bowyer_watson.hpp"
#include "../../parallel/threads/threads.hpp"
#include "../../parallel/triangulation/triangulation.hpp"

namespace pardel::engine {

/// One of the given points. Its position along the curve tells who owns it, and when it counts as inserted.
struct Site {
  Point at;
  std::uint64_t position = 0;
};

/// A rank knows its own points, which are the first vertices, and some of the others. It learns of more points as it
/// asks other ranks about its triangles. The triangles depend on the points alone, not on the sequence in which the
/// rank learns of them (InsertionOrder).
class LocalDelaunay {
 public:
  /// `first`: the position of the first own point. The other own points follow it along the curve.
  LocalDelaunay(Array<Point> own, std::uint64_t first);
  LocalDelaunay(const LocalDelaunay&) = delete;
  LocalDelaunay& operator=(const LocalDelaunay&) = delete;

  /// Triangulates the own points and the others. To be called once, before the other functions. The errors are those of
  /// triangulate_points().
  [[nodiscard]] Status triangulate(std::span<const Site> others, const Threads& threads);

  [[nodiscard]] const Triangulation& triangulation() const { return t_; }
  [[nodiscard]] Triangulation& triangulation() { return t_; }
  [[nodiscard]] Index own() const { return own_; }
  [[nodiscard]] bool is_own(VertexId v) const { return v < own_; }
  [[nodiscard]] Site site(VertexId v) const { return {t_.points[v], order_.position(v)}; }
  /// A number that is greater for vertices that come later in the order of insertion.
  [[nodiscard]] std::uint64_t when(VertexId v) const { return order_.time(v); }
  /// The vertex of a point; no_index if the rank does not know the point.
  [[nodiscard]] VertexId known(const Site& site) const;
  [[nodiscard]] bool has_own_corner(TriangleId id) const;

  /// The vertex of a point, which is inserted if it is new.
  VertexId vertex(const Site& site);
  /// A triangle with the corner v. O(1) as long as the last known one exists; otherwise a search, which begins near the
  /// last vertex that was inserted or asked for.
  [[nodiscard]] TriangleId triangle_at(VertexId v);
  /// A triangle that another rank has: its corners, counter-clockwise. The last one can be the vertex at infinity.
  using Corners = std::array<VertexId, 3>;
  /// The neighbours of the corners that lie in the disk of the triangle; ascending. There are some if any vertex lies
  /// in it: of the edges of a Delaunay triangulation, those that leave a vertex of the triangle's circle lead to a
  /// vertex inside if there is one (THEORY_OF_RANKS.md, GivenPoints).
  [[nodiscard]] std::vector<VertexId> neighbours_in_disk(const Corners& corners);

  /// The slots of the triangles that have been made since the last call, with repetitions.
  [[nodiscard]] std::vector<TriangleId> take_fresh() { return std::exchange(fresh_, {}); }

 private:
  [[nodiscard]] bool is_own_position(std::uint64_t position) const {
    return position >= first_ && position - first_ < own_;
  }

  Triangulation t_;
  std::uint64_t first_;
  Index own_;
  InsertionOrder order_;
  BowyerWatson inserter_;
  std::unordered_map<std::uint64_t, VertexId> others_;  ///< by position
  std::vector<TriangleId> fresh_;
  Array<TriangleId> at_;  ///< per vertex, a triangle that had this corner when it was made or last asked for
};

}  // namespace pardel::engine
