// OutputFile: a file that gets its name only when it is complete.
#pragma once

#include <cstdint>
#include <cstdio>
#include <deque>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>

#include "../result.hpp"
#include "stop_signal.hpp"

namespace pardel {

/// True if the file exists and is not a regular file (a pipe, a device), or if the name stands for an open file: `-`
/// and /dev/stdout for standard output, /dev/fd/N.
[[nodiscard]] bool is_written_directly(const std::filesystem::path& file);

/// The file that a symbolic link leads to, also if it does not exist yet. The name itself if it is no link. If links
/// lead in a circle: one of them.
[[nodiscard]] std::filesystem::path behind_links(const std::filesystem::path& file);

/// Writes to a new file in the folder of NAME. commit() gives it the name NAME; without commit() it vanishes. The new
/// file has no name before (Linux: O_TMPFILE), so whatever ends the process, no file is left. If a file NAME exists,
/// the new one is called `NAME.SPACE-PROCESS-NUMBER.partial` for a moment and then replaces it: Linux replaces by
/// renaming only. A process that is killed in this moment leaves this name, and the next one that commits NAME removes
/// it (remove_leftovers). Where the file system has no files without names, the new file has such a name from the
/// beginning; the destructor removes it.
/// A file for which is_written_directly() is true is written directly. A symbolic link is followed: the file that it
/// leads to is made or replaced. A file that replaces another one is on the disk before (fsync). The object stores the
/// first failure, and close() reports it.
class OutputFile {
 public:
  /// How the file is kept before it has its final name.
  enum class Aside : std::uint8_t {
    unnamed,  ///< without a name, if possible; then a descriptor stays open until commit()
    named,    ///< with a name, so that processes on other machines can open it
  };

  explicit OutputFile(const std::filesystem::path& file, Aside aside = Aside::unnamed);
  /// write() and close() ask go_on() every few milliseconds if they are called by the thread that made the object. If
  /// it returns false, that is a failure: an error `cancelled`. An empty function is not asked.
  OutputFile(const std::filesystem::path& file, const std::function<bool()>& go_on);
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;
  ~OutputFile();

  /// False after a failure. Later writes then do nothing.
  [[nodiscard]] bool ok() const { return !failure_; }
  /// Precondition: neither close() nor commit() was called.
  [[nodiscard]] bool is_unnamed() const { return is_unnamed_; }
  /// The name under which processes of the same user can open the file before close(): if it has no name of its own,
  /// one in /proc of this machine. Empty if it cannot be opened.
  [[nodiscard]] std::filesystem::path written() const;
  void write(std::string_view bytes);
  /// Flushes and closes the file. Every failure to write is reported here at the latest, as an `io` error (`cancelled`
  /// if go_on() returned false).
  Status close();
  /// Calls close(), then gives the file its final name.
  Status commit();

 private:
  void fail(const char* what, int error_number);
  /// False after a failure, and if the caller asks to stop.
  [[nodiscard]] bool may_go_on();
  void write_aside(Aside aside);
  [[nodiscard]] bool open_unnamed();
  void write_to_disk();
  [[nodiscard]] int give_name();
  Status put_in_place();

  std::filesystem::path name_;     ///< as given by the caller, for messages
  std::filesystem::path target_;   ///< the file to replace
  std::filesystem::path written_;  ///< the partial file, or target_ itself; empty: none, or one without a name
  std::FILE* stream_ = nullptr;
  bool is_unnamed_ = false;  ///< neither written_ nor target_ is a name of the file yet
  int descriptor_ = -1;      ///< of an unnamed file that is closed, which would vanish without it
  std::optional<Error> failure_{};
  std::unique_ptr<StopSignal> stop_{};  ///< null: nothing is asked

  friend class Replacement;
};

/// Called when all files have their final names, or with the error because of which they have not. If it returns an
/// error, the files that were there before are put back.
using FinalAgreement = std::function<Status(const Status& placed)>;

/// Closes all files, then gives them their final names: all or none. If a file cannot get its name, or
/// `agree` returns an error, the files that were there before are put back (KeptFile says when this is not possible).
/// Returns the error, or the result of `agree`, which is called in any case.
Status commit_all(std::deque<OutputFile>& files, const FinalAgreement& agree = {});

/// Removes the partial files of all OutputFiles that exist. While the caller holds the lock, no partial file is made
/// and no file gets its final name: other threads that try wait. A program calls this if it has to end at once, in the
/// middle of any work, and keeps the lock until it ends. Of files that are committed together, either all have their
/// final names then or none has.
[[nodiscard]] std::unique_lock<std::recursive_mutex> remove_partial_files();

}  // namespace pardel
