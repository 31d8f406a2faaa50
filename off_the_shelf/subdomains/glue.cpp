#include "glue.hpp"

#include <algorithm>
#include <utility>

#include "../../parallel/threads/parallel_for.hpp"
#include "../../parallel/triangulation/flips.hpp"

namespace pardel::engine {
namespace {

/// A frozen edge between two parts, or between a part and the rest of the mesh: the side that it was, and the side that
/// it is.
struct RenamedSide {
  Index before;  ///< 4 * triangle + side
  EdgeRef now;
};
Index number_of(EdgeRef e) { return 4 * e.triangle() + e.side(); }

class Gluing {
 public:
  Gluing(MeshInWork& mesh, std::span<const Replacement> replacements, const Threads& threads)
      : t_(mesh.t), all_(replacements), threads_(threads) {}

  std::uint64_t run() {
    make_room();
    for (std::size_t i = 0; i < all_.size(); ++i) rename_border(i);
    std::ranges::sort(renamed_, {}, &RenamedSide::before);
    suspects_.resize(all_.size());
    parallel_for(threads_, all_.size(), [&](std::size_t i, int) {
      write_vertices(i);
      write_triangles(i);
      if (!t_.region.empty()) write_regions(i);
    });
    parallel_for(threads_, all_.size(), [&](std::size_t i, int) { find_suspects(i); });
    std::vector<EdgeRef> suspects;
    for (const std::vector<EdgeRef>& found : suspects_) suspects.insert(suspects.end(), found.begin(), found.end());
    const std::uint64_t count = suspects.size();
    std::vector<TriangleId> changed;
    restore_delaunay(t_, std::move(suspects), changed, threads_);
    return count;
  }

 private:
  void make_room() {
    std::size_t vertices = t_.points.size(), triangles = t_.slots.size();
    for (const Replacement& r : all_) {
      first_vertex_.push_back(static_cast<VertexId>(vertices));
      first_triangle_.push_back(static_cast<TriangleId>(triangles));
      vertices += r.answer.points.size() - r.part.vertices.size();
      triangles += r.answer.triangles.size() - r.part.triangles.size();
    }
    t_.points.resize_uninitialised(vertices);
    t_.origin.resize_uninitialised(vertices);
    t_.slots.resize_uninitialised(triangles);
    if (!t_.region.empty()) t_.region.resize_uninitialised(triangles);
  }

  [[nodiscard]] VertexId vertex(std::size_t i, Index point) const {
    const std::vector<VertexId>& old = all_[i].part.vertices;
    return point < old.size() ? old[point] : first_vertex_[i] + static_cast<VertexId>(point - old.size());
  }
  [[nodiscard]] TriangleId triangle(std::size_t i, Index local) const {
    const std::vector<TriangleId>& old = all_[i].part.triangles;
    return local < old.size() ? old[local] : first_triangle_[i] + static_cast<TriangleId>(local - old.size());
  }
  [[nodiscard]] bool is_constrained(std::size_t i, Index side) const {
    const Index edge = all_[i].answer.on_edge[side];
    return edge != no_index && all_[i].part.seams[edge].segment != no_index;
  }

  void rename_border(std::size_t i) {
    const VerifiedSubdomain& answer = all_[i].answer;
    for (Index side = 0; side < answer.across.size(); ++side) {
      if (answer.across[side] != no_index) continue;
      const Part::Seam& seam = all_[i].part.seams[answer.on_edge[side]];
      if (!seam.outer.none()) renamed_.push_back({number_of(seam.inner), EdgeRef(triangle(i, side / 3), side % 3)});
    }
  }

  void write_vertices(std::size_t i) {
    const VerifiedSubdomain& answer = all_[i].answer;
    const std::size_t old = all_[i].part.vertices.size();
    for (std::size_t k = old; k < answer.points.size(); ++k) {
      const VertexId v = vertex(i, static_cast<Index>(k));
      const Index edge = answer.edge_of_new_point[k - old];
      t_.points[v] = answer.points[k];
      t_.origin[v] = edge == no_index ? interior_vertex : origin_on_segment(all_[i].part.seams[edge].segment);
    }
  }

  void write_triangles(std::size_t i) {
    const VerifiedSubdomain& answer = all_[i].answer;
    for (Index local = 0; local < answer.triangles.size(); ++local) {
      Slot slot;
      for (unsigned k = 0; k < 3; ++k) slot.v[k] = vertex(i, answer.triangles[local][k]);
      const TriangleId id = triangle(i, local);
      for (unsigned k = 0; k < 3; ++k) {
        const Index side = 3 * local + k, across = answer.across[side];
        slot.n[k] = across != no_index ? EdgeRef(triangle(i, across / 3), across % 3, is_constrained(i, side))
                                       : beyond_border(EdgeRef(id, k), all_[i].part.seams[answer.on_edge[side]]);
      }
      t_.slots[id] = slot;
    }
  }

  /// The side of the triangle beyond the border of a part. If that triangle stays, its reference back is updated.
  [[nodiscard]] EdgeRef beyond_border(EdgeRef here, const Part::Seam& seam) {
    if (seam.outer.none()) return {};
    const bool constrained = seam.segment != no_index;
    const auto found = std::ranges::lower_bound(renamed_, number_of(seam.outer), {}, &RenamedSide::before);
    if (found != renamed_.end() && found->before == number_of(seam.outer))
      return found->now.with_constraint(constrained);
    t_.slots[seam.outer.triangle()].n[seam.outer.side()] = here.with_constraint(constrained);
    return seam.outer;
  }

  /// Spreads the regions beside the edges of the part over its faces.
  void write_regions(std::size_t i) {
    const VerifiedSubdomain& answer = all_[i].answer;
    std::vector<Index> waiting;
    std::vector<char> known(answer.triangles.size(), 0);
    const auto give = [&](Index local, Index region) {
      if (std::exchange(known[local], 1) != 0) return;
      t_.region[triangle(i, local)] = region;
      waiting.push_back(local);
    };
    for (Index side = 0; side < answer.on_edge.size(); ++side) {
      const Index edge = answer.on_edge[side];
      if (edge == no_index) continue;
      const Part::Seam& seam = all_[i].part.seams[edge];
      give(side / 3, runs_along(i, side, edge) ? seam.left_region : seam.right_region);
    }
    while (!waiting.empty()) {
      const Index local = waiting.back();
      waiting.pop_back();
      for (Index side = 3 * local; side < 3 * local + 3; ++side)
        if (answer.across[side] != no_index && answer.on_edge[side] == no_index)
          give(answer.across[side] / 3, t_.region[triangle(i, local)]);
    }
  }

  /// True if a piece of an edge has the direction of the edge, so that its triangle lies to the left.
  [[nodiscard]] bool runs_along(std::size_t i, Index side, Index edge) const {
    const VerifiedSubdomain& answer = all_[i].answer;
    const SubdomainEdge& e = all_[i].part.subdomain.edges[edge];
    const auto& v = answer.triangles[side / 3];
    const Point from = answer.points[v[(side + 1) % 3]], to = answer.points[v[(side % 3 + 2) % 3]];
    const Point a = answer.points[e.a], b = answer.points[e.b];
    return (to.x - from.x) * (b.x - a.x) + (to.y - from.y) * (b.y - a.y) > 0;
  }

  /// The answers are constrained Delaunay, so only their borders are tested.
  void find_suspects(std::size_t i) {
    const VerifiedSubdomain& answer = all_[i].answer;
    for (Index side = 0; side < answer.across.size(); ++side)
      if (const EdgeRef e(triangle(i, side / 3), side % 3); answer.across[side] == no_index && !locally_delaunay(t_, e))
        suspects_[i].push_back(e);
  }

  Triangulation& t_;
  std::span<const Replacement> all_;
  const Threads& threads_;
  std::vector<VertexId> first_vertex_;
  std::vector<TriangleId> first_triangle_;
  std::vector<RenamedSide> renamed_;
  std::vector<std::vector<EdgeRef>> suspects_;  ///< of each part: edges of its border that are not locally Delaunay
};

}  // namespace

std::uint64_t glue(MeshInWork& mesh, std::span<const Replacement> replacements, const Threads& threads) {
  return replacements.empty() ? 0 : Gluing(mesh, replacements, threads).run();
}

}  // namespace pardel::engine
