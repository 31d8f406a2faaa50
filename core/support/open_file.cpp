#include "open_file.hpp"

#include <unistd.h>

#include <charconv>
#include <string>
#include <string_view>
#include <system_error>

namespace pardel {
namespace fs = std::filesystem;

std::optional<int> descriptor_of(const fs::path& file) {
  const std::string name = file.lexically_normal().string();
  if (name == "/dev/stdin") return STDIN_FILENO;
  if (name == "-" || name == "/dev/stdout") return STDOUT_FILENO;
  if (name == "/dev/stderr") return STDERR_FILENO;
  for (const std::string_view folder : {"/dev/fd/", "/proc/self/fd/"}) {
    if (!name.starts_with(folder)) continue;
    int number = -1;
    const auto [stop, status] = std::from_chars(name.data() + folder.size(), name.data() + name.size(), number);
    if (status == std::errc() && stop == name.data() + name.size()) return number;
  }
  return std::nullopt;
}

bool is_standard_output(const fs::path& file) { return descriptor_of(file) == STDOUT_FILENO; }

bool is_standard_input(const fs::path& file) { return file == "-" || descriptor_of(file) == STDIN_FILENO; }

}  // namespace pardel
