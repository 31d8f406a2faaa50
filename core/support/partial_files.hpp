// The files of this process that have names of their own, but not their final ones.
#pragma once

#include <cerrno>
#include <cstdint>
#include <filesystem>
#include <mutex>
#include <set>
#include <system_error>

namespace pardel {

/// There is one list for the process, because the process may have to end while any of its threads writes. Whoever
/// makes, renames or removes such a file holds the mutex.
class PartialFiles {
 public:
  [[nodiscard]] static PartialFiles& of_process();

  std::recursive_mutex mutex;  ///< who holds it while several files are replaced also removes some of them

  /// Calls make(name) for new names (partial_name()), until the result is not EEXIST. `make` has to make the file and
  /// to return 0, or an error number. Puts the name on the list and returns it; empty after an error,
  /// which is then in errno. Nothing is made if there is no memory for the name.
  template <class Make>
  [[nodiscard]] std::filesystem::path make(const std::filesystem::path& file, const Make& make) {
    const std::scoped_lock lock(mutex);
    for (;;) {
      const auto name = names_.insert(next_name(file)).first;
      std::filesystem::path made = *name;
      const int error = make(made);
      if (error == 0) return made;
      names_.erase(name);
      errno = error;
      if (error != EEXIST) return {};
    }
  }
  /// The file is not partial any more, or is gone.
  void forget(const std::filesystem::path& name) {
    const std::scoped_lock lock(mutex);
    names_.erase(name);
  }
  void remove(const std::filesystem::path& name) {
    const std::scoped_lock lock(mutex);
    std::error_code ignored;  // a file stays if it cannot be removed
    std::filesystem::remove(name, ignored);
    names_.erase(name);
  }
  void remove_all();

 private:
  [[nodiscard]] std::filesystem::path next_name(const std::filesystem::path& file);

  std::set<std::filesystem::path> names_;
  std::uint64_t made_ = 0;  ///< counts the names that were tried
};

}  // namespace pardel
