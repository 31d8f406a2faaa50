#include "distinct_files.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <map>
#include <system_error>
#include <utility>
#include <vector>

#include "../core/formats.hpp"
#include "../core/support/open_file.hpp"
#include "../core/support/output_file.hpp"

namespace pardel::cli {
namespace fs = std::filesystem;
namespace {

constexpr std::array family = {".poly", ".node", ".ele", ".area"};

/// The full name without symbolic links, also if the last link leads to a file that does not exist.
fs::path full_name(const fs::path& file) {
  std::error_code error;
  const fs::path reached = behind_links(file);
  const fs::path full = fs::weakly_canonical(fs::absolute(reached, error), error);
  return full.empty() ? reached : full;
}

/// The full names of all files that the file stands for. An .npy is read with its world file.
std::vector<fs::path> full_names(const NamedFile& named) {
  const fs::path full = full_name(named.file);
  if (full.extension() == ".npy") return {full, fs::path(full).replace_extension(".wld")};
  if (!named.with_family || std::ranges::find(family, full.extension()) == family.end()) return {full};
  std::vector<fs::path> names;
  names.reserve(family.size());
  for (const char* suffix : family) names.push_back(fs::path(full).replace_extension(suffix));
  return names;
}

bool is_skipped(const NamedFile& named) {
  std::error_code ignored;
  return named.file.empty() || is_standard_output(named.file) || fs::is_character_file(named.file, ignored);
}

/// The files of the pieces, if the file is a mesh in pieces that is read. If a .pvtu cannot be read, the reader of the
/// mesh says why.
std::vector<fs::path> pieces_of(const fs::path& mesh) {
  std::vector<fs::path> pieces;
  std::error_code ignored;
  if (mesh.extension() == ".pvtu")
    if (auto listed = files_of_pieces(mesh)) pieces = std::move(*listed);
  if (mesh.extension() == ".msh" && !fs::exists(mesh, ignored))
    for (int i = 1; fs::exists(msh_of_piece(mesh, i), ignored); ++i) pieces.push_back(msh_of_piece(mesh, i));
  return pieces;
}

}  // namespace

Status check_distinct(std::span<const NamedFile> outputs, std::span<const NamedFile> inputs) {
  std::map<fs::path, std::string> taken;  // full names, and whose files they are
  for (const NamedFile& input : inputs) {
    if (is_skipped(input)) continue;
    const std::string whose = fmt::format("the input {}", input.file.string());
    for (const fs::path& name : full_names(input)) taken.try_emplace(name, whose);
    for (const fs::path& piece : pieces_of(input.file)) taken.try_emplace(full_name(piece), whose);
  }
  for (const NamedFile& output : outputs) {
    if (is_skipped(output)) continue;
    const std::string what = fmt::format("{} {}", output.option, output.file.string());
    const std::vector<fs::path> names = full_names(output);
    const auto used = std::ranges::find_if(names, [&](const fs::path& name) { return taken.contains(name); });
    if (used != names.end())
      return Error{ErrorKind::usage, fmt::format("{}: this output would replace files of {}; choose another name", what,
                                                 taken.at(*used))};
    for (const fs::path& name : names) taken.try_emplace(name, what);
  }
  return Done{};
}

NamedFile domain_input(const fs::path& file) {
  return {.option = {}, .file = file, .with_family = file.extension() != ".node"};
}

}  // namespace pardel::cli
