#include "verdict.hpp"

#include <algorithm>
#include <utility>

namespace pardel::checker {

Certificate empty_certificate(const Pslg& pslg, const Goal& goal) {
  Certificate certificate;
  certificate.goal = goal;
  for (const Region& region : pslg.regions)
    if (goal.region_caps) certificate.region_caps.push_back(region.max_area);
  certificate.angle_histogram.assign(18, 0);
  return certificate;
}

LabelsOfMesh labels_of(const Mesh& mesh) {
  return {.regions = !mesh.region.empty(),
          .attributes = mesh.attributes_per_point > 0,
          .markers = !mesh.point_markers.empty(),
          .edges = !mesh.constrained_edges.empty()};
}

std::vector<std::string> not_checked(const Pslg& pslg, const LabelsOfMesh& mesh) {
  std::vector<std::string> list;
  const auto compare = [&](const std::string& what, bool in_domain, bool in_mesh) {
    if (in_domain != in_mesh) list.push_back(what + ": the " + (in_domain ? "mesh" : "domain") + " has none");
  };
  compare("regions of triangles", !pslg.regions.empty(), mesh.regions);
  compare("attributes of vertices", pslg.attributes_per_point > 0, mesh.attributes);
  compare("markers of vertices", true, mesh.markers);
  compare("the list of constrained edges and their markers", true, mesh.edges);
  return list;
}

void set_verdict(Certificate& certificate, Findings found) {
  certificate.violation_counts = found.counts();
  certificate.valid = !certificate.cancelled &&
                      std::ranges::all_of(certificate.violation_counts, [](auto count) { return count == 0; });
  certificate.violations = std::move(found).sorted();
}

}  // namespace pardel::checker
