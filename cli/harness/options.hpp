// What the command line asks for.
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
  bool any_triangulation = false;  ///< no Delaunay mesh is asked for
  std::uint64_t cases = 500;
  std::uint64_t seed = 1;
  std::vector<Family> families;  ///< in turn
  std::vector<CaseId> replay;    ///< these instead of drawn ones, if any
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

/// Fills in the options. `was_answered`: --help, --version or --list-families was, on stdout; `misused`: what has
/// no meaning is on stderr.
[[nodiscard]] Answer parse(int argc, char** argv, Options& options);

}  // namespace pardel::harness
