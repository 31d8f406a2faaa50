#include "patch.hpp"

#include <algorithm>
#include <fstream>
#include <map>
#include <set>
#include <stdexcept>

#include "registry.hpp"
#include "text_file.hpp"

namespace pardel::mutants {
namespace {
namespace fs = std::filesystem;

/// Texts of files, by the path relative to the root.
using Sources = std::map<fs::path, std::string>;

Lines split(const std::string& text) {
  Lines lines;
  std::size_t begin = 0;
  for (std::size_t end; (end = text.find('\n', begin)) != std::string::npos; begin = end + 1)
    lines.push_back(text.substr(begin, end - begin));
  if (begin < text.size()) lines.push_back(text.substr(begin));
  return lines;
}

std::string joined(const Lines& lines, const std::string& separator) {
  std::string text;
  for (const std::string& line : lines) text += line + separator;
  return text;
}

[[noreturn]] void fail(const Patch& patch, const std::string& reason) {
  throw std::runtime_error("mutant " + patch.name + ": " + patch.file.string() + " does not apply to " +
                           patch.changes.string() + ": " + reason);
}

void add_line(const Patch& patch, const std::string& line, Hunk& hunk) {
  // Some editors remove the blank at the end of an empty context line.
  const char mark = line.empty() ? ' ' : line[0];
  const std::string text = line.empty() ? "" : line.substr(1);
  if (mark != ' ' && mark != '-' && mark != '+') fail(patch, "this line has no mark: " + line);
  if (mark != '+') hunk.old_lines.push_back(text);
  if (mark != '-') hunk.new_lines.push_back(text);
}

bool adds_its_switch(const Patch& patch) {
  return std::any_of(patch.hunks.begin(), patch.hunks.end(), [&](const Hunk& hunk) {
    return joined(hunk.new_lines, "\n").find("mutated(\"" + patch.name + "\"") != std::string::npos;
  });
}

/// The mutant or family of `patches` that holds a mutant; nullptr if there is none.
const Patch* patch_of(const std::string& mutant, const std::vector<Patch>& patches) {
  const Patch* family = nullptr;
  for (const Patch& patch : patches) {
    if (patch.name == mutant) return &patch;
    if (patch.name.ends_with('_') && mutant.starts_with(patch.name)) family = &patch;
  }
  return family;
}

/// Runs `action` and records the message of the exception that it throws, if any.
template <class Action>
void attempt(std::vector<std::string>& errors, Action&& action) {
  try {
    action();
  } catch (const std::exception& error) {
    errors.emplace_back(error.what());
  }
}

std::vector<Patch> read_patches(const fs::path& folder, std::vector<std::string>& errors) {
  const std::set<fs::path> files(fs::directory_iterator(folder), fs::directory_iterator{});
  std::vector<Patch> patches;
  for (const fs::path& file : files) attempt(errors, [&] { patches.push_back(read_patch(file)); });
  return patches;
}

/// The patches in the order of the registry. A family has the place of its first member.
std::vector<const Patch*> in_order(const std::vector<Patch>& patches, const fs::path& registry,
                                   std::vector<std::string>& errors) {
  std::vector<const Patch*> ordered;
  std::set<const Patch*> known;
  for (const Mutant& mutant : read_registry(registry)) {
    const Patch* patch = patch_of(mutant.name, patches);
    if (patch == nullptr)
      errors.push_back("mutant " + mutant.name + " of " + registry.string() + " has no patch");
    else if (known.insert(patch).second)
      ordered.push_back(patch);
  }
  for (const Patch& patch : patches)
    if (!known.contains(&patch)) errors.push_back(patch.file.string() + " has no mutant in " + registry.string());
  return ordered;
}

bool is_source(const fs::path& file) { return file.extension() == ".hpp" || file.extension() == ".cpp"; }

Sources read_sources(const fs::path& root, const std::vector<std::string>& folders) {
  Sources sources;
  for (const std::string& folder : folders)
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root / folder))
      if (entry.is_regular_file() && is_source(entry.path()))
        sources[entry.path().lexically_relative(root)] = contents(entry.path());
  return sources;
}

void apply(const Patch& patch, Sources& sources) {
  const auto source = sources.find(patch.changes);
  if (source == sources.end()) fail(patch, "there is no such source file");
  source->second = joined(patched(patch, split(source->second)), "\n");
}

void write_if_changed(const fs::path& file, const std::string& text) {
  if (fs::exists(file) && contents(file) == text) return;
  fs::create_directories(file.parent_path());
  std::ofstream out(file, std::ios::binary);
  out << text;
  out.close();
  if (!out) throw std::runtime_error("cannot write " + file.string());
}

void remove_files_without_source(const fs::path& copy, const std::vector<std::string>& folders,
                                 const Sources& sources) {
  for (const auto& [file, text] : read_sources(copy, folders))
    if (!sources.contains(file)) fs::remove(copy / file);
}

}  // namespace

Patch read_patch(const fs::path& file) {
  const Lines lines = split(contents(file));
  Patch patch{file.stem().string(), file, lines.empty() ? "" : lines[0], {Hunk()}};
  for (std::size_t i = 1; i < lines.size(); ++i) {
    if (lines[i] == "@@")
      patch.hunks.emplace_back();
    else
      add_line(patch, lines[i], patch.hunks.back());
  }
  for (const Hunk& hunk : patch.hunks)
    if (hunk.old_lines.empty()) fail(patch, "a hunk has neither context nor removed lines");
  if (!adds_its_switch(patch)) fail(patch, "no line of it contains mutated(\"" + patch.name + "\")");
  return patch;
}

Lines patched(const Patch& patch, Lines text) {
  for (const Hunk& hunk : patch.hunks) {
    const auto search = [&](Lines::iterator from) {
      return std::search(from, text.end(), hunk.old_lines.begin(), hunk.old_lines.end());
    };
    const auto first = search(text.begin());
    if (first == text.end()) fail(patch, "these lines do not occur: " + joined(hunk.old_lines, "\\n"));
    if (search(first + 1) != text.end())
      fail(patch, "these lines occur more than once: " + joined(hunk.old_lines, "\\n"));
    const auto at = text.erase(first, first + static_cast<std::ptrdiff_t>(hunk.old_lines.size()));
    text.insert(at, hunk.new_lines.begin(), hunk.new_lines.end());
  }
  return text;
}

std::vector<std::string> copy_with_mutants(const fs::path& root, const std::vector<std::string>& folders,
                                           const fs::path& copy) {
  std::vector<std::string> errors;
  const fs::path mutants = root / "properties" / "mutants";
  const std::vector<Patch> patches = read_patches(mutants / "patches", errors);
  if (!errors.empty()) return errors;
  Sources sources = read_sources(root, folders);
  for (const Patch* patch : in_order(patches, mutants / "registry", errors))
    attempt(errors, [&] { apply(*patch, sources); });
  if (!errors.empty()) return errors;

  std::set<fs::path> changed;
  for (const Patch& patch : patches) changed.insert(patch.changes);
  for (const fs::path& file : changed)
    sources[file].insert(0, "#include \"" + (mutants / "mutated.hpp").string() + "\"\n");
  for (const std::string& folder : folders) fs::create_directories(copy / folder);
  for (const auto& [file, text] : sources) write_if_changed(copy / file, text);
  remove_files_without_source(copy, folders, sources);
  return {};
}

}  // namespace pardel::mutants
