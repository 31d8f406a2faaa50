#include "shared_files.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>
#include <utility>

#include "agree.hpp"
#include "collective.hpp"

namespace pardel {
namespace {

namespace fs = std::filesystem;

std::string because(const char* what, int error_number) {
  return std::string(what) + ": " + std::generic_category().message(error_number);
}

}  // namespace

SharedFiles::SharedFiles(std::span<const fs::path> names, Ranks& ranks)
    : ranks_(ranks), names_(names.begin(), names.end()), descriptors_(names.size(), -1) {
  for (std::size_t i = 0; i < names_.size(); ++i) {
    const bool is_regular = !is_written_directly(names_[i]);
    if (!is_regular) fail(i, "cannot be written by several processes, because it is not a regular file");
    std::string partial;
    if (ranks_.rank() == 0 && is_regular) partial = outputs_.emplace_back(names_[i]).written().string();
    partial = text_from_first(partial, ranks_);
    if (partial.empty()) continue;  // the first rank reports why
    descriptors_[i] = open(partial.c_str(), O_WRONLY | O_CLOEXEC);
    if (descriptors_[i] < 0) fail(i, because("cannot be opened for writing", errno));
  }
}

SharedFiles::~SharedFiles() {
  for (const int descriptor : descriptors_)
    if (descriptor >= 0) ::close(descriptor);
}

void SharedFiles::fail(std::size_t file, const std::string& what) {
  const std::scoped_lock lock(mutex_);
  if (failure_.empty()) failure_ = names_[file].string() + ": " + what;
}

bool SharedFiles::has_failed() {
  const std::scoped_lock lock(mutex_);
  return !failure_.empty();
}

void SharedFiles::write_at(std::size_t file, std::uint64_t offset, std::string_view bytes) {
  if (descriptors_[file] < 0 || has_failed()) return;
  while (!bytes.empty()) {
    const ssize_t written = pwrite(descriptors_[file], bytes.data(), bytes.size(), static_cast<off_t>(offset));
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return fail(file, because("cannot be written", errno));
    bytes.remove_prefix(static_cast<std::size_t>(written));
    offset += static_cast<std::uint64_t>(written);
  }
}

Status SharedFiles::close() {
  for (std::size_t i = 0; i < descriptors_.size(); ++i) {
    const int descriptor = std::exchange(descriptors_[i], -1);
    if (descriptor >= 0 && ::close(descriptor) != 0) fail(i, because("cannot be written", errno));
  }
  if (has_failed()) return Error{ErrorKind::io, failure_};
  return Done{};
}

Status SharedFiles::commit() {
  if (Status all = agree(close(), ranks_); !all) return all;
  return commit_all(outputs_, [&](const Status& placed) { return agree(placed, ranks_); });
}

}  // namespace pardel
