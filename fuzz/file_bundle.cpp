#include "file_bundle.hpp"

#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <fstream>

namespace pardel::fuzz {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view mark = "== ";

bool is_name(std::string_view name) {
  return !name.empty() && name.size() < 60 && name.front() != '.' &&
         std::ranges::all_of(name, [](unsigned char c) { return std::isalnum(c) != 0 || c == '_' || c == '.'; });
}

const std::string prefix = "pardel-fuzz-";  // of the folders; the number of the process follows

}  // namespace

std::vector<NamedText> files_of(std::span<const std::uint8_t> bytes, const std::string& otherwise) {
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  if (!text.starts_with(mark)) return {{otherwise, std::string(text)}};
  std::vector<NamedText> files;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = text.find("\n== ", begin);
    std::string_view part = text.substr(begin, end == std::string_view::npos ? end : end - begin);
    part.remove_prefix(mark.size());
    const std::size_t line = std::min(part.find('\n'), part.size());
    const std::string_view name = part.substr(0, line);
    files.push_back(
        {is_name(name) ? std::string(name) : otherwise, std::string(part.substr(std::min(line + 1, part.size())))});
    begin = end == std::string_view::npos ? text.size() : end + 1;
  }
  return files;
}

Scratch::Scratch() {
  const fs::path memory = "/dev/shm";
  const fs::path place = fs::is_directory(memory) ? memory : fs::temp_directory_path();
  static const bool once = (remove_leftovers(place), true);
  static_cast<void>(once);
  folder_ = place / (prefix + std::to_string(getpid()));
  fs::create_directories(folder_);
}

void Scratch::remove_leftovers(const fs::path& place) {
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(place, ignored)) {
    const std::string name = entry.path().filename().string();
    if (!name.starts_with(prefix)) continue;
    const int process = std::atoi(name.c_str() + prefix.size());
    const bool has_ended = process > 0 && kill(process, 0) != 0 && errno == ESRCH;
    if (has_ended || process == getpid()) fs::remove_all(entry.path(), ignored);  // an earlier process had this number
  }
}

Scratch::~Scratch() {
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
}

fs::path file_to_read(const Scratch& scratch, const std::string& main_file) {
  const fs::path file = scratch / main_file, points = fs::path(file).replace_extension(".node");
  return file.extension() == ".poly" && !fs::exists(file) && fs::exists(points) ? points : file;
}

void Scratch::write(const NamedText& file) const { std::ofstream(folder_ / file.name, std::ios::binary) << file.text; }

}  // namespace pardel::fuzz
