#include "part_of_domain.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <optional>

#include "../../core/support/exchange_lists.hpp"
#include "../../core/support/message.hpp"
#include "../arithmetic/predicates.hpp"
#include "../concurrency/parallel_arrays.hpp"
#include "../construction/begin_with_latest.hpp"
#include "../given_points/shared_hull.hpp"
#include "../triangulation/triangle_shape.hpp"

namespace pardel::engine {
namespace {

/// Where a triangle is, on its way from the rank that names it.
struct NamedTriangle {
  std::array<std::uint64_t, 3> corners;  ///< positions
  Index id;
  Index unused = 0;
};

/// The two vertices that come first in the order of insertion, and the first one that is not on a line with them. As
/// vertices of the local triangulation; no_index for those that it does not have.
class FirstThree {
 public:
  FirstThree(const LocalDelaunay& delaunay, Ranks& ranks) : delaunay_(delaunay), ranks_(ranks) {}

  [[nodiscard]] std::array<VertexId, 3> find() const {
    const Site first = earliest([](Point) { return true; });
    const Site second = earliest([&](Point p) { return p != first.at; });
    const Site third = earliest([&](Point p) { return orient2d(first.at, second.at, p) != 0; });
    return {delaunay_.known(first), delaunay_.known(second), delaunay_.known(third)};
  }

 private:
  template <class IsWanted>
  [[nodiscard]] Site earliest(const IsWanted& is_wanted) const {
    std::optional<VertexId> own;
    for (VertexId v = 0; v < delaunay_.own(); ++v)
      if (is_wanted(delaunay_.triangulation().points[v]) && (!own || delaunay_.when(v) < delaunay_.when(*own))) own = v;
    std::vector<Site> sent;
    if (own) sent.push_back(delaunay_.site(*own));
    const std::vector<Site> all = concatenated(lists_of_all(sent, ranks_));
    return *std::ranges::min_element(all, {}, [](const Site& s) { return InsertionOrder::rank_of(s.position); });
  }

  const LocalDelaunay& delaunay_;
  Ranks& ranks_;
};

class PartMaker {
 public:
  PartMaker(LocalDelaunay& delaunay, const OwnPoints& own, Ranks& ranks, const Threads& threads)
      : delaunay_(delaunay),
        t_(delaunay.triangulation()),
        own_(own),
        ranks_(ranks),
        threads_(threads),
        first_(own.first[ranks.rank()]),
        hull_(delaunay, own, ranks) {
    part_.hull = static_cast<Index>(hull_.vertices().size());
    part_.points = own.first.back();
  }

  [[nodiscard]] PartOfDomain make() {
    begin_with_latest(
        t_, FirstThree(delaunay_, ranks_).find(), [&](VertexId v) { return delaunay_.when(v); }, threads_);
    number_triangles();
    number_vertices();
    add_points();
    add_triangles();
    add_segments();
    exchange_names();
    return std::move(part_);
  }

 private:
  void number_triangles() {
    kept_ = indices_where(threads_, t_.slots.size(), [&](std::size_t id) {
      return !t_.slots[id].is_ghost() && delaunay_.has_own_corner(static_cast<TriangleId>(id));
    });
    place_ = places_in(threads_, kept_.span(), t_.slots.size());
  }

  /// The index, on its owner, of a point that is not on the hull.
  [[nodiscard]] Index index_at_owner(std::uint64_t position) const {
    const std::uint64_t first = own_.first[own_.owner(position)];
    const Index on_hull = hull_.before(position) - hull_.before(first);
    return part_.hull + static_cast<Index>(position - first) - on_hull;
  }

  void number_vertices() {
    vertex_ = make_array(threads_, t_.points.size(), [](std::size_t) { return no_index; });
    Index next = part_.hull;
    for (VertexId v = 0; v < delaunay_.own(); ++v) {
      const std::uint64_t position = first_ + v;
      vertex_[v] = hull_.has(position) ? hull_.before(position) : next++;
    }
    known_ = next;
    for (const Index id : kept_)
      for (const VertexId v : t_.slots[id].v) {
        if (vertex_[v] != no_index) continue;
        const std::uint64_t position = delaunay_.site(v).position;
        if (hull_.has(position)) {
          vertex_[v] = hull_.before(position);
          continue;
        }
        vertex_[v] = next++;
        others_.push_back(v);
        part_.named_vertices.emplace_back(vertex_[v], Name{Name::rank(own_.owner(position)), index_at_owner(position)});
      }
  }

  void add_points() {
    Triangulation& t = part_.domain.triangulation;
    const bool marked = !own_.marker.empty() ||
                        std::ranges::any_of(hull_.vertices(), [](const HullVertex& v) { return v.marker != 0; });
    for (const HullVertex& v : hull_.vertices()) {
      t.points.push_back(v.at);
      part_.domain.input_of_vertex.push_back(static_cast<Index>(v.number));
    }
    t.points.resize_uninitialised(known_ + others_.size());
    part_.number.resize_uninitialised(known_);
    if (marked) part_.marker.resize(known_, 0);
    for (Index i = 0; i < part_.hull; ++i) {
      part_.number[i] = hull_.vertices()[i].number;
      if (marked) part_.marker[i] = hull_.vertices()[i].marker;
    }
    for (VertexId v = 0; v < delaunay_.own(); ++v) {
      const Index at = vertex_[v];
      t.points[at] = t_.points[v];
      part_.number[at] = own_.number[v];
      if (!own_.marker.empty()) part_.marker[at] = own_.marker[v];
    }
    for (std::size_t i = 0; i < others_.size(); ++i) t.points[known_ + i] = t_.points[others_[i]];
    t.origin = make_array(threads_, t.points.size(), [](std::size_t) { return input_vertex; });
  }

  void add_triangles() {
    Triangulation& t = part_.domain.triangulation;
    t.slots.resize_uninitialised(kept_.size());
    for (std::size_t i = 0; i < kept_.size(); ++i) {
      const Slot& old = t_.slots[kept_[i]];
      Slot& slot = t.slots[i];
      slot = {};
      for (unsigned k = 0; k < 3; ++k) {
        slot.v[k] = vertex_[old.v[k]];
        const EdgeRef across = old.n[k];
        if (place_[across.triangle()] != no_index)
          slot.n[k] = EdgeRef(place_[across.triangle()], across.side());
        else if (!hull_.has_edge(delaunay_.site(old.from(k)).position, delaunay_.site(old.to(k)).position))
          part_.cut.emplace_back(static_cast<TriangleId>(i), k);
      }
    }
  }

  void add_segments() {
    std::vector<Constraint> constraints;
    for (Index i = 0; i < part_.hull; ++i) constraints.push_back({i, hull_.before(hull_.vertices()[i].next)});
    DomainTriangulation& domain = part_.domain;
    domain.input_segment.assign(constraints.size(), no_index);
    domain.segment_marker.assign(constraints.size(), 0);
    domain.segments = DomainSegments(domain.triangulation.points, constraints, threads_);
  }

  [[nodiscard]] std::array<std::uint64_t, 3> positions(const Slot& old) const {
    return {delaunay_.site(old.v[0]).position, delaunay_.site(old.v[1]).position, delaunay_.site(old.v[2]).position};
  }
  [[nodiscard]] int owner(VertexId old) const { return own_.owner(delaunay_.site(old).position); }

  /// A triangle has the name that the owner of its least corner gives it.
  void exchange_names() {
    std::vector<std::vector<NamedTriangle>> told(static_cast<std::size_t>(ranks_.count()));
    std::map<std::array<std::uint64_t, 3>, TriangleId> unnamed;
    for (std::size_t i = 0; i < kept_.size(); ++i) {
      const Slot& old = t_.slots[kept_[i]];
      if (std::ranges::all_of(old.v, [&](VertexId v) { return delaunay_.is_own(v); })) continue;
      const int home = owner(least_corner(t_, old));
      if (home != ranks_.rank()) {
        unnamed.emplace(positions(old), static_cast<TriangleId>(i));
        continue;
      }
      std::vector<int> others{owner(old.v[0]), owner(old.v[1]), owner(old.v[2])};
      std::ranges::sort(others);
      others.erase(std::unique(others.begin(), others.end()), others.end());
      for (const int rank : others)
        if (rank != ranks_.rank()) told[rank].push_back({positions(old), static_cast<Index>(i)});
    }
    const auto arrived = exchange_lists(told, ranks_);
    for (int rank = 0; rank < ranks_.count(); ++rank)
      for (const NamedTriangle& named : arrived[rank]) {
        const auto at = unnamed.find(named.corners);
        if (at == unnamed.end()) throw Reader::does_not_match();
        part_.named_triangles.emplace_back(at->second, Name{Name::rank(rank), named.id});
      }
    if (part_.named_triangles.size() != unnamed.size()) throw Reader::does_not_match();
  }

  LocalDelaunay& delaunay_;
  Triangulation& t_;
  const OwnPoints& own_;
  Ranks& ranks_;
  Threads threads_;
  std::uint64_t first_;  ///< the position of the first own point
  SharedHull hull_;
  Array<Index> kept_, place_;  ///< the slots of the part's triangles; for each slot its new index, or no_index
  Array<Index> vertex_;        ///< for each old vertex its new index, or no_index
  Index known_ = 0;            ///< the number of vertices that are on the hull or own
  std::vector<VertexId> others_;
  PartOfDomain part_;
};

}  // namespace

PartOfDomain part_of_domain(LocalDelaunay& delaunay, const OwnPoints& own, Ranks& ranks, const Threads& threads) {
  return PartMaker(delaunay, own, ranks, threads).make();
}

}  // namespace pardel::engine
