#include "refine_domain.hpp"

#include <algorithm>
#include <span>
#include <utility>

#include "../refinement/exemptions.hpp"

namespace pardel::engine {
namespace {

/// The number of these triangles for which the test of the user is still true.
std::uint64_t failing_user_test(const Triangulation& t, const Criteria& criteria, std::span<const Exemption> exempt) {
  return static_cast<std::uint64_t>(std::ranges::count_if(exempt, [&](const Exemption& e) {
    const auto& v = t.slots[e.triangle].v;
    return criteria.fails_user_test(t.points[v[0]], t.points[v[1]], t.points[v[2]]);
  }));
}

}  // namespace

InputData input_data(const Pslg& pslg, const DomainTriangulation& domain, const Threads& threads) {
  InputData input{
      {}, {pslg.points, pslg.attributes_per_point, pslg.point_attributes, pslg.point_markers, pslg.segments}, {}};
  for (const Region& region : pslg.regions) input.region_attributes.push_back(region.attribute);
  if (pslg.attributes_per_point > 0) input.background = input_corners(domain, threads);
  return input;
}

Mesh to_mesh(DomainTriangulation&& domain, InputData input, const Threads& threads) {
  return export_mesh(std::move(domain), std::move(input.region_attributes), input.points, std::move(input.background),
                     threads);
}

Watcher watcher(const DomainTriangulation& domain, const Options& options, ToMesh to_mesh) {
  if (!options.after_sweep) return {};
  return [&, to_mesh = std::move(to_mesh)](Triangulation&& snapshot, const Sweep& sweep) -> Status {
    const Result<Mesh> mesh = to_mesh({std::move(snapshot), domain.segments, domain.input_of_vertex,
                                       domain.input_segment, domain.subsegments, domain.given_origin});
    if (!mesh) return mesh.error();
    return options.after_sweep(*mesh, sweep);
  };
}

void write_report(DomainTriangulation& domain, const Criteria& criteria, const Options& options, RefineCounts&& counts,
                  const Threads& threads, Report& report, const std::function<bool(TriangleId)>& reports,
                  std::vector<EdgeRef>* undecided) {
  report.inserted = counts.inserted;
  report.segment_splits = counts.segment_splits;
  report.refused = counts.refused;
  report.tiling = std::move(counts.tiling);
  if (counts.left_alone)
    report.exempt = exemptions(domain.triangulation, domain.segments, criteria, options, counts.budget_reached, threads,
                               reports, undecided);
  report.fail_user_test = failing_user_test(domain.triangulation, criteria, report.exempt);
}

void name_apexes(const DomainTriangulation& domain, Report& report) {
  for (Exemption& e : report.exempt)
    if (e.apex < domain.input_of_vertex.size()) e.apex = domain.input_of_vertex[e.apex];
}

Result<Mesh> refine_domain(DomainTriangulation domain, const Criteria& criteria, InputData input,
                           const Options& options, ProgressMonitor& progress, Report& report) {
  const auto convert = [&](DomainTriangulation&& snapshot) -> Result<Mesh> {
    return to_mesh(std::move(snapshot), input, progress.threads());
  };
  Result<RefineCounts> counts = refine_by_sweeps(domain.triangulation, domain.segments, criteria, options, progress, {},
                                                 watcher(domain, options, convert));
  if (!counts) return counts.error();
  write_report(domain, criteria, options, std::move(*counts), progress.threads(), report);
  name_apexes(domain, report);
  return to_mesh(std::move(domain), std::move(input), progress.threads());
}

}  // namespace pardel::engine
