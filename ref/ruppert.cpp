#include "ruppert.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <numbers>
#include <optional>

#include "faces.hpp"
#include "insertion.hpp"

namespace pardel::ref {
namespace {

/// The state of the algorithm: a Delaunay mesh, and where its vertices and subsegments come from.
struct Refinement {
  PlainMesh mesh;
  Provenance provenance;
  std::set<Corners> good;  ///< triangles that were examined and need no split; a triangle never changes
};

bool below_sixty_degrees(const ExactPoint& apex, const ExactPoint& p, const ExactPoint& q) {
  const Kernel::Vector_2 u = p - apex, v = q - apex;
  const Number dot = u * v;
  return dot > 0 && 4 * dot * dot > u.squared_length() * v.squared_length();
}

std::optional<Error> refused(const Pslg& pslg, const Goal& goal) {
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

/// Splits the subsegment at its midpoint. Returns the new vertex, or nothing when the midpoint is no double.
std::optional<Index> split(Refinement& state, const Edge& e) {
  const ExactPoint middle = CGAL::midpoint(state.mesh.points[e[0]], state.mesh.points[e[1]]);
  if (exact(rounded(middle)) != middle) return std::nullopt;
  const Index segment = state.provenance.segment_of_edge.at(e);
  const Index vertex = insert(state.mesh, exact(rounded(middle)));
  state.provenance.origin.push_back(segment);
  state.provenance.segment_of_edge.erase(e);
  state.provenance.segment_of_edge[edge(e[0], vertex)] = segment;
  state.provenance.segment_of_edge[edge(e[1], vertex)] = segment;
  return vertex;
}

/// Splits these subsegments and all that become encroached by it, until no subsegment is encroached.
/// False when a midpoint is no double.
bool split_encroached(Refinement& state, std::deque<Edge> encroached) {
  while (!encroached.empty()) {
    const Edge e = encroached.front();
    encroached.pop_front();
    if (!state.provenance.segment_of_edge.contains(e)) continue;  // split meanwhile
    const std::optional<Index> vertex = split(state, e);
    if (!vertex) return false;
    // What can be encroached now: a half of e, by any vertex, and any subsegment, by the new vertex.
    for (Index end : e)
      if (is_encroached(state.mesh, edge(end, *vertex))) encroached.push_back(edge(end, *vertex));
    for (const auto& [other, segment] : state.provenance.segment_of_edge)
      if (encroaches(state.mesh.points[*vertex], state.mesh.points[other[0]], state.mesh.points[other[1]]))
        encroached.push_back(other);
  }
  return true;
}

/// The area cap of every triangle that lies in a region with one, found anew for each triangle.
class RegionCaps {
 public:
  RegionCaps(const Pslg& pslg, const Goal& goal, const PlainMesh& mesh) {
    if (!goal.region_caps) return;
    for (const Region& region : pslg.regions) {
      PlainMesh face{mesh.points, {}, {}};
      for (Index t : face_of(mesh, exact(region.seed))) face.triangles.push_back(mesh.triangles[t]);
      faces_.push_back({std::move(face), region.max_area});
    }
  }
  [[nodiscard]] double at(const ExactPoint& p) const {
    for (const auto& [face, cap] : faces_)
      for (const Corners& t : face.triangles) {
        const Kernel::Triangle_2 triangle(face.points[t[0]], face.points[t[1]], face.points[t[2]]);
        if (!triangle.has_on_unbounded_side(p)) return cap;
      }
    return std::numeric_limits<double>::infinity();
  }

 private:
  std::vector<std::pair<PlainMesh, double>> faces_;
};

/// Of poor quality: the ratio of circumradius to shortest edge is above the bound, or the triangle is too large.
bool needs_split(const PlainMesh& mesh, const Corners& t, const Goal& goal, const RegionCaps& caps) {
  const double sine = std::sin(goal.min_angle_deg * (std::numbers::pi / 180));
  if (squared_circumradius(mesh, t) * (4 * sine * sine) > squared_shortest_edge(mesh, t)) return true;

  const ExactPoint centroid = CGAL::centroid(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]);
  const double max_area = std::min(goal.max_area, caps.at(centroid));
  if (std::isfinite(max_area) && area(mesh, t) > max_area) return true;

  double max_edge = goal.max_edge;
  if (goal.size) max_edge = std::min(max_edge, goal.size(rounded(centroid)));
  if (!std::isfinite(max_edge)) return false;
  const Number bound = Number(max_edge) * Number(max_edge);
  for (int i = 0; i < 3; ++i)
    if (CGAL::squared_distance(mesh.points[t[i]], mesh.points[t[(i + 1) % 3]]) > bound) return true;
  return false;
}

std::optional<Corners> triangle_to_split(Refinement& state, const Goal& goal, const RegionCaps& caps) {
  for (const Corners& t : state.mesh.triangles) {
    if (state.good.contains(t)) continue;
    if (needs_split(state.mesh, t, goal, caps)) return t;
    state.good.insert(t);
  }
  return std::nullopt;
}

}  // namespace

Result<Mesh> ruppert(const Pslg& pslg, const Goal& goal) {
  if (const auto error = refused(pslg, goal)) return *error;
  const Error no_midpoint{ErrorKind::invalid_input, "The midpoint of a subsegment is not representable."};

  // The Delaunay triangulation of the input's vertices; splitting every subsegment that is encroached makes
  // all of them edges of it, since an edge with an empty diametral circle is Delaunay.
  Refinement state;
  state.mesh = delaunay_in_far_box(pslg.points);
  const auto inputs = static_cast<Index>(pslg.points.size());
  state.provenance.origin.assign(inputs + 4, input_vertex);
  std::deque<Edge> encroached;
  for (Index s = 0; s < pslg.segments.size(); ++s) {
    const Edge e = edge(pslg.segments[s].a, pslg.segments[s].b);
    state.provenance.segment_of_edge[e] = s;
    if (is_encroached(state.mesh, e)) encroached.push_back(e);
  }
  if (!split_encroached(state, encroached)) return no_midpoint;

  // From here on the subsegments bound the domain. The far box goes, and its vertices with it.
  for (const auto& [e, segment] : state.provenance.segment_of_edge) state.mesh.constraints.insert(e);
  carve(state.mesh, state.mesh.points[inputs], pslg.holes);
  const RegionCaps caps(pslg, goal, state.mesh);

  while (const auto poor = triangle_to_split(state, goal, caps)) {
    const ExactPoint centre = exact(rounded(circumcentre(state.mesh, *poor)));
    const std::vector<Edge> upon = encroached_by(state.mesh, centre);
    if (!upon.empty()) {
      if (!split_encroached(state, {upon.begin(), upon.end()})) return no_midpoint;
    } else if (cavity(state.mesh, centre).empty()) {
      return Error{ErrorKind::invalid_input, "A circumcentre is not representable inside the domain."};
    } else {
      insert(state.mesh, centre);
      state.provenance.origin.push_back(interior_vertex);
    }
  }

  const auto renumbered = [&](Index v) { return v < inputs ? v : v - 4; };
  state.mesh.points.erase(state.mesh.points.begin() + inputs, state.mesh.points.begin() + inputs + 4);
  state.provenance.origin.erase(state.provenance.origin.begin() + inputs, state.provenance.origin.begin() + inputs + 4);
  for (Corners& t : state.mesh.triangles)
    for (Index& v : t) v = renumbered(v);
  std::set<Edge> constraints;
  for (const Edge& e : state.mesh.constraints) constraints.insert({renumbered(e[0]), renumbered(e[1])});
  state.mesh.constraints = constraints;
  std::map<Edge, Index> segments;
  for (const auto& [e, segment] : state.provenance.segment_of_edge)
    segments[{renumbered(e[0]), renumbered(e[1])}] = segment;
  state.provenance.segment_of_edge = segments;
  return to_mesh(state.mesh, state.provenance, pslg);
}

}  // namespace pardel::ref
