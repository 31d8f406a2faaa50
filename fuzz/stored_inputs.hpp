// Inputs of fuzz targets that are stored as files.
#pragma once

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <system_error>
#include <vector>

namespace pardel::fuzz {

/// The files of a folder and of those in it, sorted; of a file, this file. Throws std::filesystem::filesystem_error if
/// a folder cannot be read.
[[nodiscard]] inline std::vector<std::filesystem::path> files_below(const std::filesystem::path& place) {
  namespace fs = std::filesystem;
  if (!fs::is_directory(place)) return {place};
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(place))
    if (entry.is_regular_file()) files.push_back(entry.path());
  std::ranges::sort(files);
  return files;
}

/// The content of a file. Throws std::system_error, with the name of the file, if it cannot be read.
[[nodiscard]] inline std::vector<std::uint8_t> bytes_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::vector<std::uint8_t> bytes{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  if (!in.is_open() || in.bad()) throw std::system_error(errno, std::generic_category(), file.string());
  return bytes;
}

}  // namespace pardel::fuzz
