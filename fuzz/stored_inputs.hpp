// Inputs of fuzz targets that are stored as files.
#pragma once

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <filesystem>
#include <fstream>
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

/// The content of a regular file. Throws std::system_error, with the name of the file, if it cannot be read.
[[nodiscard]] inline std::vector<std::uint8_t> bytes_of(const std::filesystem::path& file) {
  std::vector<char> content(std::filesystem::file_size(file));
  std::ifstream in(file, std::ios::binary);
  if (!in.read(content.data(), static_cast<std::streamsize>(content.size())))
    throw std::system_error(errno, std::generic_category(), file.string());
  return {content.begin(), content.end()};
}

}  // namespace pardel::fuzz
