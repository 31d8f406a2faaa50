// The options of pardel-harness.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "../../core/result.hpp"
#include "case.hpp"

namespace pardel::harness {

struct Options {
  std::string mesher;
  std::string format = "ele";
  double min_angle_deg = 20;
  double max_area_fraction = 0;
  bool any_triangulation = false;  ///< the mesh need not be Delaunay
  std::uint64_t cases = 500;
  std::uint64_t seed = 1;
  std::vector<Family> families;  ///< drawn from in turn
  std::vector<CaseId> replay;    ///< if not empty: run these cases instead of drawn ones
  double time_limit = 10;        ///< seconds
  std::uint64_t memory_limit_mib = 4096;
  int jobs = 1;
  std::filesystem::path report = "-";
  std::filesystem::path json;
  std::filesystem::path failures;
  std::size_t shrink_runs = 300;
  std::filesystem::path keep;
};

enum class Answer : std::uint8_t { run, was_answered, misused };

/// Sets the options from the command line. `was_answered`: --help, --version or --list-families was given, and the
/// answer is on stdout. `misused`: the command line is wrong, and the message is on stderr.
[[nodiscard]] Answer parse(int argc, char** argv, Options& options);

}  // namespace pardel::harness
