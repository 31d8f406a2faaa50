#include "domain_faces.hpp"

#include "model/domain.hpp"

namespace pardel::checker {

DomainFaces faces_of_domain(const Pslg& pslg, bool convex_hull) {
  const Domain domain(pslg, convex_hull);
  const PlanarFaces& faces = domain.faces();
  const auto inside = [&](Index face) { return domain.inside(face) ? face : no_index; };

  DomainFaces result;
  result.segments.assign(domain.segments().begin(), domain.segments().end());
  for (Index s = 0; s < result.segments.size(); ++s)
    result.sides.push_back({inside(faces.face(s, Side::left)), inside(faces.face(s, Side::right))});
  for (Index p = 0; p < pslg.points.size(); ++p) {
    if (!faces.incident(p).empty()) continue;
    if (const Index face = inside(faces.face_at(pslg.points[p])); face != no_index)
      result.isolated_points.push_back({p, face});
  }
  return result;
}

}  // namespace pardel::checker
