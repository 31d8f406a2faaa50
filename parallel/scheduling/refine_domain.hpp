// Refines a domain, and keeps the data with which the result becomes a mesh.
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "../../core/mesh.hpp"
#include "../../core/result.hpp"
#include "../construction/domain_triangulation.hpp"
#include "../conversion/export_mesh.hpp"
#include "../options.hpp"
#include "../quality/criteria.hpp"
#include "../report.hpp"
#include "progress_monitor.hpp"
#include "refine_by_sweeps.hpp"

namespace pardel::engine {

/// The data of the input that the mesh contains, too.
struct InputData {
  std::vector<double> region_attributes;
  PointData points;
  std::vector<std::array<Index, 3>> background;  ///< the triangles on which point attributes are interpolated
};

/// The data of a domain. The Pslg has to outlive it.
[[nodiscard]] InputData input_data(const Pslg& pslg, const DomainTriangulation& domain, const Threads& threads);

[[nodiscard]] Mesh to_mesh(DomainTriangulation&& domain, InputData input, const Threads& threads);

/// Makes a mesh of a domain that has been refined.
using ToMesh = std::function<Result<Mesh>(DomainTriangulation&&)>;
/// A watcher that converts each snapshot to a mesh and calls options.after_sweep with it. Empty if there is no such
/// function. All references have to outlive it.
[[nodiscard]] Watcher watcher(const DomainTriangulation& domain, const Options& options, ToMesh to_mesh);

/// Writes to the report what a refinement has done, and which triangles it left. `options`: those of the refinement.
/// `reports`: if given, only triangles for which it is true are reported. `undecided`: see exemptions(). The apexes of
/// the exemptions are vertices of the triangulation.
void write_report(DomainTriangulation& domain, const Criteria& criteria, const Options& options, RefineCounts&& counts,
                  const Threads& threads, Report& report, const std::function<bool(TriangleId)>& reports = {},
                  std::vector<EdgeRef>* undecided = nullptr);

/// Makes the apexes of the exemptions points of the input.
void name_apexes(const DomainTriangulation& domain, Report& report);

/// Refines the domain, and makes its mesh. Errors: as from refine_by_sweeps().
[[nodiscard]] Result<Mesh> refine_domain(DomainTriangulation domain, const Criteria& criteria, InputData input,
                                         const Options& options, ProgressMonitor& progress, Report& report);

}  // namespace pardel::engine
