#include "input_faces.hpp"

#include <CGAL/Arr_segment_traits_2.h>
#include <CGAL/Arr_walk_along_line_point_location.h>
#include <CGAL/Arrangement_2.h>
#include <CGAL/convex_hull_2.h>

#include <algorithm>
#include <iterator>
#include <map>

namespace pardel::fuzz {
namespace {

using ref::ExactPoint;
using ref::Number;

/// The sides of the convex hull, divided at the points on them, without those that are segments.
std::vector<Wall> sides_of_hull(const Pslg& pslg) {
  std::map<ExactPoint, Index> index;  // from left to right, so in order along each side
  std::vector<ExactPoint> points, corners;
  for (Index i = 0; i < pslg.points.size(); ++i) {
    points.push_back(ref::exact(pslg.points[i]));
    index.emplace(points.back(), i);
  }
  std::set<ref::Edge> segments;
  for (const Segment& s : pslg.segments) segments.insert(ref::edge(s.a, s.b));
  CGAL::convex_hull_2(points.begin(), points.end(), std::back_inserter(corners));
  std::vector<Wall> sides;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const auto [from, to] = std::minmax(corners[i], corners[(i + 1) % corners.size()]);
    Index last = index.at(from);
    for (auto at = index.upper_bound(from); at != index.end() && at->first <= to; ++at) {
      if (CGAL::orientation(from, to, at->first) != CGAL::COLLINEAR) continue;
      if (!segments.contains(ref::edge(last, at->second))) sides.push_back({last, at->second, no_index, 0});
      last = at->second;
    }
  }
  return sides;
}

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

using ArrangementOfSegments = CGAL::Arrangement_2<CGAL::Arr_segment_traits_2<ref::Kernel>>;

struct InputFaces::Arrangement : ArrangementOfSegments {
  [[nodiscard]] InputFaces::Face number(Face_const_handle face) const {
    return static_cast<std::size_t>(std::distance(faces_begin(), Face_const_iterator(face)));
  }
};

InputFaces::InputFaces(const Pslg& pslg, bool convex_hull) : arrangement_(std::make_unique<Arrangement>()) {
  for (Index s = 0; s < pslg.segments.size(); ++s)
    walls_.push_back({pslg.segments[s].a, pslg.segments[s].b, s, pslg.segments[s].marker});
  if (convex_hull || pslg.segments.empty())
    for (const Wall& side : sides_of_hull(pslg)) walls_.push_back(side);
  std::vector<ref::Kernel::Segment_2> curves;
  for (const Wall& wall : walls_) curves.emplace_back(ref::exact(pslg.points[wall.a]), ref::exact(pslg.points[wall.b]));
  CGAL::insert(*arrangement_, curves.begin(), curves.end());
  outside_.insert(arrangement_->number(arrangement_->unbounded_face()));
  for (const Point seed : pslg.holes) outside_.insert(face_at(ref::exact(seed)));
  for (const Region& region : pslg.regions) face_of_region_.push_back(face_at(ref::exact(region.seed)));
  for (Wall& wall : walls_)
    wall.sides_inside = count_inside(CGAL::midpoint(ref::exact(pslg.points[wall.a]), ref::exact(pslg.points[wall.b])));
}

InputFaces::~InputFaces() = default;

std::vector<InputFaces::Face> InputFaces::around(const ExactPoint& p) const {
  const CGAL::Arr_walk_along_line_point_location<ArrangementOfSegments> location(*arrangement_);
  const auto found = location.locate(p);
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

int InputFaces::count_inside(const ExactPoint& p) const {
  const std::vector<Face> faces = around(p);
  return static_cast<int>(std::ranges::count_if(faces, [&](Face face) { return is_inside(face); }));
}

std::set<Index> InputFaces::regions_in(Face face) const {
  std::set<Index> regions;
  for (Index r = 0; r < face_of_region_.size(); ++r)
    if (face_of_region_[r] == face) regions.insert(r);
  return regions;
}

Number InputFaces::area() const {
  Number twice = 0;
  for (auto face = arrangement_->faces_begin(); face != arrangement_->faces_end(); ++face) {
    if (!is_inside(arrangement_->number(face))) continue;
    for (auto outer = face->outer_ccbs_begin(); outer != face->outer_ccbs_end(); ++outer) twice += twice_area(*outer);
    for (auto inner = face->inner_ccbs_begin(); inner != face->inner_ccbs_end(); ++inner) twice += twice_area(*inner);
  }
  return twice / 2;
}

}  // namespace pardel::fuzz
