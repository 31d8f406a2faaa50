#include "leftover_files.hpp"

#include <dirent.h>
#include <signal.h>  // NOLINT(modernize-deprecated-headers): kill() is of POSIX
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "this_machine.hpp"

namespace pardel {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view suffix = ".partial";

const std::string& own_space() {
  static const std::string space = space_of_processes();
  return space;
}

std::optional<std::uint64_t> number_in(std::string_view text) {
  std::uint64_t number = 0;
  const auto [stop, status] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (status != std::errc() || stop != text.data() + text.size()) return std::nullopt;
  return number;
}

/// What a partial name says.
struct PartialName {
  std::string file, space;
  pid_t process;
};

std::optional<PartialName> parts_of(std::string_view name) {
  if (!name.ends_with(suffix)) return std::nullopt;
  name.remove_suffix(suffix.size());
  const std::size_t dot = name.rfind('.'), last = name.rfind('-');
  const std::size_t first = last == std::string_view::npos ? last : name.rfind('-', last - 1);
  if (dot == std::string_view::npos || first == std::string_view::npos || first < dot) return std::nullopt;
  const auto process = number_in(name.substr(first + 1, last - first - 1));
  if (!process || !number_in(name.substr(last + 1))) return std::nullopt;
  return PartialName{std::string(name.substr(0, dot)), std::string(name.substr(dot + 1, first - dot - 1)),
                     static_cast<pid_t>(*process)};
}

/// True only if it is certain.
bool has_ended(const PartialName& name) {
  return !own_space().empty() && name.space == own_space() && name.process > 0 && kill(name.process, 0) != 0 &&
         errno == ESRCH;
}

/// The names of the files in a folder; none if it cannot be read. Not with std::filesystem::directory_iterator: that of
/// GCC 12 ends the process if there is no memory.
std::vector<std::string> entries_of(const fs::path& folder) {
  struct Close {
    void operator()(DIR* open) const { ::closedir(open); }
  };
  std::vector<std::string> names;
  const std::unique_ptr<DIR, Close> open(::opendir(folder.empty() ? "." : folder.c_str()));
  if (!open) return names;
  while (const dirent* entry = ::readdir(open.get())) names.emplace_back(entry->d_name);
  return names;
}

}  // namespace

fs::path partial_name(const fs::path& file, std::uint64_t number) {
  fs::path name = file;
  name += "." + own_space() + "-" + std::to_string(getpid()) + "-" + std::to_string(number) + std::string(suffix);
  return name;
}

void remove_leftovers(std::span<const fs::path> files) {
  std::map<fs::path, std::set<std::string>> names_in;  // each folder is read once
  for (const fs::path& file : files) names_in[file.parent_path()].insert(file.filename().string());
  for (const auto& [folder, names] : names_in) {
    for (const std::string& name : entries_of(folder)) {
      const auto parts = parts_of(name);
      std::error_code ignored;
      if (parts && names.contains(parts->file) && has_ended(*parts)) fs::remove(folder / name, ignored);
    }
  }
}

}  // namespace pardel
