// One line per case that was run. The log of a run consists of these lines, and the summary is made of them alone, so a
// run can be stopped at any time and continued.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pardel::fuzz {

struct Record {
  enum class Verdict : std::uint8_t {
    right,
    wrong,    ///< a fault was found; `fault` says which
    crash,    ///< the process ended; `fault` says how
    time_out  ///< the limit on processor time, or ten times this limit has passed
  };
  std::uint64_t number = 0;
  Verdict verdict = Verdict::right;
  double seconds = 0;  ///< of processor time, for everything that was done with the case
  std::uint64_t triangles = 0, listed = 0;
  std::string kinds = "unknown";  ///< with commas between them
  std::string fault;
  friend bool operator==(const Record&, const Record&) = default;
};

[[nodiscard]] const char* name(Record::Verdict verdict);

/// The record as one line, without a line feed. Line feeds of the fault become blanks.
[[nodiscard]] std::string to_line(const Record& record);
/// The record of a line; nothing if the line was not written completely.
[[nodiscard]] std::optional<Record> to_record(std::string_view line);

/// The summary as text for people. `replay` is the beginning of the command line that runs a case again.
[[nodiscard]] std::string summary_text(const std::vector<Record>& records, std::size_t slowest,
                                       const std::string& replay);
/// The same as JSON.
[[nodiscard]] std::string summary_json(const std::vector<Record>& records, std::size_t slowest,
                                       const std::string& replay);

}  // namespace pardel::fuzz
