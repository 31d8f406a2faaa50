#include "part_of_domain.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <set>

#include "../../core/support/agree.hpp"
#include "../../core/support/exchange_lists.hpp"
#include "../arithmetic/predicates.hpp"
#include "../concurrency/parallel_arrays.hpp"
#include "../construction/begin_with_latest.hpp"
#include "../construction/insert_constraints.hpp"
#include "../given_points/problems_of_points.hpp"
#include "../given_points/shared_hull.hpp"
#include "../input/findings.hpp"
#include "common_vertices.hpp"
#include "crossed_triangles.hpp"
#include "labels.hpp"
#include "triangles_at_borders.hpp"

namespace pardel::engine {
namespace {

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

/// The problems of segments, holes and regions, except points inside segments. They are the same on all ranks.
std::vector<Problem> problems_of_rest(const CommonVertices& common, const Pslg& rest, bool convex_hull,
                                      const Threads& threads) {
  // The convex hull of the common vertices is that of all points.
  Pslg known;
  known.holes = rest.holes;
  known.regions = rest.regions;
  for (Index i = 0; i < common.size(); ++i) known.points.push_back(common[i].at);
  known.segments = common.segments();
  std::vector<Problem> problems = find_problems(known, ValidateOptions{.convex_hull = convex_hull}, threads);
  for (Problem& problem : problems)
    if (problem.kind == ProblemKind::point_on_segment) problem.ids[0] = id_of_problem(common[problem.ids[0]].number);
  return problems;
}

class PartMaker {
 public:
  PartMaker(LocalDelaunay& delaunay, const OwnPoints& own, const Pslg& rest, bool convex_hull, Ranks& ranks,
            const Threads& threads)
      : delaunay_(delaunay),
        t_(delaunay.triangulation()),
        own_(own),
        rest_(rest),
        convex_hull_(convex_hull || rest.segments.empty()),
        ranks_(ranks),
        threads_(threads),
        first_(own.first[ranks.rank()]),
        hull_(delaunay, own, ranks),
        common_(hull_, rest.segments, delaunay, own, ranks) {
    part_.common = common_.size();
    part_.points = own.first.back();
  }

  [[nodiscard]] Result<PartOfDomain> make() {
    if (Status inserted = insert_segments(); !inserted) return inserted.error();
    DomainRules rules{convex_hull_, rest_.holes, {}};
    for (const Region& region : rest_.regions) rules.region_seeds.push_back(region.seed);
    const Labels labels(delaunay_, own_, hull_, rules, ranks_, threads_);
    number_triangles(labels);
    number_vertices();
    add_points();
    add_triangles(labels);
    add_regions(labels);
    add_segments();
    exchange_names();
    return std::move(part_);
  }

 private:
  [[nodiscard]] Status insert_segments() {
    const FirstId first_id = rest_.first_id;
    OrderedConstraints constraints;
    if (!is_point_set(rest_)) {
      if (Status fine = status_of(problems_of_rest(common_, rest_, convex_hull_, threads_), first_id); !fine)
        return fine;
      constraints = ordered_constraints(common_, delaunay_);
      if (Status fine = status_of(learn_crossed_triangles(constraints, delaunay_, own_, ranks_, threads_), first_id);
          !fine)
        return fine;
    }
    const std::array<VertexId, 3> first_three = FirstThree(delaunay_, ranks_).find();
    const auto when = [&](VertexId v) { return delaunay_.when(v); };
    begin_with_latest(t_, first_three, with_early_third(first_three[2], when), threads_);
    return agree(insert_in_order(t_, constraints.edges, threads_), ranks_);
  }

  void number_triangles(const Labels& labels) {
    kept_ = indices_where(threads_, t_.slots.size(), [&](std::size_t slot) {
      const auto id = static_cast<TriangleId>(slot);
      return !t_.slots[id].is_ghost() && delaunay_.has_own_corner(id) && labels.is_in_domain(id);
    });
    place_ = places_in(threads_, kept_.span(), t_.slots.size());
    own_triangles_ = static_cast<Index>(kept_.size());
    for (Index i = 0; i < own_triangles_; ++i) borrow_neighbours(t_.slots[kept_[i]], labels);
  }

  void borrow_neighbours(const Slot& slot, const Labels& labels) {
    if (!slot.any_constrained()) return;
    for (unsigned side = 0; side < 3; ++side) {
      const EdgeRef across = slot.n[side];
      if (!across.constrained() || place_[across.triangle()] != no_index || is_on_boundary(slot, side, labels))
        continue;
      place_[across.triangle()] = static_cast<Index>(kept_.size());
      part_.borrowed.push_back(place_[across.triangle()]);
      kept_.push_back(across.triangle());
    }
  }

  /// The index, on its owner, of a point that is not common.
  [[nodiscard]] Index index_at_owner(std::uint64_t position) const {
    const std::uint64_t first = own_.first[own_.owner(position)];
    const Index common = common_.before(position) - common_.before(first);
    return part_.common + static_cast<Index>(position - first) - common;
  }

  void number_vertices() {
    vertex_ = make_array(threads_, t_.points.size(), [](std::size_t) { return no_index; });
    Index next = part_.common;
    for (VertexId v = 0; v < delaunay_.own(); ++v) {
      const std::uint64_t position = first_ + v;
      vertex_[v] = common_.has(position) ? common_.before(position) : next++;
    }
    known_ = next;
    list_loose_points();
    for (const Index id : kept_)
      for (const VertexId v : t_.slots[id].v) {
        if (vertex_[v] != no_index) continue;
        const std::uint64_t position = delaunay_.site(v).position;
        if (common_.has(position)) {
          vertex_[v] = common_.before(position);
          continue;
        }
        vertex_[v] = next++;
        others_.push_back(v);
        part_.named_vertices.emplace_back(vertex_[v], Name{Name::rank(own_.owner(position)), index_at_owner(position)});
      }
  }

  void list_loose_points() {
    std::vector<bool> is_corner(delaunay_.own());
    for (const Index id : kept_)
      for (const VertexId v : t_.slots[id].v)
        if (delaunay_.is_own(v)) is_corner[v] = true;
    for (VertexId v = 0; v < delaunay_.own(); ++v)
      if (!is_corner[v] && vertex_[v] >= part_.common) part_.loose.push_back(vertex_[v]);
  }

  [[nodiscard]] bool has_markers() const {
    for (Index i = 0; i < common_.size(); ++i)
      if (common_[i].marker != 0) return true;
    return !own_.marker.empty();
  }

  void add_points() {
    Triangulation& t = part_.domain.triangulation;
    const bool marked = has_markers();
    t.points.resize_uninitialised(known_ + others_.size());
    part_.number.resize_uninitialised(known_);
    if (marked) part_.marker.resize(known_, 0);
    for (Index i = 0; i < part_.common; ++i) {
      t.points[i] = common_[i].at;
      part_.domain.input_of_vertex.push_back(static_cast<Index>(common_[i].number));
      part_.number[i] = common_[i].number;
      if (marked) part_.marker[i] = common_[i].marker;
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

  void add_triangles(const Labels& labels) {
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
          slot.n[k] = EdgeRef(place_[across.triangle()], across.side(), across.constrained());
        else if (!is_on_boundary(old, k, labels))
          part_.cut.emplace_back(static_cast<TriangleId>(i), k, across.constrained());
      }
    }
  }

  /// Whether the domain ends at this side. (The local neighbour need not be that of the triangulation of all points.)
  [[nodiscard]] bool is_on_boundary(const Slot& old, unsigned side, const Labels& labels) const {
    const std::uint64_t from = delaunay_.site(old.from(side)).position, to = delaunay_.site(old.to(side)).position;
    return hull_.has_edge(from, to) || (old.n[side].constrained() && !labels.is_in_domain_beside(to, from));
  }

  void add_regions(const Labels& labels) {
    if (rest_.regions.empty()) return;
    Array<Index>& region = part_.domain.triangulation.region;
    // Not empty even without triangles: this would mean that there are no regions.
    region.resize(std::max<std::size_t>(kept_.size(), 1), no_index);
    for (Index i = 0; i < own_triangles_; ++i) region[i] = labels.region(kept_[i]);
  }

  /// Then, if the domain is the convex hull, its edges that are no segments.
  void add_segments() {
    DomainTriangulation& domain = part_.domain;
    std::vector<Constraint> constraints;
    std::set<std::pair<Index, Index>> present;
    for (Index s = 0; const Segment& segment : common_.segments()) {
      constraints.push_back({segment.a, segment.b});
      present.insert(std::minmax(segment.a, segment.b));
      domain.input_segment.push_back(s++);
      domain.segment_marker.push_back(segment.marker);
    }
    for (const HullVertex& v : hull_.vertices()) {
      const Constraint edge{common_.before(v.position), common_.before(v.next)};
      if (!convex_hull_ || present.contains(std::minmax(edge.a, edge.b))) continue;
      constraints.push_back(edge);
      domain.input_segment.push_back(no_index);
      domain.segment_marker.push_back(0);
    }
    domain.segments = DomainSegments(domain.triangulation.points, constraints, threads_);
  }

  /// A triangle has the name that its home gives it.
  void exchange_names() {
    const auto place = [&](TriangleId id) { return place_[id]; };
    for (const ToldTriangle& told : told_by_homes(
             delaunay_, own_, ranks_, [&](TriangleId id) { return place(id) < own_triangles_; }, place))
      part_.named_triangles.emplace_back(place(told.id), Name{Name::rank(told.home), told.value});
  }

  LocalDelaunay& delaunay_;
  Triangulation& t_;
  const OwnPoints& own_;
  const Pslg& rest_;
  bool convex_hull_;
  Ranks& ranks_;
  Threads threads_;
  std::uint64_t first_;  ///< the position of the first own point
  SharedHull hull_;
  CommonVertices common_;
  /// The slots of the part's triangles, first those with own corners; for each slot its new index, or no_index.
  Array<Index> kept_, place_;
  Index own_triangles_ = 0;
  Array<Index> vertex_;  ///< for each old vertex its new index, or no_index
  Index known_ = 0;      ///< the number of vertices that are common or own
  std::vector<VertexId> others_;
  PartOfDomain part_;
};

}  // namespace

Result<PartOfDomain> part_of_domain(LocalDelaunay& delaunay, const OwnPoints& own, const Pslg& rest, bool convex_hull,
                                    Ranks& ranks, const Threads& threads) {
  return PartMaker(delaunay, own, rest, convex_hull, ranks, threads).make();
}

}  // namespace pardel::engine
