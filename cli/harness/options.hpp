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
  std::vector<Family> families;  ///< cases are taken from these families in turn
  std::vector<CaseId> replay;    ///< if not empty: run these cases instead of drawn ones
  double time_limit = 10;        ///< seconds
  std::uint64_t memory_limit_mib = 4096;
  int jobs = 1;
  std::filesystem::path report = "-";  ///< file; "-" is standard output
  std::filesystem::path json;          ///< file; empty: no JSON report
  std::filesystem::path failures;      ///< folder for the shrunk failing inputs; empty: none
  std::size_t shrink_runs = 300;
  std::filesystem::path keep;  ///< folder that keeps the input, output and log of every case; empty: none
};

enum class ParseResult : std::uint8_t { run, done, usage_error };

/// Sets the options from the command line. `done`: --help, --version or --list-families was given, and its
/// output is on stdout. `usage_error`: the command line is wrong, and the message is on stderr.
[[nodiscard]] ParseResult parse(int argc, char** argv, Options& options);

}  // namespace pardel::harness
