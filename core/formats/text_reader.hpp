// TextReader: a text of numbers, read field by field, line by line. Every failure knows its file and line.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "../result.hpp"

namespace pardel::files {

/// The whole file as bytes; an `io` error that names the file if it cannot be opened or read.
[[nodiscard]] Result<std::string> read_file(const std::filesystem::path& file);

/// `token` between quotes, shortened to 40 bytes, with what does not print as \xNN: safe in a message.
[[nodiscard]] std::string in_quotes(std::string_view token);

/// Walks over a text whose records are lines of fields between blanks (spaces, tabs, the CR of CR LF). Blank
/// lines are passed over, and where `#` starts a comment, so is what follows it. What a line holds beyond the
/// fields asked for is ignored. Numbers may carry a leading `+`.
///
/// The first failure is kept, and everything after it reads as zero, so that a caller may read a whole line
/// before it looks at failed(). Messages read `NAME:LINE: expected WHAT, found "TOKEN"`; once binary data has
/// been read, where lines mean nothing, `NAME: byte OFFSET: ...`.
class TextReader {
 public:
  /// `text` must outlive the reader.
  TextReader(std::string_view text, std::string name);

  /// Goes to the next line that holds a field; false at the end of the text or after a failure.
  bool next_line();
  /// The same, but the end of the text is a failure: `expected WHAT, found the end of the file`.
  bool expect_line(std::string_view what);
  /// The same for record i (from 0) of n: `expected triangle 5 of 9, ...` where `what` is "triangle".
  bool expect_record(std::string_view what, std::size_t i, std::size_t n);
  /// Whether the line holds another field.
  [[nodiscard]] bool has_field();
  /// Goes to the next field, on this line or a later one; false at the end of the text.
  bool next_field();

  /// The next field of the line, any bytes but blanks; empty if there is none.
  std::string_view word();
  /// What is left of the line, comments and all.
  std::string_view rest_of_line();
  /// A finite number that a double can hold.
  double number(std::string_view what);
  /// A whole number in [low, high].
  std::int64_t integer(std::string_view what, std::int64_t low, std::int64_t high);
  /// integer() if the line holds another field, else `otherwise`.
  std::int64_t integer_or(std::string_view what, std::int64_t low, std::int64_t high, std::int64_t otherwise);
  /// A number of things, 0 or more.
  std::size_t count(std::string_view what);
  /// Fails unless n records of `bytes_each` bytes or more fit what remains of the text, so that no count in a
  /// file makes us allocate more than a small multiple of the file's size.
  bool room_for(std::size_t n, std::size_t bytes_each, std::string_view what);

  /// Binary data: goes behind the end of the current line, where such data begin ...
  void end_line();
  /// ... and takes the next n bytes; empty, with a failure, if there are fewer.
  std::string_view bytes(std::size_t n, std::string_view what);

  [[nodiscard]] bool failed() const { return failed_; }
  /// Precondition: failed().
  [[nodiscard]] Error error() const { return {ErrorKind::invalid_input, message_}; }
  /// Fails with `NAME:LINE: message`, unless it has failed already.
  void fail(const std::string& message);
  /// The text from the next unread byte on.
  [[nodiscard]] std::string_view rest() const { return {at_, static_cast<std::size_t>(end_ - at_)}; }
  /// Goes on at rest().substr(n); the lines between are counted.
  void skip(std::size_t n);

 private:
  void skip_blanks();
  [[nodiscard]] std::string_view peek() const;
  void fail_expected(std::string_view what);

  const char* begin_;
  const char* at_;
  const char* end_;
  std::string name_;
  std::size_t line_ = 1;  ///< of at_
  bool entered_ = false;  ///< the line of at_ is the current one (not so before the first next_line)
  bool binary_ = false;
  bool failed_ = false;
  std::string message_;
};

/// Bytes that a record of `fields` fields takes at least: a digit and a separator each.
constexpr std::size_t text_bytes(std::size_t fields) { return 2 * fields; }

}  // namespace pardel::files
