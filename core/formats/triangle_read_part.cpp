// Reads points by several ranks, each of which reads a part of the file.
#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <optional>
#include <string>

#include "../formats.hpp"
#include "../support/agree.hpp"
#include "../support/byte_order_mark.hpp"
#include "../support/exchange_lists.hpp"
#include "triangle_sections.hpp"

namespace pardel {
using namespace files;
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

/// What a rank finds in its part before the points are read. A record is a line that is neither blank nor a comment.
struct PartOfRank {
  std::uint64_t lines = 0, records = 0;
};

PartOfRank count_in(std::string_view text) {
  TextReader in(text, {});
  PartOfRank part;
  while (in.next_line()) ++part.records;
  part.lines = static_cast<std::uint64_t>(std::ranges::count(text, '\n'));
  return part;
}

/// The header, as the rank that has read it tells the others.
struct SentHeader {
  std::uint64_t points = 0, attributes = 0;
  std::uint64_t markers = 0;
};

class PartReader {
 public:
  PartReader(const fs::path& file, Ranks& ranks) : file_(file), ranks_(ranks) {}

  [[nodiscard]] Result<std::optional<PartOfPoints>> read() {
    if (Status text = agree_on_input(read_text(), ranks_); !text) return text.error();
    count();
    if (Status header = agree_on_input(read_header(), ranks_); !header) return header.error();
    share_header();
    if (file_.extension() == ".poly" && !has_only_points()) return std::optional<PartOfPoints>();
    if (Status base = agree_on_input(read_base(), ranks_); !base) return base.error();
    share_base();
    if (Status points = agree_on_input(read_points(), ranks_); !points) return points.error();
    return std::optional(std::move(points_));
  }

 private:
  [[nodiscard]] Status read_text() {
    std::error_code unknown;
    if (!fs::is_regular_file(file_, unknown))
      return Error{ErrorKind::io,
                   file_.string() + (fs::exists(file_, unknown) ? ": only a regular file can be read in parts"
                                                                : ": cannot be opened: No such file or directory")};
    const std::uint64_t size = fs::file_size(file_, unknown);
    if (unknown) return Error{ErrorKind::io, file_.string() + ": " + unknown.message()};
    const auto count = static_cast<std::uint64_t>(ranks_.count());
    const std::uint64_t part = (size + count - 1) / count;
    Result<Array<char>> lines = lines_of_part(file_, part, ranks_.rank());
    if (!lines) return lines.error();
    bytes_ = std::move(*lines);
    text_ = {bytes_.data(), bytes_.size()};
    if (ranks_.rank() == 0) text_ = without_byte_order_mark(text_);
    return Done{};
  }

  /// Where the part begins, in lines and records.
  void count() {
    parts_ = concatenated(lists_of_all(std::vector{count_in(text_)}, ranks_));
    for (int rank = 0; rank < ranks_.rank(); ++rank) {
      before_.lines += parts_[rank].lines;
      before_.records += parts_[rank].records;
    }
    while (with_header_ + 1 < ranks_.count() && parts_[with_header_].records == 0) ++with_header_;
    in_ = TextReader({}, file_.string()).part(text_, before_.lines + 1);
  }

  /// On one rank: reads the first record.
  [[nodiscard]] Status read_header() {
    if (ranks_.rank() != with_header_) return Done{};
    header_ = read_point_header(*in_);
    return in_->failed() ? Status(in_->error()) : Done{};
  }

  void share_header() {
    std::vector<SentHeader> sent;
    if (ranks_.rank() == with_header_) sent.push_back({header_.points, header_.attributes, header_.markers ? 1U : 0U});
    const SentHeader read = concatenated(lists_of_all(sent, ranks_)).front();
    header_ = {read.points, read.attributes, read.markers != 0};
  }

  /// True if the sections of segments, holes and regions are there and empty. (Regions may be missing.) The sections
  /// are the records after those of the header and the points.
  [[nodiscard]] bool has_only_points() {
    constexpr std::size_t sections = 3;
    std::array<std::uint64_t, sections> empty{}, present{};
    TextReader ahead = *in_;
    // The header has been read.
    for (std::uint64_t record = std::max<std::uint64_t>(before_.records, 1); ahead.next_line(); ++record) {
      if (record <= header_.points || record > header_.points + sections) continue;
      const std::size_t section = record - header_.points - 1;
      present[section] = 1;
      empty[section] = ahead.word() == "0" ? 1 : 0;
    }
    ranks_.add_up(empty);
    ranks_.add_up(present);
    return header_.points > 0 && empty[0] == 1 && empty[1] == 1 && empty[2] == present[2];
  }

  /// The number of points before the end of a rank's part. The first record is the header.
  [[nodiscard]] std::uint64_t points_until(int rank) const {
    std::uint64_t records = 0;
    for (int r = 0; r <= rank; ++r) records += parts_[r].records;
    return std::min<std::uint64_t>(header_.points, records > 0 ? records - 1 : 0);
  }
  [[nodiscard]] bool has_first_point() const {
    return points_until(ranks_.rank()) > 0 && (ranks_.rank() == 0 || points_until(ranks_.rank() - 1) == 0);
  }

  /// On one rank: looks at the number of the first point.
  [[nodiscard]] Status read_base() {
    if (!has_first_point()) return Done{};
    TextReader ahead = *in_;
    ahead.next_line();
    points_.first_id.value = static_cast<int>(ahead.integer("the first point's number", 0, 1));
    return ahead.failed() ? Status(ahead.error()) : Done{};
  }

  void share_base() {
    std::vector<int> sent;
    if (has_first_point()) sent.push_back(points_.first_id.value);
    const std::vector<int> read = concatenated(lists_of_all(sent, ranks_));
    points_.first_id = {read.empty() ? 1 : read.front()};
  }

  /// Reads the points in the part. Text after the last point is ignored.
  [[nodiscard]] Status read_points() {
    TextReader& in = *in_;
    points_.first = ranks_.rank() == 0 ? 0 : points_until(ranks_.rank() - 1);
    const std::uint64_t end = points_until(ranks_.rank());
    const auto count = static_cast<std::size_t>(end - points_.first);
    if (!in.room_for(count, bytes_of_point(header_), "points")) return in.error();
    resize_points(points_, count, header_);
    read_records(in, "point", points_.first, end, [&](TextReader& line, std::size_t i) {
      read_number(line, "point", i, points_.first_id.value);
      read_point(line, header_, points_, i - points_.first);
    });
    if (!in.failed() && ranks_.rank() + 1 == ranks_.count() && end < header_.points)
      in.expect_record("point", end, header_.points);
    return in.failed() ? Status(in.error()) : Done{};
  }

  fs::path file_;
  Ranks& ranks_;
  Array<char> bytes_;
  std::string_view text_;
  std::vector<PartOfRank> parts_;
  PartOfRank before_;
  int with_header_ = 0;  ///< the rank whose part has the first record
  std::optional<TextReader> in_;
  PointHeader header_;
  PartOfPoints points_;
};

}  // namespace

Result<std::optional<PartOfPoints>> read_part_of_points(const fs::path& file, Ranks& ranks) {
  return PartReader(file, ranks).read();
}

}  // namespace pardel
