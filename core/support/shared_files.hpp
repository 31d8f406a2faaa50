// SharedFiles: files that several ranks write together, and that get their names only when all ranks have finished.
#pragma once

#include <cstdint>
#include <deque>
#include <filesystem>
#include <mutex>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "../ranks.hpp"
#include "../result.hpp"
#include "output_file.hpp"

namespace pardel {

/// Files in a folder that all ranks see. The first rank makes the files (see OutputFile); every rank writes to them at
/// places of its own. If all ranks run on one machine, the files have no names before commit(). Ranks on several
/// machines can open them only by partial names. The object stores the first failure of this rank, and commit() reports
/// it.
class SharedFiles {
 public:
  /// Collective. All ranks pass the same names. A file that is written directly (is_written_directly) is an error.
  SharedFiles(std::span<const std::filesystem::path> names, Ranks& ranks);
  SharedFiles(const SharedFiles&) = delete;
  SharedFiles& operator=(const SharedFiles&) = delete;
  /// Without commit() the files vanish.
  ~SharedFiles();

  /// Writes bytes to file number `file`, from byte `offset` on. Several threads may call this. After a failure it does
  /// nothing.
  void write_at(std::size_t file, std::uint64_t offset, std::string_view bytes);
  /// Collective. Either all files get their final names or, if a rank has failed, none does; then its error is returned
  /// on all ranks.
  [[nodiscard]] Status commit();

 private:
  [[nodiscard]] std::string make(std::size_t file, OutputFile::Aside aside);
  [[nodiscard]] bool open_unnamed(std::size_t file);
  void open_named(std::size_t file);
  void fail(std::size_t file, const std::string& what);
  [[nodiscard]] bool has_failed();
  [[nodiscard]] Status close();

  Ranks& ranks_;
  std::vector<std::filesystem::path> names_;
  std::deque<OutputFile> outputs_;  ///< only the first rank has them
  std::vector<int> descriptors_;    ///< of the files; -1: not open
  std::mutex mutex_;
  std::string failure_;
};

}  // namespace pardel
