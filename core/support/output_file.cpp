#include "output_file.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <set>
#include <system_error>

#include "open_file.hpp"

namespace pardel {
namespace {

namespace fs = std::filesystem;

/// The partial files that exist. There is one list for the process, because the process may have to end while any of
/// its threads writes. Whoever makes, renames or removes a partial file holds the mutex.
struct PartialFiles {
  std::mutex mutex;
  std::set<fs::path> names;
  std::uint64_t made = 0;  ///< counts the names that were tried
};

PartialFiles& partial_files() {
  static PartialFiles files;
  return files;
}

}  // namespace

bool is_written_directly(const fs::path& file) {
  if (descriptor_of(file)) return true;
  std::error_code missing;
  const fs::file_status status = fs::status(file, missing);
  return fs::exists(status) && !fs::is_regular_file(status);
}

fs::path behind_links(const fs::path& file) {
  constexpr int most_links = 40;  // of the system, which refuses longer chains, and circles
  fs::path reached = file;
  std::error_code failure;
  for (int i = 0; i < most_links && fs::is_symlink(reached, failure); ++i) {
    const fs::path target = fs::read_symlink(reached, failure);
    if (failure) break;
    reached = reached.parent_path() / target;
  }
  return reached;
}

OutputFile::OutputFile(const fs::path& file)
    : name_(file == "-" ? "standard output" : file), target_(file), written_(file) {
  if (const auto descriptor = descriptor_of(file)) {
    // A duplicate has the same position. So text that is printed later follows, also if the output is a regular file.
    const int copy = dup(*descriptor);
    stream_ = copy < 0 ? nullptr : fdopen(copy, "wb");
  } else if (is_written_directly(file)) {
    stream_ = std::fopen(file.c_str(), "wb");
  } else {
    write_aside();
  }
  if (stream_ == nullptr) fail("cannot be opened for writing", errno);
}

void OutputFile::write_aside() {
  target_ = behind_links(target_);
  if (std::error_code ignored; fs::is_symlink(target_, ignored)) {
    written_.clear();
    errno = ELOOP;
    return;
  }
  PartialFiles& files = partial_files();
  const std::scoped_lock lock(files.mutex);
  // "x": the file must not exist yet. So a file of another process, or of the user, is never replaced or removed.
  // The name is on the list before the file exists: if there is no memory for it, no file stays behind.
  do {
    written_ = target_;
    written_ += "." + std::to_string(getpid()) + "-" + std::to_string(++files.made) + ".partial";
    const auto name = files.names.insert(written_).first;
    stream_ = std::fopen(written_.c_str(), "wbx");
    if (stream_ == nullptr) files.names.erase(name);
  } while (stream_ == nullptr && errno == EEXIST);
  if (stream_ == nullptr) written_.clear();
}

OutputFile::~OutputFile() {
  if (stream_ != nullptr) std::fclose(stream_);
  if (written_.empty() || written_ == target_) return;
  const std::scoped_lock lock(partial_files().mutex);
  std::error_code ignored;  // a partial file stays if it cannot be removed
  fs::remove(written_, ignored);
  partial_files().names.erase(written_);
}

void OutputFile::fail(const char* what, int error_number) {
  if (!ok()) return;
  failure_ = name_.string() + ": " + what + ": " + std::generic_category().message(error_number);
}

void OutputFile::write(std::string_view bytes) {
  if (!ok() || bytes.empty()) return;  // an empty array has no address, and fwrite() must not get a null pointer
  if (std::fwrite(bytes.data(), 1, bytes.size(), stream_) != bytes.size()) fail("cannot be written", errno);
}

Status OutputFile::close() {
  if (stream_ != nullptr && std::fclose(stream_) != 0) fail("cannot be written", errno);
  stream_ = nullptr;
  if (!ok()) return Error{ErrorKind::io, failure_};
  return Done{};
}

Status OutputFile::commit() {
  if (Status closed = close(); !closed.ok()) return closed;
  const std::scoped_lock lock(partial_files().mutex);
  return put_in_place();
}

/// Precondition: the file is closed, and the caller holds the mutex of the partial files.
Status OutputFile::put_in_place() {
  if (written_ == target_) return Done{};
  std::error_code error;
  fs::rename(written_, target_, error);
  if (error) {
    fail("cannot be put in place", error.value());
    return Error{ErrorKind::io, failure_};
  }
  partial_files().names.erase(written_);
  written_.clear();
  return Done{};
}

Status commit_all(std::deque<OutputFile>& files) {
  for (OutputFile& file : files) {
    if (Status closed = file.close(); !closed.ok()) return closed;
  }
  const std::scoped_lock lock(partial_files().mutex);
  for (OutputFile& file : files) {
    if (Status placed = file.put_in_place(); !placed.ok()) return placed;
  }
  return Done{};
}

std::unique_lock<std::mutex> remove_partial_files() {
  std::unique_lock lock(partial_files().mutex);
  std::error_code ignored;
  for (const fs::path& name : partial_files().names) fs::remove(name, ignored);
  partial_files().names.clear();
  return lock;
}

}  // namespace pardel
