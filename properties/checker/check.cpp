#include "check.hpp"

#include <utility>

#include "stages/faces_of_triangles.hpp"
#include "stages/stages.hpp"
#include "stages/verdict.hpp"

namespace pardel {

using namespace checker;

namespace {

void run_stages(const Subject& subject, Findings& found, Certificate& certificate) {
  const Pslg& pslg = subject.pslg;
  const Mesh& mesh = subject.mesh;
  ScanBounds bounds = bounds_of(subject);
  bounds.boundary = !lacks_neighbours(subject);
  Scan scanned = scan(mesh.points.span(), mesh.triangles.span(), bounds, found.stop());
  const bool input_usable = check_input(pslg, found);
  const Sanity sanity = check_sanity(subject, scanned, found);
  if (!input_usable || !sanity.geometry) return;
  const Adjacency adjacency = check_topology(subject, sanity.neighbours, scanned, found);
  const Domain domain(pslg, subject.goal.convex_hull, found.stop());
  const InputVertices inputs = check_input_vertices(subject, domain, adjacency, found);
  const Chains chains = check_segments(subject, domain, adjacency, inputs, scanned, found);
  check_holes(subject, domain, chains, check_coverage(subject, domain, adjacency, chains, found), found);
  std::vector<Index> faces;
  if (!pslg.regions.empty()) faces = paint_faces(domain, adjacency, chains, found.stop());
  if (sanity.labels) {
    check_labels(subject, domain, adjacency, chains, inputs, found);
    check_regions(subject, domain, faces, found);
    certificate.digest = digest(mesh);
  }
  check_delaunay(subject, adjacency, chains, scanned, found);
  check_goal(subject, domain, adjacency, chains, inputs, faces, scanned, found, certificate.justified);
  measure(mesh, adjacency, scanned, certificate);
  certificate.decided_exactly = scanned.open.size();
}

}  // namespace

Certificate check(const Pslg& pslg, const Mesh& mesh, const Goal& goal, const CheckOptions& options) {
  Certificate certificate = empty_certificate(pslg, goal);
  certificate.vertices = mesh.points.size();
  certificate.triangles = mesh.triangles.size();
  certificate.constrained_edges = mesh.constrained_edges.size();
  if (options.foreign) certificate.not_checked = not_checked(pslg, labels_of(mesh));

  StopSignal stop(StopSignal::unless(options.go_on));
  Findings found(options.max_violations, &stop);
  try {
    run_stages({pslg, mesh, goal, options}, found, certificate);
  } catch (const Stopped&) {
    certificate.cancelled = true;
  }
  set_verdict(certificate, std::move(found));
  return certificate;
}

}  // namespace pardel
