#include "registry.hpp"

#include <fstream>
#include <stdexcept>

namespace pardel::mutants {
namespace {

std::vector<std::string> split(const std::string& text, const std::string& separator) {
  std::vector<std::string> parts;
  std::size_t begin = 0;
  for (std::size_t end; (end = text.find(separator, begin)) != std::string::npos; begin = end + separator.size())
    parts.push_back(text.substr(begin, end - begin));
  parts.push_back(text.substr(begin));
  return parts;
}

End end_named(const std::string& text) {
  for (const End end : {End::crashed, End::timed_out})
    if (text == name(end)) return end;
  throw std::runtime_error("a mutant cannot end as '" + text + "'");
}

}  // namespace

const char* name(End end) {
  switch (end) {
    case End::passed:
      return "passed";
    case End::failed:
      return "failed";
    case End::crashed:
      return "crashed";
    case End::timed_out:
      return "timed out";
    case End::not_found:
      return "not found";
  }
  return "";
}

std::vector<Mutant> read_registry(const std::filesystem::path& file) {
  std::ifstream in(file);
  if (!in) throw std::runtime_error("cannot read " + file.string());
  std::vector<Mutant> mutants;
  for (std::string line; std::getline(in, line);) {
    if (line.empty() || line[0] == '#') continue;
    const std::vector<std::string> column = split(line, " | ");
    const std::vector<std::string> killer = column.size() < 4 ? column : split(column[3], " ");
    if (column.size() < 4 || column.size() > 5 || killer.size() != 2) throw std::runtime_error("not a mutant: " + line);
    mutants.push_back({column[0], column[1], column[2], {killer[0], killer[1]}});
    if (column.size() == 5) mutants.back().end = end_named(column[4]);
  }
  return mutants;
}

}  // namespace pardel::mutants
