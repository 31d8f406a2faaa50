// The report of a run of `pardel mesh`: as text, and as JSON with the schema pardel.report/1.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "../core/digest.hpp"
#include "../core/goal.hpp"
#include "../parallel/mesher.hpp"
#include "../parallel/warnings.hpp"
#include "../properties/checker/check.hpp"
#include "../properties/checker/statistics.hpp"
#include "exempt_triangles.hpp"
#include "mesher_report.hpp"

namespace pardel::cli {

/// Wall-clock time by step.
struct Seconds {
  double read = 0, validate = 0, triangulate = 0, refine = 0, check = 0, write = 0;
  double statistics = 0;  ///< time to compute the statistics and the digest of the mesh
  double total = 0;
};

/// The ranks of an MPI job that have made a mesh together.
struct RanksOfRun {
  std::vector<std::uint64_t> triangles;    ///< of the pieces of each rank
  std::vector<std::uint64_t> peak_memory;  ///< of each rank, in bytes
  std::uint64_t pieces = 0;                ///< of all ranks
  /// Each rank has read a part of the input. Then nobody has looked for gaps and warnings.
  bool divided = false;
};

struct MeshRun {
  std::string name;  ///< the name of the input file
  std::size_t points = 0, segments = 0, holes = 0, regions = 0;
  std::uint64_t points_outside = 0;  ///< the points of the input that are in no triangle
  bool refined = false;              ///< the input is a mesh
  Goal goal;
  std::vector<Warning> warnings;    ///< of the domain
  std::optional<LeastSize> large;   ///< if the mesh needs very many triangles
  bool hull_by_default = false;     ///< the domain has no segments, and --convex-hull is not given
  bool region_caps_unused = false;  ///< regions have area caps, but the goal ignores them
  std::vector<GroupName> names;     ///< of markers and regions
  std::filesystem::path sizes;      ///< the file of --sizes, or empty
  std::filesystem::path sources;    ///< the file of --sources, or empty
  Options options;
  Report report;
  ExemptTriangles exempt;
  MeshStatistics statistics;
  Digest digest;
  std::optional<Certificate> certificate;       ///< only with --check
  std::optional<std::uint64_t> sweeps_checked;  ///< only with --paranoid
  std::vector<std::filesystem::path> outputs;
  Seconds seconds;
  std::optional<RanksOfRun> ranks;    ///< only of pardel-mpi
  std::optional<MesherOfRun> mesher;  ///< only with --mesher
};

/// Fills in the numbers of points, segments, holes and regions.
void count_input(const Pslg& input, MeshRun& run);
/// Fills in the goal, and what it makes of the input. `regions`: those of the input. `expects_hull`: the user has asked
/// for the convex hull. Precondition: the numbers and MeshRun::refined are filled in.
void describe_goal(const Goal& goal, std::span<const Region> regions, bool expects_hull, MeshRun& run);

[[nodiscard]] std::string to_json(const MeshRun& run);
/// The lines of the summary on the input, the mesh and the check. They do not depend on the number of ranks.
[[nodiscard]] std::string text_of_mesh(const MeshRun& run);
/// A summary of a few lines: those of text_of_mesh(), the times, the digest and the files.
[[nodiscard]] std::string to_text(const MeshRun& run);

}  // namespace pardel::cli
