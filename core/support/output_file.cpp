#include "output_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>
#include <utility>
#include <vector>

#include "kept_file.hpp"
#include "leftover_files.hpp"
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

namespace {

/// A name of a file that this process, or another one on this machine, has open. It can be opened, and linked.
std::string name_in_proc(const std::string& process, int descriptor) {
  return "/proc/" + process + "/fd/" + std::to_string(descriptor);
}

}  // namespace

OutputFile::OutputFile(const fs::path& file, Aside aside)
    : name_(file == "-" ? "standard output" : file), target_(file), written_(file) {
  if (const auto descriptor = descriptor_of(file)) {
    // A duplicate has the same position. So text that is printed later follows, also if the output is a regular file.
    const int copy = dup(*descriptor);
    stream_ = copy < 0 ? nullptr : fdopen(copy, "wb");
  } else if (is_written_directly(file)) {
    stream_ = std::fopen(file.c_str(), "wb");
  } else {
    write_aside(aside);
  }
  if (stream_ == nullptr) fail("cannot be opened for writing", errno);
}

OutputFile::OutputFile(const fs::path& file, const std::function<bool()>& go_on) : OutputFile(file) {
  if (go_on) stop_ = std::make_unique<StopSignal>(StopSignal::unless(go_on));
}

bool OutputFile::may_go_on() {
  if (!ok()) return false;
  try {
    if (stop_) stop_->ask();
  } catch (const Stopped& stopped) {
    failure_ = stopped.error;
  }
  return ok();
}

void OutputFile::write_aside(Aside aside) {
  written_.clear();
  target_ = behind_links(target_);
  if (std::error_code ignored; fs::is_symlink(target_, ignored)) {
    errno = ELOOP;
    return;
  }
  // commit() needs a partial name. So one that is too long is an error at once.
  constexpr std::uint64_t long_number = 1'000'000;
  if (access(partial_name(target_, long_number).c_str(), F_OK) != 0 && errno == ENAMETOOLONG) return;
  if (aside == Aside::unnamed && open_unnamed()) return;
  // "x": the file must not exist yet. So a file of another process, or of the user, is never replaced or removed.
  written_ = PartialFiles::of_process().make(target_, [&](const fs::path& name) {
    stream_ = std::fopen(name.c_str(), "wbx");
    return stream_ == nullptr ? errno : 0;
  });
}

/// False if the file system has no such files. Other failures are in errno, and there is no stream.
bool OutputFile::open_unnamed() {
  // Without /proc the file could not get a name.
  if (access("/proc/self/fd", F_OK) != 0) return false;
  const fs::path folder = target_.parent_path();
  constexpr mode_t as_umask_allows = 0666;
  const int descriptor = open(folder.empty() ? "." : folder.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, as_umask_allows);
  if (descriptor < 0) return errno != EOPNOTSUPP && errno != EISDIR && errno != EINVAL;
  stream_ = fdopen(descriptor, "wb");
  is_unnamed_ = stream_ != nullptr;
  if (is_unnamed_) return true;
  const int failure = errno;
  ::close(descriptor);
  errno = failure;
  return true;
}

OutputFile::~OutputFile() {
  if (stream_ != nullptr) std::fclose(stream_);
  if (descriptor_ >= 0) ::close(descriptor_);
  if (!written_.empty() && written_ != target_) PartialFiles::of_process().remove(written_);
}

fs::path OutputFile::written() const {
  if (!is_unnamed_ || stream_ == nullptr) return written_;
  return name_in_proc(std::to_string(getpid()), fileno(stream_));
}

void OutputFile::fail(const char* what, int error_number) {
  if (!ok()) return;
  failure_ = Error{ErrorKind::io, name_.string() + ": " + what + ": " + std::generic_category().message(error_number)};
}

void OutputFile::write(std::string_view bytes) {
  if (bytes.empty() || !may_go_on()) return;  // an empty array has no address, and fwrite() must not get a null pointer
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
  if (stream_ != nullptr && may_go_on()) write_to_disk();
  if (stream_ != nullptr && is_unnamed_) {
    descriptor_ = fcntl(fileno(stream_), F_DUPFD_CLOEXEC, 0);
    if (descriptor_ < 0) fail("cannot be closed", errno);
  }
  if (stream_ != nullptr && std::fclose(stream_) != 0) fail("cannot be written", errno);
  stream_ = nullptr;
  if (!ok()) return *failure_;
  return Done{};
}

Status OutputFile::commit() {
  if (Status closed = close(); !closed.ok()) return closed;
  const bool was_aside = written_ != target_;
  Status placed = put_in_place();
  if (placed.ok() && was_aside) remove_leftovers({&target_, 1});
  return placed;
}

/// Gives a closed file without a name its final name if no file has this name, otherwise a partial one. Returns 0 or
/// an error number.
int OutputFile::give_name() {
  const std::string name = name_in_proc("self", descriptor_);
  const auto link_to = [&](const fs::path& file) {
    return linkat(AT_FDCWD, name.c_str(), AT_FDCWD, file.c_str(), AT_SYMLINK_FOLLOW) == 0 ? 0 : errno;
  };
  const int failure = link_to(target_);
  if (failure == 0) {
    written_ = target_;
  } else if (failure == EEXIST) {
    written_ = PartialFiles::of_process().make(target_, link_to);
    if (written_.empty()) return errno;
  } else {
    return failure;
  }
  is_unnamed_ = false;
  ::close(std::exchange(descriptor_, -1));
  return 0;
}

/// Precondition: the file is closed.
Status OutputFile::put_in_place() {
  const std::scoped_lock lock(PartialFiles::of_process().mutex);
  std::error_code error;
  if (is_unnamed_) error.assign(give_name(), std::generic_category());
  if (!error && written_ == target_) return Done{};
  if (!error) fs::rename(written_, target_, error);
  if (error) {
    fail("cannot be put in place", error.value());
    return *failure_;
  }
  PartialFiles::of_process().forget(written_);
  written_ = target_;
  return Done{};
}

/// Replaces files by new ones. What they replace is kept until the end.
class Replacement {
 public:
  explicit Replacement(std::deque<OutputFile>& files) : files_(files) {}

  /// Gives the files their names. If this fails, all that was replaced is put back before another thread may end the
  /// process.
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
    remove_leftovers(placed_);
  }

 private:
  Status place_all() {
    for (OutputFile& file : files_) {
      if (file.written_ == file.target_) continue;
      placed_.push_back(file.target_);
      KeptFile& old = kept_.emplace_back(file.target_);
      if (Status placed = file.put_in_place(); !placed.ok()) return placed;
      old.changed();
    }
    return Done{};
  }

  std::deque<OutputFile>& files_;
  std::vector<fs::path> placed_;
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
