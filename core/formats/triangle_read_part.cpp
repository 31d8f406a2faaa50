// Reads the input of a mesh by several ranks, each of which reads a part of the points and of the segments.
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "../formats.hpp"
#include "../support/agree.hpp"
#include "../support/exchange_lists.hpp"
#include "file_in_parts.hpp"
#include "triangle_sections.hpp"

namespace pardel {
using namespace files;
namespace {

namespace fs = std::filesystem;

/// The header, as the rank that has read it tells the others.
struct SentHeader {
  std::uint64_t points = 0, attributes = 0;
  std::uint64_t markers = 0;
};

/// Of the items of a section, one per record: how many come before the part of a rank. `section`: the record with the
/// header of the section.
std::uint64_t items_before(int rank, const FileInParts& file, std::uint64_t section, std::uint64_t items) {
  const std::uint64_t records = file.records_before(rank);
  return std::min(items, records > section ? records - section - 1 : 0);
}

/// Reads the items from `first` to `end` - 1 by calls of read(line, i). The last rank also finds out whether there are
/// fewer than `items` in all.
template <class Read>
Status read_items(TextReader& in, std::string_view what, std::uint64_t first, std::uint64_t end, std::uint64_t items,
                  const Ranks& ranks, const Read& read) {
  read_records(in, what, first, end, read);
  if (!in.failed() && ranks.rank() + 1 == ranks.count() && end < items) in.expect_record(what, end, items);
  return in.failed() ? Status(in.error()) : Done{};
}

/// Reads the header and the points at the beginning of a file.
class PointsReader {
 public:
  explicit PointsReader(Ranks& ranks) : ranks_(ranks) {}

  [[nodiscard]] Status read_header(const fs::path& file) {
    if (Status read = file_.read(file, ranks_); !read) return read;
    in_ = file_.lines();
    with_header_ = file_.rank_of(0);
    if (Status header = agree_on_input(read_first_record(), ranks_); !header) return header;
    share_header();
    return Done{};
  }
  [[nodiscard]] const PointHeader& header() const { return header_; }
  [[nodiscard]] const FileInParts& file() const { return file_; }

  [[nodiscard]] Result<PartOfPoints> read() {
    if (Status base = agree_on_input(read_base(), ranks_); !base) return base.error();
    share_base();
    if (Status points = agree_on_input(read_points(), ranks_); !points) return points.error();
    return std::move(points_);
  }

 private:
  /// On one rank.
  [[nodiscard]] Status read_first_record() {
    if (ranks_.rank() != with_header_) return Done{};
    header_ = read_point_header(*in_);
    static_cast<void>(in_->room_for(header_.points, bytes_of_point(header_), "points", file_.bytes_after()));
    return in_->failed() ? Status(in_->error()) : Done{};
  }

  void share_header() {
    std::vector<SentHeader> sent;
    if (ranks_.rank() == with_header_) sent.push_back({header_.points, header_.attributes, header_.markers ? 1U : 0U});
    const SentHeader read = value_of_one(sent, ranks_);
    header_ = {read.points, read.attributes, read.markers != 0};
  }

  [[nodiscard]] std::uint64_t points_before(int rank) const { return items_before(rank, file_, 0, header_.points); }
  [[nodiscard]] bool has_first_point() const {
    return points_before(ranks_.rank() + 1) > 0 && points_before(ranks_.rank()) == 0;
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

  /// Reads the points in the part. What follows the last point is not read.
  [[nodiscard]] Status read_points() {
    points_.first = points_before(ranks_.rank());
    const std::uint64_t end = points_before(ranks_.rank() + 1);
    const auto count = static_cast<std::size_t>(end - points_.first);
    resize_points(points_, count, header_);
    return read_items(*in_, "point", points_.first, end, header_.points, ranks_, [&](TextReader& line, std::size_t i) {
      read_number(line, "point", i, points_.first_id.value);
      read_point(line, header_, points_, i - points_.first);
    });
  }

  Ranks& ranks_;
  FileInParts file_;
  int with_header_ = 0;  ///< the rank whose part has the first record
  std::optional<TextReader> in_;
  PointHeader header_;
  PartOfPoints points_;
};

/// Reads the segments.
class SegmentsReader {
 public:
  /// `section`: the record with which the section begins. `points`: how many points there are. `base`: the number of
  /// the first one.
  SegmentsReader(const FileInParts& file, std::uint64_t section, std::size_t points, int base, Ranks& ranks)
      : ranks_(ranks), file_(file), section_(section), points_(points), base_(base) {}

  [[nodiscard]] Result<PartOfSegments> read() {
    if (Status header = agree_on_input(read_header(), ranks_); !header) return header.error();
    share_header();
    if (Status segments = agree_on_input(read_segments(), ranks_); !segments) return segments.error();
    return std::move(segments_);
  }
  // After read():
  [[nodiscard]] bool markers() const { return header_.markers != 0; }
  /// The record after the section.
  [[nodiscard]] std::uint64_t end() const { return section_ + 1 + header_.segments; }

 private:
  struct Header {
    std::uint64_t segments = 0, markers = 0;
  };

  /// On one rank.
  [[nodiscard]] Status read_header() {
    if (ranks_.rank() != file_.rank_of(section_)) return Done{};
    TextReader in = file_.before(section_);
    const SegmentHeader header = read_segment_header(in);
    header_ = {header.segments, header.markers ? 1U : 0U};
    static_cast<void>(in.room_for(header.segments, bytes_of_segment(header), "segments", file_.bytes_after()));
    return in.failed() ? Status(in.error()) : Done{};
  }

  void share_header() {
    std::vector<Header> sent;
    if (ranks_.rank() == file_.rank_of(section_)) sent.push_back(header_);
    header_ = value_of_one(sent, ranks_);
  }

  [[nodiscard]] std::uint64_t segments_before(int rank) const {
    return items_before(rank, file_, section_, header_.segments);
  }

  [[nodiscard]] Status read_segments() {
    const SegmentHeader header{static_cast<std::size_t>(header_.segments), markers()};
    TextReader in = file_.before(section_ + 1);
    segments_.first = segments_before(ranks_.rank());
    const std::uint64_t end = segments_before(ranks_.rank() + 1);
    segments_.segments.resize(static_cast<std::size_t>(end - segments_.first));
    return read_items(in, "segment", segments_.first, end, header_.segments, ranks_,
                      [&](TextReader& line, std::size_t i) {
                        segments_.segments[i - segments_.first] = read_segment(line, header, points_, base_);
                      });
  }

  Ranks& ranks_;
  const FileInParts& file_;
  std::uint64_t section_;
  std::size_t points_;
  int base_;
  Header header_;
  PartOfSegments segments_;
};

/// Reads holes and regions, as all ranks do.
Status read_rest(TextReader in, Pslg& rest) {
  read_holes(in, rest.holes);
  read_regions(in, rest.regions);
  return in.failed() ? Status(in.error()) : Done{};
}

}  // namespace

Result<PartOfPslg> read_part_of_pslg(const fs::path& file, Ranks& ranks) {
  PointsReader first(ranks), in_node(ranks);
  if (Status header = first.read_header(file); !header) return header.error();
  const bool is_poly = file.extension() != ".node";
  PointsReader& points = is_poly && first.header().points == 0 ? in_node : first;
  if (&points == &in_node)
    if (Status header = points.read_header(fs::path(file).replace_extension(".node")); !header) return header.error();
  Result<PartOfPoints> part = points.read();
  if (!part) return part.error();
  PartOfPslg pslg{std::move(*part)};
  if (!is_poly) return pslg;
  SegmentsReader segments(first.file(), 1 + first.header().points, points.header().points, pslg.points.first_id.value,
                          ranks);
  Result<PartOfSegments> read = segments.read();
  if (!read) return read.error();
  pslg.segments = std::move(*read);
  pslg.rest.has_segment_markers = segments.markers();
  const FileInParts::SharedLines rest = first.file().lines_from(segments.end(), ranks);
  if (Status done = read_rest(first.file().reader_of(rest), pslg.rest); !done) return done.error();
  return pslg;
}

}  // namespace pardel
