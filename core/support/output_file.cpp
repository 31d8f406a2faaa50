#include "output_file.hpp"

#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "kept_file.hpp"
#include "open_file.hpp"
#include "partial_files.hpp"

namespace pardel {

namespace fs = std::filesystem;

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
  // "x": the file must not exist yet. So a file of another process, or of the user, is never replaced or removed.
  written_ = PartialFiles::of_process().make(target_, [&](const fs::path& name) {
    stream_ = std::fopen(name.c_str(), "wbx");
    return stream_ == nullptr ? errno : 0;
  });
}

OutputFile::~OutputFile() {
  if (stream_ != nullptr) std::fclose(stream_);
  if (!written_.empty() && written_ != target_) PartialFiles::of_process().remove(written_);
}

void OutputFile::fail(const char* what, int error_number) {
  if (!ok()) return;
  failure_ = name_.string() + ": " + what + ": " + std::generic_category().message(error_number);
}

void OutputFile::write(std::string_view bytes) {
  if (!ok() || bytes.empty()) return;  // an empty array has no address, and fwrite() must not get a null pointer
  if (std::fwrite(bytes.data(), 1, bytes.size(), stream_) != bytes.size()) fail("cannot be written", errno);
}

/// A file that another one will replace must be on the disk before. Else a power failure soon after the rename could
/// leave an empty file: some file systems write the name first.
void OutputFile::write_to_disk() {
  std::error_code ignored;
  if (written_ == target_ || !fs::exists(target_, ignored)) return;
  if (std::fflush(stream_) != 0 || fsync(fileno(stream_)) != 0) fail("cannot be written", errno);
}

Status OutputFile::close() {
  if (stream_ != nullptr && ok()) write_to_disk();
  if (stream_ != nullptr && std::fclose(stream_) != 0) fail("cannot be written", errno);
  stream_ = nullptr;
  if (!ok()) return Error{ErrorKind::io, failure_};
  return Done{};
}

Status OutputFile::commit() {
  if (Status closed = close(); !closed.ok()) return closed;
  return put_in_place();
}

/// Precondition: the file is closed.
Status OutputFile::put_in_place() {
  if (written_ == target_) return Done{};
  const std::scoped_lock lock(PartialFiles::of_process().mutex);
  std::error_code error;
  fs::rename(written_, target_, error);
  if (error) {
    fail("cannot be put in place", error.value());
    return Error{ErrorKind::io, failure_};
  }
  PartialFiles::of_process().forget(written_);
  written_.clear();
  return Done{};
}

/// Replaces files by new ones. What they replace is kept until the end.
class Replacement {
 public:
  explicit Replacement(std::deque<OutputFile>& files) : files_(files) {}

  /// Renames the files. If this fails, all that was replaced is put back before another thread may end the process.
  Status place() {
    for (OutputFile& file : files_)
      if (Status closed = file.close(); !closed.ok()) return closed;
    const std::scoped_lock lock(PartialFiles::of_process().mutex);
    Status placed = place_all();
    if (!placed.ok()) kept_.clear();
    return placed;
  }
  void forget_old() {
    for (KeptFile& kept : kept_) kept.forget();
  }

 private:
  Status place_all() {
    for (OutputFile& file : files_) {
      if (file.written_ == file.target_) continue;
      KeptFile& old = kept_.emplace_back(file.target_);
      if (Status placed = file.put_in_place(); !placed.ok()) return placed;
      old.changed();
    }
    return Done{};
  }

  std::deque<OutputFile>& files_;
  std::deque<KeptFile> kept_;
};

Status commit_all(std::deque<OutputFile>& files, const FinalAgreement& agree) {
  Replacement replacement(files);
  Status done = replacement.place();
  if (agree) done = agree(done);
  if (done.ok()) replacement.forget_old();
  return done;
}

std::unique_lock<std::recursive_mutex> remove_partial_files() {
  std::unique_lock lock(PartialFiles::of_process().mutex);
  PartialFiles::of_process().remove_all();
  return lock;
}

}  // namespace pardel
