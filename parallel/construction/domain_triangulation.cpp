#include "domain_triangulation.hpp"

#include <string>

#include "../threads/parallel_arrays.hpp"
#include "carve.hpp"
#include "delaunay.hpp"
#include "hairlines.hpp"
#include "insert_constraints.hpp"

namespace pardel::engine {
namespace {

std::vector<Index> inverse(std::span<const Index> permutation, SparseAsk& ask) {
  std::vector<Index> result(permutation.size());
  for (std::size_t i = 0; i < permutation.size(); ++i) {
    ask();
    result[permutation[i]] = static_cast<Index>(i);
  }
  return result;
}

std::vector<FlatTriangle> flat_triangles(const Triangulation& t, std::span<const TriangleId> among,
                                         const Threads& threads) {
  std::vector<FlatTriangle> flat;
  SparseAsk ask(threads.stop);
  for (const TriangleId id : among) {
    ask();
    const Slot& slot = t.slots[id];
    if (!slot.is_ghost())
      add_if_flat(
          t, slot, [](VertexId v) { return v; }, flat);
  }
  return flat;
}

}  // namespace

Result<DomainTriangulation> triangulate_domain(const Pslg& pslg, bool convex_hull, const Threads& threads) {
  Result<Delaunay> triangulated = delaunay(pslg.points, threads);
  if (!triangulated) return triangulated.error();
  DomainTriangulation domain;
  Triangulation& t = domain.triangulation;
  t = std::move(triangulated->triangulation);
  domain.input_of_vertex = std::move(triangulated->input_of_vertex);

  std::vector<Constraint> constraints;
  std::vector<int> markers;
  if (!pslg.segments.empty()) {
    SparseAsk ask(threads.stop);
    const std::vector<Index> vertex_of_input = inverse(domain.input_of_vertex.span(), ask);
    for (Index s = 0; s < pslg.segments.size(); ++s) {
      ask();
      const Segment& segment = pslg.segments[s];
      if (segment.a >= pslg.points.size() || segment.b >= pslg.points.size())
        return Error{ErrorKind::invalid_input, "segment " + std::to_string(s) + " names a point that does not exist"};
      constraints.push_back({vertex_of_input[segment.a], vertex_of_input[segment.b]});
      domain.input_segment.push_back(s);
      markers.push_back(segment.marker);
    }
  }
  if (Status inserted = insert_constraints(t, constraints, threads); !inserted) return inserted.error();

  DomainRules rules{convex_hull || pslg.segments.empty(), pslg.holes, {}};
  for (const Region& region : pslg.regions) rules.region_seeds.push_back(region.seed);
  std::vector<FlatTriangle> flat;
  const auto look_for_flat = [&](std::span<const TriangleId> outside) { flat = flat_triangles(t, outside, threads); };
  for (const Constraint hull_edge : carve(t, rules, threads, look_for_flat)) {
    constraints.push_back(hull_edge);
    domain.input_segment.push_back(no_index);
    markers.push_back(0);
  }
  if (t.slots.empty())
    return Error{ErrorKind::invalid_input,
                 "the domain is empty: the segments enclose no area, or the holes remove all of it"};
  t.origin = make_array(threads, t.points.size(), [](std::size_t) { return input_vertex; });
  domain.segments = DomainSegments(t.points, constraints, markers, threads);
  keep_clear(hairlines_among(flat), t, domain.segments);
  return domain;
}

std::vector<std::array<Index, 3>> input_corners(const DomainTriangulation& domain, const Threads& threads) {
  std::vector<std::array<Index, 3>> result;
  SparseAsk ask(threads.stop);
  result.reserve(domain.triangulation.slots.size());
  for (const Slot& slot : domain.triangulation.slots) {
    ask();
    std::array<Index, 3> v = slot.v;
    for (Index& corner : v)
      if (corner < domain.input_of_vertex.size()) corner = domain.input_of_vertex[corner];
    result.push_back(v);
  }
  return result;
}

}  // namespace pardel::engine
