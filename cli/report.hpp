// The report of a run of `pardel mesh`: as text, and as JSON with the schema pardel.report/1.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "../core/digest.hpp"
#include "../core/goal.hpp"
#include "../parallel/mesher.hpp"
#include "../parallel/warnings.hpp"
#include "../properties/checker/check.hpp"
#include "../properties/checker/statistics.hpp"

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
  MeshStatistics statistics;
  Digest digest;
  std::optional<Certificate> certificate;       ///< only with --check
  std::optional<std::uint64_t> sweeps_checked;  ///< only with --paranoid
  std::vector<std::filesystem::path> outputs;
  Seconds seconds;
  std::optional<RanksOfRun> ranks;  ///< only of pardel-mpi
};

/// Fills in the numbers of points, segments, holes and regions.
void count_input(const Pslg& input, MeshRun& run);

[[nodiscard]] std::string to_json(const MeshRun& run);
/// A summary of a few lines.
[[nodiscard]] std::string to_text(const MeshRun& run);

/// Describes the triangles that miss the goal for a reason that no small input angle justifies: their number by reason,
/// then the corners of the first `most` of them, then the number of the others. `limit` is the option that limits the
/// vertices. If `all_in` is not empty, the text names it as the place that lists all of them. Returns an empty text if
/// there is no such triangle.
[[nodiscard]] std::string missed_bounds(const Report& report, const Mesh& mesh, std::size_t most,
                                        std::string_view limit, std::string_view all_in = {});

}  // namespace pardel::cli
