#include "programs.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <system_error>

namespace pardel {
namespace fs = std::filesystem;

bool is_program(const fs::path& file) {
  std::error_code ignored;
  return access(file.c_str(), X_OK) == 0 && !fs::is_directory(file, ignored);
}

fs::path on_path(const std::string& program) {
  const char* path = std::getenv("PATH");
  const std::string folders = path != nullptr ? path : "";
  for (std::size_t start = 0; start <= folders.size();) {
    const std::size_t end = std::min(folders.find(':', start), folders.size());
    const fs::path candidate = fs::path(folders.substr(start, end - start)) / program;
    if (is_program(candidate)) return fs::absolute(candidate);
    start = end + 1;
  }
  return {};
}

Result<fs::path> find_program(const std::string& word) {
  const bool is_name = word.find('/') == std::string::npos;
  const fs::path found = is_name ? on_path(word) : fs::absolute(word);
  if (is_program(found)) return found;
  return Error{ErrorKind::io, is_name ? "there is no program '" + word + "' on the PATH" : word + " is no program"};
}

fs::path beside_this_program(const std::string& program) {
  std::error_code ignored;
  const fs::path here = fs::read_symlink("/proc/self/exe", ignored).parent_path();
  for (const fs::path& candidate : {here / program, here.parent_path() / "bench" / program})
    if (is_program(candidate)) return candidate;
  return {};
}

}  // namespace pardel
