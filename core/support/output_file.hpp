// OutputFile: a file that appears under its name only when it is complete.
#pragma once

#include <cstdio>
#include <deque>
#include <filesystem>
#include <string>
#include <string_view>

#include "../result.hpp"

namespace pardel {

/// Writes to `NAME.partial` beside NAME; commit() renames it, and without commit() it is removed again. What
/// is no regular file (a pipe, a device, anything below /dev or /proc) is written to directly. A symbolic link
/// is followed: the file it points to is replaced. The first failure is kept, and reported by close().
class OutputFile {
 public:
  explicit OutputFile(const std::filesystem::path& file);
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;
  ~OutputFile();

  /// False after a failure, when writing on is in vain.
  [[nodiscard]] bool ok() const { return failure_.empty(); }
  void write(std::string_view bytes);
  /// Flushes and closes; what the system did not take is an `io` error here at the latest.
  Status close();
  /// close(), then gives the file its name.
  Status commit();

 private:
  void fail(const char* what, int error_number);

  std::filesystem::path name_;     ///< as the caller wrote it, for messages
  std::filesystem::path target_;   ///< what is to be replaced
  std::filesystem::path written_;  ///< what is being written: the partial file or target_ itself; empty: nothing
  std::FILE* stream_ = nullptr;
  std::string failure_;
};

/// Closes all and, only if that succeeded for all, commits each: a set of files appears together or not at all.
Status commit_all(std::deque<OutputFile>& files);

}  // namespace pardel
