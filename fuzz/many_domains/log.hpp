// The log of a run of many_domains: a line with the seed, then a line per case (record.hpp).
#pragma once

#include <cstdint>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "record.hpp"

namespace pardel::fuzz {

/// Only one process at a time has a log. All functions throw std::runtime_error with a message that names the file.
class Log {
 public:
  /// Makes the file if it does not exist. Throws if the log is of another seed, or if another process has it.
  Log(std::string file, std::uint64_t seed);

  /// The records that were in the file, of each number the first one. A line that was cut off is none.
  [[nodiscard]] const std::vector<Record>& records() const { return records_; }
  /// Adds a line to the file. When it returns, the line has left this process.
  void append(const Record& record);

 private:
  struct Close {
    void operator()(std::FILE* stream) const { std::fclose(stream); }
  };

  [[noreturn]] void fail(const std::string& why) const;
  void write(const std::string& line);
  /// Returns true if the last line of the file is complete.
  bool read(std::uint64_t seed);

  std::string file_;
  std::unique_ptr<std::FILE, Close> stream_;
  std::vector<Record> records_;
};

}  // namespace pardel::fuzz
