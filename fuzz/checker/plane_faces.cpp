#include "plane_faces.hpp"

#include <CGAL/Arr_naive_point_location.h>
#include <CGAL/Arr_segment_traits_2.h>
#include <CGAL/Arrangement_2.h>

#include <iterator>

namespace pardel::fuzz {

using ref::ExactPoint;
using ref::Number;
using ArrangementOfSegments = CGAL::Arrangement_2<CGAL::Arr_segment_traits_2<ref::Kernel>>;
// The faster location that walks along a line does not end for some points (CGAL 5.5).
using Location = CGAL::Arr_naive_point_location<ArrangementOfSegments>;

struct PlaneFaces::Arrangement : ArrangementOfSegments {
  [[nodiscard]] PlaneFaces::Face number(Face_const_handle face) const {
    return static_cast<std::size_t>(std::distance(faces_begin(), Face_const_iterator(face)));
  }
};

namespace {

/// Twice the signed area within a closed walk.
template <class Circulator>
Number twice_area(Circulator first) {
  Number sum = 0;
  Circulator at = first;
  do {
    const auto &p = at->source()->point(), &q = at->target()->point();
    sum += p.x() * q.y() - q.x() * p.y();
  } while (++at != first);
  return sum;
}

}  // namespace

PlaneFaces::PlaneFaces(const std::vector<Line>& lines) : arrangement_(std::make_unique<Arrangement>()) {
  std::vector<ref::Kernel::Segment_2> curves;
  curves.reserve(lines.size());
  for (const auto& [a, b] : lines) curves.emplace_back(a, b);
  CGAL::insert(*arrangement_, curves.begin(), curves.end());
}

PlaneFaces::~PlaneFaces() = default;

std::size_t PlaneFaces::count() const { return arrangement_->number_of_faces(); }

PlaneFaces::Face PlaneFaces::outside() const { return arrangement_->number(arrangement_->unbounded_face()); }

std::vector<PlaneFaces::Face> PlaneFaces::around(const ExactPoint& p) const {
  const auto found = Location(*arrangement_).locate(p);
  std::vector<Face> faces;
  if (const auto* face = boost::get<Arrangement::Face_const_handle>(&found)) faces = {arrangement_->number(*face)};
  if (const auto* edge = boost::get<Arrangement::Halfedge_const_handle>(&found))
    faces = {arrangement_->number((*edge)->face()), arrangement_->number((*edge)->twin()->face())};
  if (const auto* vertex = boost::get<Arrangement::Vertex_const_handle>(&found)) {
    const auto first = (*vertex)->incident_halfedges();
    auto at = first;
    do faces.push_back(arrangement_->number(at->face()));
    while (++at != first);
  }
  return faces;
}

PlaneFaces::Face PlaneFaces::left_of(const ExactPoint& a, const ExactPoint& b) const {
  const auto found = Location(*arrangement_).locate(CGAL::midpoint(a, b));
  const auto edge = boost::get<Arrangement::Halfedge_const_handle>(found);
  const bool runs_along = (edge->target()->point() - edge->source()->point()) * (b - a) > 0;
  return arrangement_->number(runs_along ? edge->face() : edge->twin()->face());
}

Number PlaneFaces::area(Face face) const {
  const auto at = std::next(arrangement_->faces_begin(), static_cast<std::ptrdiff_t>(face));
  Number twice = 0;
  for (auto outer = at->outer_ccbs_begin(); outer != at->outer_ccbs_end(); ++outer) twice += twice_area(*outer);
  for (auto inner = at->inner_ccbs_begin(); inner != at->inner_ccbs_end(); ++inner) twice += twice_area(*inner);
  return twice / 2;
}

}  // namespace pardel::fuzz
