#include "file_in_parts.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

#include "../support/agree.hpp"
#include "../support/byte_order_mark.hpp"
#include "../support/exchange_lists.hpp"

namespace pardel::files {
namespace {

namespace fs = std::filesystem;

struct CloseFile {
  void operator()(std::FILE* file) const { static_cast<void>(std::fclose(file)); }
};
using Stream = std::unique_ptr<std::FILE, CloseFile>;

Error failure(const fs::path& file, const std::string& what) {
  return {ErrorKind::io, file.string() + ": " + what + ": " + std::strerror(errno)};
}

/// The bytes from `begin` on: `size` bytes, or fewer at the end of the file.
Result<Array<char>> bytes_at(std::FILE* stream, const fs::path& file, std::uint64_t begin, std::size_t size) {
  Array<char> bytes;
  bytes.resize_uninitialised(size);
  if (fseeko(stream, static_cast<off_t>(begin), SEEK_SET) != 0) return failure(file, "cannot be read");
  bytes.resize_uninitialised(std::fread(bytes.data(), 1, size, stream));
  if (std::ferror(stream) != 0) return failure(file, "cannot be read");
  return bytes;
}

/// The lines whose first bytes are in the part of a rank: bytes [rank * part, (rank + 1) * part) of the file.
Result<Array<char>> lines_of_part(const fs::path& file, std::uint64_t part, int rank) {
  const Stream stream(std::fopen(file.c_str(), "rb"));
  if (!stream) return failure(file, "cannot be opened");
  const std::uint64_t begin = part * static_cast<std::uint64_t>(rank);
  // The byte before the part tells whether a line begins with it.
  const std::uint64_t from = begin > 0 ? begin - 1 : 0;
  Result<Array<char>> read = bytes_at(stream.get(), file, from, part + (begin - from));
  if (!read) return read;
  Array<char>& bytes = *read;
  const auto end_of_line = [](const Array<char>& in) { return std::find(in.begin(), in.end(), '\n') - in.begin(); };
  std::size_t first = 0;
  if (begin > 0) first = std::min(bytes.size(), static_cast<std::size_t>(end_of_line(bytes)) + 1);
  if (first == bytes.size()) return Array<char>();
  std::memmove(bytes.data(), bytes.data() + first, bytes.size() - first);
  bytes.resize(bytes.size() - first);
  // The last line may end in the parts after this one.
  constexpr std::size_t chunk = 1 << 12U;
  for (std::uint64_t at = begin + part; bytes.back() != '\n'; at += chunk) {
    const Result<Array<char>> more = bytes_at(stream.get(), file, at, chunk);
    if (!more) return more.error();
    if (more->empty()) break;
    bytes.append(more->span().first(std::min(more->size(), static_cast<std::size_t>(end_of_line(*more)) + 1)));
  }
  return read;
}

}  // namespace

Status FileInParts::read(const fs::path& file, Ranks& ranks) {
  name_ = file.string();
  rank_ = ranks.rank();
  if (Status text = agree_on_input(read_bytes(file, ranks), ranks); !text) return text;
  Part part{static_cast<std::uint64_t>(std::ranges::count(text_, '\n')), 0, text_.size()};
  for (TextReader in(text_, {}); in.next_line();) ++part.records;
  parts_ = concatenated(lists_of_all(std::vector{part}, ranks));
  for (int rank = 0; rank < rank_; ++rank) before_.lines += parts_[rank].lines;
  before_.records = records_before(rank_);
  return Done{};
}

Status FileInParts::read_bytes(const fs::path& file, const Ranks& ranks) {
  std::error_code unknown;
  if (fs::is_directory(file, unknown)) return Error{ErrorKind::io, file.string() + ": cannot be read: Is a directory"};
  if (!fs::is_regular_file(file, unknown))
    return Error{ErrorKind::io,
                 file.string() + (fs::exists(file, unknown) ? ": only a regular file can be read in parts"
                                                            : ": cannot be opened: No such file or directory")};
  const std::uint64_t size = fs::file_size(file, unknown);
  if (unknown) return Error{ErrorKind::io, file.string() + ": " + unknown.message()};
  const auto count = static_cast<std::uint64_t>(ranks.count());
  Result<Array<char>> lines = lines_of_part(file, (size + count - 1) / count, rank_);
  if (!lines) return lines.error();
  bytes_ = std::move(*lines);
  text_ = {bytes_.data(), bytes_.size()};
  if (rank_ == 0) text_ = without_byte_order_mark(text_);
  return Done{};
}

std::uint64_t FileInParts::bytes_after() const {
  std::uint64_t bytes = 0;
  for (std::size_t r = static_cast<std::size_t>(rank_) + 1; r < parts_.size(); ++r) bytes += parts_[r].bytes;
  return bytes;
}

std::uint64_t FileInParts::records_before(int rank) const {
  std::uint64_t records = 0;
  for (int r = 0; r < rank; ++r) records += parts_[r].records;
  return records;
}

TextReader FileInParts::before(std::uint64_t record) const {
  TextReader in = lines();
  for (std::uint64_t at = before_.records; at < record && in.next_line(); ++at) in.end_line();
  return in;
}

int FileInParts::rank_of(std::uint64_t record) const {
  std::size_t rank = 0;
  for (std::uint64_t end = parts_[0].records; rank + 1 < parts_.size() && end <= record; end += parts_[rank].records)
    ++rank;
  return static_cast<int>(rank);
}

FileInParts::SharedLines FileInParts::lines_from(std::uint64_t record, Ranks& ranks) const {
  std::vector<char> here;
  std::vector<std::uint64_t> first_line;
  if (before_.records + parts_[rank_].records >= record) {
    const TextReader in = before(record);
    here.assign(in.rest().begin(), in.rest().end());
    first_line.push_back(in.line());
  }
  SharedLines shared{concatenated(lists_of_all(here, ranks)), 1};
  const std::vector<std::uint64_t> all = concatenated(lists_of_all(first_line, ranks));
  if (!all.empty()) shared.first_line = all.front();
  return shared;
}

}  // namespace pardel::files
