#include "this_machine.hpp"

#include <sys/stat.h>

#include <array>
#include <charconv>
#include <cstdint>
#include <fstream>
#include <system_error>

namespace pardel {
namespace {

namespace fs = std::filesystem;

/// FNV-1a, folded to 32 bits. It is the same in all programs, unlike std::hash.
std::uint32_t short_hash(const std::string& text) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const char letter : text) hash = (hash ^ static_cast<unsigned char>(letter)) * 0x100000001b3;
  return static_cast<std::uint32_t>(hash ^ (hash >> 32));
}

std::string eight_digits(std::uint32_t number) {
  std::array<char, 8> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), number, 16).ptr;
  const std::string text(digits.data(), end);
  return std::string(digits.size() - text.size(), '0') + text;
}

}  // namespace

std::string running_system() {
  std::string text;
  std::ifstream("/proc/sys/kernel/random/boot_id") >> text;
  return text;
}

std::string space_of_processes() {
  const std::string system = running_system();
  std::error_code failure;
  const std::string container = fs::read_symlink("/proc/self/ns/pid", failure).string();
  if (system.empty() || failure) return {};
  return eight_digits(short_hash(system + container));
}

std::string identity_of(const fs::path& file) {
  const std::string system = running_system();
  struct stat about {};
  if (system.empty() || stat(file.c_str(), &about) != 0) return {};
  return system + " " + std::to_string(about.st_dev) + " " + std::to_string(about.st_ino);
}

}  // namespace pardel
