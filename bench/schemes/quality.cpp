#include "quality.hpp"

#include "../../properties/checker/check.hpp"
#include "../../ref/schemes/mesh/domain_mesh.hpp"

namespace pardel::bench {

SchemeQuality scheme_quality(const schemes::LinkedMesh& mesh, const SchemeInput& input, bool refines) {
  const Goal goal = refines ? input.goal : Goal{.min_angle_deg = 0};
  const Certificate certificate = check(input.pslg, schemes::to_mesh(mesh, input.pslg), goal);
  return {mesh.faces.size(), certificate.min_angle_deg.value, certificate.valid};
}

}  // namespace pardel::bench
