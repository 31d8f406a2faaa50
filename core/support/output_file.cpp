#include "output_file.hpp"

#include <cerrno>
#include <system_error>

namespace pardel {
namespace {

namespace fs = std::filesystem;

/// True if `file` must be written directly: it exists and is not a regular file, or its name refers to an open file
/// (/dev/stdout, /proc/self/fd/1), which a rename does not replace.
bool is_special(const fs::path& file) {
  std::error_code missing;
  const fs::file_status status = fs::status(file, missing);
  if (fs::exists(status) && !fs::is_regular_file(status)) return true;
  const std::string name = file.lexically_normal().string();
  return name.starts_with("/dev/") || name.starts_with("/proc/");
}

}  // namespace

OutputFile::OutputFile(const fs::path& file) : name_(file), target_(file) {
  std::error_code dangling;
  if (is_special(file)) {
    written_ = target_;
  } else {
    if (fs::is_symlink(file, dangling)) {
      const fs::path pointed_to = fs::canonical(file, dangling);
      if (!dangling) target_ = pointed_to;
    }
    written_ = target_;
    written_ += ".partial";
  }
  stream_ = std::fopen(written_.c_str(), "wb");
  if (stream_ == nullptr) fail("cannot be opened for writing", errno);
}

OutputFile::~OutputFile() {
  if (stream_ != nullptr) std::fclose(stream_);
  std::error_code ignored;  // a partial file stays if it cannot be removed
  if (!written_.empty() && written_ != target_) fs::remove(written_, ignored);
}

void OutputFile::fail(const char* what, int error_number) {
  if (!ok()) return;
  failure_ = name_.string() + ": " + what + ": " + std::generic_category().message(error_number);
}

void OutputFile::write(std::string_view bytes) {
  if (!ok()) return;
  if (std::fwrite(bytes.data(), 1, bytes.size(), stream_) != bytes.size()) fail("cannot be written", errno);
}

Status OutputFile::close() {
  if (stream_ != nullptr && std::fclose(stream_) != 0) fail("cannot be written", errno);
  stream_ = nullptr;
  if (!ok()) return Error{ErrorKind::io, failure_};
  return Done{};
}

Status OutputFile::commit() {
  const Status closed = close();
  if (!closed.ok() || written_ == target_) return closed;
  std::error_code error;
  fs::rename(written_, target_, error);
  if (error) {
    fail("cannot be put in place", error.value());
    return Error{ErrorKind::io, failure_};
  }
  written_.clear();
  return Done{};
}

Status commit_all(std::deque<OutputFile>& files) {
  for (OutputFile& file : files) {
    if (Status closed = file.close(); !closed.ok()) return closed;
  }
  for (OutputFile& file : files) {
    if (Status committed = file.commit(); !committed.ok()) return committed;
  }
  return Done{};
}

}  // namespace pardel
