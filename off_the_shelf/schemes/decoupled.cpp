// Domain decoupling with borders from the mesh itself (after Linardakis and Chrisochoides, "Delaunay decoupling method
// for parallel guaranteed quality planar mesh refinement", 2006, which uses a medial axis): the borders between parts
// run along edges of the coarse mesh, whose angles keep the goal. They are split to their final length before the parts
// are refined, so that no part needs another split of its border.
#include <algorithm>
#include <cmath>
#include <utility>

#include "../../parallel/arithmetic/between_ends.hpp"
#include "../../parallel/arithmetic/distance.hpp"
#include "../../parallel/arithmetic/floor.hpp"
#include "../../parallel/arithmetic/predicates.hpp"
#include "../../parallel/triangulation/flips.hpp"
#include "../../parallel/triangulation/triangle_shape.hpp"
#include "portions.hpp"
#include "schemes.hpp"

namespace pardel::engine {
namespace {

/// The pieces of a border in roots of the area wanted there. About the edges of the triangles beside it: longer pieces
/// would not be Delaunay edges.
constexpr double piece_of_unit_area = 1.3;

/// The shortest piece in lengths of the floor. Pieces of two edges that meet at 20 degrees are a third as far apart as
/// they are long.
constexpr double pieces_in_floor = 3;

/// Splits the edges between the portions of a phase.
class BorderSplitter {
 public:
  BorderSplitter(MesherRun& run, std::vector<Index>& portion_of) : run_(run), t_(run.mesh.t), portion_of_(portion_of) {}

  void run() {
    for (TriangleId id = 0; id < t_.slots.size(); ++id) is_thin_.push_back(is_thin(id) ? 1 : 0);
    // Triangles are added. One that gets a piece of a split border is visited then, or once more.
    for (TriangleId id = 0; id < t_.slots.size(); ++id)
      for (unsigned side = 0; side < 3;) side = is_border(id, side) && split(EdgeRef(id, side)) ? 0 : side + 1;
    keep_delaunay();
  }

 private:
  [[nodiscard]] bool is_border(TriangleId id, unsigned side) const {
    const EdgeRef outer = t_.slots[id].n[side];
    return !outer.constrained() && portion_of_[id] != portion_of_[outer.triangle()];
  }

  /// Splits an edge into pieces of about their final length, unless this could force a small angle. Returns whether it
  /// did; the edge of a piece is not split again.
  bool split(EdgeRef e) {
    const EdgeRef outer = t_.slot(e).n[e.side()];
    if (is_thin_[e.triangle()] != 0 || is_thin_[outer.triangle()] != 0) return false;
    const Point a = t_.points[t_.slot(e).from(e.side())], b = t_.points[t_.slot(e).to(e.side())];
    LocalHints hints;
    const double twice_area =
        run_.criteria.twice_area_wanted(middle_of(a, b), run_.mesh.assessor.region_of(e.triangle()), hints);
    const double length = distance(a, b), wanted = piece_of_unit_area * std::sqrt(twice_area / 2);
    const double least = pieces_in_floor * Floor(run_.options.min_edge).along(a, b);
    const double pieces = std::min(std::ceil((1 - 0x1p-40) * length / wanted), std::floor(length / least));
    if (!(pieces > 1 && pieces < 1e6)) return false;
    const std::uint64_t most = run_.options.max_vertices;
    if (most > 0 && static_cast<double>(t_.points.size()) + pieces > static_cast<double>(most)) return false;
    bool any = false;
    for (int i = 1; i < pieces; ++i) {
      const double part = i / pieces;
      if (!split_at({std::lerp(a.x, b.x, part), std::lerp(a.y, b.y, part)}, least, e)) break;
      any = true;
    }
    return any;
  }
  /// True if the angles of the triangle do not keep the goal, or if new vertices on two of its sides could come closer
  /// to each other than the floor.
  [[nodiscard]] bool is_thin(TriangleId id) const {
    const Shape shape(t_, t_.slots[id]);
    const double least_height = shape.twice_area / std::sqrt(std::ranges::max(shape.squared));
    return run_.criteria.bad_shape(shape) ||
           least_height < pieces_in_floor * Floor(run_.options.min_edge).at(shape.p[0]);
  }

  /// Splits the edge at p. `e` becomes the rest of the edge, from p on. False if a vertex across from the edge is
  /// nearer than `least`, or if doubles do not resolve the triangles.
  bool split_at(Point p, double least, EdgeRef& e) {
    const TriangleId left = e.triangle(), right = t_.slot(e).n[e.side()].triangle();
    t_.turn(left, e.side());
    t_.turn(right, t_.slots[left].n[0].side());
    const auto [c, a, b] = t_.slots[left].v;
    const VertexId d = t_.slots[right].v[0];
    const auto ccw = [&](VertexId u, VertexId v) { return orient2d(t_.points[u], t_.points[v], p) > 0; };
    e = EdgeRef(left, 0);
    if (distance(p, t_.points[c]) < least || distance(p, t_.points[d]) < least) return false;
    if (!ccw(c, a) || !ccw(b, c) || !ccw(a, d) || !ccw(d, b)) return false;
    const auto vertex = static_cast<VertexId>(t_.points.size());
    t_.points.push_back(p);
    t_.origin.push_back(interior_vertex);
    const TriangleId new_left = copy(left), new_right = copy(right);
    // left = (c, p, b) and right = (d, b, p) keep the end b; new_left = (c, a, p) and new_right = (d, p, a) get a.
    const EdgeRef across_ca = t_.slots[left].n[2], across_da = t_.slots[right].n[1];
    t_.slots[left].v[1] = t_.slots[right].v[2] = vertex;
    t_.slots[new_left].v[2] = t_.slots[new_right].v[1] = vertex;
    t_.link(EdgeRef(new_left, 2), across_ca);
    t_.link(EdgeRef(new_right, 1), across_da);
    t_.link(EdgeRef(new_left, 0), EdgeRef(new_right, 0));
    t_.link(EdgeRef(left, 2), EdgeRef(new_left, 1));
    t_.link(EdgeRef(right, 1), EdgeRef(new_right, 2));
    return true;
  }
  TriangleId copy(TriangleId id) {
    const auto made = static_cast<TriangleId>(t_.slots.size());
    t_.slots.push_back(Slot(t_.slots[id]));
    if (!t_.region.empty()) t_.region.push_back(Index(t_.region[id]));
    portion_of_.push_back(Index(portion_of_[id]));
    is_thin_.push_back(char(is_thin_[id]));
    return made;
  }

  /// Makes the mesh constrained Delaunay with the borders as constraints.
  void keep_delaunay() {
    const auto for_each_border = [&](const auto& visit) {
      for (TriangleId id = 0; id < t_.slots.size(); ++id)
        for (unsigned side = 0; side < 3; ++side) {
          const EdgeRef outer = t_.slots[id].n[side];
          if (!outer.none() && id < outer.triangle() && portion_of_[id] != portion_of_[outer.triangle()])
            visit(EdgeRef(id, side), outer);
        }
    };
    // Segments between two portions are borders, too, and stay constrained.
    std::vector<std::pair<VertexId, VertexId>> segments;
    const auto ends = [&](EdgeRef e) -> std::pair<VertexId, VertexId> {
      return std::minmax(t_.slot(e).from(e.side()), t_.slot(e).to(e.side()));
    };
    for_each_border([&](EdgeRef inner, EdgeRef outer) {
      if (outer.constrained())
        segments.push_back(ends(inner));
      else
        t_.constrain(inner);
    });
    std::ranges::sort(segments);
    make_delaunay(t_, run_.threads);
    for_each_border([&](EdgeRef inner, EdgeRef outer) {
      if (!std::ranges::binary_search(segments, ends(inner))) t_.link(inner, outer.with_constraint(false));
    });
  }

  MesherRun& run_;
  Triangulation& t_;
  std::vector<Index>& portion_of_;
  std::vector<char> is_thin_;  ///< of each triangle, or of the one of which it was a part
};

}  // namespace

void refine_decoupled(MesherRun& run) {
  const ToSplit to_split = triangles_to_split(run);
  if (to_split.triangles.empty()) return;
  Portions portions = divide_among_leaves(run, all_triangles(run.mesh.t), to_split, 0);
  const std::size_t vertices = run.mesh.t.points.size();
  if (run.criteria.has_size()) BorderSplitter(run, portions.portion_of).run();
  run.report.prepared += run.mesh.t.points.size() - vertices;
  for (Portion& portion : portions.all) portion.triangles.clear();
  for (TriangleId id = 0; id < portions.portion_of.size(); ++id)
    if (portions.portion_of[id] != no_index) portions.all[portions.portion_of[id]].triangles.push_back(id);
  ++run.report.sweeps;
  const std::uint64_t made = run_tasks(run, std::move(portions));
  // Where an answer was not used, borders are not Delaunay yet.
  make_delaunay(run.mesh.t, run.threads);
  show(run, made);
}

}  // namespace pardel::engine
