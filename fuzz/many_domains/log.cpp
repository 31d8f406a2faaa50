#include "log.hpp"

#include <fcntl.h>
#include <fmt/format.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <set>
#include <stdexcept>
#include <utility>

namespace pardel::fuzz {
namespace {

/// The next line, with its line feed if it has one; empty at the end of the file.
std::string next_line(std::FILE* stream) {
  char* text = nullptr;
  std::size_t capacity = 0;
  const ssize_t length = getline(&text, &capacity, stream);
  const std::unique_ptr<char, decltype(&std::free)> owned(text, &std::free);
  return length > 0 ? std::string(text, static_cast<std::size_t>(length)) : std::string();
}

/// Child processes do not have this lock, and it ends with the process. Closing the file by any handle gives it up.
bool lock(std::FILE* stream) {
  struct flock whole = {};
  whole.l_type = F_WRLCK;
  whole.l_whence = SEEK_SET;
  return fcntl(fileno(stream), F_SETLK, &whole) == 0 || (errno != EACCES && errno != EAGAIN);
}

}  // namespace

Log::Log(std::string file, std::uint64_t seed) : file_(std::move(file)), stream_(std::fopen(file_.c_str(), "a+e")) {
  if (!stream_) fail(std::strerror(errno));
  if (!lock(stream_.get())) fail("another process is writing this log");
  std::rewind(stream_.get());
  const bool is_complete = read(seed);
  std::fseek(stream_.get(), 0, SEEK_END);
  if (!is_complete) write("\n");
  if (std::ftell(stream_.get()) == 0) write(fmt::format("seed {}\n", seed));
}

bool Log::read(std::uint64_t seed) {
  std::string line = next_line(stream_.get());
  if (line.empty()) return true;
  if (line != fmt::format("seed {}\n", seed)) fail("the log is of another seed");
  std::set<std::uint64_t> known;
  bool is_complete = true;
  for (line = next_line(stream_.get()); !line.empty(); line = next_line(stream_.get())) {
    is_complete = line.ends_with('\n');
    if (is_complete) line.pop_back();
    if (const auto record = to_record(line); record && known.insert(record->number).second) records_.push_back(*record);
  }
  return is_complete;
}

void Log::append(const Record& record) { write(to_line(record) + '\n'); }

void Log::write(const std::string& line) {
  std::fputs(line.c_str(), stream_.get());
  if (std::fflush(stream_.get()) != 0) fail(std::strerror(errno));
}

void Log::fail(const std::string& why) const { throw std::runtime_error(file_ + ": " + why); }

}  // namespace pardel::fuzz
