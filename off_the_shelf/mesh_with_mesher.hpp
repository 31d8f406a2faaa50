// Makes a mesh in parallel with a sequential mesher of the caller's (subdomain_mesher.hpp).
//
//     const auto mesher = own_mesher();
//     const auto result = mesh_with_mesher(domain, {.min_angle_deg = 25, .max_area = 1e-4}, *mesher);
//
// The result meets the goal as that of mesh() does, with any mesher, however bad: what the mesher leaves undone, or
// does wrong, pardel's own refiner does at the end. With a mesher whose answers depend on the subdomain alone, the mesh
// is the same on any number of threads.
#pragma once

#include <cstdint>

#include "../core/goal.hpp"
#include "../parallel/mesher.hpp"
#include "breach.hpp"
#include "subdomain_mesher.hpp"

namespace pardel {

/// How the work is divided.
enum class Scheme : std::uint8_t {
  /// Parts side by side, all at the same time. The edges between them are frozen. Sweeps with shifted parts follow,
  /// until no triangle is left that breaks the goal. Works with every mesher that keeps frozen edges.
  frozen,
  /// The cells of the paper: at least 4 r̄ wide, in four colours, and a task inserts points in its own cell only
  /// (properties/THEORY.md, T1 and Lattice). For meshers that obey a cell.
  cells,
  /// As `frozen` with one sweep: the edges between the parts are split to their final length before.
  decoupled,
};
/// The enumerator as text: "frozen".
[[nodiscard]] const char* name(Scheme scheme);

struct MesherOptions {
  Scheme scheme = Scheme::frozen;
  /// About how many triangles of the result belong to one task, > 0. Another number gives another mesh.
  std::uint32_t triangles_per_task = 20'000;
  /// The most sweeps over the mesh before pardel's own refiner does the rest. Fewer if nothing is left to do, or if a
  /// sweep achieves little.
  std::uint32_t most_sweeps = 8;
  /// > 0; ends meshers that are programs or run in processes. Where it does, the mesh depends on the speed of the
  /// machine. A mesher in this process that never returns is not ended.
  double seconds_per_task = 60;
};

/// What the tasks of a run have done.
struct MesherReport {
  std::uint64_t tasks = 0;      ///< parts that the mesher was given; in each phase it gets one of them twice
  std::uint32_t sweeps = 0;     ///< rounds over the whole domain
  std::uint32_t phases = 0;     ///< groups of tasks that ran at the same time
  std::uint64_t inserted = 0;   ///< vertices of the mesher, inside faces and on segments
  std::uint64_t prepared = 0;   ///< vertices of pardel's own refiner before the first sweep
  std::uint64_t completed = 0;  ///< and after the last one
  std::uint64_t flipped = 0;    ///< edges between parts that were not Delaunay after gluing; none with cells
  std::uint64_t at_limit = 0;   ///< answers that ended at a limit
  Breaches breaches;
  double preparation_seconds = 0;  ///< the coarse mesh before the first sweep
  double division_seconds = 0;     ///< dividing the mesh into parts, and finding what is left to do
  /// Sums over all threads: taking parts out of the mesh, calls of the mesher, verification of its answers.
  double extraction_seconds = 0, mesher_seconds = 0, verification_seconds = 0;
  double gluing_seconds = 0;
};

struct MeshedWithMesher {
  Mesh mesh;
  /// As from mesh(); the vertices of the mesher count as inserted.
  Report report;
  MesherReport mesher;
};

/// Makes the quality mesh of a domain. Options::interior and Options::decomposition are not used. Errors: those of
/// mesh(); `usage` if the mesher cannot serve the scheme, a number of `how` is not positive, or the goal has a test of
/// the user, which no mesher gets.
[[nodiscard]] Result<MeshedWithMesher> mesh_with_mesher(const ValidPslg& domain, const Goal& goal,
                                                        SubdomainMesher& mesher, const MesherOptions& how = {},
                                                        const Options& options = {});

}  // namespace pardel
