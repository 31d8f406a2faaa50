#include "distinct_files.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <system_error>
#include <vector>

#include "../core/formats.hpp"
#include "../core/support/open_file.hpp"

namespace pardel::cli {
namespace fs = std::filesystem;
namespace {

constexpr std::array family = {".poly", ".node", ".ele", ".area"};

/// The full name without symbolic links, also if the last link leads to a file that does not exist.
fs::path full_name(fs::path file) {
  std::error_code error;
  constexpr int most_links = 40;
  for (int i = 0; i < most_links && fs::is_symlink(file, error); ++i) {
    const fs::path target = fs::read_symlink(file, error);
    if (error) break;
    file = file.parent_path() / target;
  }
  const fs::path full = fs::weakly_canonical(fs::absolute(file, error), error);
  return full.empty() ? file : full;
}

/// The full names of all files that the file stands for. An .npy is read with its world file.
std::vector<fs::path> full_names(const NamedFile& named) {
  const fs::path full = full_name(named.file);
  if (full.extension() == ".npy") return {full, fs::path(full).replace_extension(".wld")};
  if (!named.with_family || std::ranges::find(family, full.extension()) == family.end()) return {full};
  std::vector<fs::path> names;
  for (const char* suffix : family) names.push_back(fs::path(full).replace_extension(suffix));
  return names;
}

bool is_skipped(const NamedFile& named) {
  std::error_code ignored;
  return named.file.empty() || is_standard_output(named.file) || fs::is_character_file(named.file, ignored);
}

bool are_distinct(const NamedFile& a, const NamedFile& b) {
  if (is_skipped(a) || is_skipped(b)) return true;
  const std::vector<fs::path> names = full_names(b);
  return std::ranges::none_of(full_names(a),
                              [&](const fs::path& name) { return std::ranges::find(names, name) != names.end(); });
}

}  // namespace

Status check_distinct(std::span<const NamedFile> outputs, std::span<const NamedFile> inputs) {
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    const NamedFile& output = outputs[i];
    const std::string name = fmt::format("{} {}", output.option, output.file.string());
    for (const NamedFile& input : inputs) {
      if (!are_distinct(output, input))
        return Error{ErrorKind::usage,
                     fmt::format("{}: this output would replace files of the input {}; choose another name", name,
                                 input.file.string())};
    }
    for (const NamedFile& earlier : outputs.first(i)) {
      if (!are_distinct(output, earlier))
        return Error{ErrorKind::usage, fmt::format("{}: this output would replace files of {} {}; choose another name",
                                                   name, earlier.option, earlier.file.string())};
    }
  }
  return Done{};
}

std::vector<NamedFile> with_pieces(const NamedFile& mesh) {
  std::vector<NamedFile> files{mesh};
  if (mesh.file.extension() == ".pvtu")
    if (const auto pieces = files_of_pieces(mesh.file))
      for (const fs::path& piece : *pieces) files.push_back({{}, piece, false});
  std::error_code ignored;
  if (mesh.file.extension() == ".msh" && !fs::exists(mesh.file, ignored))
    for (int i = 1; fs::exists(msh_of_piece(mesh.file, i), ignored); ++i)
      files.push_back({{}, msh_of_piece(mesh.file, i), false});
  return files;
}

NamedFile domain_input(const fs::path& file) {
  return {.option = {}, .file = file, .with_family = file.extension() != ".node"};
}

}  // namespace pardel::cli
