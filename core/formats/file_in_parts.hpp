// A text file of which each of several ranks reads a part.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "../array.hpp"
#include "../ranks.hpp"
#include "../result.hpp"
#include "text_reader.hpp"

namespace pardel::files {

/// Records are the lines that are neither blank nor a comment. They are numbered from 0 in the whole file.
class FileInParts {
 public:
  /// Each rank reads the lines that begin in its part of the bytes; the parts are about equal. Collective; all ranks
  /// see the same regular file. All ranks return the error of the first one that failed.
  [[nodiscard]] Status read(const std::filesystem::path& file, Ranks& ranks);

  /// A reader of the lines of this rank. Its messages name the file, and lines of the whole file.
  [[nodiscard]] TextReader lines() const { return TextReader({}, name_).part(text_, before_.lines + 1); }
  /// The number of bytes in the parts after that of this rank.
  [[nodiscard]] std::uint64_t bytes_after() const;
  /// The number of records before the part of a rank.
  [[nodiscard]] std::uint64_t records_before(int rank) const;

  /// The rank that has a record; the last rank if the file has fewer records.
  [[nodiscard]] int rank_of(std::uint64_t record) const;
  /// A reader of the lines of this rank that reads this record next. It begins with the first line of this rank if the
  /// record is in the part of an earlier rank, and it is at the end if the record is in that of a later one.
  [[nodiscard]] TextReader before(std::uint64_t record) const;

  /// Lines of the file that all ranks have.
  struct SharedLines {
    std::vector<char> text;
    std::size_t first_line = 1;
  };
  /// The lines from a record on, to the end of the file. Collective.
  [[nodiscard]] SharedLines lines_from(std::uint64_t record, Ranks& ranks) const;
  /// A reader of lines that all ranks have, which must outlive it.
  [[nodiscard]] TextReader reader_of(const SharedLines& lines) const {
    return TextReader({}, name_).part({lines.text.data(), lines.text.size()}, lines.first_line);
  }

 private:
  struct Part {
    std::uint64_t lines = 0, records = 0, bytes = 0;
  };
  [[nodiscard]] Status read_bytes(const std::filesystem::path& file, const Ranks& ranks);

  std::string name_;
  Array<char> bytes_;
  std::string_view text_;
  std::vector<Part> parts_;  ///< of all ranks
  int rank_ = 0;
  Part before_;
};

}  // namespace pardel::files
