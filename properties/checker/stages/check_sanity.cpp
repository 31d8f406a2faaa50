// Finds out which arrays of the input and of the mesh can be read safely.
#include <cmath>

#include "../arithmetic/text.hpp"
#include "stages.hpp"

namespace pardel::checker {
namespace {

/// How many problems with points and corners were found.
std::uint64_t problems_of_geometry(const Findings& found) {
  return found.count(ViolationKind::non_finite_coordinate) + found.count(ViolationKind::index_out_of_range) +
         found.count(ViolationKind::degenerate_triangle);
}

bool is_finite(Point p) { return std::isfinite(p.x) && std::isfinite(p.y); }

}  // namespace

bool check_input(const Pslg& pslg, Findings& found) {
  const std::uint64_t before = problems_of_geometry(found);
  SparseAsk ask(found.stop());
  for (std::size_t i = 0; i < pslg.points.size(); ++i) {
    ask();
    if (is_finite(pslg.points[i])) continue;
    found.add(ViolationKind::non_finite_coordinate, {static_cast<Index>(i)}, {pslg.points[i]},
              "point " + domain_number(i) + " of the input is not finite");
  }
  const auto seed_is_usable = [&](Point seed, std::size_t i, const char* what) {
    if (is_finite(seed)) return;
    found.add(ViolationKind::non_finite_coordinate, {static_cast<Index>(i)}, {seed},
              what + domain_number(i) + " of the input is not finite");
  };
  for (std::size_t i = 0; i < pslg.holes.size(); ++i) seed_is_usable(pslg.holes[i], i, "hole ");
  for (std::size_t i = 0; i < pslg.regions.size(); ++i) seed_is_usable(pslg.regions[i].seed, i, "the seed of region ");
  for (std::size_t s = 0; s < pslg.segments.size(); ++s) {
    ask();
    const auto [a, b, marker] = pslg.segments[s];
    if (a < pslg.points.size() && b < pslg.points.size()) continue;
    found.add(ViolationKind::index_out_of_range, {static_cast<Index>(s), a, b}, {},
              "segment " + domain_number(s) + " of the input refers to a point that does not exist");
  }
  return problems_of_geometry(found) == before;
}

namespace {

void check_corners(const Subject& subject, Findings& found) {
  const Mesh& mesh = subject.mesh;
  check_each(mesh.points.size(), found, [&](std::size_t v, Findings& mine) {
    if (is_finite(mesh.points[v])) return;
    const Index name = subject.names.vertex(static_cast<Index>(v));
    mine.add(ViolationKind::non_finite_coordinate, {name}, {mesh.points[v]},
             "vertex " + vertex_number(name) + " is not finite");
  });
  check_each(mesh.triangles.size(), found, [&](std::size_t t, Findings& mine) {
    const auto [a, b, c] = mesh.triangles[t].v;
    const std::size_t n = mesh.points.size();
    const Index name = subject.names.triangle(static_cast<Index>(t));
    if (a >= n || b >= n || c >= n)
      mine.add(ViolationKind::index_out_of_range, {name, a, b, c}, {},
               "triangle " + triangle_number(name) + " refers to a vertex that does not exist (there are " +
                   to_text(n) + ")");
    else if (a == b || b == c || c == a)
      mine.add(ViolationKind::degenerate_triangle,
               subject.names.triangle_and_corners(static_cast<Index>(t), mesh.triangles[t]), {mesh.points[a]},
               "triangle " + triangle_number(name) + " has two equal corners");
  });
}

bool neighbours_are_usable(const Mesh& mesh, Findings& found) {
  const std::uint64_t before = found.count(ViolationKind::index_out_of_range);
  check_each(mesh.triangles.size(), found, [&](std::size_t t, Findings& mine) {
    for (const Index n : mesh.triangles[t].n)
      if (n != no_index && n >= mesh.triangles.size())
        mine.add(ViolationKind::index_out_of_range, {static_cast<Index>(t), n}, {},
                 "triangle " + triangle_number(t) + " has a neighbour that does not exist");
  });
  return found.count(ViolationKind::index_out_of_range) == before;
}

bool labels_are_usable(const Subject& subject, Findings& found) {
  const Mesh& mesh = subject.mesh;
  bool usable = true;
  const auto expect_count = [&](std::size_t size, std::size_t expected, bool may_be_empty, const std::string& what) {
    if (size == expected || (size == 0 && may_be_empty)) return;
    usable = false;
    found.add(ViolationKind::wrong_count, {}, {},
              what + ": " + to_text(size) + " entries instead of " + to_text(expected));
  };
  // A mesh from another program may lack arrays that a mesh from the mesher must have.
  const bool foreign = subject.options.foreign;
  expect_count(mesh.origin.size(), mesh.points.size(), foreign, "origin of points");
  expect_count(mesh.region.size(), mesh.triangles.size(), foreign || subject.pslg.regions.empty(),
               "region of triangles");
  expect_count(mesh.point_markers.size(), mesh.points.size(), foreign || subject.pslg.point_markers.empty(),
               "point markers");
  expect_count(mesh.point_attributes.size(), mesh.points.size() * mesh.attributes_per_point, false, "point attributes");
  // Values that a file has and the input has not, such as results, are no attributes. A rank without triangles has a
  // piece without points, which says nothing about attributes.
  const bool are_attributes = !foreign || (mesh.attributes_per_point != 0 && subject.pslg.attributes_per_point != 0);
  if (are_attributes && !mesh.points.empty())
    expect_count(mesh.attributes_per_point, subject.pslg.attributes_per_point, false, "attributes of a point");

  const auto out_of_range = [&](std::vector<Index> ids, const Witness& what) {
    usable = false;
    found.add(ViolationKind::index_out_of_range, std::move(ids), {}, what);
  };
  SparseAsk ask(found.stop());
  for (std::size_t e = 0; e < mesh.constrained_edges.size(); ++e) {
    ask();
    const ConstrainedEdge& edge = mesh.constrained_edges[e];
    if (edge.a >= mesh.points.size() || edge.b >= mesh.points.size())
      out_of_range({static_cast<Index>(e), edge.a, edge.b},
                   "constrained edge " + to_text(e) + " refers to a vertex that does not exist");
    else if (edge.segment != no_index && edge.segment >= subject.pslg.segments.size())
      out_of_range({static_cast<Index>(e), edge.segment},
                   "constrained edge " + to_text(e) + " refers to a segment that does not exist");
  }
  for (std::size_t t = 0; t < mesh.region.size(); ++t) {
    ask();
    if (mesh.region[t] != no_index && mesh.region[t] >= mesh.region_attributes.size())
      out_of_range({static_cast<Index>(t), mesh.region[t]},
                   "triangle " + triangle_number(t) + " lies in a region that does not exist");
  }
  return usable;
}

}  // namespace

Sanity check_sanity(const Subject& subject, const Scan& scan, Findings& found) {
  // The scan knows whether points, corners and neighbours are usable. Only mistakes are searched again, to describe
  // them.
  const bool corners_usable = scan.points_finite && scan.corners_usable;
  const bool neighbours_usable = corners_usable && scan.neighbours_in_range;
  Sanity sanity;
  if (!corners_usable) check_corners(subject, found);
  sanity.geometry = corners_usable;
  sanity.neighbours = neighbours_usable || neighbours_are_usable(subject.mesh, found);
  sanity.labels = labels_are_usable(subject, found);
  return sanity;
}

}  // namespace pardel::checker
