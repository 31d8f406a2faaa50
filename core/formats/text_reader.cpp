#include "text_reader.hpp"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <limits>
#include <memory>

#include "../support/byte_order_mark.hpp"
#include "../support/open_file.hpp"

namespace pardel::files {
namespace {

int close_unless_input(std::FILE* f) { return f == stdin ? 0 : std::fclose(f); }
using Stream = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

/// Files of at least this size are read on all threads: the system then also provides the memory on all threads.
constexpr std::size_t least_shared_size = std::size_t{1} << 24;

/// False if the work has to end. Does not throw.
bool may_go_on(StopSignal* stop) {
  try {
    if (stop != nullptr) stop->ask();
  } catch (const Stopped&) {
    return false;
  }
  return true;
}

/// The threads read parts of the file. False if one of them cannot, for example because the file becomes shorter.
bool read_on_all_threads(const std::filesystem::path& file, std::size_t size, Array<char>& bytes, StopSignal* stop) {
  if (size > static_cast<std::size_t>(std::numeric_limits<long>::max())) return false;
  bytes.reserve(size);
  bytes.resize_uninitialised(size);
  constexpr std::size_t part_size = least_shared_size / 8;
  bool complete = true;
#pragma omp parallel for schedule(dynamic, 1) reduction(&& : complete)
  for (std::size_t begin = 0; begin < size; begin += part_size) {
    if (!may_go_on(stop)) continue;
    const std::size_t length = std::min(part_size, size - begin);
    const Stream part(std::fopen(file.c_str(), "rb"), close_unless_input);
    complete = complete && part && std::fseek(part.get(), static_cast<long>(begin), SEEK_SET) == 0 &&
               std::fread(bytes.data() + begin, 1, length, part.get()) == length;
  }
  if (stop != nullptr) stop->ask();
  return complete;
}

/// Removes a leading '+', which std::from_chars does not accept. Another sign after the '+' is not allowed.
std::string_view without_plus(std::string_view token) {
  if (token.size() > 1 && token[0] == '+' && token[1] != '-' && token[1] != '+') token.remove_prefix(1);
  return token;
}

}  // namespace

FileText::FileText(Array<char> bytes) : bytes_(std::move(bytes)) {
  if (std::string_view(*this).starts_with(byte_order_mark)) first_ = byte_order_mark.size();
}

Result<FileText> read_file(const std::filesystem::path& file, StopSignal* stop) {
  const auto failure = [&](const char* what) {
    return Error{ErrorKind::io, file.string() + ": " + what + ": " + std::strerror(errno)};
  };
  const bool is_input = is_standard_input(file);
  const Stream stream(is_input ? stdin : std::fopen(file.c_str(), "rb"), close_unless_input);
  if (!stream) return failure("cannot be opened");

  Array<char> bytes;
  std::error_code unknown;  // a pipe has no size; the array then grows step by step
  const auto size = std::filesystem::file_size(file, unknown);
  if (!unknown && !is_input && size >= least_shared_size && read_on_all_threads(file, size, bytes, stop))
    return FileText(std::move(bytes));
  std::size_t length = 0;
  std::size_t chunk = unknown ? std::size_t{1} << 16 : static_cast<std::size_t>(size) + 1;
  for (;;) {
    bytes.resize_uninitialised(length + chunk);
    const std::size_t got = std::fread(bytes.data() + length, 1, chunk, stream.get());
    length += got;
    if (got < chunk) break;
    chunk = length;
  }
  if (std::ferror(stream.get()) != 0) return failure("cannot be read");
  bytes.resize_uninitialised(length);
  return FileText(std::move(bytes));
}

std::string in_quotes(std::string_view token) {
  constexpr std::size_t longest = 40;
  constexpr char digits[] = "0123456789abcdef";
  std::string text = "\"";
  for (const char c : token.substr(0, longest)) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 0x20 && byte < 0x7f && c != '"' && c != '\\') {
      text += c;
    } else {
      text += {'\\', 'x', digits[byte >> 4], digits[byte & 15]};
    }
  }
  return text + (token.size() > longest ? "...\"" : "\"");
}

TextReader::TextReader(std::string_view text, std::string name, StopSignal* stop)
    : begin_(text.data()), at_(text.data()), end_(text.data() + text.size()), name_(std::move(name)), stop_(stop) {}

TextReader TextReader::part(std::string_view lines, std::size_t line) const {
  TextReader reader(lines, name_, stop_);
  reader.line_ = line;
  return reader;
}

void TextReader::go_on_after(const TextReader& part) {
  at_ = part.at_;
  line_ = part.line_;
  entered_ = part.entered_;
  failed_ = part.failed_;
  message_ = part.message_;
}

void TextReader::ask_stop() { ask_(); }

void TextReader::end_line() {
  if (at_ == end_) return;
  // Most lines have been read to their ends.
  const void* newline = *at_ == '\n' ? at_ : std::memchr(at_, '\n', static_cast<std::size_t>(end_ - at_));
  at_ = newline == nullptr ? end_ : static_cast<const char*>(newline) + 1;
  if (newline != nullptr) ++line_;
  entered_ = false;
}

bool TextReader::next_line() {
  if (failed_) return false;
  ask();
  leave_line();
  while (at_ != end_ && !has_field()) end_line();
  entered_ = at_ != end_;
  return entered_;
}

bool TextReader::expect_line(std::string_view what) {
  if (next_line()) return true;
  fail_expected(what);
  return false;
}

bool TextReader::expect_record(std::string_view what, std::size_t i, std::size_t n) {
  if (next_line()) return true;
  if (!failed_) fail_expected(std::string(what) + " " + std::to_string(i + 1) + " of " + std::to_string(n));
  return false;
}

bool TextReader::next_field() {
  if (failed_) return false;
  ask();
  return (entered_ && has_field()) || next_line();
}

std::string_view TextReader::peek() const {
  const char* p = at_;
  while (!is_end_of_field(p)) ++p;
  return {at_, static_cast<std::size_t>(p - at_)};
}

std::string_view TextReader::word() {
  if (failed_ || !has_field()) return {};
  const std::string_view token = peek();
  at_ += token.size();
  return token;
}

void TextReader::expect_word(std::string_view expected) {
  if (const std::string_view found = word(); found != expected)
    fail("expected " + std::string(expected) + ", found " + in_quotes(found));
}

std::string_view TextReader::rest_of_line() {
  if (failed_) return {};
  skip_blanks();
  const char* stop = std::find(at_, end_, '\n');
  while (stop != at_ && field_blanks.has(stop[-1])) --stop;
  const std::string_view text(at_, static_cast<std::size_t>(stop - at_));
  at_ = stop;
  return text;
}

double TextReader::number(std::string_view what) {
  if (failed_) return 0;
  skip_blanks();
  double value = 0;
  // Most numbers end where their field ends, and have no '+'.
  if (const auto [stop, status] = std::from_chars(at_, end_, value);
      status == std::errc() && is_end_of_field(stop) && std::isfinite(value)) {
    at_ = stop;
    return value;
  }
  const std::string_view token = peek();
  const std::string_view digits = without_plus(token);
  const auto [stop, status] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (token.empty() || stop != digits.data() + digits.size() || status == std::errc::invalid_argument) {
    fail_expected(what);
    return 0;
  }
  if (status != std::errc() || !std::isfinite(value)) {
    fail_expected(std::string(what) + ", finite and within the range of a double");
    return 0;
  }
  at_ += token.size();
  return value;
}

double TextReader::any_number(std::string_view what) {
  if (failed_ || !has_field()) return number(what);
  const std::string_view token = peek();
  const std::string_view digits = without_plus(token);
  double value = 0;
  const auto [stop, status] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (status != std::errc() || stop != digits.data() + digits.size()) return number(what);
  at_ += token.size();
  return value;
}

std::int64_t TextReader::integer_in_any_form(std::string_view what, std::int64_t low, std::int64_t high) {
  if (failed_) return 0;
  skip_blanks();
  const std::string_view token = peek();
  const std::string_view digits = without_plus(token);
  std::int64_t value = 0;
  const auto [stop, status] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (token.empty() || stop != digits.data() + digits.size() || status == std::errc::invalid_argument) {
    fail_expected(std::string(what) + ", a whole number");
    return 0;
  }
  if (status != std::errc() || value < low || value > high) {
    fail_expected(std::string(what) + ", a whole number from " + std::to_string(low) + " to " + std::to_string(high));
    return 0;
  }
  at_ += token.size();
  return value;
}

std::int64_t TextReader::integer_or(std::string_view what, std::int64_t low, std::int64_t high,
                                    std::int64_t otherwise) {
  if (failed_ || !has_field()) return otherwise;
  return integer(what, low, high);
}

std::size_t TextReader::count(std::string_view what) {
  return static_cast<std::size_t>(integer(what, 0, std::numeric_limits<std::int64_t>::max()));
}

bool TextReader::room_for(std::size_t n, std::size_t bytes_each, std::string_view what, std::size_t more) {
  if (failed_) return false;
  // The text counts as one byte longer, because the newline of the last record may be missing.
  if (n <= (rest().size() + more + 1) / bytes_each) return true;
  fail("announces " + std::to_string(n) + " " + std::string(what) + ", but the rest of the file is too short for that");
  return false;
}

std::string_view TextReader::bytes(std::size_t n, std::string_view what) {
  if (failed_) return {};
  binary_ = true;
  if (n > rest().size()) {
    fail("expected " + std::string(what) + " (" + std::to_string(n) + " bytes), found the end of the file after " +
         std::to_string(rest().size()) + " bytes");
    return {};
  }
  const std::string_view data = rest().substr(0, n);
  at_ += n;
  return data;
}

void TextReader::skip(std::size_t n) {
  line_ += static_cast<std::size_t>(std::count(at_, at_ + n, '\n'));
  at_ += n;
  entered_ = false;
}

void TextReader::fail(const std::string& message) {
  if (failed_) return;
  failed_ = true;
  const std::string place = std::to_string(binary_ ? static_cast<std::size_t>(at_ - begin_) : line_);
  message_ = name_ + (binary_ ? ": byte " : ":") + place + ": " + message;
}

void TextReader::fail_expected(std::string_view what) {
  skip_blanks();
  const std::string_view token = peek();
  const std::string found = !token.empty() ? in_quotes(token)
                            : at_ == end_  ? "the end of the file"
                                           : "the end of the line";
  fail("expected " + std::string(what) + ", found " + found);
}

}  // namespace pardel::files
