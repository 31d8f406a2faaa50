#include "suffix.hpp"

#include <fmt/core.h>

#include <string>

namespace pardel::cli {
namespace fs = std::filesystem;

bool is_domain_suffix(const fs::path& file) {
  const fs::path suffix = file.extension();
  return suffix.empty() || suffix == ".poly" || suffix == ".node";
}

Error unknown_format(const fs::path& file, const char* content, const char* known) {
  const std::string suffix = file.extension().string();
  const std::string what = suffix.empty() ? std::string("the name has no suffix, which sets the format")
                                          : fmt::format("'{}' is not a known format", suffix);
  return {ErrorKind::usage, fmt::format("{}: {}; the formats of {} are {}", file.string(), what, content, known)};
}

}  // namespace pardel::cli
