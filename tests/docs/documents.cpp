#include "documents.hpp"

#include <fstream>
#include <sstream>

namespace pardel::testing {

std::string read_document(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(std::filesystem::path(PARDEL_SOURCE) / file).rdbuf();
  return text.str();
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

std::string without_code(const std::string& text) {
  std::string kept;
  bool code = false;
  for (const std::string& line : lines_of(text)) {
    const bool fence = line.starts_with("```");
    if (fence) code = !code;
    if (!fence && !code) kept += line + '\n';
  }
  return kept;
}

std::vector<std::string> code_blocks(const std::string& text, const std::string& language) {
  std::vector<std::string> blocks;
  bool code = false;
  bool wanted = false;
  for (const std::string& line : lines_of(text)) {
    if (line.starts_with("```")) {
      wanted = !code && line.substr(3) == language;
      code = !code;
      if (wanted) blocks.emplace_back();
    } else if (wanted) {
      blocks.back() += line + '\n';
    }
  }
  return blocks;
}

std::string without_indentation(const std::string& text) {
  std::string flat;
  for (const std::string& line : lines_of(text)) {
    const std::size_t first = line.find_first_not_of(' ');
    flat += (first == std::string::npos ? "" : line.substr(first)) + '\n';
  }
  return flat;
}

}  // namespace pardel::testing
