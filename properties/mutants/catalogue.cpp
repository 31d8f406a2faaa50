// catalogue RECORDS OUTPUT: writes properties/CATALOGUE.md. RECORDS is a folder with one file per property, written by
// a run of all properties (PARDEL_RECORDS, framework/property.hpp).
#include <cmath>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "registry.hpp"

namespace pardel::mutants {
namespace {
namespace fs = std::filesystem;
using nlohmann::json;

/// The records by suite, then by name of the property.
using Records = std::map<std::string, std::map<std::string, json>>;

Records read_records(const fs::path& folder) {
  Records records;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    const json record = json::parse(std::ifstream(entry.path()));
    const std::string property = record.at("property");
    const std::size_t dot = property.find('.');
    records[property.substr(0, dot)][property.substr(dot + 1)] = record;
  }
  return records;
}

std::map<std::string, std::set<std::string>> mutants_of_property() {
  std::map<std::string, std::set<std::string>> result;
  for (const Mutant& mutant : read_registry(fs::path(PARDEL_SOURCE) / "properties/mutants/registry"))
    result[mutant.killer.property].insert(mutant.name);
  return result;
}

/// The text with the escapes that a cell of a Markdown table needs.
std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '|') result += '\\';
    result += c;
  }
  return result;
}

/// Rounded to whole percents; smaller shares to one digit, so that no share is shown as zero.
std::string percentage(double share) {
  std::ostringstream text;
  if (share < 0.01)
    text << std::setprecision(1) << 100 * share << " %";
  else
    text << std::lround(100 * share) << " %";
  return text.str();
}

/// The families of inputs, followed by each tag with its share of all cases, the largest share first.
std::string tried_on(const json& record) {
  std::string text = record.at("families");
  const double cases = record.at("cases");
  std::multimap<double, std::string, std::greater<>> shares;
  for (const auto& [tag, count] : record.at("shares").items()) {
    if (double(count) <= 0 || double(count) > cases)
      throw std::runtime_error(std::string(record.at("property")) + ": " + tag + " is the kind of " + count.dump() +
                               " of its cases");
    shares.emplace(double(count) / cases, tag);
  }
  for (const auto& [share, tag] : shares) text += (text.empty() ? "" : "<br>") + tag + " " + percentage(share);
  return text;
}

std::string listed(const std::set<std::string>& mutants) {
  std::string text;
  for (const std::string& mutant : mutants) text += (text.empty() ? "`" : ", `") + mutant + "`";
  return text;
}

void write(const Records& records, std::ostream& out) {
  const auto mutants = mutants_of_property();
  std::size_t properties = 0, killed = 0;
  double cases = 0;
  for (const auto& [suite, rows] : records)
    for (const auto& [name, record] : rows) {
      ++properties;
      cases += double(record.at("cases"));
    }
  for (const auto& [property, names] : mutants) killed += names.size();
  out << "# Catalogue of properties\n\n"
      << "Written by `cmake --build --preset release --target catalogue`, which runs them all. " << properties
      << " properties, " << std::lround(cases) << " cases, " << killed
      << " known mistakes (mutants), each with the property that must fail for it (`ctest -L mutants` runs "
         "them all).\n";
  for (const auto& [suite, rows] : records) {
    out << "\n## " << suite << "\n\n| Property | Statement | Source | Tried on | Cases | Mutants killed |\n"
        << "|---|---|---|---|--:|---|\n";
    for (const auto& [name, record] : rows) {
      const auto killer = mutants.find(suite + "." + name);
      out << "| `" << suite << "." << name << "` | " << escaped(record.at("statement")) << " | "
          << escaped(record.at("source")) << " | " << escaped(tried_on(record)) << " | "
          << record.at("cases").get<std::uint64_t>() << " | " << (killer == mutants.end() ? "" : listed(killer->second))
          << " |\n";
    }
    for (const auto& [name, record] : rows) {
      if (record.at("notes").empty()) continue;
      out << "\nFound by `" << suite << "." << name << "`:\n\n";
      for (const std::string note : record.at("notes")) out << "- " << note << '\n';
    }
  }
}

}  // namespace
}  // namespace pardel::mutants

int main(int argc, char** argv) try {
  if (argc != 3) throw std::runtime_error("usage: catalogue RECORDS OUTPUT");
  std::ofstream out(argv[2]);
  pardel::mutants::write(pardel::mutants::read_records(argv[1]), out);
  out.flush();
  if (!out) throw std::runtime_error(std::string("cannot write ") + argv[2]);
  return 0;
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
