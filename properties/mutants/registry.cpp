#include "registry.hpp"

#include <fstream>
#include <stdexcept>

#include "../../core/support/enum_names.hpp"

namespace pardel::mutants {
namespace {

constexpr auto end_names = enum_names<End>({{End::passed, "passed"},
                                            {End::failed, "failed"},
                                            {End::crashed, "crashed"},
                                            {End::timed_out, "timed out"},
                                            {End::not_found, "not found"}});

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

const char* name(End end) { return end_names[end]; }

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
