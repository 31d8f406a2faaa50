// SPDX-License-Identifier: GPL-3.0-or-later
#include "cgal_mesh_2.hpp"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_mesh_face_base_2.h>
#include <CGAL/Delaunay_mesh_vertex_base_2.h>
#include <CGAL/Delaunay_mesher_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <iterator>
#include <map>
#include <numeric>
#include <set>
#include <utility>

#include "bounds.hpp"

namespace pardel::bench {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

/// The point of the subdomain that a vertex is.
struct Origin {
  Index point = no_index;
};
using VertexBase =
    CGAL::Delaunay_mesh_vertex_base_2<Kernel, CGAL::Triangulation_vertex_base_with_info_2<Origin, Kernel>>;
using Structure = CGAL::Triangulation_data_structure_2<VertexBase, CGAL::Delaunay_mesh_face_base_2<Kernel>>;
using Triangulation = CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure>;
using VertexHandle = Triangulation::Vertex_handle;
using FaceHandle = Triangulation::Face_handle;

Point at(VertexHandle v) { return {v->point().x(), v->point().y()}; }

/// True if Mesh_2 splits a constrained edge ab because of a vertex p beside it.
bool encroaches(const Kernel::Point_2& p, const Kernel::Point_2& a, const Kernel::Point_2& b) {
  return CGAL::angle(a, p, b) != CGAL::ACUTE;
}

/// The two points of an edge, the lower one first.
using Ends = std::pair<Index, Index>;
Ends ends_of(Index a, Index b) { return std::minmax(a, b); }
Ends ends_of(const Triangulation::Edge& e) {
  return ends_of(e.first->vertex(Triangulation::ccw(e.second))->info().point,
                 e.first->vertex(Triangulation::cw(e.second))->info().point);
}

/// A part of the triangles of a subdomain, and the edges that Mesh_2 gets as constraints.
struct Region {
  std::vector<Index> triangles;
  std::set<Ends> frozen, free;
  std::vector<std::pair<Index, Index>> border;  ///< the region lies to the left
};

/// The region with these triangles.
Region region_of(const Subdomain& subdomain, std::vector<Index> triangles, bool splits_segments) {
  Region region;
  std::set<std::pair<Index, Index>> sides;
  for (const Index t : triangles) {
    const auto& v = subdomain.triangles[t];
    for (unsigned i = 0; i < 3; ++i) sides.emplace(v[i], v[(i + 1) % 3]);
  }
  for (const auto& [a, b] : sides)
    if (!sides.contains({b, a})) {
      region.border.emplace_back(a, b);
      region.frozen.insert(ends_of(a, b));
    }
  for (const SubdomainEdge& e : subdomain.edges) {
    if (!sides.contains({e.a, e.b}) && !sides.contains({e.b, e.a})) continue;
    // A piece of an edge whose other end is outside the cell may have its midpoint there.
    const auto& cell = subdomain.cell;
    const bool is_in_cell = !cell || (cell->contains(subdomain.points[e.a]) && cell->contains(subdomain.points[e.b]));
    const bool is_inner_border = e.inside && sides.contains({e.a, e.b}) != sides.contains({e.b, e.a});
    if (splits_segments && e.may_be_split && is_in_cell && !is_inner_border) {
      region.frozen.erase(ends_of(e.a, e.b));
      region.free.insert(ends_of(e.a, e.b));
    } else {
      region.frozen.insert(ends_of(e.a, e.b));
    }
  }
  region.triangles = std::move(triangles);
  return region;
}

/// The constrained Delaunay triangulation of a region; its faces are marked.
class Domain {
 public:
  Domain(const Subdomain& subdomain, const Region& region) {
    vertices_.resize(subdomain.points.size());
    FaceHandle near;
    for (const Index t : region.triangles)
      for (const Index point : subdomain.triangles[t]) {
        if (vertices_[point] != VertexHandle()) continue;
        const Point p = subdomain.points[point];
        vertices_[point] = cdt_.insert({p.x, p.y}, near);
        vertices_[point]->info().point = point;
        near = vertices_[point]->face();
      }
    for (const auto* const edges : {&region.frozen, &region.free})
      for (const auto& [a, b] : *edges) cdt_.insert_constraint(vertices_[a], vertices_[b]);
    mark(region);
  }

  [[nodiscard]] Triangulation& cdt() { return cdt_; }

 private:
  void mark(const Region& region) {
    for (auto f = cdt_.all_faces_begin(); f != cdt_.all_faces_end(); ++f) f->set_in_domain(false);
    std::vector<FaceHandle> waiting;
    for (const auto& [a, b] : region.border) {
      FaceHandle face;
      int side = 0;
      if (!cdt_.is_edge(vertices_[a], vertices_[b], face, side)) continue;
      waiting.push_back(face->vertex(Triangulation::ccw(side)) == vertices_[a] ? face : face->neighbor(side));
    }
    while (!waiting.empty()) {
      const FaceHandle face = waiting.back();
      waiting.pop_back();
      if (face->is_in_domain()) continue;
      face->set_in_domain(true);
      for (int i = 0; i < 3; ++i)
        if (!face->is_constrained(i)) waiting.push_back(face->neighbor(i));
    }
  }

  Triangulation cdt_;
  std::vector<VertexHandle> vertices_;
};

/// The frozen edges upon which a vertex beside them encroaches.
std::set<Ends> encroached(const Triangulation& cdt, const std::set<Ends>& frozen) {
  std::set<Ends> found;
  for (const auto& e : cdt.finite_edges()) {
    if (!cdt.is_constrained(e) || !frozen.contains(ends_of(e))) continue;
    const auto& a = e.first->vertex(Triangulation::ccw(e.second))->point();
    const auto& b = e.first->vertex(Triangulation::cw(e.second))->point();
    for (const VertexHandle apex : {e.first->vertex(e.second), cdt.tds().mirror_vertex(e.first, e.second)})
      if (!cdt.is_infinite(apex) && encroaches(apex->point(), a, b)) found.insert(ends_of(e));
  }
  return found;
}

/// The part of a subdomain in which Mesh_2 keeps the frozen edges.
Region usable_region(const Subdomain& subdomain, bool splits_segments) {
  std::vector<Index> triangles(subdomain.triangles.size());
  std::iota(triangles.begin(), triangles.end(), Index{0});
  while (true) {
    Region region = region_of(subdomain, std::move(triangles), splits_segments);
    if (region.triangles.empty()) return region;
    const std::set<Ends> bad = encroached(Domain(subdomain, region).cdt(), region.frozen);
    if (bad.empty()) return region;
    triangles = std::move(region.triangles);
    std::erase_if(triangles, [&](Index t) {
      const auto& v = subdomain.triangles[t];
      return bad.contains(ends_of(v[0], v[1])) || bad.contains(ends_of(v[1], v[2])) ||
             bad.contains(ends_of(v[2], v[0]));
    });
  }
}

/// The criteria for Mesh_2: the bounds of the subdomain, with the exceptions that cgal_mesh_2.hpp names. Triangles that
/// are too large come first, in decreasing size; then thin triangles, in increasing angle.
class CellCriteria {
 public:
  struct Quality : Bounds::Quality {
    bool operator<(const Quality& other) const {
      if (size > 1 || other.size > 1) return size > other.size;
      return squared_sine < other.squared_sine;
    }
  };
  class Is_bad {
   public:
    explicit Is_bad(const CellCriteria& all) : all_(all) {}
    CGAL::Mesh_2::Face_badness operator()(const Quality& quality) const {
      if (all_.bounds_.is_too_large(quality)) return CGAL::Mesh_2::IMPERATIVELY_BAD;
      return all_.bounds_.is_thin(quality) ? CGAL::Mesh_2::BAD : CGAL::Mesh_2::NOT_BAD;
    }
    CGAL::Mesh_2::Face_badness operator()(const FaceHandle& face, Quality& quality) const {
      const Point corner = at(face->vertex(0));
      static_cast<Bounds::Quality&>(quality) = all_.bounds_.quality(corner, at(face->vertex(1)), at(face->vertex(2)));
      const CGAL::Mesh_2::Face_badness badness = (*this)(quality);
      if (badness == CGAL::Mesh_2::NOT_BAD) return badness;
      const Kernel::Point_2 centre = all_.cdt_.circumcenter(face);
      if (!all_.bounds_.may_insert({centre.x(), centre.y()}, corner)) return CGAL::Mesh_2::NOT_BAD;
      return all_.disturbs_constraint(centre, face) ? CGAL::Mesh_2::NOT_BAD : badness;
    }

   private:
    const CellCriteria& all_;
  };

  CellCriteria(const Bounds& bounds, const Triangulation& cdt, const std::set<Ends>& frozen)
      : bounds_(bounds), cdt_(cdt), frozen_(frozen) {}
  [[nodiscard]] Is_bad is_bad_object() const { return Is_bad(*this); }

 private:
  /// True if p lies on a constrained edge, up to rounding, or encroaches upon a frozen one.
  [[nodiscard]] bool disturbs_constraint(const Kernel::Point_2& p, FaceHandle near) const {
    Triangulation::Locate_type place{};
    int side = 0;
    const FaceHandle face = cdt_.locate(p, place, side, near);
    if (place != Triangulation::FACE && (place != Triangulation::EDGE || face->is_constrained(side))) return true;
    std::vector<Triangulation::Edge> border;
    cdt_.get_boundary_of_conflicts(p, std::back_inserter(border), face);
    for (const Triangulation::Edge& e : border) {
      if (!e.first->is_constrained(e.second) || !frozen_.contains(ends_of(e))) continue;
      if (encroaches(p, e.first->vertex(Triangulation::ccw(e.second))->point(),
                     e.first->vertex(Triangulation::cw(e.second))->point()))
        return true;
    }
    return false;
  }

  const Bounds& bounds_;
  const Triangulation& cdt_;
  const std::set<Ends>& frozen_;
};

/// Makes the answer from the triangles that stayed and the faces of the domain.
class Answer {
 public:
  Answer(const Subdomain& subdomain, const Region& region, Triangulation& cdt) : subdomain_(subdomain), cdt_(cdt) {
    answer_.points = subdomain.points;
    std::vector<char> is_replaced(subdomain.triangles.size(), 0);
    for (const Index t : region.triangles) is_replaced[t] = 1;
    for (std::size_t t = 0; t < is_replaced.size(); ++t)
      if (is_replaced[t] == 0) answer_.triangles.push_back(subdomain.triangles[t]);
    for (const VertexHandle v : cdt.finite_vertex_handles())
      if (v->info().point == no_index) {
        v->info().point = static_cast<Index>(answer_.points.size());
        answer_.points.push_back(at(v));
      }
    answer_.edge_of_new_point.assign(answer_.points.size() - subdomain.points.size(), no_index);
    for (const FaceHandle f : cdt.finite_face_handles())
      if (f->is_in_domain())
        answer_.triangles.push_back(
            {f->vertex(0)->info().point, f->vertex(1)->info().point, f->vertex(2)->info().point});
    find_split_edges();
  }
  [[nodiscard]] RefinedSubdomain take() { return std::move(answer_); }

 private:
  [[nodiscard]] bool is_new(VertexHandle v) const { return v->info().point >= subdomain_.points.size(); }

  /// Mesh_2 does not say which constraint a vertex splits. A chain of constrained edges through new vertices leads from
  /// one end of the constraint to the other.
  void find_split_edges() {
    std::map<Ends, Index> edge_between;
    for (Index i = 0; i < subdomain_.edges.size(); ++i)
      edge_between[ends_of(subdomain_.edges[i].a, subdomain_.edges[i].b)] = i;
    for (const auto& e : cdt_.finite_edges()) {
      if (!cdt_.is_constrained(e)) continue;
      const VertexHandle a = e.first->vertex(Triangulation::ccw(e.second));
      const VertexHandle b = e.first->vertex(Triangulation::cw(e.second));
      if (is_new(a) == is_new(b)) continue;
      const VertexHandle start = is_new(a) ? b : a;
      std::vector<Index> chain;
      VertexHandle before = start, here = is_new(a) ? a : b;
      while (here != VertexHandle() && is_new(here)) {
        chain.push_back(here->info().point);
        before = std::exchange(here, other_end(here, before));
      }
      if (here == VertexHandle()) continue;
      const auto split = edge_between.find(ends_of(start->info().point, here->info().point));
      if (split == edge_between.end()) continue;
      for (const Index point : chain) answer_.edge_of_new_point[point - subdomain_.points.size()] = split->second;
    }
  }

  /// The end of the constrained edge at `v` that does not lead to `before`; none if there is no such edge.
  [[nodiscard]] VertexHandle other_end(VertexHandle v, VertexHandle before) const {
    const auto first = cdt_.incident_edges(v);
    auto e = first;
    do {
      const VertexHandle end = e->first->vertex(Triangulation::ccw(e->second)) == v
                                   ? e->first->vertex(Triangulation::cw(e->second))
                                   : e->first->vertex(Triangulation::ccw(e->second));
      if (e->first->is_constrained(e->second) && end != before) return end;
    } while (++e != first);
    return {};
  }

  const Subdomain& subdomain_;
  Triangulation& cdt_;
  RefinedSubdomain answer_;
};

class CgalMesh2 final : public SubdomainMesher {
 public:
  explicit CgalMesh2(bool splits_segments) : splits_segments_(splits_segments) {}
  [[nodiscard]] MesherAbilities abilities() const override {
    return {.obeys_cell = true,
            .keeps_frozen_edges = true,
            .splits_segments = splits_segments_,
            .exempts_small_angles = true,
            .is_thread_safe = true};
  }

  [[nodiscard]] RefinedSubdomain refine(const Subdomain& subdomain) override {
    const Region region = usable_region(subdomain, splits_segments_);
    Domain domain(subdomain, region);
    Triangulation& cdt = domain.cdt();
    const Bounds bounds(subdomain);
    const CellCriteria criteria(bounds, cdt, region.frozen);
    bool is_done = region.triangles.empty();
    if (!is_done) {
      CGAL::Delaunay_mesher_2<Triangulation, CellCriteria> mesher(cdt, criteria);
      mesher.init(true);
      const std::size_t most = cdt.number_of_vertices() + subdomain.most_new_points;
      while (!(is_done = mesher.is_refinement_done()) && cdt.number_of_vertices() < most)
        mesher.try_one_step_refine_mesh();
    }
    RefinedSubdomain answer = Answer(subdomain, region, cdt).take();
    if (!is_done) answer.ending = RefinedSubdomain::Ending::limit;
    return answer;
  }

 private:
  bool splits_segments_;
};

}  // namespace

std::unique_ptr<SubdomainMesher> cgal_mesh_2() { return std::make_unique<CgalMesh2>(false); }

std::unique_ptr<SubdomainMesher> cgal_mesh_2_with_segments() { return std::make_unique<CgalMesh2>(true); }

}  // namespace pardel::bench
