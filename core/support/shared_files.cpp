#include "shared_files.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>
#include <utility>

#include "agree.hpp"
#include "collective.hpp"
#include "this_machine.hpp"

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
    if (is_written_directly(names_[i]))
      fail(i, "cannot be written by several processes, because it is not a regular file");
    if (!open_unnamed(i)) open_named(i);
  }
}

/// The name under which the first rank has made the file, or "" if it has not. Elsewhere "".
std::string SharedFiles::make(std::size_t file, OutputFile::Aside aside) {
  if (ranks_.rank() != 0 || is_written_directly(names_[file])) return {};
  return outputs_.emplace_back(names_[file], aside).written().string();
}

/// Collective. True if all ranks have opened a file without a name. Otherwise there is no file.
bool SharedFiles::open_unnamed(std::size_t file) {
  const std::size_t made_before = outputs_.size();
  const std::string made = make(file, OutputFile::Aside::unnamed);
  const bool is_unnamed = outputs_.size() > made_before && outputs_.back().is_unnamed();
  const std::string name = text_from_first(is_unnamed ? made : "", ranks_);
  // On another machine, or in another container, the name stands for another file or for none.
  const std::string identity = text_from_first(is_unnamed ? identity_of(made) : "", ranks_);
  if (!identity.empty() && identity_of(name) == identity) descriptors_[file] = open(name.c_str(), O_WRONLY | O_CLOEXEC);
  if (sum_of(descriptors_[file] < 0 ? 1 : 0, ranks_) == 0) return true;
  if (const int descriptor = std::exchange(descriptors_[file], -1); descriptor >= 0) ::close(descriptor);
  if (outputs_.size() > made_before) outputs_.pop_back();
  return false;
}

/// Collective.
void SharedFiles::open_named(std::size_t file) {
  const std::string partial = text_from_first(make(file, OutputFile::Aside::named), ranks_);
  if (partial.empty()) return;  // the first rank reports why
  descriptors_[file] = open(partial.c_str(), O_WRONLY | O_CLOEXEC);
  if (descriptors_[file] < 0) fail(file, because("cannot be opened for writing", errno));
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
