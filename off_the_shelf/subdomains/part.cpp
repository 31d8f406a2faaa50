#include "part.hpp"

namespace pardel::engine {

Part PartMaker::take_out(const Portion& portion, bool splits_segments) {
  const Triangulation& t = mesh_.t;
  point_of_vertex_.resize(t.points.size(), no_index);
  Part part;
  part.triangles = portion.triangles;
  part.subdomain.cell = portion.cell;
  part.subdomain.triangles.reserve(portion.triangles.size());
  for (const TriangleId id : portion.triangles) {
    const Slot& slot = t.slots[id];
    part.subdomain.triangles.push_back(
        {point_of(slot.v[0], part), point_of(slot.v[1], part), point_of(slot.v[2], part)});
  }
  for (const TriangleId id : portion.triangles)
    for (unsigned side = 0; side < 3; ++side) {
      const EdgeRef outer = t.slots[id].n[side];
      const bool inside = !outer.none() && portion_of_[outer.triangle()] == portion_of_[id];
      if (!inside || (outer.constrained() && id < outer.triangle())) add_edge(EdgeRef(id, side), splits_segments, part);
    }
  for (const VertexId v : part.vertices) point_of_vertex_[v] = no_index;
  return part;
}

Index PartMaker::point_of(VertexId v, Part& part) {
  Index& point = point_of_vertex_[v];
  if (point == no_index) {
    point = static_cast<Index>(part.vertices.size());
    part.vertices.push_back(v);
    part.subdomain.points.push_back(mesh_.t.points[v]);
  }
  return point;
}

void PartMaker::add_edge(EdgeRef inner, bool splits_segments, Part& part) {
  const Triangulation& t = mesh_.t;
  const Slot& slot = t.slot(inner);
  const EdgeRef outer = slot.n[inner.side()];
  const VertexId a = slot.from(inner.side()), b = slot.to(inner.side());
  const bool inside = !outer.none() && portion_of_[outer.triangle()] == portion_of_[inner.triangle()];
  const Index segment = outer.constrained() ? mesh_.assessor.segment_of(inner) : no_index;
  // Where rounding could move a point across a neighbouring segment, pardel's own refiner splits.
  const bool may_be_split = splits_segments && segment != no_index && (outer.none() || inside) &&
                            mesh_.segments.clearances(segment).empty() && !mesh_.assessor.forbidden(inner);
  part.subdomain.edges.push_back({point_of_vertex_[a], point_of_vertex_[b], inside, may_be_split});
  Part::Seam seam{inner, outer, segment};
  if (!t.region.empty()) {
    seam.left_region = t.region[inner.triangle()];
    if (inside) seam.right_region = t.region[outer.triangle()];
  }
  part.seams.push_back(seam);
  EndPoints line{t.points[a], t.points[b]};
  if (may_be_split) {
    const Constraint whole = mesh_.segments.line_at(t.points, segment, line.a);
    line = {t.points[whole.a], t.points[whole.b]};
  }
  part.lines.push_back(line);
}

}  // namespace pardel::engine
