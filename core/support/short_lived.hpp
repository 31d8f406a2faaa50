// The child processes and temporary folders of this process.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <mutex>
#include <set>

namespace pardel {

/// What must not outlive the process, also if it ends without destructors. There is one list for the process, with the
/// mutex of PartialFiles. Whoever starts a child, or waits for its end, holds the mutex: so nothing is left out, and no
/// number of a process that is gone is used.
class ShortLived {
 public:
  [[nodiscard]] static ShortLived& of_process();

  void add_folder(const std::filesystem::path& folder);
  /// Removes the folder with its contents.
  void remove_folder(const std::filesystem::path& folder);
  /// A child that leads a process group.
  void add_child(pid_t child);
  void forget_child(pid_t child);
  /// Kills the groups of all children, and removes all folders.
  void end_all();

 private:
  std::set<std::filesystem::path> folders_;
  std::set<pid_t> children_;
};

/// For a process that has to end at once: ends its children, and removes its folders and partial files, as
/// remove_partial_files() does (output_file.hpp). While the caller holds the lock, no child is started.
[[nodiscard]] std::unique_lock<std::recursive_mutex> leave_nothing_behind();

}  // namespace pardel
