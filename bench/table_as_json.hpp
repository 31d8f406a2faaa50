// Writes the rows of a table of measurements in the format of Google Benchmark, for bench/track and other programs.
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace pardel::bench {

struct MeasuredRow {
  std::string name;  ///< without the number of threads
  int threads = 1;
  double seconds = 0;  ///< > 0
  std::uint64_t triangles = 0;
  std::uint64_t peak_rss_bytes = 0;
  std::string digest{};  ///< of the mesh; empty: not computed
};

/// Writes the file. Returns false if this fails.
[[nodiscard]] inline bool write_json(const std::filesystem::path& file, const std::string& executable,
                                     const std::vector<MeasuredRow>& rows) {
  constexpr double nanoseconds = 1e9;
  nlohmann::ordered_json entries = nlohmann::ordered_json::array();
  for (const MeasuredRow& row : rows) {
    const std::string name = row.threads == 1 ? row.name : row.name + "/threads:" + std::to_string(row.threads);
    const auto triangles = static_cast<double>(row.triangles);
    nlohmann::ordered_json entry = {{"name", name},
                                    {"run_name", name},
                                    {"run_type", "iteration"},
                                    {"threads", row.threads},
                                    {"iterations", 1},
                                    {"real_time", nanoseconds * row.seconds},
                                    {"time_unit", "ns"},
                                    {"items_per_second", triangles / row.seconds},
                                    {"items", row.triangles},
                                    {"bytes_per_triangle", static_cast<double>(row.peak_rss_bytes) / triangles}};
    if (!row.digest.empty()) entry["digest"] = row.digest;
    entries.push_back(entry);
  }
  std::ofstream out(file);
  out << nlohmann::ordered_json{{"context", {{"executable", executable}}}, {"benchmarks", entries}}.dump(1) << '\n';
  out.close();
  return !out.fail();
}

}  // namespace pardel::bench
