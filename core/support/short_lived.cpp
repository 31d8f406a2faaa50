#include "short_lived.hpp"

#include <chrono>
#include <csignal>
#include <system_error>
#include <thread>

#include "output_file.hpp"
#include "partial_files.hpp"

namespace pardel {
namespace {

namespace fs = std::filesystem;

std::scoped_lock<std::recursive_mutex> locked() { return std::scoped_lock(PartialFiles::of_process().mutex); }

/// Gives the owner back what a program may have taken from its own folders.
void allow_removal(const fs::path& folder) {
  std::error_code ignored;
  fs::permissions(folder, fs::perms::owner_all, fs::perm_options::add, ignored);
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
    if (entry->is_directory(ignored) && !entry->is_symlink(ignored)) allow_removal(entry->path());
}

/// What cannot be removed stays.
void remove_with_contents(const fs::path& folder) {
  // A process that was killed may still make a file.
  constexpr int tries = 20;
  std::error_code error;
  fs::remove_all(folder, error);
  for (int i = 0; i < tries && error; ++i) {
    if (i > 0) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    allow_removal(folder);
    fs::remove_all(folder, error);
  }
}

}  // namespace

ShortLived& ShortLived::of_process() {
  static ShortLived all;
  return all;
}

void ShortLived::add_folder(const std::filesystem::path& folder) {
  const auto lock = locked();
  folders_.insert(folder);
}

void ShortLived::remove_folder(const std::filesystem::path& folder) {
  remove_with_contents(folder);
  const auto lock = locked();
  folders_.erase(folder);
}

void ShortLived::add_child(pid_t child) {
  const auto lock = locked();
  children_.insert(child);
}

void ShortLived::forget_child(pid_t child) {
  const auto lock = locked();
  children_.erase(child);
}

void ShortLived::end_all() {
  const auto lock = locked();
  for (const pid_t child : children_) kill(-child, SIGKILL);
  for (const std::filesystem::path& folder : folders_) remove_with_contents(folder);
  children_.clear();
  folders_.clear();
}

std::unique_lock<std::recursive_mutex> leave_nothing_behind() {
  std::unique_lock lock = remove_partial_files();
  ShortLived::of_process().end_all();
  return lock;
}

}  // namespace pardel
