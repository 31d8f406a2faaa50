// Tests domains for the traits of the families.
#include <algorithm>
#include <cstdlib>
#include <set>

#include "lattice/determinants.hpp"
#include "lattice/faces.hpp"

namespace pardel::generators {
namespace {

using Points = std::vector<LatticePoint>;

bool three_are_collinear(const Points& p) {
  for (std::size_t i = 0; i < p.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      for (std::size_t k = 0; k < j; ++k)
        if (turn(p[i], p[j], p[k]) == 0) return true;
  return false;
}

/// The number of quadruples on a circle (not on a line), counted up to `enough`.
std::size_t cocircular_quadruples(const Points& p, std::size_t enough) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < p.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      for (std::size_t k = 0; k < j; ++k) {
        if (turn(p[i], p[j], p[k]) == 0) continue;
        for (std::size_t l = 0; l < k; ++l)
          if (in_circle(p[i], p[j], p[k], p[l]) == 0 && ++count == enough) return count;
      }
  return count;
}

bool has_near_duplicates(const Points& points) {
  const std::int64_t extent = width(points);
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const LatticePoint apart = points[i] - points[j];
      if (dot(apart, apart) <= (extent >> 9) * (extent >> 9)) return true;
    }
  return false;
}

/// The half-edges with the domain on their left.
std::vector<Index> inner_sides(const LatticeFaces& faces) {
  std::vector<Index> sides;
  for (Index h = 0; h < faces.half_edges(); ++h)
    if (faces.is_domain(faces.left_of(h))) sides.push_back(h);
  return sides;
}

bool has_collinear_run(const Points& points, const LatticeFaces& faces) {
  const auto on_boundary = [&](Index h) {
    return faces.is_domain(faces.left_of(h)) && !faces.is_domain(faces.left_of(LatticeFaces::twin(h)));
  };
  const std::vector<Index> sides = inner_sides(faces);
  return std::ranges::any_of(sides, [&](Index h) {
    const auto [a, b] = faces.ends(h);
    return on_boundary(h) && std::ranges::any_of(faces.around(b), [&, a = a, b = b](Index g) {
             return on_boundary(g) && lies_inside(points[b], points[a], points[faces.ends(g).b]);
           });
  });
}

bool has_small_angle(const Points& points, const LatticeFaces& faces) {
  for (Index apex = 0; apex < points.size(); ++apex) {
    const std::span<const Index> star = faces.around(apex);
    for (std::size_t i = 0; i < star.size(); ++i) {
      const LatticePoint u = points[faces.ends(star[i]).b] - points[apex];
      const LatticePoint v = points[faces.ends(star[(i + 1) % star.size()]).b] - points[apex];
      if (faces.is_domain(faces.left_of(star[i])) && cross(u, v) > 0 && 4 * cross(u, v) < dot(u, v)) return true;
    }
  }
  return false;
}

/// True if ab and cd are antiparallel, each on the left of the other, near to each other for at least half of their
/// length.
bool make_a_channel(LatticePoint a, LatticePoint b, LatticePoint c, LatticePoint d) {
  const LatticePoint u = b - a, v = d - c;
  if (cross(u, v) != 0 || dot(u, v) >= 0 || turn(a, b, c) <= 0) return false;
  // Lengths along u, times the length of u.
  const std::int64_t shorter = std::min(dot(u, u), -dot(u, v));
  const std::int64_t overlap = std::min(dot(u, c - a), dot(u, u)) - std::max<std::int64_t>(dot(u, d - a), 0);
  const std::int64_t shorter_squared = std::min(dot(u, u), dot(v, v));
  const Wide gap = turn(a, b, c);  // times the length of u
  return 2 * overlap >= shorter && 400 * gap * gap < Wide{dot(u, u)} * shorter_squared;
}

bool has_thin_channel(const Points& points, const LatticeFaces& faces) {
  const std::vector<Index> sides = inner_sides(faces);
  return std::ranges::any_of(sides, [&](Index g) {
    return std::ranges::any_of(sides, [&](Index h) {
      const auto [a, b] = faces.ends(g);
      const auto [c, d] = faces.ends(h);
      return make_a_channel(points[a], points[b], points[c], points[d]);
    });
  });
}

bool has_island(const LatticeFaces& faces) {
  return std::ranges::any_of(inner_sides(faces), [&](Index h) {
    const Index outside = LatticeFaces::twin(h), face = faces.left_of(outside);
    return face != LatticeFaces::exterior && !faces.is_domain(face) && !faces.on_outer_contour(outside);
  });
}

/// True if a point exists around which the domain alternates with at least two different other faces.
bool has_touching_holes(const Points& points, const LatticeFaces& faces) {
  for (Index p = 0; p < points.size(); ++p) {
    std::set<Index> entered;  // faces outside the domain that follow the domain counter-clockwise
    const std::span<const Index> star = faces.around(p);
    for (std::size_t i = 0; i < star.size(); ++i) {
      const Index face = faces.left_of(star[i]), next = faces.left_of(star[(i + 1) % star.size()]);
      if (faces.is_domain(face) && !faces.is_domain(next)) entered.insert(next);
    }
    if (entered.size() > 1) return true;
  }
  return false;
}

bool has_crack(const Points& points, const LatticeFaces& faces) {
  for (Index p = 0; p < points.size(); ++p)
    if (faces.around(p).size() == 1 && faces.is_domain(faces.left_of(faces.around(p)[0]))) return true;
  return false;
}

bool has_isolated_point(const Points& points, const LatticeFaces& faces) {
  for (Index p = 0; p < points.size(); ++p)
    if (faces.around(p).empty() && faces.is_domain(faces.containing(4 * points[p]))) return true;
  return false;
}

}  // namespace

bool has_trait(Family family, const LatticeDomain& domain) {
  const Points& points = domain.points;
  switch (family) {
    case Family::general_position:
      return !three_are_collinear(points) && cocircular_quadruples(points, 1) == 0;
    case Family::cocircular_grid:
      return cocircular_quadruples(points, points.size()) == points.size();
    case Family::collinear_runs:
      return has_collinear_run(points, LatticeFaces(domain));
    case Family::near_duplicates:
      return has_near_duplicates(points);
    case Family::small_angles:
      return has_small_angle(points, LatticeFaces(domain));
    case Family::thin_channels:
      return has_thin_channel(points, LatticeFaces(domain));
    case Family::nested_holes:
      return has_island(LatticeFaces(domain));
    case Family::touching_holes:
      return has_touching_holes(points, LatticeFaces(domain));
    case Family::cracks:
      return has_crack(points, LatticeFaces(domain));
    case Family::isolated_points:
      return has_isolated_point(points, LatticeFaces(domain));
    case Family::far_offset:
      return std::max(std::abs(domain.offset.x), std::abs(domain.offset.y)) >= width(points) << 20;
  }
  return false;
}

}  // namespace pardel::generators
