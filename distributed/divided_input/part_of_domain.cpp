#include "part_of_domain.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <span>

#include "../../core/support/agree.hpp"
#include "../../core/support/collective.hpp"
#include "../../core/support/exchange_lists.hpp"
#include "../../parallel/arithmetic/predicates.hpp"
#include "../../parallel/construction/begin_with_latest.hpp"
#include "../../parallel/construction/hairlines.hpp"
#include "../../parallel/construction/insert_constraints.hpp"
#include "../../parallel/threads/parallel_arrays.hpp"
#include "../../parallel/triangulation/triangle_shape.hpp"
#include "../cdt/common_segments.hpp"
#include "../cdt/common_vertices.hpp"
#include "../cdt/own_segments.hpp"
#include "../cdt/problems_of_domain.hpp"
#include "../cdt/segments_around.hpp"
#include "../cdt/sides_of_triangles.hpp"
#include "../delaunay/shared_hull.hpp"
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
    return *std::ranges::min_element(all, {}, [](const Site& s) { return InsertionOrder::time_of(s.position); });
  }

  const LocalDelaunay& delaunay_;
  Ranks& ranks_;
};

class PartMaker {
 public:
  PartMaker(TriangulatedPoints& points, const ReadDomain& read, bool convex_hull, Ranks& ranks, const Threads& threads)
      : points_(points),
        delaunay_(points.delaunay),
        t_(delaunay_.triangulation()),
        own_(points.own),
        read_(read),
        all_segments_(sum_of(read.segments.segments.size(), ranks)),
        convex_hull_(convex_hull || all_segments_ == 0),
        ranks_(ranks),
        threads_(threads),
        first_(own_.first[ranks.rank()]),
        hull_(delaunay_, own_, ranks) {
    part_.points = own_.first.back();
  }

  [[nodiscard]] Result<PartOfDomain> make() {
    if (all_segments_ >= no_index) return Error{ErrorKind::resources, "there are more segments than can be numbered"};
    if (!divide_all_segments()) return certainly_invalid();
    common_.emplace(hull_, segments_.common, delaunay_, own_, ranks_);
    part_.common = common_->size();
    if (const Status inserted = insert_segments(); !inserted) return certainly_invalid();
    DomainRules rules{convex_hull_, read_.rest.holes, {}};
    for (const Region& region : read_.rest.regions) rules.region_seeds.push_back(region.seed);
    const Labels labels(delaunay_, own_, hull_, rules, ranks_, threads_);
    const bool has_caps = std::ranges::all_of(read_.rest.regions, [](const Region& r) { return r.max_area > 0; });
    if (!labels.are_certainly_valid() || !has_caps)
      if (Status valid = whole_status(); !valid) return valid.error();
    number_triangles(labels);
    number_vertices();
    hairlines_ = find_hairlines(labels);
    add_segments();  // before the points: it may add vertices
    add_points();
    add_triangles(labels);
    add_regions(labels);
    exchange_names();
    return std::move(part_);
  }

 private:
  [[nodiscard]] Status whole_status() const {
    const std::span<const Point> at = delaunay_.triangulation().points.span().first(delaunay_.own());
    return status_of_whole(numbered(at, own_), read_.segments, read_.rest, convex_hull_, ranks_, threads_);
  }
  [[nodiscard]] Error certainly_invalid() const {
    const Status valid = whole_status();
    return valid ? Error{ErrorKind::internal, "the segments of a valid domain do not fit its triangulation"}
                 : valid.error();
  }

  /// False, on all ranks, if the segments are invalid.
  [[nodiscard]] bool divide_all_segments() {
    if (all_segments_ == 0) return true;
    OwnSegments own_segments = send_to_owners_of_ends(read_.segments, points_, ranks_);
    if (!own_segments.are_sound) return false;
    segments_ = divide_segments(std::move(own_segments.segments), hull_, delaunay_, own_, ranks_, threads_);
    return !segments_.pass_points;
  }

  [[nodiscard]] Status insert_segments() {
    const std::vector<Constraint> sides = learn_sides(segments_.own, delaunay_, own_, ranks_);
    std::vector<Constraint> crossing;
    for (const GivenSegment& s : segments_.common) crossing.push_back({delaunay_.vertex(s.a), delaunay_.vertex(s.b)});
    const std::array<VertexId, 3> first_three = FirstThree(delaunay_, ranks_).find();
    const auto when = [&](VertexId v) { return delaunay_.when(v); };
    begin_with_latest(t_, first_three, with_early_third(first_three[2], when), threads_);
    constrain(sides, delaunay_);
    return agree(insert_in_order(t_, crossing, threads_), ranks_);
  }

  /// Each rank tells the others about the flat triangles that are at home there.
  [[nodiscard]] std::vector<Hairline> find_hairlines(const Labels& labels) {
    std::vector<FlatTriangle> flat;
    for (TriangleId id = 0; id < t_.slots.size(); ++id) {
      const Slot& slot = t_.slots[id];
      if (!slot.is_ghost() && delaunay_.is_own(least_corner(t_, slot)) && !labels.is_in_domain(id))
        add_if_flat(
            t_, slot, [&](VertexId v) { return delaunay_.site(v).position; }, flat);
    }
    return hairlines_among(concatenated(lists_of_all(flat, ranks_)));
  }

  void number_triangles(const Labels& labels) {
    kept_ = indices_where(threads_, t_.slots.size(), [&](std::size_t slot) {
      const auto id = static_cast<TriangleId>(slot);
      return !t_.slots[id].is_ghost() && delaunay_.has_own_corner(id) && labels.is_in_domain(id);
    });
    place_ = places_in(threads_, kept_.span(), t_.slots.size());
    own_triangles_ = static_cast<Index>(kept_.size());
    for (Index i = 0; i < own_triangles_; ++i) add_halo(t_.slots[kept_[i]], labels);
  }

  void add_halo(const Slot& slot, const Labels& labels) {
    if (!slot.any_constrained()) return;
    for (unsigned side = 0; side < 3; ++side) {
      const EdgeRef across = slot.n[side];
      if (!across.constrained() || place_[across.triangle()] != no_index || is_on_boundary(slot, side, labels))
        continue;
      place_[across.triangle()] = static_cast<Index>(kept_.size());
      part_.halo.push_back(place_[across.triangle()]);
      kept_.push_back(across.triangle());
    }
  }

  /// The name of a point that is not common: its index in the part of its owner.
  [[nodiscard]] Name name_at_owner(std::uint64_t position) const {
    const int owner = own_.owner(position);
    const std::uint64_t first = own_.first[owner];
    const Index common = common_->before(position) - common_->before(first);
    return {Name::rank(owner), part_.common + static_cast<Index>(position - first) - common};
  }

  void number_vertices() {
    vertex_ = make_array(threads_, t_.points.size(), [](std::size_t) { return no_index; });
    Index next = part_.common;
    for (VertexId v = 0; v < delaunay_.own(); ++v) {
      const std::uint64_t position = first_ + v;
      vertex_[v] = common_->has(position) ? common_->before(position) : next++;
    }
    known_ = next;
    list_loose_points();
    for (const Index id : kept_)
      for (const VertexId v : t_.slots[id].v) {
        if (vertex_[v] != no_index) continue;
        const std::uint64_t position = delaunay_.site(v).position;
        if (common_->has(position)) {
          vertex_[v] = common_->before(position);
          continue;
        }
        vertex_[v] = next++;
        others_.push_back(v);
        part_.named_vertices.emplace_back(vertex_[v], name_at_owner(position));
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
    for (Index i = 0; i < common_->size(); ++i)
      if ((*common_)[i].marker != 0) return true;
    return !own_.marker.empty();
  }

  void add_points() {
    Triangulation& t = part_.domain.triangulation;
    const bool marked = has_markers();
    t.points.resize_uninitialised(known_ + others_.size() + far_ends_.size());
    part_.number.resize_uninitialised(known_);
    if (marked) part_.marker.resize(known_, 0);
    for (Index i = 0; i < part_.common; ++i) {
      t.points[i] = (*common_)[i].at;
      part_.domain.input_of_vertex.push_back(static_cast<Index>((*common_)[i].number));
      part_.number[i] = (*common_)[i].number;
      if (marked) part_.marker[i] = (*common_)[i].marker;
    }
    for (VertexId v = 0; v < delaunay_.own(); ++v) {
      const Index at = vertex_[v];
      t.points[at] = t_.points[v];
      part_.number[at] = own_.number[v];
      if (!own_.marker.empty()) part_.marker[at] = own_.marker[v];
    }
    for (std::size_t i = 0; i < others_.size(); ++i) t.points[known_ + i] = t_.points[others_[i]];
    for (std::size_t i = 0; i < far_ends_.size(); ++i) t.points[known_ + others_.size() + i] = far_ends_[i].at;
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
        else if (i >= own_triangles_ || !is_on_boundary(old, k, labels))  // nobody asks beyond the halo
          part_.cut.emplace_back(static_cast<TriangleId>(i), k, across.constrained());
      }
    }
  }

  /// Whether the domain ends at this side. (The local neighbour need not be that of the triangulation of all points.)
  [[nodiscard]] bool is_on_boundary(const Slot& old, unsigned side, const Labels& labels) const {
    const std::uint64_t from = delaunay_.site(old.from(side)).position, to = delaunay_.site(old.to(side)).position;
    return hull_.has_edge(from, to) || (old.n[side].constrained() && !labels.is_in_domain_beyond(old, side));
  }

  void add_regions(const Labels& labels) {
    if (read_.rest.regions.empty()) return;
    Array<Index>& region = part_.domain.triangulation.region;
    // Not empty even without triangles: this would mean that there are no regions.
    region.resize(std::max<std::size_t>(kept_.size(), 1), no_index);
    for (Index i = 0; i < own_triangles_; ++i) region[i] = labels.region(kept_[i]);
  }

  /// The common segments. If the domain is the convex hull, the edges of the hull that are no segments come after them.
  [[nodiscard]] std::vector<GivenSegment> common_segments() const {
    std::vector<GivenSegment> all = segments_.common;
    for (const HullVertex& v : hull_.vertices()) {
      if (!convex_hull_) break;
      const HullVertex& next = *at_position(hull_.vertices(), v.next);
      const auto [a, b] = std::minmax(
          v, next, [](const HullVertex& left, const HullVertex& right) { return left.position < right.position; });
      if (with_ends(segments_.common, {a.position, b.position}) == nullptr)
        all.push_back({{a.at, a.position}, {b.at, b.position}, no_index, 0});
    }
    return all;
  }

  void add_segments() {
    const std::vector<GivenSegment> common = common_segments();
    part_.common_segments = static_cast<Index>(common.size());
    std::vector<std::uint64_t> needed;
    for (Index i = 0; i < part_.common; ++i) needed.push_back((*common_)[i].position);
    for (const VertexId v : others_) needed.push_back(delaunay_.site(v).position);
    SegmentsAround around(common, segments_.own, std::move(needed), own_, ranks_, threads_);
    around.keep_clear(std::move(hairlines_));
    segments_ = {};
    std::vector<VertexId> vertex(around.ends().size(), no_index);  // in the part
    const auto vertex_of = [&](Index end) {
      if (vertex[end] == no_index) vertex[end] = vertex_of_end(around.ends()[end]);
      return vertex[end];
    };
    std::vector<Index> index(around.segments().size(), no_index);  // in the part
    for (Index i = 0; i < index.size(); ++i) {
      if (!around.is_known(around.segments()[i].segment)) continue;
      index[i] = static_cast<Index>(part_.domain.segments.size());
      add_segment(around, i, vertex_of);
    }
    std::vector<std::pair<VertexId, Index>> ends;
    for (Index end = 0; end < around.ends().size(); ++end)
      if (around.is_known(around.ends()[end])) ends.emplace_back(vertex_of(end), end);
    std::ranges::sort(ends);
    for (const auto& [v, end] : ends) {
      std::vector<Index> here;
      for (const Index i : around.domain_segments().segments_at(end)) here.push_back(index[i]);
      part_.domain.segments.add_end(v, here);
    }
  }

  /// The vertex of the part at the end of a segment. It need not be a corner of a triangle.
  [[nodiscard]] VertexId vertex_of_end(const Site& end) {
    if (common_->has(end.position)) return common_->before(end.position);
    if (const VertexId v = delaunay_.known(end); v != no_index && vertex_[v] != no_index) return vertex_[v];
    const auto added = static_cast<VertexId>(known_ + others_.size() + far_ends_.size());
    far_ends_.push_back(end);
    part_.named_vertices.emplace_back(added, name_at_owner(end.position));
    return added;
  }

  template <class VertexOf>
  void add_segment(const SegmentsAround& around, Index number, const VertexOf& vertex_of) {
    const NamedSegment& named = around.segments()[number];
    const DomainSegment& s = around.domain_segments()[number];
    const VertexId apex = s.narrow_apex == no_index ? no_index : vertex_of(s.narrow_apex);
    std::vector<PlaceBesideEnd> places;
    for (const PlaceBesideEnd& place : around.domain_segments().places_beside_ends(number))
      places.push_back({vertex_of(place.apex), place.distance, place.gap});
    DomainTriangulation& domain = part_.domain;
    const bool is_of_others = named.name.creator != Name::everyone && named.name.creator != Name::rank(ranks_.rank());
    if (is_of_others) part_.named_segments.emplace_back(static_cast<Index>(domain.segments.size()), named.name);
    domain.segments.add({vertex_of(s.a), vertex_of(s.b), s.cosine_at_a, s.cosine_at_b, apex, named.segment.marker},
                        places, around.domain_segments().clearances(number));
    domain.input_segment.push_back(named.segment.number);
  }

  /// A triangle has the name that its home gives it.
  void exchange_names() {
    const auto place = [&](TriangleId id) { return place_[id]; };
    for (const ToldTriangle& told : told_by_homes(
             delaunay_, own_, ranks_, [&](TriangleId id) { return place(id) < own_triangles_; }, place))
      part_.named_triangles.emplace_back(place(told.id), Name{Name::rank(told.home), told.value});
  }

  TriangulatedPoints& points_;
  LocalDelaunay& delaunay_;
  Triangulation& t_;
  const OwnPoints& own_;
  const ReadDomain& read_;
  std::uint64_t all_segments_;  ///< how many all ranks have read
  bool convex_hull_;
  Ranks& ranks_;
  Threads threads_;
  std::uint64_t first_;  ///< the position of the first own point
  SharedHull hull_;
  DividedSegments segments_;
  std::vector<Hairline> hairlines_;
  std::optional<CommonVertices> common_;
  /// The slots of the part's triangles, first those with own corners; for each slot its new index, or no_index.
  Array<Index> kept_, place_;
  Index own_triangles_ = 0;
  Array<Index> vertex_;  ///< for each old vertex its new index, or no_index
  Index known_ = 0;      ///< the number of vertices that are common or own
  std::vector<VertexId> others_;
  std::vector<Site> far_ends_;  ///< ends of segments at the part's vertices that are not among these
  PartOfDomain part_;
};

}  // namespace

Result<PartOfDomain> part_of_domain(TriangulatedPoints& points, const ReadDomain& read, bool convex_hull, Ranks& ranks,
                                    const Threads& threads) {
  return PartMaker(points, read, convex_hull, ranks, threads).make();
}

}  // namespace pardel::engine
