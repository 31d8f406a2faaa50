#include "short_lived.hpp"

#include <chrono>
#include <csignal>
#include <system_error>
#include <thread>

#include "output_file.hpp"
#include "partial_files.hpp"

namespace pardel {
namespace {

std::scoped_lock<std::recursive_mutex> locked() { return std::scoped_lock(PartialFiles::of_process().mutex); }

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
  std::error_code ignored;  // what cannot be removed stays
  std::filesystem::remove_all(folder, ignored);
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
  // A process that was killed may still make a file.
  constexpr int tries = 20;
  for (const std::filesystem::path& folder : folders_) {
    std::error_code left;
    for (int i = 0; i < tries && (std::filesystem::remove_all(folder, left), left); ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  children_.clear();
  folders_.clear();
}

std::unique_lock<std::recursive_mutex> leave_nothing_behind() {
  std::unique_lock lock = remove_partial_files();
  ShortLived::of_process().end_all();
  return lock;
}

}  // namespace pardel
