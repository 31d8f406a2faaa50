// What `pardel mesh` tells about its run: to people, and as JSON with the schema pardel.report/1.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "../core/digest.hpp"
#include "../core/goal.hpp"
#include "../parallel/mesher.hpp"
#include "../properties/checker/check.hpp"
#include "../properties/checker/statistics.hpp"

namespace pardel::cli {

struct Seconds {
  double read = 0, validate = 0, triangulate = 0, refine = 0, check = 0, write = 0;
  double statistics = 0;  ///< what the report says of the mesh, its digest included
  double total = 0;
};

struct MeshRun {
  std::string name;  ///< of the input file
  std::size_t points = 0, segments = 0, holes = 0, regions = 0;
  Goal goal;
  bool region_caps_unused = false;  ///< there are some, and the goal leaves them aside
  std::filesystem::path sizes;      ///< where goal.size came from
  Options options;
  Report report;
  MeshStatistics statistics;
  Digest digest;
  std::optional<Certificate> certificate;       ///< where a check was asked for
  std::optional<std::uint64_t> sweeps_checked;  ///< where --paranoid was
  std::vector<std::filesystem::path> outputs;
  Seconds seconds;
};

[[nodiscard]] std::string to_json(const MeshRun& run);
/// A few lines.
[[nodiscard]] std::string to_text(const MeshRun& run);

/// The triangles that miss the goal for a reason that no small input angle justifies: their number by
/// reason, then the first `most` of them with their places, then how many more there are and, if `all_in` is not
/// empty, where they can be read. Empty where there are none.
[[nodiscard]] std::string missed_bounds(const Report& report, const Mesh& mesh, std::size_t most,
                                        std::string_view all_in = {});

}  // namespace pardel::cli
