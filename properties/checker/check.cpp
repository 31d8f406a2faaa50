#include "check.hpp"

#include <algorithm>

#include "stages/faces_of_triangles.hpp"
#include "stages/stages.hpp"

namespace pardel {

using namespace checker;

namespace {

void run_stages(const Subject& subject, Findings& found, Certificate& certificate) {
  const auto& [pslg, mesh, goal, options] = subject;
  ScanBounds bounds = bounds_of(subject);
  bounds.boundary = !lacks_neighbours(subject);
  Scan scanned = scan(mesh.points.span(), mesh.triangles.span(), bounds, found.stop());
  const Sanity sanity = check_sanity(subject, scanned, found);
  if (!sanity.geometry) return;
  const Adjacency adjacency = check_topology(subject, sanity.neighbours, scanned, found);
  const Domain domain(pslg, goal.convex_hull, found.stop());
  const InputVertices inputs = check_input_vertices(subject, domain, adjacency, found);
  const Chains chains = check_segments(subject, domain, adjacency, inputs, scanned, found);
  check_coverage(subject, domain, adjacency, chains, found);
  std::vector<Index> faces;
  if (!pslg.regions.empty()) faces = paint_faces(domain, adjacency, chains, found.stop());
  if (sanity.labels) {
    check_labels(subject, domain, adjacency, chains, inputs, faces, found);
    certificate.digest = digest(mesh);
  }
  check_delaunay(subject, adjacency, chains, scanned, found);
  check_goal(subject, domain, adjacency, chains, inputs, faces, scanned, found, certificate.justified);
  measure(mesh, adjacency, scanned, certificate);
  certificate.decided_exactly = scanned.open.size();
}

}  // namespace

Certificate check(const Pslg& pslg, const Mesh& mesh, const Goal& goal, const CheckOptions& options) {
  Certificate certificate;
  certificate.goal = goal;
  for (const Region& region : pslg.regions)
    if (goal.region_caps) certificate.region_caps.push_back(region.max_area);
  certificate.vertices = mesh.points.size();
  certificate.triangles = mesh.triangles.size();
  certificate.constrained_edges = mesh.constrained_edges.size();
  certificate.angle_histogram.assign(18, 0);

  StopSignal stop(StopSignal::unless(options.go_on));
  Findings found(options.max_violations, &stop);
  try {
    run_stages({pslg, mesh, goal, options}, found, certificate);
  } catch (const Stopped&) {
    certificate.cancelled = true;
  }
  certificate.violation_counts = found.counts();
  certificate.valid = !certificate.cancelled &&
                      std::ranges::all_of(certificate.violation_counts, [](auto count) { return count == 0; });
  certificate.violations = std::move(found).sorted();
  return certificate;
}

}  // namespace pardel
