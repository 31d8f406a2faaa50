#include "definitions.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "../../core/support/same_attribute.hpp"
#include "../../properties/checker/tolerances.hpp"
#include "../../ref/faces.hpp"
#include "../distances.hpp"

namespace pardel::fuzz {

using ref::Corners;
using ref::Edge;
using ref::ExactPoint;
using ref::Number;

ExactMesh::ExactMesh(const Mesh& mesh) : given(mesh), plain(ref::to_plain_mesh(mesh)) {
  has_triangle.resize(mesh.points.size());
  for (Index t = 0; t < plain.triangles.size(); ++t) {
    const Corners& c = plain.triangles[t];
    for (int i = 0; i < 3; ++i) triangles_at[ref::edge_of(c, i)].push_back(t);
    for (const Index v : c) has_triangle[v] = true;
  }
}

namespace {

template <class Fits>
Triangles triangles_that(const ExactMesh& mesh, const Fits& fits) {
  Triangles found;
  for (Index t = 0; t < mesh.plain.triangles.size(); ++t)
    if (fits(t, mesh.plain.triangles[t])) found.insert(t);
  return found;
}

/// True if the triangle is on the left of the edge from its lesser to its greater number.
bool is_on_left(const Corners& c, const Edge& e) {
  for (int i = 0; i < 3; ++i)
    if (c[i] == e[0]) return c[(i + 1) % 3] == e[1];
  return false;
}

Number squared_length(const ExactMesh& mesh, const Edge& e) {
  return CGAL::squared_distance(mesh.plain.points[e[0]], mesh.plain.points[e[1]]);
}

bool has_edge_longer_than(const ExactMesh& mesh, const Corners& c, const Number& length) {
  for (int i = 0; i < 3; ++i)
    if (squared_length(mesh, ref::edge_of(c, i)) > length * length) return true;
  return false;
}

/// Is the cosine of the angle at corner i greater than the bound, a number between 0 and 1?
bool is_sharper(const ExactMesh& mesh, const Corners& c, int i, double cosine) {
  const Index a = c[i], b = c[(i + 1) % 3], d = c[(i + 2) % 3];
  const auto& points = mesh.plain.points;
  const Number dot = (points[b] - points[a]) * (points[d] - points[a]);
  return dot > 0 && dot * dot > Number(cosine) * cosine * squared_length(mesh, ref::edge(a, b)) *
                                    squared_length(mesh, ref::edge(a, d));
}

}  // namespace

Triangles not_counter_clockwise(const ExactMesh& mesh) {
  return triangles_that(mesh, [&](Index, const Corners& c) {
    const auto& p = mesh.plain.points;
    return CGAL::orientation(p[c[0]], p[c[1]], p[c[2]]) != CGAL::LEFT_TURN;
  });
}

Triangles with_equal_twins(const ExactMesh& mesh) {
  const auto sorted = [](Corners c) {
    std::ranges::sort(c);
    return c;
  };
  std::map<Corners, int> count;
  for (const Corners& c : mesh.plain.triangles) ++count[sorted(c)];
  return triangles_that(mesh, [&](Index, const Corners& c) { return count[sorted(c)] > 1; });
}

Triangles at_edges_with_too_many(const ExactMesh& mesh) {
  Triangles found;
  for (const auto& [e, at] : mesh.triangles_at) {
    const auto left =
        std::ranges::count_if(at, [&, &ends = e](Index t) { return is_on_left(mesh.plain.triangles[t], ends); });
    if (left > 1 || static_cast<std::size_t>(left) + 1 < at.size()) found.insert(at.begin(), at.end());
  }
  return found;
}

Edges with_wrong_neighbours(const ExactMesh& mesh) {
  Edges found;
  for (Index t = 0; t < mesh.plain.triangles.size(); ++t)
    for (int i = 0; i < 3; ++i) {
      const Edge e = ref::edge_of(mesh.plain.triangles[t], i);
      Index across = no_index;
      for (const Index other : mesh.triangles_at.at(e))
        if (other != t) across = other;
      if (mesh.given.triangles[t].n[i] != across) found.insert(e);
    }
  return found;
}

Triangles with_small_angles(const ExactMesh& mesh, double min_angle_deg) {
  if (!(min_angle_deg > 0)) return {};
  const double cosine = angle_cosine_bound(min_angle_deg);
  return triangles_that(mesh, [&](Index, const Corners& c) {
    return is_sharper(mesh, c, 0, cosine) || is_sharper(mesh, c, 1, cosine) || is_sharper(mesh, c, 2, cosine);
  });
}

Triangles larger_than(const ExactMesh& mesh, double max_area) {
  if (!std::isfinite(max_area)) return {};
  return triangles_that(mesh, [&](Index, const Corners& c) { return ref::area(mesh.plain, c) > max_area; });
}

Triangles with_larger_circumradius_than(const ExactMesh& mesh, double radius) {
  if (!(radius > 0) || !std::isfinite(radius)) return {};
  return triangles_that(mesh, [&](Index, const Corners& c) {
    return ref::squared_circumradius(mesh.plain, c) > Number(radius) * radius;
  });
}

Triangles longer_than_sizes(const ExactMesh& mesh, const std::function<double(Point)>& size) {
  if (!size) return {};
  return triangles_that(mesh, [&](Index t, const Corners& c) {
    // The centroid is rounded as check.hpp says.
    const auto& v = mesh.given.triangles[t].v;
    const Point a = mesh.given.points[v[0]], b = mesh.given.points[v[1]], d = mesh.given.points[v[2]];
    const double allowed = size({(a.x + b.x + d.x) / 3, (a.y + b.y + d.y) / 3});
    return !(allowed > 0) || has_edge_longer_than(mesh, c, allowed);
  });
}

Edges longer_than(const ExactMesh& mesh, double max_edge) {
  Edges found;
  for (const auto& [e, at] : mesh.triangles_at)
    if (std::isfinite(max_edge) && squared_length(mesh, e) > Number(max_edge) * max_edge) found.insert(e);
  return found;
}

Edges not_locally_delaunay(const ExactMesh& mesh) {
  Edges found;
  for (const auto& [e, at] : mesh.triangles_at) {
    if (at.size() != 2) continue;
    const Corners& other = mesh.plain.triangles[at[1]];
    const Index apex = *std::ranges::find_if(other, [&ends = e](Index v) { return v != ends[0] && v != ends[1]; });
    if (ref::circumdisk_contains(mesh.plain, mesh.plain.triangles[at[0]], mesh.plain.points[apex])) found.insert(e);
  }
  return found;
}

std::set<Index> missing_inputs(const ExactMesh& mesh, const Pslg& pslg, const InputFaces& faces) {
  std::set<Index> found;
  for (Index i = 0; i < pslg.points.size(); ++i) {
    const bool is_vertex = i < mesh.given.points.size();
    const bool was_moved = is_vertex && mesh.given.points[i] != pslg.points[i];
    const bool is_used = is_vertex && mesh.has_triangle[i];
    if (was_moved || (!is_used && faces.contains(ref::exact(pslg.points[i])))) found.insert(i);
  }
  return found;
}

std::set<Index> unused_points(const ExactMesh& mesh, const Pslg& pslg) {
  std::set<Index> found;
  for (std::size_t v = pslg.points.size(); v < mesh.given.points.size(); ++v)
    if (!mesh.has_triangle[v]) found.insert(static_cast<Index>(v));
  return found;
}

std::set<Index> with_wrong_attributes(const ExactMesh& mesh, const Pslg& pslg) {
  std::set<Index> found;
  const std::vector<double>& expected = pslg.point_attributes;
  const auto& given = mesh.given.point_attributes;
  const auto is_wrong = [&](std::size_t k) {
    if (k < expected.size()) return !is_same_attribute(given[k], expected[k]);
    double least = std::numeric_limits<double>::infinity(), greatest = -least;
    for (std::size_t i = k % pslg.attributes_per_point; i < expected.size(); i += pslg.attributes_per_point) {
      least = std::min(least, expected[i]);
      greatest = std::max(greatest, expected[i]);
    }
    const double spare = attribute_tolerance * std::max(std::abs(least), std::abs(greatest));
    return !(least - spare <= given[k] && given[k] <= greatest + spare);
  };
  for (std::size_t k = 0; k < given.size() && !expected.empty(); ++k)
    if (is_wrong(k)) found.insert(static_cast<Index>(k / pslg.attributes_per_point));
  return found;
}

namespace {

/// Does p lie on the open segment?
bool lies_inside(const ExactPoint& p, const ExactPoint& a, const ExactPoint& b) {
  return CGAL::collinear(a, p, b) && CGAL::collinear_are_strictly_ordered_along_line(a, p, b);
}

/// More than two units of a segment with these ends: twice the spacing of doubles at its largest coordinate, in both
/// axes.
double two_units(Point a, Point b) {
  const double greatest = std::max({std::abs(a.x), std::abs(a.y), std::abs(b.x), std::abs(b.y)});
  return 3 * greatest * std::numeric_limits<double>::epsilon();
}

}  // namespace

bool is_far_or_on_walls(const ExactMesh& mesh, const Pslg& pslg, const InputFaces& faces) {
  for (const Wall& wall : faces.walls()) {
    const Point a = pslg.points[wall.a], b = pslg.points[wall.b];
    // Farther than the checker allows, and farther than it looks for the chain that was meant.
    const double near = std::max(100 * two_units(a, b), 10 * meant_chain_share * distance(a, b));
    for (Index v = 0; v < mesh.given.points.size(); ++v) {
      if (!mesh.has_triangle[v] || v == wall.a || v == wall.b) continue;
      const ExactPoint& p = mesh.plain.points[v];
      const bool is_on = lies_inside(p, ref::exact(a), ref::exact(b));
      if (!is_on && distance(mesh.given.points[v], a, b) <= near) return false;
    }
  }
  return true;
}

Walls walls_of(const ExactMesh& mesh, const Pslg& pslg, const InputFaces& faces) {
  Walls walls;
  walls.wall_of_vertex.resize(mesh.given.points.size(), nullptr);
  for (const Wall& wall : faces.walls()) {
    if (wall.sides_inside == 0) continue;
    const ExactPoint a = ref::exact(pslg.points[wall.a]), b = ref::exact(pslg.points[wall.b]);
    std::vector<Index> chain = {wall.a, wall.b};
    for (Index v = 0; v < mesh.given.points.size(); ++v)
      if (mesh.has_triangle[v] && lies_inside(mesh.plain.points[v], a, b)) chain.push_back(v);
    std::ranges::sort(chain, [&](Index u, Index v) {
      return CGAL::compare_distance_to_point(a, mesh.plain.points[u], mesh.plain.points[v]) == CGAL::SMALLER;
    });
    for (std::size_t i = 1; i < chain.size(); ++i) {
      const Edge e = ref::edge(chain[i - 1], chain[i]);
      if (!mesh.triangles_at.contains(e)) {
        walls.are_whole = false;
        if (wall.segment != no_index) walls.broken.insert(wall.segment);
      }
      walls.wall_of.emplace(e, &wall);
      if (i + 1 < chain.size()) walls.wall_of_vertex[chain[i]] = &wall;
    }
  }
  return walls;
}

namespace {

Number area(const ExactMesh& mesh) {
  Number sum = 0;
  for (const Corners& c : mesh.plain.triangles) sum += ref::area(mesh.plain, c);
  return sum;
}

/// The rule of the program Triangle: the wall's own marker if it is not zero, else 1 on the boundary, else 0.
int marker_of(const Wall& wall) { return wall.marker != 0 ? wall.marker : wall.sides_inside == 1 ? 1 : 0; }

}  // namespace

std::vector<InputFaces::Face> faces_of_triangles(const ExactMesh& mesh, const InputFaces& faces) {
  std::vector<InputFaces::Face> found;
  const auto& p = mesh.plain.points;
  for (const Corners& c : mesh.plain.triangles)
    found.push_back(faces.face_at(CGAL::centroid(p[c[0]], p[c[1]], p[c[2]])));
  return found;
}

bool covers_domain(const ExactMesh& mesh, const InputFaces& faces, const std::vector<InputFaces::Face>& face) {
  return std::ranges::all_of(face, [&](InputFaces::Face f) { return faces.is_inside(f); }) &&
         area(mesh) == faces.area();
}

std::set<Index> with_wrong_origin(const ExactMesh& mesh, const Pslg& pslg, const Walls& walls) {
  std::set<Index> found;
  for (Index v = 0; v < mesh.given.origin.size(); ++v) {
    const Wall* wall = walls.wall_of_vertex[v];
    const Index origin = v < pslg.points.size()      ? input_vertex
                         : wall == nullptr           ? interior_vertex
                         : wall->segment == no_index ? hull_vertex
                                                     : origin_on_segment(wall->segment);
    if (mesh.given.origin[v] != origin) found.insert(v);
  }
  return found;
}

std::set<Index> with_wrong_marker(const ExactMesh& mesh, const Pslg& pslg, const Walls& walls) {
  std::vector<std::set<int>> possible(mesh.given.points.size());
  for (const auto& [e, wall] : walls.wall_of)
    for (const Index v : e)
      if (const int marker = marker_of(*wall); marker != 0) possible[v].insert(marker);
  std::set<Index> found;
  for (Index v = 0; v < mesh.given.point_markers.size(); ++v) {
    const int own = v < pslg.point_markers.size() ? pslg.point_markers[v] : 0;
    if (own != 0) possible[v] = {own};
    if (own == 0 && !mesh.has_triangle[v]) continue;
    if (possible[v].empty()) possible[v] = {0};
    if (!possible[v].contains(mesh.given.point_markers[v])) found.insert(v);
  }
  return found;
}

ListFaults faults_of_list(const ExactMesh& mesh, const Walls& walls) {
  ListFaults faults;
  Edges listed;
  for (Index i = 0; i < mesh.given.constrained_edges.size(); ++i) {
    const ConstrainedEdge& edge = mesh.given.constrained_edges[i];
    const Edge e = ref::edge(edge.a, edge.b);
    const auto wall = walls.wall_of.find(e);
    if (wall == walls.wall_of.end() || !listed.insert(e).second) {
      faults.wrong.insert(i);
      continue;
    }
    if (edge.segment != wall->second->segment) faults.wrong.insert(i);
    if (edge.marker != marker_of(*wall->second)) faults.wrong_marker.insert(i);
  }
  for (const auto& [e, wall] : walls.wall_of)
    if (!listed.contains(e)) faults.missing.insert(e);
  return faults;
}

Triangles with_wrong_region(const ExactMesh& mesh, const Pslg& pslg, const InputFaces& faces,
                            const std::vector<InputFaces::Face>& face) {
  if (mesh.given.region.empty()) return {};
  return triangles_that(mesh, [&](Index t, const Corners&) {
    const std::set<Index> regions = faces.regions_in(face[t]);
    const Index given = mesh.given.region[t];
    if (given == no_index || regions.empty()) return given != no_index || !regions.empty();
    return !regions.contains(given) || mesh.given.region_attributes[given] != pslg.regions[given].attribute;
  });
}

Triangles larger_than_caps(const ExactMesh& mesh, const Pslg& pslg, const InputFaces& faces,
                           const std::vector<InputFaces::Face>& face) {
  return triangles_that(mesh, [&](Index t, const Corners& c) {
    const std::set<Index> regions = faces.regions_in(face[t]);
    return std::ranges::any_of(regions, [&](Index r) {
      const double cap = pslg.regions[r].max_area;
      return std::isfinite(cap) && ref::area(mesh.plain, c) > cap;
    });
  });
}

}  // namespace pardel::fuzz
