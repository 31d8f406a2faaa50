// Inputs of fuzz targets that are stored as files.
#pragma once

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

namespace pardel::fuzz {

/// The files of a folder and of those in it, sorted; of a file, this file.
[[nodiscard]] inline std::vector<std::filesystem::path> files_below(const std::filesystem::path& place) {
  namespace fs = std::filesystem;
  if (!fs::is_directory(place)) return {place};
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(place))
    if (entry.is_regular_file()) files.push_back(entry.path());
  std::ranges::sort(files);
  return files;
}

[[nodiscard]] inline std::vector<std::uint8_t> bytes_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

}  // namespace pardel::fuzz
