#include "refinement.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "../core/user_test.hpp"
#include "insertion.hpp"

namespace pardel::ref {
namespace {

bool below_sixty_degrees(const ExactPoint& apex, const ExactPoint& p, const ExactPoint& q) {
  const Kernel::Vector_2 u = p - apex, v = q - apex;
  const Number dot = u * v;
  return dot > 0 && 4 * dot * dot > u.squared_length() * v.squared_length();
}

/// Removes the four vertices `first` to `first` + 3. Precondition: no triangle uses them.
void drop_four_vertices(Refinement& state, Index first) {
  const auto renumbered = [&](Index v) { return v < first ? v : v - 4; };
  const auto drop = [&](auto& values) { values.erase(values.begin() + first, values.begin() + first + 4); };
  drop(state.mesh.points);
  drop(state.provenance.origin);
  for (Corners& t : state.mesh.triangles)
    for (Index& v : t) v = renumbered(v);
  std::map<Edge, Index> segments;
  for (const auto& [e, segment] : state.provenance.segment_of_edge)
    segments[{renumbered(e[0]), renumbered(e[1])}] = segment;
  state.provenance.segment_of_edge = segments;
}

}  // namespace

std::optional<Error> unsupported(const Pslg& pslg, const Goal& goal) {
  const auto usage = [](const char* why) { return Error{ErrorKind::usage, why}; };
  const double proven = std::asin(1 / (2 * std::numbers::sqrt2)) * (180 / std::numbers::pi);
  if (pslg.segments.empty()) return usage("The reference refiner needs segments.");
  if (pslg.attributes_per_point != 0) return usage("The reference refiner carries no point attributes.");
  if (goal.convex_hull) return usage("The reference refiner meshes outlines, not hulls.");
  if (!(goal.min_angle_deg <= proven)) return usage("The angle bound is above what Ruppert's proof covers.");
  for (const Segment& s : pslg.segments)
    for (const Segment& t : pslg.segments)
      for (const auto& [apex, p] : {Edge{s.a, s.b}, Edge{s.b, s.a}})
        for (const auto& [other, q] : {Edge{t.a, t.b}, Edge{t.b, t.a}})
          if (apex == other && p != q &&
              below_sixty_degrees(exact(pslg.points[apex]), exact(pslg.points[p]), exact(pslg.points[q])))
            return usage("Two segments meet at less than 60 degrees.");
  return std::nullopt;
}

Refinement conforming_delaunay(const Pslg& pslg) {
  // Start with the Delaunay triangulation of the input vertices, and split every encroached subsegment. In the end all
  // subsegments are edges, because an edge whose diametral circle is empty is Delaunay.
  Refinement state;
  state.mesh = delaunay_in_far_box(pslg.points);
  const auto inputs = static_cast<Index>(pslg.points.size());
  state.provenance.origin.assign(inputs + 4, input_vertex);
  for (Index s = 0; s < pslg.segments.size(); ++s) {
    const Edge e = edge(pslg.segments[s].a, pslg.segments[s].b);
    state.provenance.segment_of_edge[e] = s;
    if (is_encroached(state.mesh, e)) request_split(state, e);
  }
  split_waiting(state);

  // Now the subsegments form the border of the domain. Remove the far box, the exterior and the holes.
  for (const auto& [e, segment] : state.provenance.segment_of_edge) state.mesh.constraints.insert(e);
  carve(state.mesh, state.mesh.points[inputs], pslg.holes);
  drop_four_vertices(state, inputs);
  std::set<Edge> edges;
  for (const Corners& t : state.mesh.triangles) edges.insert({edge_of(t, 0), edge_of(t, 1), edge_of(t, 2)});
  std::erase_if(state.provenance.segment_of_edge, [&](const auto& entry) { return !edges.contains(entry.first); });
  state.mesh.constraints.clear();
  for (const auto& [e, segment] : state.provenance.segment_of_edge) state.mesh.constraints.insert(e);
  return state;
}

void request_split(Refinement& state, const Edge& e) {
  const ExactPoint middle = CGAL::midpoint(state.mesh.points[e[0]], state.mesh.points[e[1]]);
  if (exact(rounded(middle)) != middle)
    state.failure = Error{ErrorKind::invalid_input, "The midpoint of a subsegment is not representable."};
  state.waiting.try_emplace(e, exact(rounded(middle)));
}

void split_waiting(Refinement& state) {
  while (!state.waiting.empty() && !state.failure) {
    const auto [e, middle] = *state.waiting.begin();
    const Index vertex = insert(state.mesh, middle);
    record_origin(state, vertex, e);
    for (const Edge& other : newly_encroached(state, vertex)) request_split(state, other);
  }
}

void record_origin(Refinement& state, Index vertex, const std::optional<Edge>& split) {
  auto& segment_of_edge = state.provenance.segment_of_edge;
  if (!split) {
    state.provenance.origin.push_back(interior_vertex);
    return;
  }
  const Index segment = segment_of_edge.at(*split);
  state.provenance.origin.push_back(origin_on_segment(segment));
  segment_of_edge.erase(*split);
  for (Index end : *split) segment_of_edge[edge(end, vertex)] = segment;
  state.waiting.erase(*split);
}

std::vector<Edge> newly_encroached(const Refinement& state, Index vertex) {
  const std::vector<ExactPoint>& points = state.mesh.points;
  std::vector<Edge> encroached;
  for (const auto& [e, segment] : state.provenance.segment_of_edge) {
    const bool is_half = e[0] == vertex || e[1] == vertex;
    if (is_half ? is_encroached(state.mesh, e) : encroaches(points[vertex], points[e[0]], points[e[1]]))
      encroached.push_back(e);
  }
  return encroached;
}

double inverse_squared_ratio(const Goal& goal) {
  const double sine = std::sin(goal.min_angle_deg * (std::numbers::pi / 180));
  return 4 * sine * sine;
}

Criteria::Criteria(const Pslg& pslg, const Goal& goal, const PlainMesh& mesh) : goal_(goal) {
  if (!goal.region_caps) return;
  for (const Region& region : pslg.regions) {
    PlainMesh face{mesh.points, {}, {}};
    for (Index t : face_of(mesh, exact(region.seed))) face.triangles.push_back(mesh.triangles[t]);
    caps_.push_back({std::move(face), region.max_area});
  }
}

const std::optional<ExactPoint>& Criteria::split_point(const PlainMesh& mesh, const Corners& t) {
  const auto [entry, is_new] = known_.try_emplace(t);
  if (is_new && is_bad(mesh, t)) entry->second = exact(rounded(circumcentre(mesh, t)));
  return entry->second;
}

double Criteria::area_cap_at(const ExactPoint& p) const {
  for (const auto& [face, max_area] : caps_)
    for (const Corners& t : face.triangles) {
      const Kernel::Triangle_2 triangle(face.points[t[0]], face.points[t[1]], face.points[t[2]]);
      if (!triangle.has_on_unbounded_side(p)) return max_area;
    }
  return std::numeric_limits<double>::infinity();
}

bool Criteria::is_bad(const PlainMesh& mesh, const Corners& t) const {
  if (squared_circumradius(mesh, t) * inverse_squared_ratio(goal_) > squared_shortest_edge(mesh, t)) return true;

  const ExactPoint centroid = CGAL::centroid(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]);
  const double max_area = std::min(goal_.max_area, area_cap_at(centroid));
  if (std::isfinite(max_area) && area(mesh, t) > max_area) return true;

  if (goal_.user_test) {
    const auto corner = [&](int i) { return rounded(mesh.points[t[i]]); };
    if (must_be_refined(goal_.user_test, corner(0), corner(1), corner(2))) return true;
  }
  double max_edge = goal_.max_edge;
  if (goal_.size) max_edge = std::min(max_edge, goal_.size(rounded(centroid)));
  if (!std::isfinite(max_edge)) return false;
  const Number bound = Number(max_edge) * Number(max_edge);
  for (int i = 0; i < 3; ++i)
    if (CGAL::squared_distance(mesh.points[t[i]], mesh.points[t[(i + 1) % 3]]) > bound) return true;
  return false;
}

}  // namespace pardel::ref
