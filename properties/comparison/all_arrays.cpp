#include "all_arrays.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <iterator>
#include <sstream>
#include <vector>

namespace pardel::properties {
namespace {

/// What a mesh says about one thing: numbers, printed as text.
using Row = std::vector<double>;
using Rows = std::vector<Row>;

/// An order in which numbers are equal if their bits are.
bool less(const Row& a, const Row& b) {
  return std::ranges::lexicographical_compare(a, b, {}, std::bit_cast<std::uint64_t, double>,
                                              std::bit_cast<std::uint64_t, double>);
}

void append(Row& row, Point p) { row.insert(row.end(), {p.x, p.y}); }
bool comes_before(Point a, Point b) { return a.x != b.x ? a.x < b.x : a.y < b.y; }

Rows points_of(const Mesh& mesh) {
  const std::size_t k = mesh.attributes_per_point;
  Rows rows;
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    Row& row = rows.emplace_back();
    append(row, mesh.points[v]);
    if (!mesh.point_markers.empty()) row.push_back(mesh.point_markers[v]);
    if (!mesh.origin.empty()) row.push_back(mesh.origin[v]);
    for (std::size_t a = 0; a < k; ++a) row.push_back(mesh.point_attributes[k * v + a]);
  }
  return rows;
}

Rows triangles_of(const Mesh& mesh) {
  Rows rows;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    std::array<Point, 3> corners;
    std::ranges::transform(mesh.triangles[t].v, corners.begin(), [&](Index v) { return mesh.points[v]; });
    std::rotate(corners.begin(), std::ranges::min_element(corners, comes_before), corners.end());
    Row& row = rows.emplace_back();
    for (const Point p : corners) append(row, p);
    if (!mesh.region.empty()) row.push_back(mesh.region[t]);
  }
  return rows;
}

Rows edges_of(const Mesh& mesh) {
  Rows rows;
  for (const ConstrainedEdge& e : mesh.constrained_edges) {
    const auto [first, second] = std::minmax(mesh.points[e.a], mesh.points[e.b], comes_before);
    Row& row = rows.emplace_back();
    append(row, first);
    append(row, second);
    row.insert(row.end(), {static_cast<double>(e.segment), static_cast<double>(e.marker)});
  }
  return rows;
}

/// The rows of a mesh, sorted.
struct Contents {
  Rows points, triangles, edges;
  Row region_attributes;

  explicit Contents(const Mesh& mesh)
      : points(points_of(mesh)),
        triangles(triangles_of(mesh)),
        edges(edges_of(mesh)),
        region_attributes(mesh.region_attributes) {
    for (Rows* rows : {&points, &triangles, &edges}) std::ranges::sort(*rows, less);
  }
};

/// The first row that only `some` has.
std::string first_missing(const char* what, const Rows& some, const Rows& others) {
  Rows missing;
  std::ranges::set_difference(some, others, std::back_inserter(missing), less);
  if (missing.empty()) return {};
  std::ostringstream text;
  text.precision(17);
  text << "only one mesh has the " << what;
  for (const double number : missing.front()) text << ' ' << number;
  return text.str() + "; ";
}

std::string excess(const Contents& some, const Contents& all) {
  return first_missing("point", some.points, all.points) + first_missing("triangle", some.triangles, all.triangles) +
         first_missing("constrained edge", some.edges, all.edges);
}

}  // namespace

std::string difference(const Mesh& one, const Mesh& other) {
  if (one.attributes_per_point != other.attributes_per_point) return "another number of attributes per point";
  const Contents first(one), second(other);
  return excess(first, second) + excess(second, first) +
         first_missing("attributes of regions", {first.region_attributes}, {second.region_attributes});
}

std::string excess(const Mesh& piece, const Mesh& whole) { return excess(Contents(piece), Contents(whole)); }

}  // namespace pardel::properties
