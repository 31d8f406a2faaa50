// TextReader reads a text of numbers line by line and field by field. Every failure names the file and the line.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "../array.hpp"
#include "../result.hpp"
#include "../support/stop_signal.hpp"
#include "fields.hpp"

namespace pardel::files {

/// The bytes of a file.
class FileText {
 public:
  /// A byte order mark (EF BB BF) at the beginning does not count.
  explicit FileText(Array<char> bytes);
  operator std::string_view() const { return std::string_view(bytes_.data(), bytes_.size()).substr(first_); }

 private:
  Array<char> bytes_;
  std::size_t first_ = 0;
};

/// Returns the bytes of a file. Large files are read on all threads. Names of standard input, such as `-`, are
/// accepted. Error: `io`, with the name of the file, if it cannot be opened or read.
/// `stop`, here and for other readers: asked now and then; it throws Stopped. It may be null.
[[nodiscard]] Result<FileText> read_file(const std::filesystem::path& file, StopSignal* stop = nullptr);

/// `token` in quotation marks, for messages: its first 40 bytes at most. Bytes that cannot be printed appear as \xNN.
[[nodiscard]] std::string in_quotes(std::string_view token);

/// Reads a text of lines. A line consists of fields separated by blanks (spaces, tabs, the CR of CR LF). Blank lines
/// are skipped, and so are comments, which start with `#`. Fields that the caller does not read are ignored. Numbers
/// may have a leading `+`.
///
/// The reader stores the first failure. After it, all functions return zero or an empty text. So a caller may read a
/// whole line before it calls failed(). A message has the form `NAME:LINE: expected WHAT, found "TOKEN"`. After binary
/// data have been read, lines have no meaning, and the form is `NAME: byte OFFSET: ...`.
class TextReader {
 public:
  /// `text` must outlive the reader.
  TextReader(std::string_view text, std::string name, StopSignal* stop = nullptr);

  /// Goes to the next line that has a field. Returns false at the end of the text or after a failure.
  bool next_line();
  /// Like next_line(), but the end of the text is a failure: `expected WHAT, found the end of the file`.
  bool expect_line(std::string_view what);
  /// Like expect_line(), for record i of n, counted from 0. If `what` is "triangle": `expected triangle 5 of 9, ...`.
  bool expect_record(std::string_view what, std::size_t i, std::size_t n);
  /// True if the line has another field.
  [[nodiscard]] bool has_field() {
    skip_blanks();
    return at_ != end_ && *at_ != '\n' && *at_ != '#';
  }
  /// Goes to the next field, on this line or a later one. Returns false at the end of the text.
  bool next_field();

  /// Returns the next field of the line; empty if there is none.
  std::string_view word();
  /// Reads a field that must be this word. Fails otherwise.
  void expect_word(std::string_view expected);
  /// Returns the rest of the line, including comments.
  std::string_view rest_of_line();
  /// Reads a finite number that a double can represent.
  double number(std::string_view what);
  /// Reads a number that may also be infinite or not a number (`nan`), as results of computations are.
  double any_number(std::string_view what);
  /// Reads an integer in [low, high].
  std::int64_t integer(std::string_view what, std::int64_t low, std::int64_t high) {
    if (failed_) return 0;
    skip_blanks();
    std::int64_t value = 0;
    const char* const stop = read_digits(at_, end_, value);
    if (stop == at_ || !is_end_of_field(stop) || value < low || value > high)
      return integer_in_any_form(what, low, high);
    at_ = stop;
    return value;
  }
  /// Returns integer() if the line has another field, else `otherwise`.
  std::int64_t integer_or(std::string_view what, std::int64_t low, std::int64_t high, std::int64_t otherwise);
  /// Reads a number of records, 0 or more.
  std::size_t count(std::string_view what);
  /// Fails if the rest of the text is too short for n records of at least `bytes_each` bytes. Call it before memory is
  /// allocated for n records: a wrong count then cannot cost more memory than a small multiple of the file's size.
  /// `more`: so many bytes follow the text in the file.
  bool room_for(std::size_t n, std::size_t bytes_each, std::string_view what, std::size_t more = 0);

  /// Asks the StopSignal, as next_line() and next_field() do; for readers of binary data.
  void ask() {
    if (stop_ != nullptr) [[unlikely]]
      ask_stop();
  }

  /// Goes to the first byte after the end of the current line, where binary data begin.
  void end_line();
  /// The same if a line has been begun.
  void leave_line() {
    if (entered_) end_line();
  }
  /// Reads the next n bytes as binary data. If there are fewer, fails and returns an empty text.
  std::string_view bytes(std::size_t n, std::string_view what);

  [[nodiscard]] bool failed() const { return failed_; }
  /// Precondition: failed().
  [[nodiscard]] Error error() const { return {ErrorKind::invalid_input, message_}; }
  /// Stores the failure `NAME:LINE: message`, unless there was a failure before.
  void fail(const std::string& message);
  /// A reader of `lines`, whole lines of this text of which the first has the number `line`.
  [[nodiscard]] TextReader part(std::string_view lines, std::size_t line) const;
  /// Goes to where a reader that part() returned is, and takes over its failure.
  void go_on_after(const TextReader& part);
  /// The number of the line that is read, or of the next one. The first line has the number 1.
  [[nodiscard]] std::size_t line() const { return line_; }
  /// The part of the text that has not been read.
  [[nodiscard]] std::string_view rest() const { return {at_, static_cast<std::size_t>(end_ - at_)}; }
  /// Skips n bytes. Line ends among them count for the line number.
  void skip(std::size_t n);

 private:
  /// Not inlined: nearly no caller has a question, and the functions that ask are called for every line.
  [[gnu::noinline]] void ask_stop();
  void skip_blanks() {
    while (at_ != end_ && field_blanks.has(*at_)) ++at_;
  }
  [[nodiscard]] bool is_end_of_field(const char* p) const { return p == end_ || field_ends.has(*p); }
  [[nodiscard]] std::string_view peek() const;
  /// Also for integers with a sign or many digits; all failures.
  std::int64_t integer_in_any_form(std::string_view what, std::int64_t low, std::int64_t high);
  void fail_expected(std::string_view what);

  const char* begin_;
  const char* at_;
  const char* end_;
  std::string name_;
  StopSignal* stop_;
  SparseAsk ask_{stop_};
  std::size_t line_ = 1;  ///< the number of the line that contains at_
  bool entered_ = false;  ///< the line that contains at_ is the current line; false before next_line()
  bool binary_ = false;
  bool failed_ = false;
  std::string message_;
};

/// The least number of bytes of a record of `fields` fields: each has at least one digit and one separator.
constexpr std::size_t text_bytes(std::size_t fields) { return 2 * fields; }

}  // namespace pardel::files
